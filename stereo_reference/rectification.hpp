// Rectification: two calibrated cameras made to see along parallel rows, and the tables that do it.
//
// Models: both cameras turned by as little as possible, half of their relative rotation each, then
// together until the baseline lies along x (or y: cameras one above the other); new intrinsics that
// keep the pictures filled; for each rectified pixel the place in the camera's picture, bilinear
// sampling (Ahuja 2009, A.1; 3.4 for the firmware's tables). Tangential distortion can be left out,
// as the firmware does. Does not model: cropping to the commonly visible part.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <scenes/image.hpp>
#include <stereo_reference/projection.hpp>

namespace finback::stereo_reference {

// A pair of cameras with pictures of the same size.
struct StereoCalibration {
  int width = 0;  // pixels
  int height = 0;
  Intrinsics left;
  Intrinsics right;
  Pose left_to_right;  // a point of the left camera's space, seen from the right one
};

struct RectifiedPair {
  Eigen::Matrix3d left_rotation;   // from the camera's space to the rectified one
  Eigen::Matrix3d right_rotation;  //
  Intrinsics left;                 // without distortion and skew
  Intrinsics right;
  Eigen::Vector3d translation;  // left to right, in the rectified space: one component is not 0
  bool vertical = false;        // the cameras stand one above the other: columns match, not rows
};

// Throws InputError where the calibration has a value that is no number, a focal length that is not
// positive, no baseline or no pixels.
[[nodiscard]] RectifiedPair rectify(const StereoCalibration& calibration);

// The same cameras with pictures of every n-th pixel of every n-th row, beginning with the first.
// Throws InputError where n does not divide the size.
[[nodiscard]] StereoCalibration subsampled(const StereoCalibration& calibration, int n);

// For every rectified pixel, row by row, where it lies in the camera's picture; (-1, -1) where the
// lens's polynomial is past its fold and tells of places that it does not see.
struct PixelMap {
  int width = 0;
  int height = 0;
  Points2 sources;
};
// `tangential` false: the coefficients p1 and p2 count as 0.
[[nodiscard]] PixelMap pixel_map(const Intrinsics& camera, const Eigen::Matrix3d& rotation,
                                 const Intrinsics& rectified, int width, int height,
                                 bool tangential = true);

// The picture in the rectified camera, rounded to the nearest grey; 0 where the camera did not see.
// Throws InputError where picture and map differ in size.
[[nodiscard]] scenes::ByteImage remap(const scenes::ByteImage& image, const PixelMap& map);

// What the firmware has of a map: for each pixel the upper left one of four neighbours, and their
// weights as fractions of 1.15 that sum to at most 1.
struct RectificationTable {
  int width = 0;  // at most 256
  int height = 0;
  std::vector<std::uint8_t> column;
  std::vector<std::uint8_t> row;
  // Upper left, upper right, lower left, lower right; all 0 where the camera did not see.
  std::vector<std::array<std::int16_t, 4>> weights;
};
// Throws InputError for pictures of more than 256 columns or rows.
[[nodiscard]] RectificationTable rectification_table(const PixelMap& map);

// The firmware's arithmetic: products summed in 40 bits, rounded once.
[[nodiscard]] scenes::ByteImage remap(const scenes::ByteImage& image,
                                      const RectificationTable& table);

}  // namespace finback::stereo_reference
