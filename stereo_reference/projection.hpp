// A camera as geometry: rigid motion, lens distortion, projection to pixels, and the way back.
//
// Models: pinhole with focal lengths, principal point and skew; radial distortion to the sixth
// power and tangential distortion (the "Oulu" model); all derivatives (Ahuja 2009, A.4-A.6, A.8).
// The inverse of the distortion is a fixed point, 20 rounds as in A.8, and Newton's steps to its
// last digits. Does not model: cameras that see behind themselves, rolling shutters. Lengths are in
// whatever unit the points have.
#pragma once

#include <Eigen/Core>

namespace finback::stereo_reference {

using Points2 = Eigen::Matrix2Xd;  // one column a point
using Points3 = Eigen::Matrix3Xd;

struct Intrinsics {
  Eigen::Vector2d focal{1, 1};      // pixels, horizontal and vertical
  Eigen::Vector2d principal{0, 0};  // pixels from the centre of the first pixel
  double skew = 0;                  // alpha: x leans by skew * y
  // k1, k2: radial, second and fourth power; p1, p2: tangential; k3: radial, sixth power.
  Eigen::Matrix<double, 5, 1> distortion = Eigen::Matrix<double, 5, 1>::Zero();
};

// Where one camera stands: a point X of the world is rotation * X + translation to it.
struct Pose {
  Eigen::Vector3d rotation{0, 0, 0};  // as rodrigues() takes it
  Eigen::Vector3d translation{0, 0, 0};
};

// Points seen from a camera, with derivatives: rows 3 n to 3 n + 2 belong to point n.
struct MovedPoints {
  Points3 points;
  Eigen::MatrixX3d by_rotation;
  Eigen::MatrixX3d by_translation;
};
[[nodiscard]] MovedPoints move_points(const Points3& points, const Pose& pose);

// Pixels, with derivatives: rows 2 n and 2 n + 1 belong to point n.
struct ProjectedPoints {
  Points2 pixels;
  Eigen::MatrixX3d by_rotation;
  Eigen::MatrixX3d by_translation;
  Eigen::MatrixX2d by_focal;
  Eigen::MatrixX2d by_principal;
  Eigen::Matrix<double, Eigen::Dynamic, 5> by_distortion;
  Eigen::VectorXd by_skew;
};
// Throws InputError for a point in the plane of the camera (depth 0).
[[nodiscard]] ProjectedPoints project_points(const Points3& points, const Pose& pose,
                                             const Intrinsics& camera);

// Distorts points of the plane at depth 1.
[[nodiscard]] Points2 distort(const Points2& points, const Eigen::Matrix<double, 5, 1>& distortion);
// How far from the centre, at depth 1, the radial part turns back on itself: rays beyond fall on
// pixels that others have; infinite where it never does (up to a radius of 4).
[[nodiscard]] double fold_radius(const Eigen::Matrix<double, 5, 1>& distortion);
// The way back. Points that no ray within the fold radius reaches come out near it. Within 1e-6 of
// the true point for lenses whose distortion is modest: a tenth of the radius at the picture's
// edge, say.
[[nodiscard]] Points2 undistort(const Points2& points,
                                const Eigen::Matrix<double, 5, 1>& distortion);

// From pixels to undistorted points of the plane at depth 1.
[[nodiscard]] Points2 normalize_pixels(const Points2& pixels, const Intrinsics& camera);

}  // namespace finback::stereo_reference
