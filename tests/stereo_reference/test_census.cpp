#include <gtest/gtest.h>

#include "random_images.hpp"
#include <common/error.hpp>
#include <stereo_reference/matching.hpp>

namespace finback::stereo_reference {
namespace {

ByteImage image_of(int width, std::initializer_list<int> values) {
  ByteImage image(width, static_cast<int>(values.size()) / width);
  int index = 0;
  for (const int value : values) {
    image.at(index % width, index / width) = static_cast<std::uint8_t>(value);
    ++index;
  }
  return image;
}

TEST(Census, FirstNeighbourIsTheMostSignificantBitAndRowsFollow) {
  // Less than 5: upper left (1), the left one (2), lower right (4).
  const ByteImage census = census_3x3(image_of(3, {1, 9, 9, 2, 5, 9, 9, 9, 4}));
  EXPECT_EQ(census.at(1, 1), 0b1001'0001);
}

TEST(Census, EqualNeighboursGiveZero) {
  const ByteImage census = census_3x3(ByteImage(5, 4, 77));
  EXPECT_EQ(census, ByteImage(5, 4, 0));
}

TEST(Census, EveryNeighbourHasItsBit) {
  int bit = 7;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      if (x == 1 && y == 1) {
        continue;
      }
      ByteImage image(3, 3, 100);
      image.at(x, y) = 99;
      EXPECT_EQ(census_3x3(image).at(1, 1), 1 << bit) << "neighbour " << x << "," << y;
      --bit;
    }
  }
}

TEST(Census, BorderIsZero) {
  std::mt19937 generator(3);
  const ByteImage census = census_3x3(test::random_image(generator, 9, 7));
  for (int x = 0; x < 9; ++x) {
    EXPECT_EQ(census.at(x, 0), 0);
    EXPECT_EQ(census.at(x, 6), 0);
  }
  for (int y = 0; y < 7; ++y) {
    EXPECT_EQ(census.at(0, y), 0);
    EXPECT_EQ(census.at(8, y), 0);
  }
}

TEST(Census, DoesNotChangeUnderBrightnessAndContrast) {
  std::mt19937 generator(4);
  ByteImage image = test::random_image(generator, 20, 20, 100);
  const ByteImage census = census_3x3(image);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(2 * image.at(x, y) + 30);
    }
  }
  EXPECT_EQ(census_3x3(image), census);
}

TEST(Census, ImagesWithoutInteriorAreAllBorder) {
  EXPECT_EQ(census_3x3(image_of(2, {1, 2, 3, 4})), ByteImage(2, 2, 0));
  EXPECT_THROW((void)census_3x3(ByteImage()), InputError);
}

TEST(Subsampling, TakesEveryFourthPixelOfEveryFourthRow) {
  ByteImage image(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(10 * y + x);
    }
  }
  EXPECT_EQ(subsample_by_4(image), image_of(2, {0, 4, 40, 44}));
}

}  // namespace
}  // namespace finback::stereo_reference
