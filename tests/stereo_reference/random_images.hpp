// Seeded random images for tests: the same bytes on every host.
#pragma once

#include <cstdint>
#include <random>

#include <scenes/image.hpp>

namespace finback::test {

// Every grey value 0..levels-1 is equally likely, up to the bias of the remainder.
inline scenes::ByteImage random_image(std::mt19937& generator, int width, int height,
                                      unsigned levels = 256) {
  scenes::ByteImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(generator() % levels);
    }
  }
  return image;
}

// The right view of a frontal plane: left x is seen at x - disparity; the columns that the left
// view does not see are random.
inline scenes::ByteImage shifted(std::mt19937& generator, const scenes::ByteImage& left,
                                 int disparity) {
  scenes::ByteImage right = random_image(generator, left.width(), left.height());
  for (int y = 0; y < left.height(); ++y) {
    for (int x = disparity; x < left.width(); ++x) {
      right.at(x - disparity, y) = left.at(x, y);
    }
  }
  return right;
}

}  // namespace finback::test
