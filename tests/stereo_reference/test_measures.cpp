// All measures, fast against plain, for any window and range; rank and census; local variance.
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "random_images.hpp"
#include <common/error.hpp>
#include <stereo_reference/measures.hpp>
#include <stereo_reference/texture.hpp>

namespace finback::stereo_reference {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

ByteImage random_image(int width, int height, unsigned seed, unsigned greys = 256) {
  std::mt19937 generator(seed);
  return test::random_image(generator, width, height, greys);
}

struct MeasureCase {
  int width, height, window, disparity_min, disparity_max;
};

class MeasureOn : public testing::TestWithParam<std::tuple<Measure, MeasureCase>> {};

TEST_P(MeasureOn, FastEqualsPlain) {
  const auto& [measure, c] = GetParam();
  const MatchParameters parameters{c.window, c.disparity_min, c.disparity_max};
  for (const unsigned greys : {256U, 3U, 1U}) {  // few greys: many ties, and windows without light
    const WordImage left = as_words(random_image(c.width, c.height, 1, greys));
    const WordImage right = as_words(random_image(c.width, c.height, 2, greys));
    const DisparityPair plain = match_by_plain(measure, left, right, parameters);
    const DisparityPair fast = match_by(measure, left, right, parameters);
    EXPECT_EQ(plain.left, fast.left) << greys << " greys";
    EXPECT_EQ(plain.right, fast.right) << greys << " greys";
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, MeasureOn,
    testing::Combine(testing::Values(Measure::sad, Measure::ssd, Measure::ncc, Measure::shd),
                     testing::Values(MeasureCase{40, 30, 1, 1, 9}, MeasureCase{40, 30, 3, 2, 12},
                                     MeasureCase{33, 17, 15, 1, 40}, MeasureCase{20, 9, 9, 3, 3},
                                     MeasureCase{10, 9, 9, 1, 255}, MeasureCase{64, 5, 5, 1, 63})));

// A picture and itself shifted by 4: everybody finds the 4.
TEST(Measures, AllFindAShift) {
  const ByteImage wide = random_image(64, 24, 3);
  ByteImage left(60, 24), right(60, 24);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 60; ++x) {
      left.at(x, y) = wide.at(x, y);
      right.at(x, y) = wide.at(x + 4, y);
    }
  }
  const MatchParameters parameters{5, 1, 10};
  for (const Measure measure : {Measure::sad, Measure::ssd, Measure::ncc, Measure::shd}) {
    const DisparityPair maps = match_by(measure, as_words(left), as_words(right), parameters);
    const Region inside = computed_region(60, 24, parameters);
    for (int y = inside.top; y < inside.bottom; ++y) {
      for (int x = inside.left + 3; x < inside.right; ++x) {
        ASSERT_EQ(maps.left.at(x, y), 4) << static_cast<int>(measure) << " at " << x << "," << y;
      }
      for (int x = 2; x < 60 - 2 - 4; ++x) {
        ASSERT_EQ(maps.right.at(x, y), 4);
      }
    }
  }
}

TEST(Measures, ShdOfCensusIsTheFirmwaresMatching) {
  const ByteImage left = random_image(80, 40, 5);
  const ByteImage right = random_image(80, 40, 6);
  const MatchParameters parameters{7, 2, 20};
  const DisparityPair firmware = match_recursive(census_3x3(left), census_3x3(right), parameters);
  const DisparityPair measured =
      match_by(Measure::shd, census_transform(left, 3), census_transform(right, 3), parameters);
  EXPECT_EQ(firmware.left, measured.left);
  EXPECT_EQ(firmware.right, measured.right);
}

// The right picture is twice as bright and shifted by 2: only NCC finds that everywhere.
TEST(Measures, NccIsBlindToScale) {
  const ByteImage wide = random_image(42, 9, 11, 120);
  ByteImage left(40, 9), right(40, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 40; ++x) {
      left.at(x, y) = wide.at(x, y);
      right.at(x, y) = static_cast<std::uint8_t>(2 * wide.at(x + 2, y));
    }
  }
  const MatchParameters parameters{5, 1, 8};
  const auto twos = [&](Measure measure) {
    const ByteImage map = match_by(measure, as_words(left), as_words(right), parameters).left;
    int count = 0;
    for (int x = 4; x < 38; ++x) {
      count += map.at(x, 4) == 2;
    }
    return count;
  };
  EXPECT_EQ(twos(Measure::ncc), 34);
  EXPECT_LT(twos(Measure::sad), 34);
}

TEST(Measures, RefuseWhatCannotBeMatched) {
  const WordImage image = as_words(random_image(20, 12, 1));
  const auto matching = [&](const WordImage& right, const MatchParameters& p) {
    return [&image, right, p] { (void)match_by(Measure::sad, image, right, p); };
  };
  EXPECT_THAT(matching(as_words(random_image(21, 12, 1)), {}),
              ThrowsMessage<InputError>(HasSubstr("both must have the same size")));
  EXPECT_THAT(matching(image, {4, 1, 5}), ThrowsMessage<InputError>(HasSubstr("odd number")));
  EXPECT_THAT(matching(image, {5, 7, 6}), ThrowsMessage<InputError>(HasSubstr("7..6")));
  EXPECT_THAT(matching(image, {13, 1, 5}), ThrowsMessage<InputError>(HasSubstr("too small")));
  WordImage large = image;
  large.at(3, 3) = 65536;
  EXPECT_THAT(
      [&] {
        (void)match_by(Measure::ssd, image, large, {5, 1, 6});
      },
      ThrowsMessage<InputError>(HasSubstr("a value of 65536")));
  EXPECT_NO_THROW((void)match_by(Measure::shd, image, large, {5, 1, 6}));
}

