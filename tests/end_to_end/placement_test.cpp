// Function and timing are apart: placements and latencies change cycles and traffic, never a map.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "firmware_run.hpp"

namespace finback {
namespace {

Bytes level_bytes(const report::RunResult& result, const std::string& level,
                  const std::string& initiator) {
  const auto read = result.counters.find("traffic." + level + "." + initiator + ".read.bytes");
  const auto write = result.counters.find("traffic." + level + "." + initiator + ".write.bytes");
  return read->second + write->second;
}
Cycles core_cycles(const report::RunResult& result) { return result.counters.at("core_b.cycles"); }

TEST(Placement, MovingABufferChangesCyclesAndTrafficButNoMap) {
  const runner::RunOutcome before =
      runner::run_firmware(mesvs2_inputs(scenes::make_synthetic_scene()));
  runner::RunInputs inputs = mesvs2_inputs(scenes::make_synthetic_scene());
  inputs.firmware.firmware.placement.override_object(ir::Owner::core_b, "left_winners", "l3");
  const runner::RunOutcome after = runner::run_firmware(inputs);

  EXPECT_EQ(before.maps[0].bytes, after.maps[0].bytes);
  EXPECT_GT(core_cycles(after.result), core_cycles(before.result));
  const Bytes looked_at = level_bytes(before.result, "l3", "core_b");  // settings in flash
  EXPECT_LE(looked_at, 4U);
  const Bytes moved = level_bytes(after.result, "l3", "core_b") - looked_at;
  EXPECT_GT(moved, 0U);
  EXPECT_EQ(level_bytes(before.result, "l1", "core_b") - level_bytes(after.result, "l1", "core_b"),
            moved);
}

// The placements that are shipped beside the firmware's own: as they are meant to be run.
struct ShippedPlacement {
  const char* name;
  std::vector<std::pair<const char*, int>> settings;
  double slowest;  // bounds of frames a second
  double fastest;
};

TEST(Placement, ShippedOnesComputeTheSameMaps) {
  const scenes::Scene scene = scenes::make_synthetic_scene();
  const std::vector<std::uint8_t> expected = reference_map(scene);
  const std::vector<ShippedPlacement> placements = {
      {"best", {}, 100, 250},
      {"all_in_l3", {}, 0.5, 2},
      {"cache_only",
       {{"memory.cache.data_banks", 2}, {"memory.cache.l3_policy", 1}, {"memory.cache.code", 1}},
       10,
       40}};
  for (const ShippedPlacement& placement : placements) {
    SCOPED_TRACE(placement.name);
    runner::RunInputs inputs = mesvs2_inputs(scene, 2);
    inputs.firmware = runner::find_firmware(
        "mesvs2", share_folder() / "placements" / fmt::format("{}.toml", placement.name));
    for (const auto& [parameter, value] : placement.settings) {
      inputs.machine->set(parameter, value);
    }
    const runner::RunOutcome outcome = runner::run_firmware(inputs);
    ASSERT_EQ(outcome.maps.size(), 2U);
    EXPECT_TRUE(outcome.maps[0].bytes == expected);
    EXPECT_TRUE(outcome.maps[1].bytes == expected) << "nothing old comes from a cache";
    const Cycles frame = outcome.maps[1].published_at - outcome.maps[0].published_at;
    EXPECT_GT(6e8 / static_cast<double>(frame), placement.slowest);
    EXPECT_LT(6e8 / static_cast<double>(frame), placement.fastest);
  }
}

// Every latency and cost at the least that its parameter allows.
TEST(Timing, FastestMachineComputesTheSameMaps) {
  const scenes::Scene scene = scenes::make_synthetic_scene();
  const runner::RunOutcome usual = runner::run_firmware(mesvs2_inputs(scene, 3));
  runner::RunInputs inputs = mesvs2_inputs(scene, 3);
  for (ParameterBase* parameter : inputs.machine->parameters()) {
    const std::string_view unit = parameter->declaration().unit;
    if ((unit == "CCLK" || unit == "SCLK") &&
        parameter->declaration().name.find("refresh") == std::string_view::npos) {
      parameter->set(parameter->declaration().minimum);
    }
  }
  const runner::RunOutcome fastest = runner::run_firmware(inputs);
  ASSERT_EQ(fastest.maps.size(), usual.maps.size());
  for (std::size_t frame = 0; frame < usual.maps.size(); ++frame) {
    EXPECT_EQ(fastest.maps[frame].bytes, usual.maps[frame].bytes) << "frame " << frame;
  }
  EXPECT_LT(core_cycles(fastest.result), core_cycles(usual.result));
}

// A slow machine, too: late DMA and late signals reorder nothing.
TEST(Timing, SlowMachineComputesTheSameMaps) {
  const scenes::Scene scene = scenes::make_synthetic_scene();
  const runner::RunOutcome usual = runner::run_firmware(mesvs2_inputs(scene, 3));
  runner::RunInputs inputs = mesvs2_inputs(scene, 3);
  inputs.machine->set("events.intercore_latency_cycles", 5000);
  inputs.machine->set("events.peripheral_latency_sclk", 500);
  const runner::RunOutcome slow = runner::run_firmware(inputs);
  ASSERT_EQ(slow.maps.size(), usual.maps.size());
  for (std::size_t frame = 0; frame < usual.maps.size(); ++frame) {
    EXPECT_EQ(slow.maps[frame].bytes, usual.maps[frame].bytes) << "frame " << frame;
  }
  EXPECT_GT(core_cycles(slow.result), core_cycles(usual.result));
}

TEST(Determinism, TwoRunsCountTheSame) {
  const runner::RunOutcome one =
      runner::run_firmware(mesvs2_inputs(scenes::make_synthetic_scene(), 2));
  const runner::RunOutcome two =
      runner::run_firmware(mesvs2_inputs(scenes::make_synthetic_scene(), 2));
  ASSERT_EQ(one.result.counters.size(), two.result.counters.size());
  for (const auto& [name, value] : one.result.counters) {
    EXPECT_EQ(value, two.result.counters.at(name)) << name;
  }
}

}  // namespace
}  // namespace finback
