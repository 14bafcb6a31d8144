#include <Eigen/Dense>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include <common/error.hpp>
#include <stereo_reference/projection.hpp>
#include <stereo_reference/rotation.hpp>

namespace finback::stereo_reference {

namespace {

using Distortion = Eigen::Matrix<double, 5, 1>;
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;

// The factor along the radius, and what the tangential part adds.
struct LensAt {
  double radial = 1;
  Vector2d tangential;
};

LensAt lens_at(const Vector2d& p, const Distortion& k) {
  const double r2 = p.squaredNorm();
  const double xy = p.x() * p.y();
  return {1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4])),
          {2 * k[2] * xy + k[3] * (r2 + 2 * p.x() * p.x()),
           k[2] * (r2 + 2 * p.y() * p.y()) + 2 * k[3] * xy}};
}

Vector2d distorted(const Vector2d& p, const Distortion& k) {
  const LensAt lens = lens_at(p, k);
  return p * lens.radial + lens.tangential;
}

// Of the distorted point by the undistorted one.
Matrix2d by_point(const Vector2d& p, const Distortion& k) {
  const double r2 = p.squaredNorm();
  const double radial_slope = k[0] + r2 * (2 * k[1] + r2 * 3 * k[4]);  // by r^2
  Matrix2d slope =
      Matrix2d::Identity() * lens_at(p, k).radial + 2 * radial_slope * p * p.transpose();
  slope(0, 0) += 2 * k[2] * p.y() + 6 * k[3] * p.x();
  slope(0, 1) += 2 * k[2] * p.x() + 2 * k[3] * p.y();
  slope(1, 0) += 2 * k[2] * p.x() + 2 * k[3] * p.y();
  slope(1, 1) += 6 * k[2] * p.y() + 2 * k[3] * p.x();
  return slope;
}

Eigen::Matrix<double, 2, 5> by_coefficients(const Vector2d& p) {
  const double r2 = p.squaredNorm();
  const double xy = p.x() * p.y();
  Eigen::Matrix<double, 2, 5> slope;
  slope.col(0) = p * r2;
  slope.col(1) = p * r2 * r2;
  slope.col(2) << 2 * xy, r2 + 2 * p.y() * p.y();
  slope.col(3) << r2 + 2 * p.x() * p.x(), 2 * xy;
  slope.col(4) = p * r2 * r2 * r2;
  return slope;
}

}  // namespace

MovedPoints move_points(const Points3& points, const Pose& pose) {
  const RotationMatrix rotation = rodrigues(pose.rotation);
  MovedPoints moved;
  moved.points = (rotation.matrix * points).colwise() + pose.translation;
  moved.by_rotation.resize(3 * points.cols(), 3);
  moved.by_translation.resize(3 * points.cols(), 3);
  for (Index n = 0; n < points.cols(); ++n) {
    for (Index i = 0; i < 3; ++i) {
      const Eigen::Matrix3d change = rotation.by_vector.col(i).reshaped(3, 3);
      moved.by_rotation.block<3, 1>(3 * n, i) = change * points.col(n);
    }
    moved.by_translation.middleRows<3>(3 * n).setIdentity();
  }
  return moved;
}

