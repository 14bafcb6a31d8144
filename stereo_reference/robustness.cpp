#include <algorithm>

#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/masks.hpp>
#include <stereo_reference/robustness.hpp>

namespace finback::stereo_reference {

TrialError try_method(Method method, const ByteImage& left, const ByteImage& right,
                      const FloatImage& truth, const ByteImage& non_occluded, int largest) {
  constexpr int kWindow = 17;
  constexpr double kDelta = 1;
  const ByteImage map = check_left_right(match(method, left, right, {kWindow, 1, largest}));
  const MapQuality quality = evaluate(
      map, truth, inner_region(map.width(), map.height(), kWindow / 2), non_occluded, kDelta);
  return {quality.bad_percent(), quality.wrong_percent()};
}

ByteImage non_occluded_mask(const StereoSample& sample) {
  ByteImage mask = sample.right_truth.empty()
                       ? occluded_mask(sample.left_truth)
                       : occluded_mask(sample.left_truth, sample.right_truth);
  std::ranges::transform(mask.pixels(), mask.data(), [](std::uint8_t occluded) {
    return static_cast<std::uint8_t>(occluded == 0 ? 255 : 0);
  });
  return mask;
}

}  // namespace finback::stereo_reference
