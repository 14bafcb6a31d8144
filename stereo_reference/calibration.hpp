// Two cameras measured by photographs of a checkerboard.
//
// Models: each camera alone first (focal lengths, principal point, k1, k2, p1, p2), then both and
// their relative position together, by OpenCV's optimiser; errors in pixels by projecting the
// boards with project_points. Does not model: skew and the sixth power of the radius (they stay 0),
// cameras with pictures of different sizes, boards that are not flat.
#pragma once

#include <vector>

#include <stereo_reference/checkerboard.hpp>
#include <stereo_reference/rectification.hpp>

namespace finback::stereo_reference {

struct CalibrationFit {
  StereoCalibration calibration;
  // Root of the mean squared distance of found and projected corners, pixels.
  double left_rms = 0;   // the left camera by itself
  double right_rms = 0;  // the right camera by itself
  double rms = 0;        // both together, with one position of the board for both views
};

// Throws InputError for fewer than three pairs, another number of corners than the board has, and
// photographs that OpenCV finds no cameras for.
[[nodiscard]] CalibrationFit calibrate(const std::vector<BoardPair>& pairs, const Board& board,
                                       int width, int height);

// How far rows differ (columns, for cameras one above the other) where both rectified cameras see
// the same corner: what is left for matching along rows. Pixels.
struct RowErrors {
  double mean = 0;  // signed: a shift of one picture
  double rms = 0;   // detection's own error is in it
  double largest = 0;
  double slope = 0;  // over the picture's width: a turn of one picture
};
[[nodiscard]] RowErrors row_errors(const StereoCalibration& calibration,
                                   const std::vector<BoardPair>& pairs);

}  // namespace finback::stereo_reference
