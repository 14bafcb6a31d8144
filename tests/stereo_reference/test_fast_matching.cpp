// The fast matcher equals the general one, in every pixel; and work in pieces.
#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "random_images.hpp"
#include <common/error.hpp>
#include <stereo_reference/fast_matching.hpp>
#include <stereo_reference/parallel.hpp>

namespace finback::stereo_reference {
namespace {

using test::random_image;

TEST(FastMatching, EqualsTheGeneralMatcher) {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const int window = 1 + 2 * static_cast<int>(random() % 9);
    const int width = window + 2 + static_cast<int>(random() % 50);
    const int height = window + static_cast<int>(random() % 20);
    const int least = 1 + static_cast<int>(random() % 2);
    // Sometimes more disparities than fit.
    const MatchParameters parameters{window, least, least + static_cast<int>(random() % 60)};
    const ByteImage left = random_image(random, width, height);
    const ByteImage right = random_image(random, width, height);
    for (const Measure measure : {Measure::shd, Measure::sad}) {
      const DisparityPair fast = match_bytes(measure, left, right, parameters);
      const DisparityPair general = match_by(measure, as_words(left), as_words(right), parameters);
      ASSERT_EQ(fast.left, general.left) << "window " << window << ", round " << round;
      ASSERT_EQ(fast.right, general.right) << "window " << window << ", round " << round;
    }
  }
}

TEST(FastMatching, SumsOver16BitsAreStillRight) {
  std::mt19937 random(8);
  const ByteImage left(60, 40, 255);
  const ByteImage right = random_image(random, 60, 40);
  const MatchParameters parameters{31, 1, 12};
  EXPECT_EQ(match_bytes(Measure::sad, left, right, parameters).left,
            match_by(Measure::sad, as_words(left), as_words(right), parameters).left);
}

TEST(FastMatching, OtherMeasuresAreRefused) {
  const ByteImage image(40, 40, 1);
  EXPECT_THROW((void)match_bytes(Measure::ncc, image, image, {9, 1, 5}), InputError);
  EXPECT_THROW((void)match_bytes(Measure::shd, image, ByteImage(40, 39), {9, 1, 5}), InputError);
}

TEST(Parallel, RunsEveryPieceOnce) {
  std::vector<int> runs(100);
  EXPECT_TRUE(run_all(runs.size(), {3, {}}, [&](std::size_t i) { ++runs[i]; }));
  EXPECT_THAT(runs, ::testing::Each(1));
}

TEST(Parallel, TellsTheFirstFailure) {
  try {
    run_all(8, {1, {}}, [](std::size_t i) {
      if (i >= 2) {
        throw std::runtime_error(std::to_string(i));
      }
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "2");
  }
}

TEST(Parallel, StopsWhenToldTo) {
  std::atomic<bool> looked = false;
  const auto watch = [&](std::size_t, std::size_t) {
    looked = true;
    return true;
  };
  const bool complete = run_all(1000, {2, watch}, [&](std::size_t) {
    while (!looked) {
    }
  });
  EXPECT_FALSE(complete);
}

}  // namespace
}  // namespace finback::stereo_reference
