#include <fmt/format.h>
#include <vector>

#include <common/error.hpp>
#include <stereo_reference/texture.hpp>

namespace finback::stereo_reference {

using scenes::ByteImage;

namespace {

// Values and their squares, summed.
struct Sums {
  std::int64_t values = 0;
  std::int64_t squares = 0;
  void add(int value, int sign) {
    values += std::int64_t{sign} * value;
    squares += std::int64_t{sign} * value * value;
  }
  void add(const Sums& other, int sign) {
    values += sign * other.values;
    squares += sign * other.squares;
  }
};

}  // namespace

// The recursions of the matching: columns go down, the window goes along them.
scenes::Image<double> variance_map(const ByteImage& image, int window) {
  if (image.empty()) {
    throw InputError("variance map: the image is empty");
  }
  if (window < 3 || window > 255 || window % 2 == 0) {
    throw InputError(
        fmt::format("variance map: window {}: it must be an odd number from 3 to 255", window));
  }
  const int n = window / 2;
  const std::int64_t count = std::int64_t{window} * window;
  scenes::Image<double> variances(image.width(), image.height());
  std::vector<Sums> columns(static_cast<std::size_t>(image.width()));
  for (int row = 0; row < image.height(); ++row) {
    Sums sum;
    for (int x = 0; x < image.width(); ++x) {
      Sums& column = columns[static_cast<std::size_t>(x)];
      column.add(image.at(x, row), 1);
      if (row >= window) {
        column.add(image.at(x, row - window), -1);
      }
      sum.add(column, 1);
      if (x >= window) {
        sum.add(columns[static_cast<std::size_t>(x - window)], -1);
      }
      if (row >= window - 1 && x >= window - 1) {
        // Whole numbers up to the one division.
        const std::int64_t scaled = count * sum.squares - sum.values * sum.values;
        variances.at(x - n, row - n) =
            static_cast<double>(scaled) / static_cast<double>(count * (count - 1));
      }
    }
  }
  return variances;
}

ByteImage post_process(const ByteImage& map, const ByteImage& image, const PostProcessing& how) {
  if (map.width() != image.width() || map.height() != image.height()) {
    throw InputError(
        fmt::format("post-processing: the map is {}x{}, its image {}x{}; both must "
                    "have the same size",
                    map.width(), map.height(), image.width(), image.height()));
  }
  const scenes::Image<double> texture = variance_map(image, how.window);
  const scenes::Image<double> disparity = variance_map(map, how.window);
  ByteImage result = map;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const bool plain = texture.at(x, y) <= how.texture_threshold;
      const bool torn = disparity.at(x, y) >= how.disparity_threshold;
      if (how.either ? plain || torn : plain && torn) {
        result.at(x, y) = 0;
      }
    }
  }
  return result;
}

}  // namespace finback::stereo_reference
