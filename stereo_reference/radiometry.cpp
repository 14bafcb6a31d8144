#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>

#include <common/error.hpp>
#include <stereo_reference/radiometry.hpp>

namespace finback::stereo_reference {

using scenes::ByteImage;

namespace {

constexpr double kWhite = 255;

void check(const ByteImage& image, bool level_fits, const char* what, const char* wanted) {
  if (image.empty()) {
    throw InputError(fmt::format("{}: the picture is empty", what));
  }
  if (!level_fits) {
    throw InputError(fmt::format("{}: {}", what, wanted));
  }
}

std::uint8_t grey(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, kWhite)));
}

template <class Change>
ByteImage changed(const ByteImage& image, const Change& change) {
  ByteImage result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      result.at(x, y) = grey(change(x, y, double{1} * image.at(x, y)));
    }
  }
  return result;
}

// Mean 0, variance 1, by whole numbers up to the last step.
double nearly_normal(std::mt19937& generator) {
  constexpr int kTerms = 12;
  std::int64_t sum = 0;
  for (int i = 0; i < kTerms; ++i) {
    sum += generator();
  }
  constexpr double kRange = 4294967296.0;
  return static_cast<double>(sum) / kRange - kTerms / 2.0;
}

}  // namespace

ByteImage vignette(const ByteImage& image, double level) {
  check(image, level > 0 && level <= 1, "vignetting", "the level lies above 0, up to 1");
  const double centre_x = (image.width() - 1) / 2.0;
  const double centre_y = (image.height() - 1) / 2.0;
  const double corner = std::max(std::sqrt(centre_x * centre_x + centre_y * centre_y), 1e-9);
  return changed(image, [&](int x, int y, double value) {
    const double dx = x - centre_x;
    const double dy = y - centre_y;
    return value * (1 - (1 - level) * std::sqrt(dx * dx + dy * dy) / corner);
  });
}

ByteImage scale_greys(const ByteImage& image, double factor) {
  check(image, factor > 0 && std::isfinite(factor), "scale", "the factor must be positive");
  return changed(image, [&](int, int, double value) { return value * factor; });
}

ByteImage change_gamma(const ByteImage& image, double gamma) {
  check(image, gamma > 0 && std::isfinite(gamma), "gamma", "it must be positive");
  const auto [least, most] = std::minmax_element(image.pixels().begin(), image.pixels().end());
  const double low = *least;
  const double range = std::max(double{1} * *most - low, 1.0);
  return changed(image, [&](int, int, double value) {
    return kWhite * std::pow((value - low) / range, 1 / gamma);
  });
}

ByteImage add_noise(const ByteImage& image, double variance, std::uint32_t seed) {
  check(image, variance >= 0 && std::isfinite(variance), "noise",
        "the variance must not be negative");
  std::mt19937 generator(seed);
  const double deviation = kWhite * std::sqrt(variance);
  return changed(
      image, [&](int, int, double value) { return value + deviation * nearly_normal(generator); });
}

double noise_variance(const ByteImage& image, double snr_decibel) {
  check(image, std::isfinite(snr_decibel), "noise", "the ratio must be a number of decibels");
  double power = 0;
  for (const std::uint8_t value : image.pixels()) {
    power += (value / kWhite) * (value / kWhite);
  }
  power /= static_cast<double>(image.pixels().size());
  return power / std::pow(10.0, snr_decibel / 10);
}

}  // namespace finback::stereo_reference
