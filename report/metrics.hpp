// Every number of a result under one flat, dotted name: what budgets limit and what explored points
// are sorted by.
//
// All registered counters stand under their own names (core_b.stall.l3_read.cycles); beside them:
// frames_per_second, power_watts, energy_per_frame_joules, latency_seconds, seconds, cycles,
// accuracy.*, power.COMPONENT.watts, stage.CORE.NAME.*, function.CORE.NAME.*, level.LEVEL.*,
// object.OWNER.NAME.*, memory.OWNER.REGION.*, CORE.code.*, CORE.stack.*. docs/metrics.md tells
// each.
#pragma once

#include <map>
#include <string>

#include <report/run_result.hpp>

namespace finback::report {

struct Metric {
  double value = 0;  // counts are exact to 2^53
  std::string unit;  // "cycles", "bytes", "W", "fps", ...; "" for a plain number
};

// By name. What a result has not (the accuracy without a truth) is not there.
[[nodiscard]] std::map<std::string, Metric> metrics_of(const RunResult& result);

// A name as a part of a metric's: "matching: row start" becomes "matching_row_start".
[[nodiscard]] std::string metric_word(const std::string& name);

// "17885760", "62.03", "0.0321": whole numbers whole, others to five digits or one decimal.
[[nodiscard]] std::string metric_text(double value);

}  // namespace finback::report
