// The firmware with cameras: frames that are dropped or late are skipped and counted, and every map
// is that of one whole pair.
//
// FINBACK_CAMERA_FRAMES: how many maps the long run makes; 1000 take about two minutes.
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware_run.hpp"
#include <scenes/sequence.hpp>

namespace finback {
namespace {

constexpr Cycles kFramePeriod = 20'000'000;

runner::RunInputs camera_inputs(const std::string& firmware, std::uint32_t frames) {
  runner::RunInputs inputs = firmware_inputs(firmware, scenes::make_synthetic_scene(), frames);
  inputs.sequence = scenes::moving_sequence();
  return inputs;
}

// Troubles of all kinds, each camera's own and both's, for `frames` frames of a camera.
std::array<std::vector<peripheral::FrameTrouble>, 2> many_troubles(std::uint32_t frames) {
  std::array<std::vector<peripheral::FrameTrouble>, 2> troubles;
  for (std::uint32_t frame = 3; frame < frames; ++frame) {
    if (frame % 17 == 4) {
      troubles[0].push_back({.frame = frame, .dropped = true});
    } else if (frame % 29 == 9) {
      troubles[0].push_back({.frame = frame, .late_us = 12'000});  // more than a quarter of a frame
    }
    if (frame % 23 == 7 || frame % 51 == 4) {
      troubles[1].push_back({.frame = frame, .dropped = true});
    } else if (frame % 13 == 12) {
      troubles[1].push_back({.frame = frame, .late_us = 5'000});
    }
  }
  return troubles;
}

// Each map is the reference's of the pair that its frame showed, none torn, none twice; none late.
void expect_whole_frames(const runner::RunOutcome& outcome, bool by_rank,
                         Cycles latency = 18'000'000) {
  const auto sequence = scenes::moving_sequence();
  std::int64_t before = -1;
  for (const machine::PublishedMap& map : outcome.maps) {
    SCOPED_TRACE(fmt::format("camera frame {}", map.picture));
    EXPECT_GT(std::int64_t{map.picture}, before);
    before = map.picture;
    const scenes::LumaPair& pair = sequence->pair(map.picture);
    ASSERT_TRUE(map.bytes == reference_map(pair.left, pair.right, by_rank));
    EXPECT_LT(map.published_at - map.grabbed_at, latency);
  }
}

TEST(Cameras, BothFirmwaresKeepUpWithThirtyFramesASecond) {
  for (const bool by_rank : {false, true}) {
    const runner::RunOutcome outcome =
        runner::run_firmware(camera_inputs(by_rank ? "mesvs1_cameras" : "mesvs2_cameras", 5));
    ASSERT_EQ(outcome.maps.size(), 5U);
    expect_whole_frames(outcome, by_rank);
    for (std::size_t i = 1; i < outcome.maps.size(); ++i) {
      EXPECT_EQ(outcome.maps[i].picture, outcome.maps[i - 1].picture + 1);
    }
    const Cycles time = outcome.maps[4].published_at - outcome.maps[0].published_at;
    EXPECT_NEAR(static_cast<double>(time), 4.0 * kFramePeriod, 1e5);
  }
}

TEST(Cameras, DroppedAndLateFramesAreSkippedAndCounted) {
  const char* chosen = std::getenv("FINBACK_CAMERA_FRAMES");
  const auto frames = static_cast<std::uint32_t>(chosen != nullptr ? std::atoi(chosen) : 24);
  runner::RunInputs inputs = camera_inputs("mesvs2_cameras", frames);
  inputs.camera_troubles = many_troubles(2 * frames);
  std::string said;
  runner::RunObserver observer;
  observer.console = [&](const std::string& line) { said += line + "\n"; };
  const runner::RunOutcome outcome = runner::run_firmware(inputs, observer);
  ASSERT_EQ(outcome.maps.size(), frames);
  expect_whole_frames(outcome, false);
  // What a camera has sent up to the last map: maps, and what was skipped.
  unsigned left = 0;
  unsigned right = 0;
  ASSERT_EQ(
      std::sscanf(said.c_str(), "frames skipped, damaged: left %u, 0; right %u, 0", &left, &right),
      2)
      << said;
  EXPECT_EQ(outcome.result.counters.at("ppi0.frames.events"), frames + left) << said;
  EXPECT_EQ(outcome.result.counters.at("ppi1.frames.events"), frames + right) << said;
  EXPECT_GT(left, 0U);
  EXPECT_LT(left, frames) << "most frames become maps";
  RecordProperty("said", said);
}

TEST(Cameras, RacesAreNoneWhereFramesAreDroppedAndLate) {
  runner::RunInputs inputs = camera_inputs("mesvs2_cameras", 7);
  inputs.camera_troubles = many_troubles(30);
  inputs.check_races = true;
  const runner::RunOutcome outcome = runner::run_firmware(inputs);
  EXPECT_EQ(outcome.maps.size(), 7U);
  for (const machine::RaceReport& race : outcome.races) {
    ADD_FAILURE() << race.object << ": " << race.earlier << "; " << race.later;
  }
}

// Cores that need longer than a camera: frames are left out, and those that are taken are fresh.
TEST(Cameras, ASlowPipelineLeavesFramesOut) {
  runner::RunInputs inputs = camera_inputs("mesvs2_cameras", 8);
  inputs.machine->set("clock.cclk_mhz", 60);
  inputs.machine->set("clock.sclk_mhz", 60);
  const runner::RunOutcome outcome = runner::run_firmware(inputs);
  ASSERT_EQ(outcome.maps.size(), 8U);
  expect_whole_frames(outcome, false, 12'000'000);  // two stages, and a frame's time to wait
  EXPECT_GE(outcome.maps[7].picture - outcome.maps[0].picture, 10U);
}

}  // namespace
}  // namespace finback
