// Rank against census: how each stands differences of light between the two pictures.
//
// Models: one trial of the thesis's 4.1: transform, match with a 17x17 window, left-right check,
// bad pixels (more than 1 pixel off) in non-occluded regions outside a border of 8 (Ahuja
// 2009, 4.1.1). The thesis does not say what becomes of pixels that the check leaves without a
// disparity: both answers are measured. Does not model: averages over colours, sub-pixel
// disparities.
#pragma once

#include <array>

#include <stereo_reference/method.hpp>
#include <stereo_reference/middlebury.hpp>

namespace finback::stereo_reference {

// In the order of the curves.
inline constexpr std::array kCompared = {Method::rank3, Method::rank5, Method::census3};

struct TrialError {
  double of_all = 0;    // percent bad, pixels without a disparity as bad
  double of_valid = 0;  // percent bad of the pixels with a disparity
};

// `non_occluded`: where to look, not 0. Disparities from 1 to `largest`.
[[nodiscard]] TrialError try_method(Method method, const ByteImage& left, const ByteImage& right,
                                    const FloatImage& truth, const ByteImage& non_occluded,
                                    int largest);

// 255 where a sample's left truth is known and seen in the right view; by both truths where there
// are two.
[[nodiscard]] ByteImage non_occluded_mask(const StereoSample& sample);

}  // namespace finback::stereo_reference
