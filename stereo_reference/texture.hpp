// Local variance, and what it says about disparities: the last step of the system.
//
// Models: Ahuja 2009, A.27 (sample variance over a square window, divided by n^2 - 1) and A.28 with
// equation 19: a disparity is given up where the image has no texture and the disparities
// contradict each other. Pixels whose window does not lie inside the image have the variance 0.
// Does not model: the listing's binary maps, of which the second is compared with the wrong
// threshold.
#pragma once

#include <cstdint>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

// Throws InputError for an empty image, an even window or one outside 3..255.
[[nodiscard]] scenes::Image<double> variance_map(const scenes::ByteImage& image, int window);

struct PostProcessing {
  int window = 9;
  double texture_threshold = 135;   // T_L, squared grey levels
  double disparity_threshold = 17;  // T_H, squared pixels
  // Equation 19 wants both; the listing of A.28 is content with either.
  bool either = false;
};

// The map with 0 where the rule holds. `image` is the one that the map belongs to. Throws
// InputError when the sizes differ, and what variance_map throws.
[[nodiscard]] scenes::ByteImage post_process(const scenes::ByteImage& map,
                                             const scenes::ByteImage& image,
                                             const PostProcessing& how = {});

}  // namespace finback::stereo_reference
