// How good a disparity map is against ground truth: bad pixels and RMS error.
//
// Models: Ahuja 2009, A.14 and A.15, with disparities of both in pixels. Ground truth 0 is unknown
// and left out. An invalid pixel of the map (0) counts as bad, as its error is its whole disparity;
// the figures without invalid pixels stand beside.
#pragma once

#include <stereo_reference/matching.hpp>

namespace finback::stereo_reference {

struct MapQuality {
  int compared = 0;            // pixels inside the region whose truth is known
  int invalid = 0;             // of these, 0 in the map
  int wrong = 0;               // of these, valid but more than delta away from the truth
  double rms_error = 0;        // pixels, invalid ones counted as disparity 0 (A.14)
  double rms_error_valid = 0;  // pixels, over the valid ones only

  // Shares in percent; 0 when nothing is compared.
  [[nodiscard]] double bad_percent() const;    // (invalid + wrong) / compared (A.15)
  [[nodiscard]] double wrong_percent() const;  // wrong / (compared - invalid)
};

// The image without a border of so many pixels on every side.
[[nodiscard]] Region inner_region(int width, int height, int border);

// Compares inside `region`. Throws InputError when the sizes differ, delta is negative or the
// region does not lie inside the map.
[[nodiscard]] MapQuality evaluate(const ByteImage& map, const FloatImage& truth,
                                  const Region& region, double delta = 1.0);
// The same over the pixels whose mask is not 0. Throws also when the mask has another size.
[[nodiscard]] MapQuality evaluate(const ByteImage& map, const FloatImage& truth,
                                  const Region& region, const ByteImage& mask, double delta);

}  // namespace finback::stereo_reference
