// Masks and radiometric changes on pictures whose answer is known.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random_images.hpp"
#include <common/error.hpp>
#include <stereo_reference/masks.hpp>
#include <stereo_reference/radiometry.hpp>

namespace finback::stereo_reference {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// A wall at disparity 4 and, in front of it, a board at disparity 10 over left columns 30..49.
constexpr int kWidth = 80, kHeight = 12;
FloatImage left_truth() {
  FloatImage map(kWidth, kHeight, 4);
  for (int y = 0; y < kHeight; ++y) {
    std::fill_n(&map.at(30, y), 20, 10.0F);
  }
  return map;
}
FloatImage right_truth() {
  FloatImage map(kWidth, kHeight, 4);
  for (int y = 0; y < kHeight; ++y) {
    std::fill_n(&map.at(20, y), 20, 10.0F);
  }
  return map;
}

TEST(OccludedMask, IsWhatTheBoardHidesAndWhatLiesOutside) {
  const ByteImage mask = occluded_mask(left_truth(), right_truth());
  for (int x = 0; x < kWidth; ++x) {
    // Wall at x is seen at x - 4, which the board covers for x = 24..29 (behind it on its left).
    const bool hidden = x < 4 || (x >= 24 && x < 30);
    EXPECT_EQ(mask.at(x, 5), hidden ? 255 : 0) << x;
  }
}

TEST(OccludedMask, HoldsUnknownPixelsAndObservesItsThreshold) {
  FloatImage left = left_truth();
  left.at(60, 3) = 0;
  left.at(62, 3) = 5.4F;  // leads to 57, where the wall's 4 leads back: 1.4 off
  EXPECT_EQ(occluded_mask(left, right_truth()).at(60, 3), 255);
  EXPECT_EQ(occluded_mask(left, right_truth(), 1.0).at(62, 3), 255);
  EXPECT_EQ(occluded_mask(left, right_truth(), 2.0).at(62, 3), 0);
  EXPECT_THROW((void)occluded_mask(left, FloatImage(3, 3)), InputError);
  EXPECT_THROW((void)occluded_mask(left, right_truth(), 0), InputError);
}

TEST(DiscontinuityMask, SurroundsTheBoard) {
  const ByteImage mask = discontinuity_mask(left_truth(), 9, 3);
  for (int x = 0; x < kWidth; ++x) {
    const bool near = (x >= 25 && x <= 34) || (x >= 45 && x <= 54);
    EXPECT_EQ(mask.at(x, 6), near ? 255 : 0) << x;
  }
  const ByteImage coarse = discontinuity_mask(left_truth(), 9, 6);  // the step is 6, not more
  EXPECT_EQ(std::ranges::count(coarse.pixels(), 255), 0);
  FloatImage unknown = left_truth();
  unknown.at(10, 6) = 0;
  EXPECT_EQ(discontinuity_mask(unknown, 9, 3).at(10, 6), 0) << "unknown is no depth";
}

TEST(DiscontinuityMask, SeesStepsBetweenRows) {
  FloatImage map(9, 9, 4);
  for (int y = 5; y < 9; ++y) {
    std::fill_n(&map.at(0, y), 9, 9.0F);
  }
  const ByteImage mask = discontinuity_mask(map, 3, 3);
  for (int y = 0; y < 9; ++y) {
    EXPECT_EQ(mask.at(4, y), y >= 3 && y <= 6 ? 255 : 0) << y;
  }
}

TEST(TexturelessMask, IsTheFlatHalf) {
  std::mt19937 generator(1);
  ByteImage image = test::random_image(generator, 60, 20);
  for (int y = 0; y < 20; ++y) {
    std::fill_n(&image.at(0, y), 30, std::uint8_t{90});
  }
  const ByteImage mask = textureless_mask(image);
  for (int x = 0; x < 60; ++x) {
    EXPECT_EQ(mask.at(x, 10), x < 25 ? 255 : 0) << x;
  }
  // A ramp of 4 a pixel averages to the threshold's square: not below it.
  ByteImage ramp(40, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 40; ++x) {
      ramp.at(x, y) = static_cast<std::uint8_t>(4 * x);
    }
  }
  EXPECT_EQ(std::ranges::count(textureless_mask(ramp, 9, 4).pixels(), 255), 0);
  EXPECT_EQ(std::ranges::count(textureless_mask(ramp, 9, 4.01).pixels(), 255), 40 * 9);
}

