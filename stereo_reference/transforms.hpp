// Transforms of an image that make matching blind to brightness: rank and census.
//
// Models: Ahuja 2009, A.16 and A.17: how many neighbours, or which, are darker than the centre.
// Pixels whose window does not lie inside the image are 0. census_3x3, in bytes, stands in
// matching.hpp, where the firmware's own chain is.
#pragma once

#include <cstdint>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

// What the matchers compare: grey values, ranks, or strings of up to 32 bits.
using WordImage = scenes::Image<std::uint32_t>;

// The neighbours that are less than the centre, counted. Throws InputError for an even window, one
// outside 1..255, or an empty image.
[[nodiscard]] WordImage rank_transform(const scenes::ByteImage& image, int window);

// A bit for each neighbour, row by row, the upper left one highest: 1 where it is less than the
// centre. 8 bits for a window of 3, 24 for 5. Throws InputError for another window or an empty
// image.
[[nodiscard]] WordImage census_transform(const scenes::ByteImage& image, int window);

// The grey values themselves.
[[nodiscard]] WordImage as_words(const scenes::ByteImage& image);

}  // namespace finback::stereo_reference
