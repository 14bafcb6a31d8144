// Do sequences give the pairs that they promise, and do lenses what can be undone?
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <scenes/lens.hpp>
#include <scenes/sequence.hpp>

namespace finback::scenes {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A smooth picture: what sampling loses is little.
ByteImage waves() {
  ByteImage image(kVgaWidth, kVgaHeight);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(
          std::lround(128 + 60 * std::sin(x * 0.07) + 60 * std::cos(y * 0.05 + x * 0.01)));
    }
  }
  return image;
}

// The largest difference within a border.
int difference(const ByteImage& one, const ByteImage& other, int border) {
  int largest = 0;
  for (int y = border; y < one.height() - border; ++y) {
    for (int x = border; x < one.width() - border; ++x) {
      largest = std::max(largest, std::abs(one.at(x, y) - other.at(x, y)));
    }
  }
  return largest;
}

TEST(Lens, ThatDoesNothingChangesNoPixel) {
  EXPECT_EQ(through_lens(waves(), {}), waves());
  EXPECT_EQ(without_lens(waves(), {}), waves());
}

TEST(Lens, ShiftsByWholePixelsExactly) {
  const ByteImage seen = through_lens(waves(), {.shift_x = 5, .shift_y = -3});
  const ByteImage scene = waves();
  EXPECT_EQ(seen.at(105, 97), scene.at(100, 100));
  EXPECT_EQ(seen.at(0, 200), scene.at(0, 203)) << "the edge is repeated";
}

TEST(Lens, QuarterOfARightAngleTurnsAboutTheCentreClockwise) {
  // A bright block to the right of the centre comes down when the picture turns clockwise.
  ByteImage dot(640, 480);
  for (int y = 236; y < 244; ++y) {
    for (int x = 416; x < 424; ++x) {
      dot.at(x, y) = 255;
    }
  }
  const ByteImage seen = through_lens(dot, {.rotation_degrees = 22.5});
  const double distance = 419.5 - 319.5;
  EXPECT_GT(seen.at(static_cast<int>(std::lround(319.5 + distance * std::cos(M_PI / 8))),
                    static_cast<int>(std::lround(239.5 + distance * std::sin(M_PI / 8)))),
            250);
  EXPECT_EQ(seen.at(420, 240), 0);
}

TEST(Lens, BarrelDistortionDrawsTheCornersIn) {
  // k1 < 0: the point at r = 1 (x = 320 from the centre) is shown at 0.9 of it.
  ByteImage lines(640, 480);
  for (int y = 0; y < 480; ++y) {
    lines.at(639, y) = lines.at(638, y) = lines.at(637, y) = 255;
  }
  const ByteImage seen = through_lens(lines, {.k1 = -0.1});
  EXPECT_GT(seen.at(319 + 288 - 1, 240), 200);
  EXPECT_EQ(seen.at(560, 240), 0);
}

TEST(Lens, UndistortingGivesTheSceneBack) {
  for (const Lens& lens : {Lens{.k1 = -0.15, .k2 = 0.02}, Lens{.k1 = 0.1}, Lens{.k2 = -0.05},
                           Lens{.rotation_degrees = 1.5, .shift_x = 2.25, .shift_y = -1.5},
                           Lens{-0.12, 0.01, -0.8, 3.5, 2}}) {
    const ByteImage scene = waves();
    const ByteImage seen = through_lens(scene, lens);
    EXPECT_GT(difference(seen, scene, 0), 20) << "the lens must do something";
    EXPECT_LE(difference(without_lens(seen, lens), scene, 64), 2) << lens.k1 << ' ' << lens.k2;
  }
}

TEST(Lens, ThatFoldsThePictureIsRefused) {
  EXPECT_THAT([] { check_lens({.k1 = -0.4}, "the left lens"); },
              ThrowsMessage<InputError>(HasSubstr("the left lens: k1 = -0.4, k2 = 0 fold")));
  EXPECT_THAT([] { check_lens({.rotation_degrees = 46}, "it"); },
              ThrowsMessage<InputError>(HasSubstr("at most 45")));
  EXPECT_NO_THROW(check_lens({.k1 = -0.13}, "it"));
}