TEST(Masks, RefuseWhatMakesNoSense) {
  EXPECT_THAT([] { (void)textureless_mask(ByteImage(5, 5), 4); },
              ThrowsMessage<InputError>(HasSubstr("window 4: it must be an odd number")));
  EXPECT_THAT([] { (void)discontinuity_mask(FloatImage(5, 5), 3, std::nan("")); },
              ThrowsMessage<InputError>(HasSubstr("must be positive")));
  EXPECT_THAT([] { (void)textureless_mask(ByteImage()); },
              ThrowsMessage<InputError>(HasSubstr("empty")));
}

TEST(Vignette, FallsToItsLevelInTheCorners) {
  const ByteImage image(101, 61, 200);
  const ByteImage dark = vignette(image, 0.5);
  EXPECT_EQ(dark.at(50, 30), 200);
  for (const auto& [x, y] : {std::pair{0, 0}, {100, 0}, {0, 60}, {100, 60}}) {
    EXPECT_EQ(dark.at(x, y), 100);
  }
  EXPECT_EQ(dark.at(0, 30), std::lround(200 * (1 - 0.5 * 50 / std::hypot(50, 30))));
  EXPECT_EQ(vignette(image, 1), image);
  EXPECT_THROW((void)vignette(image, 0), InputError);
  EXPECT_THROW((void)vignette(image, 1.1), InputError);
}

TEST(ScaleGreys, RoundsAndStopsAtWhite) {
  ByteImage image(3, 1);
  image.at(0, 0) = 10;
  image.at(1, 0) = 101;
  image.at(2, 0) = 250;
  const ByteImage scaled = scale_greys(image, 1.5);
  EXPECT_EQ(scaled.at(0, 0), 15);
  EXPECT_EQ(scaled.at(1, 0), 152);
  EXPECT_EQ(scaled.at(2, 0), 255);
  EXPECT_THROW((void)scale_greys(image, 0), InputError);
}

TEST(ChangeGamma, StretchesAndBends) {
  ByteImage image(3, 1);
  image.at(0, 0) = 50;
  image.at(1, 0) = 100;
  image.at(2, 0) = 250;
  const ByteImage linear = change_gamma(image, 1);
  EXPECT_EQ(linear.at(0, 0), 0);
  EXPECT_EQ(linear.at(1, 0), std::lround(255 * 0.25));
  EXPECT_EQ(linear.at(2, 0), 255);
  EXPECT_EQ(change_gamma(image, 2).at(1, 0), std::lround(255 * 0.5));
  EXPECT_EQ(change_gamma(ByteImage(4, 4, 7), 2), ByteImage(4, 4, 0)) << "one grey only";
  EXPECT_THROW((void)change_gamma(image, -1), InputError);
}

TEST(AddNoise, HasItsVarianceAndItsSeed) {
  const ByteImage image(400, 300, 128);
  const ByteImage noisy = add_noise(image, 0.002, 7);
  double mean = 0, squares = 0;
  for (const std::uint8_t value : noisy.pixels()) {
    mean += value / 255.0;
    squares += (value / 255.0) * (value / 255.0);
  }
  mean /= 120000;
  EXPECT_NEAR(mean, 128 / 255.0, 0.001);
  EXPECT_NEAR(squares / 120000 - mean * mean, 0.002, 0.00005);
  EXPECT_EQ(noisy, add_noise(image, 0.002, 7));
  EXPECT_NE(noisy, add_noise(image, 0.002, 8));
  EXPECT_EQ(add_noise(image, 0, 7), image);
  // Of a picture of one grey g: g^2 over ten to the tenth of the decibels.
  EXPECT_NEAR(noise_variance(image, 20), (128 / 255.0) * (128 / 255.0) / 100, 1e-12);
  EXPECT_THROW((void)add_noise(image, -1, 0), InputError);
}

}  // namespace
}  // namespace finback::stereo_reference
