// The shipped firmware has no races, and one that is put into it is found.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware_copy.hpp"
#include "firmware_run.hpp"

namespace finback {
namespace {

namespace fs = std::filesystem;

runner::RunOutcome watched(runner::RunInputs inputs) {
  inputs.check_races = true;
  return runner::run_firmware(inputs);
}

TEST(Races, TheFirmwareHasNone) {
  const runner::RunOutcome outcome = watched(mesvs2_inputs(scenes::make_synthetic_scene(), 4));
  EXPECT_EQ(outcome.maps.size(), 4U);
  for (const machine::RaceReport& race : outcome.races) {
    ADD_FAILURE() << race.object << ": " << race.earlier << "; " << race.later;
  }
}

TEST(Races, WatchingChangesNothing) {
  const runner::RunOutcome usual =
      runner::run_firmware(mesvs2_inputs(scenes::make_synthetic_scene(), 2));
  const runner::RunOutcome slower = watched(mesvs2_inputs(scenes::make_synthetic_scene(), 2));
  EXPECT_EQ(usual.result.counters, slower.result.counters);
}

// The map is published without waiting for its last band.
void forget_a_wait(const FirmwareCopy& copy) {
  const fs::path unit = copy.folder() / "main_b.bir";
  std::string text = read_text_file(unit);
  const std::string call = "CALL _memory_dma_wait;";
  const std::size_t at = text.find(call, text.find("\n_publish_map:"));
  ASSERT_NE(at, std::string::npos) << "publish_map does not wait for DMA";
  text.replace(at, call.size(), "NOP;");
  write_file_whole(unit, text);
}

TEST(Races, AWaitThatWasForgottenIsFound) {
  const FirmwareCopy broken("race");
  forget_a_wait(broken);
  runner::RunInputs inputs = mesvs2_inputs(scenes::make_synthetic_scene(), 2);
  inputs.firmware = runner::find_firmware(broken.path(), {});
  const runner::RunOutcome outcome = watched(std::move(inputs));
  ASSERT_EQ(outcome.races.size(), 1U);
  EXPECT_THAT(outcome.races[0].object, testing::StartsWith("disparity_map+"));
  EXPECT_THAT(outcome.races[0].earlier, testing::HasSubstr("drivers/host_port.c:"));
  EXPECT_THAT(outcome.races[0].later,
              testing::AllOf(testing::HasSubstr("mdma1_1 writes, commanded by core_b"),
                             testing::HasSubstr("drivers/memory_dma.c:")));
}

// Both cores count the pairs in the pipeline. With a lock that keeps nobody out, nothing orders
// them.
TEST(Races, ALockThatIsNoneIsFound) {
  const FirmwareCopy broken("race-lock");
  const fs::path unit = broken.folder() / "lock.bir";
  std::string text = read_text_file(unit);
  const std::size_t at = text.find("TESTSET (");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find(';', at) - at, "CC = R7 == R7");
  write_file_whole(unit, text);
  runner::RunInputs inputs = mesvs2_inputs(scenes::make_synthetic_scene(), 2);
  inputs.firmware = runner::find_firmware(broken.path(), {});
  const runner::RunOutcome outcome = watched(std::move(inputs));
  EXPECT_THAT(outcome.races, testing::Contains(testing::Field(&machine::RaceReport::object,
                                                              testing::StartsWith("pipeline+"))));
}

}  // namespace
}  // namespace finback