TEST(Rank, CountsTheDarkerNeighbours) {
  ByteImage image(3, 3);
  for (int i = 0; i < 9; ++i) {
    image.data()[i] = static_cast<std::uint8_t>(10 * i);  // the centre is 40
  }
  EXPECT_EQ(rank_transform(image, 3).at(1, 1), 4U);
  EXPECT_EQ(rank_transform(image, 3).at(0, 0), 0U);
  image.at(0, 0) = 40;  // equal is not darker
  EXPECT_EQ(rank_transform(image, 3).at(1, 1), 3U);
  EXPECT_EQ(rank_transform(image, 1).at(1, 1), 0U);
}

TEST(Rank, IsTheNumberOfBitsOfTheCensus) {
  const ByteImage image = random_image(25, 19, 9);
  for (const int window : {3, 5}) {
    const WordImage rank = rank_transform(image, window);
    const WordImage census = census_transform(image, window);
    for (std::size_t i = 0; i < rank.pixels().size(); ++i) {
      ASSERT_EQ(rank.pixels()[i], static_cast<std::uint32_t>(std::popcount(census.pixels()[i])));
    }
  }
}

TEST(Census, OrdersItsBitsRowByRow) {
  ByteImage image(5, 5, 9);
  image.at(0, 0) = 1;  // the upper left one of 24
  image.at(4, 4) = 1;  // the lower right one
  image.at(3, 2) = 1;  // right of the centre: the 13th
  EXPECT_EQ(census_transform(image, 5).at(2, 2), 1U << 23 | 1U << 11 | 1U);
  EXPECT_EQ(census_transform(image, 3).at(2, 2), 1U << 3);
  EXPECT_THROW((void)census_transform(image, 7), InputError);
  EXPECT_THROW((void)rank_transform(image, 2), InputError);
  EXPECT_THROW((void)rank_transform(ByteImage(), 3), InputError);
}

TEST(Census, OfBytesIsTheFirmwares) {
  const ByteImage image = random_image(31, 23, 4);
  EXPECT_EQ(census_transform(image, 3), as_words(census_3x3(image)));
}

double plain_variance(const ByteImage& image, int x, int y, int n) {
  const double count = (2 * n + 1) * (2 * n + 1);
  double mean = 0, sum = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (int dy = -n; dy <= n; ++dy) {
      for (int dx = -n; dx <= n; ++dx) {
        const double value = image.at(x + dx, y + dy);
        pass == 0 ? mean += value / count : sum += (value - mean) * (value - mean);
      }
    }
  }
  return sum / (count - 1);
}

TEST(VarianceMap, IsTheSampleVarianceOfEveryWindow) {
  const ByteImage image = random_image(30, 22, 8);
  for (const int window : {3, 9, 21}) {
    const auto variances = variance_map(image, window);
    const int n = window / 2;
    for (int y = 0; y < 22; ++y) {
      for (int x = 0; x < 30; ++x) {
        const bool whole = x >= n && x < 30 - n && y >= n && y < 22 - n;
        ASSERT_NEAR(variances.at(x, y), whole ? plain_variance(image, x, y, n) : 0, 1e-6);
      }
    }
  }
  EXPECT_EQ(variance_map(ByteImage(9, 9, 200), 9).at(4, 4), 0);
  EXPECT_THROW((void)variance_map(image, 4), InputError);
  EXPECT_THROW((void)variance_map(ByteImage(), 3), InputError);
}

TEST(PostProcessing, NeedsBothByEquation19AndEitherByTheListing) {
  ByteImage flat(40, 20, 100);
  const ByteImage noise = random_image(40, 20, 2);
  ByteImage torn = random_image(40, 20, 3, 2);  // disparities 10 and 30
  for (int i = 0; i < 40 * 20; ++i) {
    torn.data()[i] = static_cast<std::uint8_t>(torn.data()[i] == 0 ? 10 : 30);
  }
  const ByteImage smooth(40, 20, 12);
  const auto kept = [](const ByteImage& map, const ByteImage& image, bool either) {
    return post_process(map, image, {9, 135, 17, either}).at(20, 10) != 0;
  };
  EXPECT_FALSE(kept(torn, flat, false));
  EXPECT_TRUE(kept(torn, noise, false));
  EXPECT_TRUE(kept(smooth, flat, false));
  EXPECT_TRUE(kept(smooth, noise, false));
  EXPECT_FALSE(kept(torn, noise, true));
  EXPECT_FALSE(kept(smooth, flat, true));
  EXPECT_TRUE(kept(smooth, noise, true));
  EXPECT_THROW((void)post_process(smooth, ByteImage(3, 3)), InputError);
}

// "At most" and "at least".
TEST(PostProcessing, ThresholdsBelongToTheRule) {
  const ByteImage image = random_image(9, 9, 1);
  const ByteImage map = random_image(9, 9, 2);
  const double texture = variance_map(image, 9).at(4, 4);
  const double disparity = variance_map(map, 9).at(4, 4);
  EXPECT_EQ(post_process(map, image, {9, texture, disparity, false}).at(4, 4), 0);
  EXPECT_NE(post_process(map, image, {9, std::nextafter(texture, 0), disparity, false}).at(4, 4),
            0);
  EXPECT_NE(post_process(map, image, {9, texture, std::nextafter(disparity, 1e9), false}).at(4, 4),
            0);
}

}  // namespace
}  // namespace finback::stereo_reference
