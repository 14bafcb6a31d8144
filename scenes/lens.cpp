#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <scenes/lens.hpp>

namespace finback::scenes {

namespace {

constexpr double kMostDegrees = 45;
constexpr int kSteps = 256;  // of a pixel

struct Point {
  double x = 0;
  double y = 0;
};

// Sine and cosine of a small angle by their series: the same on every host, unlike a library's.
Point sine_and_cosine(double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  Point result{0, 0};  // cosine, sine
  double term = 1;
  for (int n = 0; n < 20; ++n) {
    const double sign = n % 4 < 2 ? 1 : -1;
    (n % 2 == 0 ? result.x : result.y) += sign * term;
    term *= angle / (n + 1);
  }
  return result;
}

// Points of a picture, in pixels from its centre.
class Mapping {
 public:
  Mapping(const ByteImage& image, const Lens& lens)
      : lens_(lens), unit_(image.width() / 2.0), turn_(sine_and_cosine(lens.rotation_degrees)) {}

  // Where the lens shows a point of the scene.
  [[nodiscard]] Point shown(Point scene) const {
    const double squared = (scene.x * scene.x + scene.y * scene.y) / (unit_ * unit_);
    const double factor = 1 + squared * (lens_.k1 + squared * lens_.k2);
    const Point bent{scene.x * factor, scene.y * factor};
    return {turn_.x * bent.x - turn_.y * bent.y + lens_.shift_x,
            turn_.y * bent.x + turn_.x * bent.y + lens_.shift_y};
  }
  // Which point of the scene is shown there: the inverse, by Newton's method on the radius.
  [[nodiscard]] Point scene(Point shown) const {
    const Point moved{shown.x - lens_.shift_x, shown.y - lens_.shift_y};
    const Point bent{turn_.x * moved.x + turn_.y * moved.y, turn_.x * moved.y - turn_.y * moved.x};
    const double target = std::sqrt(bent.x * bent.x + bent.y * bent.y) / unit_;
    if (target == 0) {
      return bent;
    }
    double radius = target;
    for (int i = 0; i < 10; ++i) {
      const double squared = radius * radius;
      const double value = radius * (1 + squared * (lens_.k1 + squared * lens_.k2)) - target;
      radius -= value / (1 + squared * (3 * lens_.k1 + 5 * squared * lens_.k2));
    }
    return {bent.x * radius / target, bent.y * radius / target};
  }

 private:
  const Lens& lens_;
  double unit_;  // pixels that are 1 to the terms of distortion
  Point turn_;   // cosine and sine
};

// The brightness at a point in steps of a pixel.
std::uint8_t sample(const ByteImage& image, std::int64_t x, std::int64_t y) {
  x = std::clamp<std::int64_t>(x, 0, std::int64_t{image.width() - 1} * kSteps);
  y = std::clamp<std::int64_t>(y, 0, std::int64_t{image.height() - 1} * kSteps);
  const int left = static_cast<int>(x / kSteps);
  const int top = static_cast<int>(y / kSteps);
  const int right = std::min(left + 1, image.width() - 1);
  const int bottom = std::min(top + 1, image.height() - 1);
  const int fx = static_cast<int>(x % kSteps);
  const int fy = static_cast<int>(y % kSteps);
  const int upper = image.at(left, top) * (kSteps - fx) + image.at(right, top) * fx;
  const int lower = image.at(left, bottom) * (kSteps - fx) + image.at(right, bottom) * fx;
  constexpr int kWhole = kSteps * kSteps;
  return static_cast<std::uint8_t>((upper * (kSteps - fy) + lower * fy + kWhole / 2) / kWhole);
}

// Each pixel of the result is taken from where `source` says.
template <class Source>
ByteImage resampled(const ByteImage& image, Source source) {
  ByteImage result(image.width(), image.height());
  const Point centre{(image.width() - 1) / 2.0, (image.height() - 1) / 2.0};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Point from = source(Point{x - centre.x, y - centre.y});
      result.at(x, y) = sample(image, std::llround((from.x + centre.x) * kSteps),
                               std::llround((from.y + centre.y) * kSteps));
    }
  }
  return result;
}

}  // namespace

void check_lens(const Lens& lens, const std::string& what) {
  if (!(std::abs(lens.rotation_degrees) <= kMostDegrees)) {
    throw InputError(fmt::format("{}: a rotation of {} degrees; at most {} are possible", what,
                                 lens.rotation_degrees, kMostDegrees));
  }
  // r' grows up to the corner of a 4:3 picture, 1.25, and somewhat beyond: the inverse exists.
  constexpr double kFarthest = 1.5;
  for (double r = 0; r <= kFarthest; r += 0.01) {
    if (!(1 + 3 * lens.k1 * r * r + 5 * lens.k2 * r * r * r * r > 0.05)) {
      throw InputError(
          fmt::format("{}: k1 = {}, k2 = {} fold the picture at {:.2f} of half its width; use "
                      "smaller ones",
                      what, lens.k1, lens.k2, r));
    }
  }
}

ByteImage through_lens(const ByteImage& image, const Lens& lens) {
  const Mapping mapping(image, lens);
  return resampled(image, [&](Point shown) { return mapping.scene(shown); });
}

ByteImage without_lens(const ByteImage& image, const Lens& lens) {
  const Mapping mapping(image, lens);
  return resampled(image, [&](Point scene) { return mapping.shown(scene); });
}

}  // namespace finback::scenes
