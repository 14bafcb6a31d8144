// Regions of a picture that matching finds hard: occluded, at depth discontinuities, without
// texture.
//
// Models: Ahuja 2009, A.20 to A.22, on disparities in pixels and on grey pictures; after Scharstein
// and Szeliski's taxonomy, as the thesis. A mask is 255 where the pixel belongs to the region, else
// 0. Where the listings leave the border undecided, windows are cut off at the picture's edge.
#pragma once

#include <scenes/image.hpp>

namespace finback::stereo_reference {

using scenes::ByteImage;
using scenes::FloatImage;

// Pixels of the left view whose disparity, known (not 0), does not lead to a pixel of the right
// view whose own, known disparity leads back to within `threshold` pixels: hidden, or outside.
// Unknown pixels are in the mask. Throws InputError when the sizes differ or the threshold is not
// positive.
[[nodiscard]] ByteImage occluded_mask(const FloatImage& left, const FloatImage& right,
                                      double threshold = 1.0);

// The same from the left view's disparities alone: hidden is what lands, to the nearest pixel,
// where another of its row with a disparity larger by more than `threshold` lands, too.
[[nodiscard]] ByteImage occluded_mask(const FloatImage& left, double threshold = 1.0);

// Pixels within a square window of side `window` of a step between two neighbours, with known
// disparities, of more than `gap` pixels. Throws InputError for an even window, a gap that is not
// positive or an empty map.
[[nodiscard]] ByteImage discontinuity_mask(const FloatImage& disparity, int window = 9,
                                           double gap = 3.0);

// Pixels around which the squared horizontal gradient, the larger of both neighbours', averages to
// less than threshold squared over a square window. Throws InputError for an even window, a
// threshold that is not positive or an empty picture.
[[nodiscard]] ByteImage textureless_mask(const ByteImage& image, int window = 9,
                                         double threshold = 4.0);

}  // namespace finback::stereo_reference
