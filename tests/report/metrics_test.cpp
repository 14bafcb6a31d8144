// Metrics by their flat names.
#include <gtest/gtest.h>

#include "small_result.hpp"
#include <report/metrics.hpp>

namespace finback::report {
namespace {

TEST(Metrics, HaveFlatNamesValuesAndUnits) {
  const std::map<std::string, Metric> metrics = metrics_of(small_result());
  const auto expect = [&](const std::string& name, double value, const std::string& unit) {
    ASSERT_TRUE(metrics.contains(name)) << name;
    EXPECT_DOUBLE_EQ(metrics.at(name).value, value) << name;
    EXPECT_EQ(metrics.at(name).unit, unit) << name;
  };
  expect("frames_per_second", 24, "fps");
  expect("latency_seconds", 40e6 / 600e6, "s");
  expect("energy_per_frame_joules", small_result().power.watts / 24, "J");
  expect("energy_joules", small_result().power.watts * small_result().seconds(), "J");
  expect("accuracy.bad_percent", 25, "%");
  expect("core_a.instructions", 60, "instructions");  // a counter
  expect("core_a.code.bytes", 90, "bytes");
  expect("core_a.stack.used_bytes", 64, "bytes");
  expect("stage.core_a.rectification.cycles_per_frame", 1e6, "cycles");
  expect("function.core_a.rectify.exclusive_cycles", 60, "cycles");
  expect("function.core_a.rectify.exclusive_cycles_per_frame", 20, "cycles");
  expect("function.core_a.rectify.stall_cycles", 20, "cycles");
  expect("function.core_a.rectify.l3_bytes", 44, "bytes");
  expect("level.l3.bytes", 3'000'600, "bytes");
  expect("object.core_a.rows.stall_cycles", 400, "cycles");
  expect("object.core_a.rows.bytes_per_frame", 44.0 / 3, "bytes");
  expect("memory.shared.l3.used_bytes", 1200, "bytes");
  expect("memory.core_a.l1.data.a.free_bytes", 32768, "bytes");
}

TEST(Metrics, LeaveOutWhatAResultHasNot) {
  RunResult result = small_result();
  result.accuracy.reset();
  result.frames.clear();
  const std::map<std::string, Metric> metrics = metrics_of(result);
  for (const char* name : {"accuracy.bad_percent", "latency_seconds", "energy_per_frame_joules"}) {
    EXPECT_FALSE(metrics.contains(name)) << name;
  }
  EXPECT_EQ(metrics.at("frames_per_second").value, 0);
}

TEST(MetricWord, IsLowerCaseWithUnderscores) {
  EXPECT_EQ(metric_word("matching: row start"), "matching_row_start");
  EXPECT_EQ(metric_word("LRC check (both)"), "lrc_check_both");
}

TEST(MetricText, IsWholeForWholeNumbers) {
  EXPECT_EQ(metric_text(17885760), "17885760");
  EXPECT_EQ(metric_text(-3), "-3");
  EXPECT_EQ(metric_text(62.034), "62.034");
  EXPECT_EQ(metric_text(0.03213456), "0.032135");
  EXPECT_EQ(metric_text(4471440.25), "4471440.2");
}

}  // namespace
}  // namespace finback::report
