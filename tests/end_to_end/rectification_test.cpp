// Tables of a calibration in flash: a raw pair becomes the map of the rectified one. And what
// double-buffered DMA saves.
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "firmware_copy.hpp"
#include "firmware_run.hpp"
#include <stereo_reference/calibration.hpp>
#include <stereo_reference/firmware_tables.hpp>

namespace finback {
namespace {

// What the firmware must make of a raw pair with these tables: sub-sampled, rectified, matched.
std::vector<std::uint8_t> reference_with(const stereo_reference::FirmwareTables& tables,
                                         const scenes::Scene& raw) {
  return reference_map_of(remap(stereo_reference::subsample_by_4(raw.left), tables.left),
                          remap(stereo_reference::subsample_by_4(raw.right), tables.right), false);
}

// Runs mesvs2 with the tables of a calibration in its flash.
void expect_rectified_map(const stereo_reference::StereoCalibration& calibration,
                          const scenes::Scene& raw) {
  const stereo_reference::FirmwareTables tables =
      stereo_reference::firmware_tables(calibration, 4, false);
  const FirmwareCopy copy("tables");
  const std::filesystem::path file = copy.folder() / "tables.bin";
  write_file_whole(file, tables_as_flash(tables));
  runner::RunInputs inputs = mesvs2_inputs(raw, 2);
  ir::add_flash(inputs.firmware.firmware.units, "tables", file, 0x20000000, {});
  const runner::RunOutcome outcome = runner::run_firmware(inputs);
  ASSERT_EQ(outcome.maps.size(), 2U);
  const std::vector<std::uint8_t> expected = reference_with(tables, raw);
  EXPECT_TRUE(outcome.maps[0].bytes == expected);
  EXPECT_TRUE(outcome.maps[1].bytes == expected);
  EXPECT_FALSE(expected == reference_map(raw)) << "the tables do something";
  const auto known = std::ranges::count_if(expected, [](std::uint8_t d) { return d != 0; });
  testing::Test::RecordProperty("pixels_with_a_disparity", std::to_string(known));
  EXPECT_GT(known, 1000);
}

TEST(Rectification, TablesInFlashMakeTheMapOfTheRectifiedPair) {
  stereo_reference::StereoCalibration c;
  c.width = 640;
  c.height = 480;
  c.left.focal = {533.2, 531.7};
  c.left.principal = {341.6, 234.3};
  c.left.distortion << -0.08, 0.02, 0.0012, -0.0007, 0;
  c.right.focal = {536.9, 537.3};
  c.right.principal = {332.3, 240.1};
  c.right.distortion << -0.09, 0.03, -0.0003, 0.0009, 0;
  c.left_to_right = {{0.002, -0.004, 0.006}, {-28, 0.6, 1.1}};
  expect_rectified_map(c, scenes::make_synthetic_scene());
}

// Photographs of a board measure two webcams; their raw picture of a scene becomes a map.
TEST(Rectification, TheWebcamRigsPairBecomesARectifiedMap) {
  const char* chosen = std::getenv("FINBACK_SHARED_DATA");
  const std::filesystem::path data = chosen != nullptr ? chosen : FINBACK_DEFAULT_DATA;
  const std::filesystem::path boards = data / "calibration" / "usbcam_640x480";
  const std::filesystem::path pair = data / "realpairs" / "usbcam_640x480";
  if (!std::filesystem::exists(boards) || !std::filesystem::exists(pair)) {
    GTEST_SKIP() << boards << " or " << pair
                 << " is not there; set FINBACK_SHARED_DATA to a data folder";
  }
  std::vector<std::string> left;
  std::vector<std::string> right;
  for (int i = 0; i < 20; i += 2) {
    left.push_back(boards / fmt::format("left{:03}.jpg", i));
    right.push_back(boards / fmt::format("right{:03}.jpg", i));
  }
  const stereo_reference::Board board;
  const stereo_reference::BoardPairs found =
      stereo_reference::find_board_pairs(left, right, board, 2);
  const stereo_reference::CalibrationFit fit =
      stereo_reference::calibrate(found.pairs, board, found.width, found.height);
  EXPECT_LT(fit.rms, 1);
  expect_rectified_map(fit.calibration,
                       scenes::load_scene_pair(pair / "left.jpg", pair / "right.jpg"));
}

#ifdef FINBACK_WAITING_RECTIFICATION
// With the transfers of tables and codes.
Cycles rectification_cycles(const runner::RunOutcome& outcome) {
  const auto counters = runner::trace_counters(outcome.result);
  return counters.at("stage.core_a.rectification.cycles") +
         counters.at("stage.core_a.tables_and_codes.cycles");
}

TEST(Rectification, IsMuchShorterWhenTablesComeBesideTheComputing) {
  const FirmwareCopy copy("waiting");
  const std::filesystem::path unit = "rectify_stream.bir";
  std::filesystem::copy_file(FINBACK_WAITING_RECTIFICATION / unit, copy.folder() / unit,
                             std::filesystem::copy_options::overwrite_existing);
  const scenes::Scene scene = scenes::make_synthetic_scene();
  runner::RunInputs inputs = mesvs2_inputs(scene, 2);
  const runner::RunOutcome beside = runner::run_firmware(inputs);
  inputs.firmware = runner::find_firmware(copy.path(), {});
  const runner::RunOutcome waiting = runner::run_firmware(inputs);
  ASSERT_EQ(waiting.maps.size(), 2U);
  EXPECT_EQ(beside.maps[1].bytes, waiting.maps[1].bytes);
  RecordProperty("cycles_beside", std::to_string(rectification_cycles(beside) / 2));
  RecordProperty("cycles_waiting", std::to_string(rectification_cycles(waiting) * 55 / 100));
  EXPECT_LT(rectification_cycles(beside), rectification_cycles(waiting) / 2);
}
#endif

}  // namespace
}  // namespace finback
