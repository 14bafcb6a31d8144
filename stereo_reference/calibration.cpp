#include <Eigen/Dense>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include <common/error.hpp>
#include <stereo_reference/calibration.hpp>

namespace finback::stereo_reference {

namespace {

using Eigen::Index;

constexpr std::size_t kLeastPairs = 3;
constexpr int kMostRounds = 200;
constexpr double kLeastStep = 1e-10;
constexpr int kFlags = cv::CALIB_FIX_K3;  // boards rarely reach the corners, where it would show

struct Camera {
  cv::Mat matrix = cv::Mat::eye(3, 3, CV_64F);
  cv::Mat distortion = cv::Mat::zeros(5, 1, CV_64F);

  [[nodiscard]] Intrinsics intrinsics() const {
    Intrinsics result;
    result.focal = {matrix.at<double>(0, 0), matrix.at<double>(1, 1)};
    result.principal = {matrix.at<double>(0, 2), matrix.at<double>(1, 2)};
    for (int i = 0; i < 5; ++i) {
      result.distortion[i] = distortion.at<double>(i);
    }
    return result;
  }
};

std::vector<cv::Point2f> to_cv(const Points2& points) {
  std::vector<cv::Point2f> result;
  for (Index n = 0; n < points.cols(); ++n) {
    result.emplace_back(static_cast<float>(points(0, n)), static_cast<float>(points(1, n)));
  }
  return result;
}

Eigen::Vector3d to_eigen(const cv::Mat& vector) {
  return {vector.at<double>(0), vector.at<double>(1), vector.at<double>(2)};
}

cv::TermCriteria until() {
  return {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kMostRounds, kLeastStep};
}

CalibrationFit fit(const std::vector<BoardPair>& pairs, const Board& board, const cv::Size& size) {
  std::vector<cv::Point3f> corners;
  const Points3 places = board.points();
  for (Index n = 0; n < places.cols(); ++n) {
    corners.emplace_back(static_cast<float>(places(0, n)), static_cast<float>(places(1, n)), 0.0F);
  }
  const std::vector<std::vector<cv::Point3f>> boards(pairs.size(), corners);
  std::vector<std::vector<cv::Point2f>> left;
  std::vector<std::vector<cv::Point2f>> right;
  for (const BoardPair& pair : pairs) {
    left.push_back(to_cv(pair.left));
    right.push_back(to_cv(pair.right));
  }
  Camera one;
  Camera other;
  CalibrationFit result;
  const auto alone = [&](const auto& views, Camera& camera) {
    std::vector<cv::Mat> turns;
    std::vector<cv::Mat> shifts;
    return cv::calibrateCamera(boards, views, size, camera.matrix, camera.distortion, turns, shifts,
                               kFlags, until());
  };
  result.left_rms = alone(left, one);
  result.right_rms = alone(right, other);
  cv::Mat rotation;
  cv::Mat translation;
  cv::Mat essential;
  cv::Mat fundamental;
  result.rms = cv::stereoCalibrate(boards, left, right, one.matrix, one.distortion, other.matrix,
                                   other.distortion, size, rotation, translation, essential,
                                   fundamental, kFlags | cv::CALIB_USE_INTRINSIC_GUESS, until());
  cv::Mat vector;
  cv::Rodrigues(rotation, vector);
  result.calibration = {size.width,
                        size.height,
                        one.intrinsics(),
                        other.intrinsics(),
                        {to_eigen(vector), to_eigen(translation)}};
  return result;
}

}  // namespace

CalibrationFit calibrate(const std::vector<BoardPair>& pairs, const Board& board, int width,
                         int height) {
  if (pairs.size() < kLeastPairs) {
    throw InputError(
        fmt::format("calibration: {} pair{} with the whole board in both views; at "
                    "least {} are needed",
                    pairs.size(), pairs.size() == 1 ? "" : "s", kLeastPairs));
  }
  for (const BoardPair& pair : pairs) {
    if (pair.left.cols() != board.corners() || pair.right.cols() != board.corners()) {
      throw InputError(fmt::format("calibration: {} and {} corners where the board has {}",
                                   pair.left.cols(), pair.right.cols(), board.corners()));
    }
  }
  CalibrationFit result;
  try {
    result = fit(pairs, board, {width, height});
  } catch (const cv::Exception&) {
    throw InputError(
        "calibration: no cameras fit these corners; turn the board more between the photographs");
  }
  (void)rectify(result.calibration);  // says what cannot be
  return result;
}

RowErrors row_errors(const StereoCalibration& calibration, const std::vector<BoardPair>& pairs) {
  const RectifiedPair rectified = rectify(calibration);
  const auto through = [](const Points2& corners, const Intrinsics& camera,
                          const Eigen::Matrix3d& rotation, const Intrinsics& seen) {
    const Points3 turned = rotation * normalize_pixels(corners, camera).colwise().homogeneous();
    return project_points(turned, {}, seen).pixels;
  };
  const Index along = rectified.vertical ? 0 : 1;
  double count = 0;
  RowErrors errors;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();  // of error = shift + slope * place
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (const BoardPair& pair : pairs) {
    const Points2 left =
        through(pair.left, calibration.left, rectified.left_rotation, rectified.left);
    const Points2 right =
        through(pair.right, calibration.right, rectified.right_rotation, rectified.right);
    for (Index n = 0; n < left.cols(); ++n) {
      const double error = left(along, n) - right(along, n);
      const Eigen::Vector2d place(1, left(1 - along, n) / calibration.width);
      normal += place * place.transpose();
      moment += place * error;
      errors.mean += error;
      errors.rms += error * error;
      errors.largest = std::max(errors.largest, std::abs(error));
      ++count;
    }
  }
  if (count > 0) {
    errors.mean /= count;
    errors.rms = std::sqrt(errors.rms / count);
    errors.slope = normal.ldlt().solve(moment)[1];
  }
  return errors;
}

}  // namespace finback::stereo_reference
