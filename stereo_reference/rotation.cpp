#include <Eigen/Dense>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <stereo_reference/rotation.hpp>

namespace finback::stereo_reference {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// R = I + a [w] + b [w]^2 for a vector w of length angle: the factors, and their derivatives by
// angle, divided by it.
struct Factors {
  double a = 0;        // sin / angle
  double b = 0;        // (1 - cos) / angle^2
  double a_slope = 0;  // (cos - a) / angle^2
  double b_slope = 0;  // (a - 2 b) / angle^2
};

Factors factors_of(double squared_angle) {
  constexpr double kSmall = 1e-4;  // below, differences of near equals lose more than the series
  const double s = squared_angle;
  if (s < kSmall) {
    return {1 - s / 6 + s * s / 120, 0.5 - s / 24 + s * s / 720, -1.0 / 3 + s / 30 - s * s / 840,
            -1.0 / 12 + s / 180 - s * s / 6720};
  }
  const double angle = std::sqrt(s);
  const double half = std::sin(angle / 2);
  Factors f;
  f.a = std::sin(angle) / angle;
  f.b = 2 * half * half / s;
  f.a_slope = (std::cos(angle) - f.a) / s;
  f.b_slope = (f.a - 2 * f.b) / s;
  return f;
}

Matrix3d nearest_rotation(const Matrix3d& matrix) {
  constexpr double kFar = 1e-2;
  if (!matrix.allFinite()) {
    throw InputError("rotation matrix: it has elements that are no numbers");
  }
  const Eigen::JacobiSVD<Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  const double off = (nearest - matrix).cwiseAbs().maxCoeff();
  if (nearest.determinant() < 0 || off > kFar) {
    throw InputError(fmt::format(
        "rotation matrix: {}", nearest.determinant() < 0
                                   ? std::string("it is a reflection, its determinant is negative")
                                   : fmt::format("an element is {:.3g} off any rotation", off)));
  }
  return nearest;
}

// Axis times angle by the unit quaternion, of which the largest part is found first: no division by
// a small number at any angle.
Vector3d vector_of(const Matrix3d& r) {
  const Eigen::Quaterniond q(r);
  const double length = q.vec().norm();
  if (length == 0) {
    return Vector3d::Zero();
  }
  double angle = 2 * std::atan2(length, std::abs(q.w()));
  Vector3d vector = q.vec() * (angle / length);
  constexpr double kHalfTurn = 1e-12;
  if (std::abs(q.w()) > kHalfTurn) {
    return q.w() < 0 ? Vector3d(-vector) : vector;
  }
  for (const double component : vector) {
    if (std::abs(component) > kHalfTurn) {
      return component < 0 ? Vector3d(-vector) : vector;
    }
  }
  return vector;
}

}  // namespace

Matrix3d skew_3(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

RotationMatrix rodrigues(const Vector3d& vector) {
  const Matrix3d w = skew_3(vector);
  const Matrix3d w2 = w * w;
  const Factors f = factors_of(vector.squaredNorm());
  RotationMatrix result;
  result.matrix = Matrix3d::Identity() + f.a * w + f.b * w2;
  for (int i = 0; i < 3; ++i) {
    const Matrix3d e = skew_3(Vector3d::Unit(i));
    const Matrix3d change =
        f.a_slope * vector[i] * w + f.a * e + f.b_slope * vector[i] * w2 + f.b * (e * w + w * e);
    result.by_vector.col(i) = change.reshaped();
  }
  return result;
}

RotationVector rodrigues(const Matrix3d& matrix) {
  RotationVector result;
  result.vector = vector_of(nearest_rotation(matrix));
  // The rotations are a surface of three dimensions among the matrices; `across` spans its plane.
  const Matrix93 across = rodrigues(result.vector).by_vector;
  result.by_matrix = (across.transpose() * across).ldlt().solve(across.transpose());
  return result;
}

ProductDerivatives product_derivatives(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.cols() != b.rows()) {
    throw InputError(fmt::format("product of {} x {} and {} x {}: the inner sizes differ", a.rows(),
                                 a.cols(), b.rows(), b.cols()));
  }
  const Eigen::Index rows = a.rows();
  const Eigen::Index inner = a.cols();
  const Eigen::Index columns = b.cols();
  ProductDerivatives result{Eigen::MatrixXd::Zero(rows * columns, rows * inner),
                            Eigen::MatrixXd::Zero(rows * columns, inner * columns)};
  for (Eigen::Index column = 0; column < columns; ++column) {
    for (Eigen::Index k = 0; k < inner; ++k) {
      result.by_a.block(column * rows, k * rows, rows, rows).diagonal().setConstant(b(k, column));
    }
    result.by_b.block(column * rows, column * inner, rows, inner) = a;
  }
  return result;
}

}  // namespace finback::stereo_reference
