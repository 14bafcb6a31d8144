// Census transform and matching by the sum of Hamming distances (SHD): the truth that the firmware
// is held against, pixel for pixel.
//
// Models: the exact integer results of MESVS-II's matching (Ahuja 2009, 3.4 and A.13, A.17-A.19).
// Does not model: time, memory, sub-pixel disparities, rectification, post-processing.
//
// Convention. A left pixel x is seen in the right image at x - d, d > 0. The final map is that of
// the LEFT image, so it can be compared with the ground truth of the left view. 0 is "invalid".
//
// What is computed. With window w = 2n + 1 on images of W x H, candidate (x, y, d) is the match of
// left (x, y) with right (x - d, y). It takes part where both windows lie wholly inside the images:
//     n + d <= x <= W - 1 - n  and  n <= y <= H - 1 - n.
// A pixel of the left map is the best of its candidates, dmin <= d <= dmax; so is a pixel of the
// right map, whose candidates are (x + d, y, d). A pixel without candidates is not computed and
// stays 0: in the left map those with x < n + dmin, the n last columns, the n first and last rows.
// The border pixels of a census image are 0 and take part as they are.
#pragma once

#include <cstdint>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

using scenes::ByteImage;
using scenes::FloatImage;

struct MatchParameters {
  int window = 15;         // side of the square window, odd, 1 .. 255
  int disparity_min = 5;   // 1 .. 255: 0 marks invalid pixels
  int disparity_max = 35;  // disparity_min .. 255, inclusive

  [[nodiscard]] int half_window() const { return window / 2; }
};

// A pair of maps that were computed from the same scores.
struct DisparityPair {
  ByteImage left;   // disparity of each left pixel, 0 invalid
  ByteImage right;  // disparity of each right pixel, 0 invalid
};

// Columns [left, right) and rows [top, bottom) of an image.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  friend bool operator==(const Region&, const Region&) = default;
};

struct ImageSize {
  int width = 0;
  int height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

// Throws InputError when the images of a pair differ in size, the window is even, the range of
// disparities is empty or no candidate fits into the image: what every matcher asks for.
void check_match_arguments(const ImageSize& left, const ImageSize& right,
                           const MatchParameters& parameters);

// The pixels of the left map that are computed (see above).
[[nodiscard]] Region computed_region(int width, int height, const MatchParameters& parameters);

// Census transform 3x3: bit 7 for the upper left neighbour, then row by row to bit 0 for the lower
// right one; a bit is 1 where the neighbour is less than the centre. Border pixels are 0.
// Throws InputError on an empty image.
[[nodiscard]] ByteImage census_3x3(const ByteImage& image);

// SHD matching in the plain form: every window summed anew. The score of a candidate is the number
// of different bits in the two windows; the smallest score wins, a tie keeps the smaller disparity.
// Throws InputError when the images differ in size, the window is even, the disparity range is
// empty or no candidate fits into the image.
[[nodiscard]] ByteImage match_left_plain(const ByteImage& left_census,
                                         const ByteImage& right_census,
                                         const MatchParameters& parameters);
[[nodiscard]] ByteImage match_right_plain(const ByteImage& left_census,
                                          const ByteImage& right_census,
                                          const MatchParameters& parameters);

// The same two maps by vertical, horizontal and modular recursion, in one pass over the scores:
// the cost of a candidate does not depend on the window. Equal to the plain form in every pixel.
[[nodiscard]] DisparityPair match_recursive(const ByteImage& left_census,
                                            const ByteImage& right_census,
                                            const MatchParameters& parameters);

// Left-right consistency: a left disparity d at x is kept where right(x - d) is valid and
// |right(x - d) - d| <= threshold, else 0. Throws InputError when the maps differ in size or the
// threshold is negative.
[[nodiscard]] ByteImage check_left_right(const DisparityPair& maps, int threshold = 1);

// Census, recursive matching and the left-right check: what MESVS-II makes of a rectified pair
// before post-processing (texture.hpp). Throws what these throw.
[[nodiscard]] ByteImage disparity_map(const ByteImage& left, const ByteImage& right,
                                      const MatchParameters& parameters, int threshold = 1);

// Every 4th pixel of every 4th row, beginning with the first: 640x480 becomes 160x120.
[[nodiscard]] ByteImage subsample_by_4(const ByteImage& image);

}  // namespace finback::stereo_reference
