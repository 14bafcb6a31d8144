#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include <common/error.hpp>
#include <stereo_reference/transforms.hpp>

namespace finback::stereo_reference {

namespace {

using scenes::ByteImage;

// Calls `take(darker)` for each neighbour of each pixel with a whole window, row by row, and
// `done(x, y)` behind a pixel's last.
template <class Take, class Done>
void visit_windows(const ByteImage& image, int window, const Take& take, const Done& done) {
  const int n = window / 2;
  for (int y = n; y < image.height() - n; ++y) {
    for (int x = n; x < image.width() - n; ++x) {
      const std::uint8_t centre = image.at(x, y);
      for (int dy = -n; dy <= n; ++dy) {
        for (int dx = -n; dx <= n; ++dx) {
          if (dx != 0 || dy != 0) {
            take(image.at(x + dx, y + dy) < centre);
          }
        }
      }
      done(x, y);
    }
  }
}

void check(const ByteImage& image, const char* what) {
  if (image.empty()) {
    throw InputError(fmt::format("{}: the image is empty", what));
  }
}

}  // namespace

WordImage rank_transform(const ByteImage& image, int window) {
  check(image, "rank transform");
  if (window < 1 || window > 255 || window % 2 == 0) {
    throw InputError(
        fmt::format("rank transform: window {}: it must be an odd number from 1 to 255", window));
  }
  WordImage ranks(image.width(), image.height());
  std::uint32_t rank = 0;
  visit_windows(
      image, window, [&](bool darker) { rank += darker ? 1 : 0; },
      [&](int x, int y) { ranks.at(x, y) = std::exchange(rank, 0); });
  return ranks;
}

WordImage census_transform(const ByteImage& image, int window) {
  check(image, "census transform");
  if (window != 3 && window != 5) {
    throw InputError(fmt::format("census transform: window {}: 3 (8 bits) or 5 (24 bits)", window));
  }
  WordImage census(image.width(), image.height());
  std::uint32_t bits = 0;
  visit_windows(
      image, window, [&](bool darker) { bits = bits << 1U | (darker ? 1U : 0U); },
      [&](int x, int y) { census.at(x, y) = std::exchange(bits, 0); });
  return census;
}

WordImage as_words(const ByteImage& image) {
  WordImage words(image.width(), image.height());
  std::copy(image.pixels().begin(), image.pixels().end(), words.data());
  return words;
}

}  // namespace finback::stereo_reference
