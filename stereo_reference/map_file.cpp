#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/map_file.hpp>

namespace finback::stereo_reference {

using scenes::ByteImage;

namespace {

constexpr int kLargestGrey = 255;

void check_scale(int scale, const std::filesystem::path& path) {
  if (scale < 1 || scale > kLargestGrey) {
    throw InputError(
        fmt::format("{}: scale {}: it is a whole number from 1 to 255", path.string(), scale));
  }
}

}  // namespace

ByteImage load_map(const std::filesystem::path& path, int scale) {
  check_scale(scale, path);
  ByteImage map = scenes::load_luma(path);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      std::uint8_t& value = map.at(x, y);
      if (value % scale != 0) {
        throw InputError(
            fmt::format("{}: grey {} at ({}, {}) is no multiple of the scale {}; is it "
                        "a map of another scale, or not a map?",
                        path.string(), value, x, y, scale));
      }
      value = static_cast<std::uint8_t>(value / scale);
    }
  }
  return map;
}

scenes::FloatImage truth_of(const ByteImage& greys, float scale) {
  scenes::FloatImage truth(greys.width(), greys.height());
  std::ranges::transform(greys.pixels(), truth.data(),
                         [scale](std::uint8_t grey) { return static_cast<float>(grey) / scale; });
  return truth;
}

scenes::FloatImage load_truth(const std::filesystem::path& path, int scale) {
  check_scale(scale, path);
  return truth_of(scenes::load_luma(path), static_cast<float>(scale));
}

void write_map(const ByteImage& map, int scale, const std::filesystem::path& path) {
  check_scale(scale, path);
  const int largest = map.empty() ? 0 : *std::ranges::max_element(map.pixels());
  if (largest * scale > kLargestGrey) {
    throw InputError(
        fmt::format("{}: disparity {} times the scale {} is over 255; take a scale of "
                    "at most {}",
                    path.string(), largest, scale, kLargestGrey / largest));
  }
  ByteImage greys(map.width(), map.height());
  std::ranges::transform(map.pixels(), greys.data(), [scale](std::uint8_t value) {
    return static_cast<std::uint8_t>(value * scale);
  });
  scenes::write_png(greys, path);
}

}  // namespace finback::stereo_reference
