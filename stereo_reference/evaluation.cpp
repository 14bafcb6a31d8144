#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <stereo_reference/evaluation.hpp>

namespace finback::stereo_reference {

namespace {

double percent(int part, int whole) { return whole == 0 ? 0.0 : 100.0 * part / whole; }

double root_mean(double sum, int count) { return count == 0 ? 0.0 : std::sqrt(sum / count); }

}  // namespace

double MapQuality::bad_percent() const { return percent(invalid + wrong, compared); }

double MapQuality::wrong_percent() const { return percent(wrong, compared - invalid); }

Region inner_region(int width, int height, int border) {
  return {border, border, width - border, height - border};
}

namespace {

// `taken(x, y)`: is the pixel looked at?
template <class Taken>
MapQuality evaluate_where(const Taken& taken, const ByteImage& map, const FloatImage& truth,
                          const Region& region, double delta) {
  if (map.width() != truth.width() || map.height() != truth.height()) {
    throw InputError(fmt::format(
        "evaluation: the map is {}x{}, the ground truth {}x{}; both must have the same size",
        map.width(), map.height(), truth.width(), truth.height()));
  }
  if (!(delta >= 0)) {
    throw InputError(fmt::format("evaluation: delta {} must not be negative", delta));
  }
  if (region.left < 0 || region.top < 0 || region.right > map.width() ||
      region.bottom > map.height() || region.left >= region.right || region.top >= region.bottom) {
    throw InputError(fmt::format(
        "evaluation: columns {}..{} and rows {}..{} are no region of a map of {}x{}", region.left,
        region.right - 1, region.top, region.bottom - 1, map.width(), map.height()));
  }
  MapQuality quality;
  double sum = 0;
  double sum_valid = 0;
  for (int y = region.top; y < region.bottom; ++y) {
    for (int x = region.left; x < region.right; ++x) {
      const double true_disparity = truth.at(x, y);
      if (true_disparity == 0 || !taken(x, y)) {
        continue;
      }
      const int disparity = map.at(x, y);
      const double error = std::abs(disparity - true_disparity);
      ++quality.compared;
      sum += error * error;
      if (disparity == 0) {
        ++quality.invalid;
        continue;
      }
      sum_valid += error * error;
      if (error > delta) {
        ++quality.wrong;
      }
    }
  }
  quality.rms_error = root_mean(sum, quality.compared);
  quality.rms_error_valid = root_mean(sum_valid, quality.compared - quality.invalid);
  return quality;
}

}  // namespace

MapQuality evaluate(const ByteImage& map, const FloatImage& truth, const Region& region,
                    double delta) {
  return evaluate_where([](int, int) { return true; }, map, truth, region, delta);
}

MapQuality evaluate(const ByteImage& map, const FloatImage& truth, const Region& region,
                    const ByteImage& mask, double delta) {
  if (mask.width() != map.width() || mask.height() != map.height()) {
    throw InputError(
        fmt::format("evaluation: the map is {}x{}, the mask {}x{}; both must have the "
                    "same size",
                    map.width(), map.height(), mask.width(), mask.height()));
  }
  return evaluate_where([&](int x, int y) { return mask.at(x, y) != 0; }, map, truth, region,
                        delta);
}

}  // namespace finback::stereo_reference
