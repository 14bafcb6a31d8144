// Rectified cameras: matching points in one row, agreement with OpenCV, and the firmware's tables
// against the exact mapping.
#include <Eigen/Dense>
#include <cmath>
#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include <common/error.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/matching.hpp>
#include <stereo_reference/rectification.hpp>
#include <stereo_reference/rotation.hpp>

namespace finback::stereo_reference {
namespace {

using Eigen::Index;
using scenes::ByteImage;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Two webcams side by side, not quite parallel.
StereoCalibration rig(const Eigen::Vector3d& translation = {-28, 0.6, 1.1}) {
  StereoCalibration c;
  c.width = 640;
  c.height = 480;
  c.left.focal = {533.2, 531.7};
  c.left.principal = {341.6, 234.3};
  c.left.distortion << -0.281, 0.062, 0.0012, -0.0007, 0;
  c.right.focal = {536.9, 537.3};
  c.right.principal = {326.3, 250.1};
  c.right.distortion << -0.297, 0.121, -0.0003, 0.0009, 0;
  c.left_to_right = {{0.011, -0.034, 0.021}, translation};
  return c;
}

cv::Matx33d camera_matrix(const Intrinsics& camera) {
  return {camera.focal.x(),
          0,
          camera.principal.x(),
          0,
          camera.focal.y(),
          camera.principal.y(),
          0,
          0,
          1};
}

// A point of the left camera's space as a rectified camera sees it.
Points2 rectified_pixels(const Points3& points, const Eigen::Matrix3d& rotation,
                         const Intrinsics& camera) {
  return project_points(rotation * points, {}, camera).pixels;
}

Points3 scene_points() {
  Points3 points(3, 60);
  for (Index n = 0; n < points.cols(); ++n) {
    const double t = static_cast<double>(n);
    points.col(n) << 150 * std::sin(t), 120 * std::cos(1.7 * t), 300 + 12 * t;
  }
  return points;
}

class RectifiedRig : public testing::TestWithParam<bool> {};

// Through the distorted pictures, as the real way is: projected, normalised, turned, projected.
TEST_P(RectifiedRig, SeesAPointInOneRow) {
  const bool vertical = GetParam();
  const StereoCalibration c = vertical ? rig({0.7, -31, 1.4}) : rig();
  const RectifiedPair pair = rectify(c);
  EXPECT_EQ(pair.vertical, vertical);
  const Points3 points = scene_points();
  const auto through = [&](const Intrinsics& camera, const Pose& pose,
                           const Eigen::Matrix3d& rotation, const Intrinsics& rectified) {
    const Points2 pixels = project_points(points, pose, camera).pixels;
    const Points2 plane = normalize_pixels(pixels, camera);
    return rectified_pixels(plane.colwise().homogeneous(), rotation, rectified);
  };
  const Points2 left = through(c.left, {}, pair.left_rotation, pair.left);
  const Points2 right = through(c.right, c.left_to_right, pair.right_rotation, pair.right);
  const Index along = vertical ? 0 : 1;
  EXPECT_LT((left.row(along) - right.row(along)).cwiseAbs().maxCoeff(), 1e-4) << "pixels";
  // The disparity is focal length times baseline over depth, and what the principal points differ.
  const double baseline = c.left_to_right.translation.norm();
  const Points3 turned = pair.left_rotation * points;
  for (Index n = 0; n < points.cols(); ++n) {
    const Index across = 1 - along;
    const double disparity = left(across, n) - right(across, n);
    const double expected = pair.left.focal.x() * baseline / turned(2, n) +
                            pair.left.principal[across] - pair.right.principal[across];
    EXPECT_NEAR(disparity, expected, 1e-3);
  }
}

TEST_P(RectifiedRig, HasOpenCvsRotations) {
  const StereoCalibration c = GetParam() ? rig({0.7, -31, 1.4}) : rig();
  const auto distortion = [](const Intrinsics& camera) {
    return std::vector<double>(camera.distortion.data(), camera.distortion.data() + 5);
  };
  cv::Mat rotation, translation, left, right, left_projection, right_projection, depth;
  cv::eigen2cv(rodrigues(c.left_to_right.rotation).matrix, rotation);
  cv::eigen2cv(c.left_to_right.translation, translation);
  cv::stereoRectify(camera_matrix(c.left), distortion(c.left), camera_matrix(c.right),
                    distortion(c.right), cv::Size(c.width, c.height), rotation, translation, left,
                    right, left_projection, right_projection, depth);
  const RectifiedPair pair = rectify(c);
  Eigen::Matrix3d expected;
  cv::cv2eigen(left, expected);
  EXPECT_LT((pair.left_rotation - expected).norm(), 1e-9);
  cv::cv2eigen(right, expected);
  EXPECT_LT((pair.right_rotation - expected).norm(), 1e-9);
}

// Where each rectified pixel lies, and the picture that comes of it: cv::remap knows 32 places
// between two pixels, so that it is off by some greys at edges.
TEST_P(RectifiedRig, HasOpenCvsPictures) {
  const StereoCalibration c = GetParam() ? rig({0.7, -31, 1.4}) : rig();
  const RectifiedPair pair = rectify(c);
  cv::Mat rotation, columns, rows, expected;
  cv::eigen2cv(pair.left_rotation, rotation);
  const std::vector<double> distortion(c.left.distortion.data(), c.left.distortion.data() + 5);
  cv::initUndistortRectifyMap(camera_matrix(c.left), distortion, rotation, camera_matrix(pair.left),
                              cv::Size(c.width, c.height), CV_32FC1, columns, rows);
  const PixelMap map = pixel_map(c.left, pair.left_rotation, pair.left, c.width, c.height);
  ByteImage image = scenes::make_synthetic_scene().left;
  cv::remap(cv::Mat(c.height, c.width, CV_8UC1, image.data()), expected, columns, rows,
            cv::INTER_LINEAR);
  const ByteImage picture = remap(image, map);
  double off = 0;
  double greys = 0;
  int seen = 0;
  for (int y = 0; y < c.height; ++y) {
    for (int x = 0; x < c.width; ++x) {
      const Eigen::Vector2d source = map.sources.col(Index{y} * c.width + x);
      off = std::max({off, std::abs(source.x() - double{columns.at<float>(y, x)}),
                      std::abs(source.y() - double{rows.at<float>(y, x)})});
      if (source.minCoeff() >= 0 && source.x() <= c.width - 1 && source.y() <= c.height - 1) {
        greys += std::abs(int{picture.at(x, y)} - int{expected.at<std::uint8_t>(y, x)});
        ++seen;
      }
    }
  }
  EXPECT_LT(off, 1e-3) << "pixels";
  EXPECT_GT(seen, c.width * c.height * 8 / 10);
  EXPECT_LT(greys / seen, 0.5);
}

INSTANTIATE_TEST_SUITE_P(SideBySideAndAbove, RectifiedRig, testing::Bool());

TEST(Rectification, OfAParallelRigChangesNothing) {
  StereoCalibration c = rig({-28, 0, 0});
  c.left_to_right.rotation.setZero();
  c.left.distortion.setZero();
  c.left.focal = {530, 530};
  c.left.principal = {319.5, 239.5};
  c.right = c.left;
  const RectifiedPair pair = rectify(c);
  EXPECT_TRUE(pair.left_rotation.isIdentity(1e-15));
  EXPECT_EQ(pair.left.focal.x(), 530);
  EXPECT_LT((pair.left.principal - c.left.principal).norm(), 1e-9);
  const ByteImage image = scenes::make_synthetic_scene().left;
  const PixelMap map = pixel_map(c.left, pair.left_rotation, c.left, 640, 480);
  EXPECT_EQ(remap(image, map), image);
}

TEST(Rectification, WhatTheCameraDoesNotSeeIsBlack) {
  const StereoCalibration c = rig();
  const ByteImage white(640, 480, 255);
  const Eigen::Matrix3d turned = rodrigues(Eigen::Vector3d(0, 0.3, 0)).matrix;
  const ByteImage seen = remap(white, pixel_map(c.left, turned, c.left, 640, 480));
  EXPECT_EQ(std::ranges::count(seen.pixels(), 0) + std::ranges::count(seen.pixels(), 255),
            640 * 480);
  EXPECT_GT(std::ranges::count(seen.pixels(), 0), 50000);
  EXPECT_GT(std::ranges::count(seen.pixels(), 255), 50000);
}

TEST(RectificationTable, IsTheExactMappingToOneGrey) {
  const StereoCalibration c = subsampled(rig(), 4);
  const RectifiedPair pair = rectify(c);
  const ByteImage image = subsample_by_4(scenes::make_synthetic_scene().left);
  const PixelMap map = pixel_map(c.left, pair.left_rotation, pair.left, c.width, c.height);
  const ByteImage exact = remap(image, map);
  const ByteImage by_table = remap(image, rectification_table(map));
  int different = 0;
  for (std::size_t n = 0; n < exact.pixels().size(); ++n) {
    const int off = std::abs(int{exact.pixels()[n]} - int{by_table.pixels()[n]});
    ASSERT_LE(off, 1) << "pixel " << n;
    different += off;
  }
  EXPECT_LT(different, 160 * 120 / 50);
}

TEST(RectificationTable, WeightsSumToOneAtMost) {
  const StereoCalibration c = subsampled(rig(), 4);
  const RectifiedPair pair = rectify(c);
  const RectificationTable table =
      rectification_table(pixel_map(c.right, pair.right_rotation, pair.right, c.width, c.height));
  int seen = 0;
  for (const auto& weights : table.weights) {
    int sum = 0;
    for (const int weight : weights) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_LE(sum, 32768);
    EXPECT_TRUE(sum == 0 || sum > 32768 - 4) << sum;
    seen += sum > 0;
  }
  EXPECT_GT(seen, 160 * 120 * 8 / 10);
}

TEST(RectificationTable, WithoutTheTangentialPartIsNear) {
  const StereoCalibration c = rig();
  const RectifiedPair pair = rectify(c);
  const Points2 with = pixel_map(c.left, pair.left_rotation, pair.left, 640, 480).sources;
  const Points2 without = pixel_map(c.left, pair.left_rotation, pair.left, 640, 480, false).sources;
  const double off = (with - without).colwise().norm().maxCoeff();
  EXPECT_GT(off, 0.1);
  EXPECT_LT(off, 3.0);
}

TEST(Rectification, RefusesCalibrationsThatAreNone) {
  StereoCalibration c = rig();
  c.right.distortion[1] = std::nan("");
  EXPECT_THAT(
      [&] { (void)rectify(c); },
      ThrowsMessage<InputError>(HasSubstr("the right camera has values that are no numbers")));
  c = rig({0, 0, 0});
  EXPECT_THAT([&] { (void)rectify(c); }, ThrowsMessage<InputError>(HasSubstr("no baseline")));
  c = rig();
  c.left.focal.x() = -3;
  EXPECT_THAT([&] { (void)rectify(c); }, ThrowsMessage<InputError>(HasSubstr("must be positive")));
  EXPECT_THAT([&] { (void)subsampled(rig(), 7); },
              ThrowsMessage<InputError>(HasSubstr("cannot be sub-sampled by 7")));
  const PixelMap map = pixel_map(rig().left, Eigen::Matrix3d::Identity(), rig().left, 640, 480);
  EXPECT_THAT([&] { (void)rectification_table(map); },
              ThrowsMessage<InputError>(HasSubstr("at most 256")));
  EXPECT_THROW((void)remap(ByteImage(3, 3), map), InputError);
}

// A lens whose polynomial folds inside the rectified picture: no place is shown twice.
TEST(PixelMap, EndsAtTheFold) {
  StereoCalibration c = rig();
  c.right.distortion << 0.124, -1.238, 0.0083, -0.0008, 0;
  const RectifiedPair pair = rectify(c);
  const PixelMap map = pixel_map(c.right, pair.right_rotation, pair.right, c.width, c.height);
  int unseen = 0;
  for (int y = 0; y < c.height; ++y) {
    double last = -1;
    for (int x = 0; x < c.width; ++x) {
      const double column = map.sources(0, Index{y} * c.width + x);
      if (column == -1) {
        ++unseen;
        continue;
      }
      EXPECT_GT(column, last) << x << ", " << y;
      last = column;
    }
  }
  EXPECT_GT(unseen, 1000);
  EXPECT_LT(unseen, c.width * c.height / 4);
}

}  // namespace
}  // namespace finback::stereo_reference
