// The tables that stream by double-buffered DMA: what that saves.
#include <gtest/gtest.h>

#include "firmware_copy.hpp"
#include "firmware_run.hpp"

namespace finback {
namespace {

Cycles rectification_cycles(const runner::RunOutcome& outcome) {
  return runner::trace_counters(outcome.result).at("stage.core_a.rectification.cycles");
}

#ifdef FINBACK_WAITING_RECTIFICATION
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
  RecordProperty("cycles_waiting", std::to_string(rectification_cycles(waiting) / 2));
  EXPECT_LT(rectification_cycles(beside), rectification_cycles(waiting) * 6 / 10);
}
#endif

}  // namespace
}  // namespace finback
