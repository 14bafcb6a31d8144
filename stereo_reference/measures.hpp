// Matching by any of the thesis's similarity measures, in both directions.
//
// Models: SAD, SSD, NCC and SHD over a square window, right and left reference (Ahuja 2009, table
// 6; A.9-A.12, A.18, A.19). Sums are whole numbers, so that the fast form, by running sums, equals
// the plain one in every pixel. Conventions of positions, candidates and ties are those of
// matching.hpp; NCC takes the largest, and a window without any light scores 0. Does not model:
// sub-pixel disparities.
#pragma once

#include <stereo_reference/matching.hpp>
#include <stereo_reference/transforms.hpp>

namespace finback::stereo_reference {

enum class Measure : std::uint8_t {
  sad,  // sum of absolute differences
  ssd,  // sum of squared differences
  ncc,  // normalised cross-correlation, not centred
  shd,  // sum of Hamming distances
};

// One window at a time. Throws InputError when the images differ in size, the window is even, the
// range of disparities is empty or no candidate fits; for NCC and SSD, when a value is over 65535.
[[nodiscard]] DisparityPair match_by_plain(Measure measure, const WordImage& left,
                                           const WordImage& right,
                                           const MatchParameters& parameters);
// The same maps; the cost of a candidate does not depend on the window.
[[nodiscard]] DisparityPair match_by(Measure measure, const WordImage& left, const WordImage& right,
                                     const MatchParameters& parameters);

}  // namespace finback::stereo_reference
