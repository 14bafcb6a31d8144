// Rodrigues both ways: against finite differences, at the angles where formulas break, and against
// OpenCV.
#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "finite_differences.hpp"
#include <common/error.hpp>
#include <stereo_reference/rotation.hpp>

namespace finback::stereo_reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kPi = std::numbers::pi;

std::vector<Vector3d> vectors_of_length(double angle) {
  std::vector<Vector3d> vectors;
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 1),
                               Vector3d(1, 2, -3), Vector3d(-1, 1e-3, 1), Vector3d(0, 1, 1)}) {
    vectors.push_back(axis.normalized() * angle);
  }
  return vectors;
}

class RotationAt : public testing::TestWithParam<double> {};

TEST_P(RotationAt, IsARotationWithTheDerivativesOfItsDifferences) {
  for (const Vector3d& vector : vectors_of_length(GetParam())) {
    SCOPED_TRACE(vector.transpose());
    const RotationMatrix rotation = rodrigues(vector);
    EXPECT_LT((rotation.matrix * rotation.matrix.transpose() - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(rotation.matrix.determinant(), 1, 1e-14);
    const auto matrix = [](const VectorXd& at) {
      return VectorXd(rodrigues(Vector3d(at)).matrix.reshaped());
    };
    EXPECT_LT((rotation.by_vector - differences(matrix, vector)).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_P(RotationAt, ComesBack) {
  for (const Vector3d& vector : vectors_of_length(GetParam())) {
    SCOPED_TRACE(vector.transpose());
    const Matrix3d matrix = rodrigues(vector).matrix;
    const RotationVector back = rodrigues(matrix);
    EXPECT_LE(back.vector.norm(), kPi + 1e-12);
    EXPECT_LT((rodrigues(back.vector).matrix - matrix).norm(), 1e-13);
    if (GetParam() < 3.1) {
      EXPECT_LT((back.vector - vector).norm(), 1e-13);
    }
    const Matrix3d round = back.by_matrix * rodrigues(back.vector).by_vector;
    EXPECT_LT((round - Matrix3d::Identity()).norm(), 1e-12);
  }
}

TEST_P(RotationAt, AgreesWithOpenCv) {
  for (const Vector3d& vector : vectors_of_length(GetParam())) {
    SCOPED_TRACE(vector.transpose());
    cv::Mat cv_vector, cv_matrix, cv_jacobian;
    cv::eigen2cv(vector, cv_vector);
    cv::Rodrigues(cv_vector, cv_matrix, cv_jacobian);  // 3 x 9, by rows of the matrix
    Matrix3d expected;
    cv::cv2eigen(cv_matrix, expected);
    const RotationMatrix rotation = rodrigues(vector);
    EXPECT_LT((rotation.matrix - expected).norm(), 1e-12);
    for (int i = 0; i < 3; ++i) {
      const Matrix3d ours = rotation.by_vector.col(i).reshaped(3, 3);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          EXPECT_NEAR(ours(row, column), cv_jacobian.at<double>(i, 3 * row + column), 1e-7);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, RotationAt,
                         testing::Values(0.0, 1e-12, 1e-8, 1e-4, 0.0099, 0.0101, 0.3, 1.5, 3.0,
                                         kPi - 1e-7, kPi));

TEST(Rotation, SmallTurnsComeBack) {
  const Vector3d tiny(1e-9, -2e-9, 3e-9);
  EXPECT_LT((rodrigues(rodrigues(tiny).matrix).vector - tiny).norm(), 1e-15);
}

TEST(Rotation, AHalfTurnHasOneName) {
  for (const Vector3d& axis : {Vector3d(1, -1, 0), Vector3d(0, 1, -2), Vector3d(0, 0, 1)}) {
    const Vector3d vector = axis.normalized() * kPi;
    EXPECT_LT((rodrigues(rodrigues(vector).matrix).vector - vector).norm(), 1e-7);
    EXPECT_LT((rodrigues(rodrigues(Vector3d(-vector)).matrix).vector - vector).norm(), 1e-7);
  }
}

TEST(Rotation, WhatIsNoneIsRefused) {
  const auto of = [](const Matrix3d& matrix) { return [matrix] { (void)rodrigues(matrix); }; };
  EXPECT_THAT(of(-Matrix3d::Identity()),
              testing::ThrowsMessage<InputError>(testing::HasSubstr("reflection")));
  EXPECT_THAT(of(Matrix3d::Identity() * 1.5),
              testing::ThrowsMessage<InputError>(testing::HasSubstr("0.5 off any rotation")));
  Matrix3d broken = Matrix3d::Identity();
  broken(1, 2) = std::nan("");
  EXPECT_THROW((void)rodrigues(broken), InputError);
  Matrix3d rounded = rodrigues(Vector3d(0.1, 0.2, 0.3)).matrix;
  rounded(0, 0) += 1e-4;  // read from a file with four digits
  EXPECT_LT((rodrigues(rounded).vector - Vector3d(0.1, 0.2, 0.3)).norm(), 1e-3);
}

TEST(Rotation, SkewIsTheCrossProduct) {
  const Vector3d a(1, -2, 3), b(0.5, 4, -1);
  EXPECT_LT((skew_3(a) * b - a.cross(b)).norm(), 1e-15);
}

TEST(ProductDerivatives, EqualDifferences) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(2, 3);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(3, 4);
  const ProductDerivatives derivatives = product_derivatives(a, b);
  const auto by_a = [&](const VectorXd& at) {
    return VectorXd((at.reshaped(2, 3) * b).reshaped());
  };
  const auto by_b = [&](const VectorXd& at) {
    return VectorXd((a * at.reshaped(3, 4)).reshaped());
  };
  EXPECT_LT((derivatives.by_a - differences(by_a, a.reshaped())).norm(), 1e-8);
  EXPECT_LT((derivatives.by_b - differences(by_b, b.reshaped())).norm(), 1e-8);
  EXPECT_THROW((void)product_derivatives(a, a), InputError);
}

}  // namespace
}  // namespace finback::stereo_reference