ProjectedPoints project_points(const Points3& points, const Pose& pose, const Intrinsics& camera) {
  const MovedPoints moved = move_points(points, pose);
  const Index count = points.cols();
  ProjectedPoints result;
  result.pixels.resize(2, count);
  result.by_rotation.resize(2 * count, 3);
  result.by_translation.resize(2 * count, 3);
  result.by_focal.setZero(2 * count, 2);
  result.by_principal.resize(2 * count, 2);
  result.by_distortion.resize(2 * count, 5);
  result.by_skew.setZero(2 * count);
  Matrix2d to_pixels;
  to_pixels << camera.focal.x(), camera.focal.x() * camera.skew, 0, camera.focal.y();
  for (Index n = 0; n < count; ++n) {
    const Eigen::Vector3d p = moved.points.col(n);
    if (p.z() == 0) {
      throw InputError(fmt::format("point {} lies in the plane of the camera: depth 0", n));
    }
    const Vector2d plane = p.head<2>() / p.z();
    const Vector2d seen = distorted(plane, camera.distortion);
    result.pixels.col(n) = to_pixels * seen + camera.principal;

    Eigen::Matrix<double, 2, 3> by_moved;
    by_moved << Matrix2d::Identity() / p.z(), -plane / p.z();
    by_moved = to_pixels * by_point(plane, camera.distortion) * by_moved;
    const Index row = 2 * n;
    result.by_rotation.middleRows<2>(row) = by_moved * moved.by_rotation.middleRows<3>(3 * n);
    result.by_translation.middleRows<2>(row) = by_moved;
    result.by_focal(row, 0) = seen.x() + camera.skew * seen.y();
    result.by_focal(row + 1, 1) = seen.y();
    result.by_principal.middleRows<2>(row).setIdentity();
    result.by_distortion.middleRows<2>(row) = to_pixels * by_coefficients(plane);
    result.by_skew[row] = camera.focal.x() * seen.y();
  }
  return result;
}

Points2 distort(const Points2& points, const Distortion& distortion) {
  Points2 result(2, points.cols());
  for (Index n = 0; n < points.cols(); ++n) {
    result.col(n) = distorted(points.col(n), distortion);
  }
  return result;
}

double fold_radius(const Distortion& distortion) {
  // Of r (1 + k1 r^2 + k2 r^4 + k3 r^6), by r; `square` is r^2.
  const auto slope = [&](double square) {
    return 1 +
           square * (3 * distortion[0] + square * (5 * distortion[1] + square * 7 * distortion[4]));
  };
  constexpr double kStep = 1.0 / 128;
  constexpr double kFarthest = 16;
  double low = 0;
  while (low < kFarthest && slope(low + kStep) > 0) {
    low += kStep;
  }
  if (low >= kFarthest) {
    return std::numeric_limits<double>::infinity();
  }
  double high = low + kStep;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (low + high) / 2;
    (slope(middle) > 0 ? low : high) = middle;
  }
  return std::sqrt(low);
}

namespace {

Vector2d within(const Vector2d& p, double radius) {
  return p.norm() > radius ? Vector2d(p * (radius / p.norm())) : p;
}

// Newton's steps, as long as they come nearer: the fixed point is slow where the lens bends much.
Vector2d polished(Vector2d p, const Vector2d& seen, const Distortion& distortion, double fold) {
  constexpr int kRounds = 10;
  double error = (distorted(p, distortion) - seen).norm();
  for (int round = 0; round < kRounds; ++round) {
    const Matrix2d slope = by_point(p, distortion);
    if (slope.determinant() == 0) {
      break;
    }
    const Vector2d better = within(p - slope.inverse() * (distorted(p, distortion) - seen), fold);
    const double left = (distorted(better, distortion) - seen).norm();
    if (!(left < error)) {
      break;
    }
    p = better;
    error = left;
  }
  return p;
}

}  // namespace

Points2 undistort(const Points2& points, const Distortion& distortion) {
  constexpr int kRounds = 20;
  const double fold = fold_radius(distortion);
  Points2 result = points;
  for (Index n = 0; n < points.cols(); ++n) {
    Vector2d p = points.col(n);
    for (int round = 0; round < kRounds; ++round) {
      const LensAt lens = lens_at(p, distortion);
      p = within((points.col(n) - lens.tangential) / lens.radial, fold);
    }
    result.col(n) = polished(p, points.col(n), distortion, fold);
  }
  return result;
}

Points2 normalize_pixels(const Points2& pixels, const Intrinsics& camera) {
  Points2 plane = (pixels.colwise() - camera.principal).array().colwise() / camera.focal.array();
  plane.row(0) -= camera.skew * plane.row(1);
  return undistort(plane, camera.distortion);
}

}  // namespace finback::stereo_reference
