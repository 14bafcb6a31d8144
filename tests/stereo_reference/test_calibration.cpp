// Cameras from photographs: against a rig that is known, against the real sets; the file; the
// tables.
#include <Eigen/Dense>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "data_folder.hpp"
#include <common/error.hpp>
#include <stereo_reference/calibration.hpp>
#include <stereo_reference/calibration_file.hpp>
#include <stereo_reference/firmware_tables.hpp>

namespace finback::stereo_reference {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

StereoCalibration rig() {
  StereoCalibration c;
  c.width = 640;
  c.height = 480;
  c.left.focal = {533.2, 531.7};
  c.left.principal = {341.6, 234.3};
  c.left.distortion << -0.281, 0.062, 0.0012, -0.0007, 0;
  c.right.focal = {536.9, 537.3};
  c.right.principal = {326.3, 250.1};
  c.right.distortion << -0.297, 0.121, -0.0003, 0.0009, 0;
  c.left_to_right = {{0.011, -0.034, 0.021}, {-28, 0.6, 1.1}};
  return c;
}

// The board in ten positions, as that rig sees its corners.
std::vector<BoardPair> seen_boards(const StereoCalibration& c, const Board& board) {
  std::vector<BoardPair> pairs;
  for (int i = 0; i < 10; ++i) {
    const Pose pose{{0.4 * std::sin(1.3 * i), 0.5 * std::cos(0.9 * i), 0.1 * i},
                    {-100.0 + 8 * i, -60.0 - 4 * (i % 3), 330.0 + 25 * i}};
    const Points3 points = move_points(board.points(), pose).points;
    pairs.push_back({project_points(points, {}, c.left).pixels,
                     project_points(points, c.left_to_right, c.right).pixels});
  }
  return pairs;
}

TEST(Calibration, FindsTheRigThatMadeThePhotographs) {
  Board board;
  board.square = 20;
  const StereoCalibration truth = rig();
  const CalibrationFit fit = calibrate(seen_boards(truth, board), board, 640, 480);
  EXPECT_LT(fit.rms, 1e-3);
  const StereoCalibration& c = fit.calibration;
  EXPECT_LT((c.left.focal - truth.left.focal).norm(), 0.05);
  EXPECT_LT((c.right.principal - truth.right.principal).norm(), 0.05);
  EXPECT_LT((c.right.distortion - truth.right.distortion).norm(), 1e-3);
  EXPECT_LT((c.left_to_right.translation - truth.left_to_right.translation).norm(), 0.01);
  EXPECT_LT((c.left_to_right.rotation - truth.left_to_right.rotation).norm(), 1e-4);
}

TEST(Calibration, ATurnedCameraShowsInTheRows) {
  Board board;
  board.square = 20;
  StereoCalibration c = rig();
  const std::vector<BoardPair> pairs = seen_boards(c, board);
  const RowErrors right = row_errors(c, pairs);
  EXPECT_LT(right.largest, 1e-4);
  c.right.principal.y() += 2;
  EXPECT_NEAR(std::abs(row_errors(c, pairs).mean), 2, 0.4);
  c = rig();
  c.left_to_right.rotation.z() += 0.01;
  EXPECT_NEAR(std::abs(row_errors(c, pairs).slope), 6.4, 1);
}

TEST(Calibration, RefusesWhatCannotBe) {
  const Board board;
  EXPECT_THAT([&] { (void)calibrate({}, board, 640, 480); },
              ThrowsMessage<InputError>(HasSubstr("0 pairs with the whole board")));
  auto pairs = seen_boards(rig(), board);
  pairs[1].left.conservativeResize(2, 53);
  EXPECT_THAT([&] { (void)calibrate(pairs, board, 640, 480); },
              ThrowsMessage<InputError>(HasSubstr("53 and 54 corners where the board has 54")));
  for (const char* text : {"", "9", "9x", "x6", "9x6x2", "2x9", "-9x6", "9 x 6"}) {
    EXPECT_THROW((void)parse_board(text), InputError) << text;
  }
  EXPECT_EQ(parse_board("9x6").corners(), 54);
}

// The largest difference of the rows in which both rectified cameras have a point, over a grid of
// the left picture and three depths: how far from horizontal epipolar lines are. Pixels that no ray
// of the lens reaches are left out.
double largest_epipolar_error(const StereoCalibration& c) {
  const RectifiedPair pair = rectify(c);
  double largest = 0;
  int points = 0;
  for (int y = 0; y < c.height; y += 24) {
    for (int x = 0; x < c.width; x += 32) {
      const Points2 pixel = Eigen::Vector2d(x, y);
      const Points2 ray = normalize_pixels(pixel, c.left);
      for (const double depth : {10.0, 20.0, 60.0}) {
        const Points3 point = depth * ray.colwise().homogeneous();
        if ((project_points(point, {}, c.left).pixels - pixel).norm() > 1e-3) {
          continue;
        }
        const Points2 seen = project_points(point, c.left_to_right, c.right).pixels;
        const Points2 back = normalize_pixels(seen, c.right);
        const Points3 moved = move_points(point, c.left_to_right).points;
        if ((back - moved.colwise().hnormalized()).norm() > 1e-5) {
          continue;
        }
        ++points;
        const Points3 left = pair.left_rotation * ray.colwise().homogeneous();
        const Points3 right = pair.right_rotation * back.colwise().homogeneous();
        largest = std::max(largest, std::abs(project_points(left, {}, pair.left).pixels(1, 0) -
                                             project_points(right, {}, pair.right).pixels(1, 0)));
      }
    }
  }
  EXPECT_GT(points, 1000);  // of 1200
  return largest;
}

struct Set {
  const char* folder;
  const char* left;  // format of the number
  const char* right;
  int first;
  std::size_t count;
  double most_rms;   // measured: 0.217 and 0.466
  double most_rows;  // measured: 0.141 and 0.236
};

constexpr Set kOpenCvSet = {"opencv_640x480", "left{:02}.png", "right{:02}.png", 1, 14, 0.25, 0.16};

BoardPairs boards_of(const Set& set, const std::filesystem::path& folder) {
  std::vector<std::string> left;
  std::vector<std::string> right;
  for (std::size_t i = 0; i < set.count; ++i) {
    const int number = set.first + static_cast<int>(i);
    left.push_back((folder / fmt::format(fmt::runtime(set.left), number)).string());
    right.push_back((folder / fmt::format(fmt::runtime(set.right), number)).string());
  }
  return find_board_pairs(left, right, Board(), 2);
}

class CalibrationSet : public testing::TestWithParam<Set> {};

TEST_P(CalibrationSet, IsMeasuredWell) {
  const auto& set = GetParam();
  const std::filesystem::path folder = data_folder() / "calibration" / set.folder;
  FINBACK_NEEDS_DATA(folder);
  const Board board;
  const BoardPairs found = boards_of(set, folder);
  ASSERT_EQ(found.pairs.size(), set.count);
  EXPECT_THAT(found.left_out, testing::IsEmpty());
  const CalibrationFit fit = calibrate(found.pairs, board, found.width, found.height);
  EXPECT_LT(fit.rms, set.most_rms);
  EXPECT_LT(largest_epipolar_error(fit.calibration), 1e-6);
  // What is left of matching points' rows is what the detector errs by, not a shift or a turn.
  const RowErrors rows = row_errors(fit.calibration, found.pairs);
  EXPECT_LT(rows.rms, set.most_rows);
  EXPECT_LT(std::abs(rows.mean), 0.02);
  EXPECT_LT(std::abs(rows.slope) / 2, 0.11);  // from the middle to a side
}

INSTANTIATE_TEST_SUITE_P(
    All, CalibrationSet,
    testing::Values(Set{"opencv_640x480", "left{:02}.png", "right{:02}.png", 1, 14, 0.25, 0.16},
                    Set{"usbcam_640x480", "left{:03}.jpg", "right{:03}.jpg", 0, 20, 0.5, 0.26}),
    [](const auto& set) { return std::string(set.param.folder); });

// OpenCV's own calibration of these photographs' left camera, which comes with them
// (left_intrinsics.yml): 13 of the photographs, that camera alone, one focal length, k3 not 0.
TEST(CalibrationOfOpenCvsSet, IsNearItsOwn) {
  const std::filesystem::path folder = data_folder() / "calibration" / kOpenCvSet.folder;
  FINBACK_NEEDS_DATA(folder);
  const BoardPairs found = boards_of(kOpenCvSet, folder);
  const Intrinsics camera =
      calibrate(found.pairs, Board(), found.width, found.height).calibration.left;
  EXPECT_LT((camera.focal.array() - 535.916).abs().maxCoeff(), 535.916 / 100);
  EXPECT_LT((camera.principal - Eigen::Vector2d(342.283, 235.571)).norm(), 2);
}

TEST(CalibrationFile, ReadsBackExactly) {
  StereoCalibration c = rig();
  c.left.focal = {1.0 / 3, 1e22};
  c.left.skew = -std::numeric_limits<double>::denorm_min();
  c.right.principal = {300, -0.0};
  const std::string text = calibration_text(c);
  const StereoCalibration back = parse_calibration(text, "rig.toml");
  EXPECT_EQ(back.width, c.width);
  EXPECT_EQ(back.height, c.height);
  EXPECT_EQ(back.left.focal, c.left.focal);
  EXPECT_EQ(back.left.skew, c.left.skew);
  EXPECT_EQ(back.left.distortion, c.left.distortion);
  EXPECT_EQ(back.right.principal, c.right.principal);
  EXPECT_EQ(back.left_to_right.rotation, c.left_to_right.rotation);
  EXPECT_EQ(back.left_to_right.translation, c.left_to_right.translation);
  EXPECT_EQ(calibration_text(back), text);
}

TEST(CalibrationFile, MistakesAreOneLineWithTheirPlace) {
  const std::string good = calibration_text(rig());
  const auto with = [&](const std::string& old, const std::string& replacement) {
    std::string text = good;
    return text.replace(text.find(old), old.size(), replacement);
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {with("533.2", "nan"), "rig.toml:6:10: 'focal' wants finite numbers"},
      {with("533.2", "\"wide\""), "'focal' wants finite numbers"},
      {with("533.2", "-533.2"), "they must be positive"},
      {with("533.2, ", ""), "'focal' is a list of 2 numbers"},
      {with("skew", "shew"), "did you mean 'skew'?"},
      {with("width = 640", "width = 640.5"), "'width' is a whole number of pixels"},
      {with("width = 640", ""), "there is no 'width'"},
      {with("[right]", "[[right]]"), "'right' is a table"},
      {with("-28.0, 0.6, 1.1", "0.0, 0.0, 0.0"), "rig.toml: calibration: the cameras stand in one"},
      {"width = ", "rig.toml:1"},
      {"", "there is no 'width'"}};
  for (const auto& [text, message] : cases) {
    EXPECT_THAT([&text = text] { (void)parse_calibration(text, "rig.toml"); },
                ThrowsMessage<InputError>(
                    testing::AllOf(HasSubstr(message), testing::Not(HasSubstr("\n")))));
  }
}

TEST(FirmwareTables, AreExactButForTheTangentialPart) {
  const FirmwareTables with = firmware_tables(rig(), 4, true);
  const FirmwareTables without = firmware_tables(rig(), 4, false);
  EXPECT_EQ(with.left.width, 160);
  EXPECT_EQ(with.left.height, 120);
  for (const TableErrors* errors : {&with.left_errors, &with.right_errors}) {
    EXPECT_LE(errors->largest, 1);
    EXPECT_LT(errors->mean, 0.01);
    EXPECT_EQ(errors->tangential_shift, 0);
    EXPECT_GT(errors->seen_percent, 80);
  }
  EXPECT_GT(without.left_errors.tangential_shift, 0.05);
  EXPECT_GT(without.left_errors.mean, 0.5);
  EXPECT_NEAR(without.left_errors.mean, without.left_errors.tangential_mean, 0.01);
}

TEST(FirmwareTables, AsCAreAllOfThem) {
  const FirmwareTables tables = firmware_tables(rig(), 4, false);
  const std::string text = tables_as_c(tables);
  const auto& w = tables.right.weights.back();
  EXPECT_THAT(text, HasSubstr("rectification_left_source[19200][2]"));
  EXPECT_THAT(text, HasSubstr(fmt::format("{{{}, {}, {}, {}}},\n}};\n", w[0], w[1], w[2], w[3])));
  EXPECT_EQ(std::ranges::count(text, '{'), 4 + 4 * 19200);
}

TEST(FirmwareTables, AsFlashAreRowsOfIndicesAndWeights) {
  const FirmwareTables tables = firmware_tables(rig(), 4, false);
  const std::string bytes = tables_as_flash(tables);
  ASSERT_EQ(bytes.size(), 8U + 2 * 19200 * 10);
  EXPECT_EQ(bytes.substr(0, 8), std::string("RECT\xA0\0\x78\0", 8));
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes.at(at)); };
  // Pixel (31, 77) of the right camera.
  const std::size_t n = 77 * 160 + 31;
  const std::size_t row = 8 + (120 + 77) * 1600;
  EXPECT_EQ(byte(row + 62), tables.right.column[n]);
  EXPECT_EQ(byte(row + 63), tables.right.row[n]);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = row + 320 + 31 * 8 + 2 * i;
    EXPECT_EQ(byte(at) + 256 * byte(at + 1), tables.right.weights[n][i]);
  }
}

}  // namespace
}  // namespace finback::stereo_reference
