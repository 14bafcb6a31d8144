#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <stereo_reference/rectification.hpp>
#include <stereo_reference/rotation.hpp>

namespace finback::stereo_reference {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scenes::ByteImage;

void check(const Intrinsics& camera, const char* which) {
  const bool numbers = camera.focal.allFinite() && camera.principal.allFinite() &&
                       camera.distortion.allFinite() && std::isfinite(camera.skew);
  if (!numbers) {
    throw InputError(fmt::format("calibration: {} camera has values that are no numbers", which));
  }
  if (camera.focal.minCoeff() <= 0) {
    throw InputError(
        fmt::format("calibration: {} camera has the focal lengths {} and {} pixels; "
                    "they must be positive",
                    which, camera.focal.x(), camera.focal.y()));
  }
}

void check(const StereoCalibration& c) {
  if (c.width < 1 || c.height < 1) {
    throw InputError(fmt::format("calibration: pictures of {} x {} pixels", c.width, c.height));
  }
  check(c.left, "the left");
  check(c.right, "the right");
  if (!c.left_to_right.rotation.allFinite() || !c.left_to_right.translation.allFinite()) {
    throw InputError("calibration: the cameras' positions have values that are no numbers");
  }
  if (c.left_to_right.translation.isZero()) {
    throw InputError("calibration: the cameras stand in one place: there is no baseline");
  }
}

// The turn by the shortest way that brings `from` onto `axis` or its opposite.
Matrix3d turn_onto(const Vector3d& from, const Vector3d& axis) {
  const Vector3d target = axis.dot(from) < 0 ? Vector3d(-axis) : axis;
  const Vector3d around = from.cross(target);
  if (around.norm() <= 1e-15 * from.norm()) {
    return Matrix3d::Identity();
  }
  const double angle = std::atan2(around.norm(), from.dot(target));
  return rodrigues(Vector3d(around.normalized() * angle)).matrix;
}

// A focal length at which a picture with barrel distortion keeps its corners.
double kept_focal(const Intrinsics& camera, int width, int height) {
  const double f = camera.focal.y();
  const double k1 = std::min(camera.distortion[0], 0.0);
  return f * (1 + k1 * (double{1} * width * width + double{1} * height * height) / (4 * f * f));
}

// The principal point that puts the picture's corners around the middle.
Vector2d centred(const Intrinsics& camera, const Matrix3d& rotation, double focal, int width,
                 int height) {
  const double right = width - 1;
  const double bottom = height - 1;
  Points2 corners(2, 4);
  corners << 0, right, right, 0, 0, 0, bottom, bottom;
  const Points2 plane = normalize_pixels(corners, camera);
  Vector2d mean = Vector2d::Zero();
  for (Index n = 0; n < corners.cols(); ++n) {
    const Vector3d seen = rotation * plane.col(n).homogeneous();
    mean += focal * seen.head<2>() / seen.z() / static_cast<double>(corners.cols());
  }
  return Vector2d(right / 2, bottom / 2) - mean;
}

}  // namespace

RectifiedPair rectify(const StereoCalibration& calibration) {
  check(calibration);
  const Vector3d half = calibration.left_to_right.rotation / -2;
  const Matrix3d right_half = rodrigues(half).matrix;
  const Vector3d baseline = right_half * calibration.left_to_right.translation;
  RectifiedPair pair;
  pair.vertical = std::abs(baseline.y()) > std::abs(baseline.x());
  const Matrix3d turn =
      turn_onto(baseline, pair.vertical ? Vector3d(Vector3d::UnitY()) : Vector3d::UnitX());
  pair.left_rotation = turn * right_half.transpose();
  pair.right_rotation = turn * right_half;
  pair.translation = pair.right_rotation * calibration.left_to_right.translation;

  const int width = calibration.width;
  const int height = calibration.height;
  const double focal = std::round(std::min(kept_focal(calibration.left, width, height),
                                           kept_focal(calibration.right, width, height)));
  pair.left.focal = pair.right.focal = {focal, focal};
  pair.left.principal = centred(calibration.left, pair.left_rotation, focal, width, height);
  pair.right.principal = centred(calibration.right, pair.right_rotation, focal, width, height);
  // What matches along rows must have the same row, or column, in both.
  const Index shared = pair.vertical ? 0 : 1;
  const double mean = (pair.left.principal[shared] + pair.right.principal[shared]) / 2;
  pair.left.principal[shared] = pair.right.principal[shared] = mean;
  return pair;
}

StereoCalibration subsampled(const StereoCalibration& calibration, int n) {
  if (n < 1 || calibration.width % n != 0 || calibration.height % n != 0) {
    throw InputError(fmt::format("calibration: pictures of {} x {} cannot be sub-sampled by {}",
                                 calibration.width, calibration.height, n));
  }
  StereoCalibration result = calibration;
  result.width /= n;
  result.height /= n;
  for (Intrinsics* camera : {&result.left, &result.right}) {
    camera->focal /= n;
    camera->principal /= n;
  }
  return result;
}

