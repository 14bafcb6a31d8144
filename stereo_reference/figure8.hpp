// Figure 8: how far away a disparity is, and how exactly that is known.
//
// Models: two parallel pinhole cameras: range = b f / (d p), uncertainty = r^2 p dN / (b f) for a
// disparity known to dN pixels (Ahuja 2009, 3.1, equation 2). Does not model: lenses, matching
// errors.
#pragma once

#include <stereo_reference/experiment.hpp>

namespace finback::stereo_reference {

struct RangeGeometry {
  double baseline = 28;       // mm
  double focal = 2.8;         // mm
  double pixel = 0.017;       // mm, at 160x120
  int disparity_min = 5;      // the camera's horopter
  int disparity_max = 35;     //
  double disparity_step = 1;  // pixels, dN

  [[nodiscard]] double range(double disparity) const {
    return baseline * focal / (disparity * pixel);
  }
  [[nodiscard]] double uncertainty(double range) const {
    return range * range * pixel * disparity_step / (baseline * focal);
  }
};

// Throws InputError for lengths that are not positive and an empty range of disparities.
[[nodiscard]] Experiment figure8_experiment(const RangeGeometry& geometry);

}  // namespace finback::stereo_reference