TEST(Sequences, AStillOneIsItsScene) {
  const Scene scene = make_synthetic_scene();
  const auto sequence = still_sequence(make_synthetic_scene());
  for (const std::uint32_t number : {0U, 1U, 999U}) {
    EXPECT_EQ(sequence->pair(number).left, scene.left);
    EXPECT_EQ(sequence->pair(number).right, scene.right);
    EXPECT_EQ(sequence->truth(number), scene.truth);
  }
}

TEST(Sequences, TheMovingSceneBeginsAsTheSyntheticOneAndKeepsItsTruth) {
  const auto sequence = moving_sequence();
  EXPECT_EQ(sequence->pair(0).left, make_synthetic_scene().left);
  const std::uint32_t last = sequence->size();
  EXPECT_EQ(sequence->pair(last).right, make_synthetic_scene().right) << "it comes back";
  for (const std::uint32_t number : {1U, 17U, 100U}) {
    const LumaPair pair = sequence->pair(number);
    const FloatImage truth = sequence->truth(number);
    EXPECT_NE(pair.left, sequence->pair(0).left);
    // Where the truth says, the right view shows the same pixel, unless something hides it.
    int equal = 0;
    int compared = 0;
    for (int y = 0; y < truth.height(); ++y) {
      for (int x = 0; x < truth.width(); ++x) {
        const int right_x = 4 * (x - static_cast<int>(truth.at(x, y)));
        if (right_x >= 0) {
          ++compared;
          equal += sequence->pair(number).left.at(4 * x, 4 * y) ==
                           sequence->pair(number).right.at(right_x, 4 * y)
                       ? 1
                       : 0;
        }
      }
    }
    EXPECT_GT(equal, compared * 85 / 100);
    EXPECT_LT(equal, compared) << "some is hidden";
  }
}

TEST(Sequences, LensesBendThePairsAndLeaveTheTruth) {
  const Lens left{.k1 = -0.1};
  const Lens right{.k1 = -0.1, .rotation_degrees = 0.5};
  const auto bent = sequence_through_lenses(moving_sequence(), left, right);
  const auto plain = moving_sequence();
  EXPECT_EQ(bent->pair(3).left, through_lens(plain->pair(3).left, left));
  EXPECT_EQ(bent->pair(3).right, through_lens(plain->pair(3).right, right));
  EXPECT_EQ(bent->truth(3), plain->truth(3));
}

class FolderTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void picture(const std::string& name, std::uint8_t grey) {
    write_png(ByteImage(8, 6, grey), folder_ / name);
  }
  // Of the test's own: several run at once.
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("finback_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(FolderTest, PairsComeInTheOrderOfTheirNames) {
  for (int i = 2; i >= 0; --i) {
    picture("left_" + std::to_string(i) + ".png", static_cast<std::uint8_t>(10 * i));
    picture("right_" + std::to_string(i) + ".png", static_cast<std::uint8_t>(10 * i + 5));
  }
  picture("other.png", 99);
  const auto sequence = folder_sequence(folder_);
  ASSERT_EQ(sequence->size(), 3U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(sequence->pair(i).left, ByteImage(640, 480, static_cast<std::uint8_t>(10 * (i % 3))));
    EXPECT_EQ(sequence->pair(i).right.at(7, 7), 10 * (i % 3) + 5);
  }
}

TEST_F(FolderTest, WhatIsMissingIsNamed) {
  EXPECT_THAT([&] { static_cast<void>(folder_sequence(folder_)); },
              ThrowsMessage<InputError>(HasSubstr("there are no pictures left_*")));
  EXPECT_THAT([&] { static_cast<void>(folder_sequence(folder_ / "nowhere")); },
              ThrowsMessage<InputError>(HasSubstr("nowhere: No such file or directory")));
  picture("left_a.png", 1);
  EXPECT_THAT([&] { static_cast<void>(folder_sequence(folder_)); },
              ThrowsMessage<InputError>(HasSubstr("there is no right_a.png beside it")));
}

}  // namespace
}  // namespace finback::scenes
