// Projection and its derivatives, distortion and its inverse: against finite differences and
// OpenCV.
#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "finite_differences.hpp"
#include <common/error.hpp>
#include <stereo_reference/projection.hpp>

namespace finback::stereo_reference {
namespace {

using Eigen::VectorXd;

// A VGA camera with a visible barrel distortion, as calibrations of webcams give it.
Intrinsics webcam() {
  Intrinsics camera;
  camera.focal = {533.2, 531.7};
  camera.principal = {341.6, 234.3};
  camera.distortion << -0.281, 0.062, 0.0012, -0.0007, 0.013;
  return camera;
}

Points3 points() {
  Points3 result(3, 5);
  result << 0.1, -0.4, 0.3, 0.0, -0.2,  //
      0.2, 0.1, -0.3, 0.0, 0.35,        //
      1.0, 1.2, 0.8, 0.9, 1.5;
  return result;
}

Pose pose() { return {{0.05, -0.2, 0.1}, {0.03, -0.02, 0.4}}; }

double off(const Eigen::MatrixXd& analytic, const Eigen::MatrixXd& numeric) {
  return (analytic - numeric).cwiseAbs().maxCoeff() / std::max(1.0, numeric.cwiseAbs().maxCoeff());
}

TEST(RigidMotion, DerivativesEqualDifferences) {
  const MovedPoints moved = move_points(points(), pose());
  const auto by_rotation = [](const VectorXd& at) {
    return VectorXd(move_points(points(), {at, pose().translation}).points.reshaped());
  };
  const auto by_translation = [](const VectorXd& at) {
    return VectorXd(move_points(points(), {pose().rotation, at}).points.reshaped());
  };
  EXPECT_LT(off(moved.by_rotation, differences(by_rotation, pose().rotation)), 1e-8);
  EXPECT_LT(off(moved.by_translation, differences(by_translation, pose().translation)), 1e-8);
}

// All that a projection depends on, in one vector.
VectorXd pack(const Pose& where, const Intrinsics& camera) {
  VectorXd all(16);
  all << where.rotation, where.translation, camera.focal, camera.principal, camera.distortion,
      camera.skew;
  return all;
}

VectorXd project_packed(const VectorXd& all) {
  Intrinsics camera;
  camera.focal = all.segment<2>(6);
  camera.principal = all.segment<2>(8);
  camera.distortion = all.segment<5>(10);
  camera.skew = all[15];
  return project_points(points(), {all.head<3>(), all.segment<3>(3)}, camera).pixels.reshaped();
}

TEST(Projection, DerivativesEqualDifferences) {
  Intrinsics camera = webcam();
  camera.skew = 0.01;
  const ProjectedPoints projected = project_points(points(), pose(), camera);
  Eigen::MatrixXd analytic(10, 16);
  analytic << projected.by_rotation, projected.by_translation, projected.by_focal,
      projected.by_principal, projected.by_distortion, projected.by_skew;
  const Eigen::MatrixXd numeric = differences(project_packed, pack(pose(), camera));
  for (Eigen::Index column = 0; column < analytic.cols(); ++column) {
    EXPECT_LT(off(analytic.col(column), numeric.col(column)), 1e-7) << "parameter " << column;
  }
}

TEST(Projection, AgreesWithOpenCv) {
  const Intrinsics camera = webcam();
  const cv::Matx33d matrix(camera.focal.x(), 0, camera.principal.x(), 0, camera.focal.y(),
                           camera.principal.y(), 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.data(), camera.distortion.data() + 5);
  std::vector<cv::Point3d> world;
  const Points3 given = points();
  for (Eigen::Index n = 0; n < given.cols(); ++n) {
    world.emplace_back(given(0, n), given(1, n), given(2, n));
  }
  const cv::Vec3d rotation(pose().rotation.data());
  const cv::Vec3d translation(pose().translation.data());
  std::vector<cv::Point2d> expected;
  cv::projectPoints(world, rotation, translation, matrix, distortion, expected);
  const ProjectedPoints ours = project_points(points(), pose(), camera);
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_NEAR(ours.pixels(0, static_cast<Eigen::Index>(n)), expected[n].x, 1e-10);
    EXPECT_NEAR(ours.pixels(1, static_cast<Eigen::Index>(n)), expected[n].y, 1e-10);
  }
  std::vector<cv::Point2d> undistorted;
  cv::undistortPoints(expected, undistorted, matrix, distortion, cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT, 20, 0));
  const Points2 plane = normalize_pixels(ours.pixels, camera);
  for (std::size_t n = 0; n < undistorted.size(); ++n) {
    EXPECT_NEAR(plane(0, static_cast<Eigen::Index>(n)), undistorted[n].x, 1e-9);
    EXPECT_NEAR(plane(1, static_cast<Eigen::Index>(n)), undistorted[n].y, 1e-9);
  }
}

// Over the whole picture: a millionth of a pixel.
TEST(Distortion, IsInvertedToAMillionthOfAPixel) {
  const Intrinsics camera = webcam();
  Points2 pixels(2, 33 * 25);
  for (Eigen::Index n = 0; n < pixels.cols(); ++n) {
    pixels.col(n) << static_cast<double>(n % 33) * 20, static_cast<double>(n / 33) * 20;
  }
  const Points2 plane = normalize_pixels(pixels, camera);
  Points2 back = distort(plane, camera.distortion);
  back = (back.array().colwise() * camera.focal.array()).matrix().colwise() + camera.principal;
  EXPECT_LT((back - pixels).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Distortion, NoneChangesNothing) {
  const Points2 some = Points2::Random(2, 7);
  EXPECT_EQ(distort(some, Intrinsics().distortion), some);
  EXPECT_EQ(undistort(some, Intrinsics().distortion), some);
}

TEST(NormalizePixels, UndoesTheSkew) {
  Intrinsics camera = webcam();
  camera.skew = 0.02;
  const ProjectedPoints projected = project_points(points(), {}, camera);
  const Points2 plane = normalize_pixels(projected.pixels, camera);
  const Points3 given = points();
  EXPECT_LT((plane - Points2(given.colwise().hnormalized())).norm(), 1e-9);
}

TEST(Projection, DepthZeroIsRefused) {
  Points3 flat = points();
  flat(2, 3) = 0;
  EXPECT_THAT([&] { (void)project_points(flat, {}, webcam()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("point 3 lies in the plane")));
}

// r - r^3 has its top at 1 / sqrt(3).
TEST(Fold, IsWhereTheLensTurnsBack) {
  Eigen::Matrix<double, 5, 1> lens = Eigen::Matrix<double, 5, 1>::Zero();
  EXPECT_EQ(fold_radius(lens), std::numeric_limits<double>::infinity());
  lens[0] = -1;
  EXPECT_NEAR(fold_radius(lens), 1 / std::sqrt(3.0), 1e-9);
  lens << 0.12, -1.2, 0, 0, 0;
  const double fold = fold_radius(lens);
  Points2 rays(2, 3);
  rays << fold - 1e-3, fold, fold + 1e-3, 0, 0, 0;
  const Points2 seen = distort(rays, lens);
  EXPECT_GT(seen(0, 1), seen(0, 0));
  EXPECT_GT(seen(0, 1), seen(0, 2));
  // What nobody sees comes back at the rim, in its direction.
  Points2 beyond(2, 1);
  beyond << -2, 2;
  const Points2 back = undistort(beyond, lens);
  EXPECT_NEAR(back.col(0).norm(), fold, 1e-9);
  EXPECT_NEAR(back(0, 0), -back(1, 0), 1e-9);
}

}  // namespace
}  // namespace finback::stereo_reference