PixelMap pixel_map(const Intrinsics& camera, const Matrix3d& rotation, const Intrinsics& rectified,
                   int width, int height, bool tangential) {
  PixelMap map{width, height, Points2(2, Index{width} * height)};
  Points2 plane(2, map.sources.cols());
  for (Index n = 0; n < plane.cols(); ++n) {
    const Index row = n / width;
    const Vector2d pixel(static_cast<double>(n % width), static_cast<double>(row));
    const Vector2d seen = (pixel - rectified.principal).cwiseQuotient(rectified.focal);
    plane.col(n) = (rotation.transpose() * seen.homogeneous()).hnormalized();
  }
  Eigen::Matrix<double, 5, 1> distortion = camera.distortion;
  if (!tangential) {
    distortion.segment<2>(2).setZero();
  }
  const Points2 rays = plane;
  plane = distort(plane, distortion);
  plane.row(0) += camera.skew * plane.row(1);
  map.sources =
      (plane.array().colwise() * camera.focal.array()).matrix().colwise() + camera.principal;
  const double fold = fold_radius(distortion);
  for (Index n = 0; n < rays.cols(); ++n) {
    if (rays.col(n).norm() > fold) {
      map.sources.col(n).setConstant(-1);
    }
  }
  return map;
}

namespace {

// The upper left one of the four neighbours, and the place between them; false: not in the picture.
struct Cell {
  int x = 0;
  int y = 0;
  double right = 0;  // 0 to 1
  double down = 0;
};

bool find_cell(const Vector2d& at, int width, int height, Cell& cell) {
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() <= width - 1 && at.y() <= height - 1)) {
    return false;
  }
  // The last column and row are the right and lower neighbours of the ones before.
  cell.x = std::min(static_cast<int>(at.x()), std::max(width - 2, 0));
  cell.y = std::min(static_cast<int>(at.y()), std::max(height - 2, 0));
  cell.right = at.x() - cell.x;
  cell.down = at.y() - cell.y;
  return true;
}

std::array<double, 4> weights_of(const Cell& c) {
  return {(1 - c.right) * (1 - c.down), c.right * (1 - c.down), (1 - c.right) * c.down,
          c.right * c.down};
}

std::array<std::uint8_t, 4> neighbours(const ByteImage& image, int x, int y) {
  const int right = std::min(x + 1, image.width() - 1);
  const int below = std::min(y + 1, image.height() - 1);
  return {image.at(x, y), image.at(right, y), image.at(x, below), image.at(right, below)};
}

void check_size(const ByteImage& image, int width, int height) {
  if (image.width() != width || image.height() != height) {
    throw InputError(fmt::format("rectification: the picture has {} x {} pixels, its table {} x {}",
                                 image.width(), image.height(), width, height));
  }
}

}  // namespace

ByteImage remap(const ByteImage& image, const PixelMap& map) {
  check_size(image, map.width, map.height);
  ByteImage result(map.width, map.height);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      Cell cell;
      if (!find_cell(map.sources.col(Index{y} * map.width + x), map.width, map.height, cell)) {
        continue;
      }
      const auto weights = weights_of(cell);
      const auto greys = neighbours(image, cell.x, cell.y);
      double sum = 0.5;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i] * greys[i];
      }
      result.at(x, y) = static_cast<std::uint8_t>(sum);
    }
  }
  return result;
}

RectificationTable rectification_table(const PixelMap& map) {
  constexpr int kMost = 256;
  constexpr double kOne = 32768;
  if (map.width > kMost || map.height > kMost) {
    throw InputError(
        fmt::format("rectification table: {} x {} pixels; columns and rows are bytes, "
                    "at most {}",
                    map.width, map.height, kMost));
  }
  const auto pixels = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  RectificationTable table{map.width, map.height, std::vector<std::uint8_t>(pixels),
                           std::vector<std::uint8_t>(pixels),
                           std::vector<std::array<std::int16_t, 4>>(pixels)};
  for (std::size_t n = 0; n < pixels; ++n) {
    Cell cell;
    if (!find_cell(map.sources.col(static_cast<Index>(n)), map.width, map.height, cell)) {
      continue;
    }
    table.column[n] = static_cast<std::uint8_t>(cell.x);
    table.row[n] = static_cast<std::uint8_t>(cell.y);
    const auto weights = weights_of(cell);
    // 1 itself is one too large; what rounding adds or takes goes to the largest weight.
    int sum = 0;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const int weight = std::min(static_cast<int>(std::lround(weights[i] * kOne)), 32767);
      table.weights[n][i] = static_cast<std::int16_t>(weight);
      sum += weight;
      largest = weights[i] > weights[largest] ? i : largest;
    }
    const int excess = std::max(sum - 32768, 0);
    table.weights[n][largest] = static_cast<std::int16_t>(table.weights[n][largest] - excess);
  }
  return table;
}

ByteImage remap(const ByteImage& image, const RectificationTable& table) {
  check_size(image, table.width, table.height);
  ByteImage result(table.width, table.height);
  for (int y = 0; y < table.height; ++y) {
    for (int x = 0; x < table.width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(table.width) +
                            static_cast<std::size_t>(x);
      const auto greys = neighbours(image, table.column[n], table.row[n]);
      std::int64_t sum = 1 << 14;
      for (std::size_t i = 0; i < greys.size(); ++i) {
        sum += std::int64_t{table.weights[n][i]} * greys[i];
      }
      result.at(x, y) = static_cast<std::uint8_t>(sum >> 15);
    }
  }
  return result;
}

}  // namespace finback::stereo_reference
