// Rotations as vectors (axis times angle) and as matrices, with derivatives both ways.
//
// Models: Rodrigues' formula and its inverse (Ahuja 2009, A.2 and A.3), right at angle 0 and at pi.
// A matrix counts column by column where it is a vector of nine. Does not model: turns beyond pi
// on the way back; a vector of length pi and its negative are the same rotation, and the way back
// gives the one whose first component that is not 0 is positive.
#pragma once

#include <Eigen/Core>

namespace finback::stereo_reference {

using Matrix93 = Eigen::Matrix<double, 9, 3>;
using Matrix39 = Eigen::Matrix<double, 3, 9>;

// The matrix of the cross product: skew_3(a) * b = a x b.
[[nodiscard]] Eigen::Matrix3d skew_3(const Eigen::Vector3d& vector);

struct RotationMatrix {
  Eigen::Matrix3d matrix;
  Matrix93 by_vector;  // derivative of the matrix
};
struct RotationVector {
  Eigen::Vector3d vector;  // radians, at most pi long
  // Derivative of the vector along changes that leave the matrix a rotation; a change that would
  // not counts as the nearest one that does.
  Matrix39 by_matrix;
};

[[nodiscard]] RotationMatrix rodrigues(const Eigen::Vector3d& vector);
// Of the rotation nearest to `matrix`. Throws InputError when it is far from any: not finite, a
// reflection, or more than a hundredth off in some element.
[[nodiscard]] RotationVector rodrigues(const Eigen::Matrix3d& matrix);

// Derivatives of A * B by the elements of A and of B, column by column (A.7, "dAB"). For A of m x n
// and B of n x p: mp x mn and mp x np.
struct ProductDerivatives {
  Eigen::MatrixXd by_a;
  Eigen::MatrixXd by_b;
};
// Throws InputError when the sizes do not fit.
[[nodiscard]] ProductDerivatives product_derivatives(const Eigen::MatrixXd& a,
                                                     const Eigen::MatrixXd& b);

}  // namespace finback::stereo_reference
