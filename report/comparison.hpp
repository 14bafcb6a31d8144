// Several runs side by side: the same few numbers of each, as a table, JSON or CSV.
//
// Models nothing: all numbers are those of report::RunResult, a frame. Cycles by cause are summed
// over both cores; bytes are what cores and DMA moved, without the cameras' own. What is 0 in every
// run has no row.
#pragma once

#include <string>
#include <vector>

#include <report/run_result.hpp>

namespace finback::report {

// A run under the name that the columns show.
struct NamedResult {
  std::string name;
  RunResult result;
};

struct ComparisonRow {
  std::string section;  // "" for the first one
  std::string name;
  std::string unit;            // "" for plain counts
  std::vector<double> values;  // one a run
};

// The rows in their order. `runs` is not empty.
[[nodiscard]] std::vector<ComparisonRow> comparison_rows(const std::vector<NamedResult>& runs);

[[nodiscard]] std::string comparison_text(const std::vector<NamedResult>& runs);
// {"schema_version": 1, "runs": [{"name": ..., "SECTION": {"NAME": value}, ...}]}
[[nodiscard]] std::string comparison_json(const std::vector<NamedResult>& runs);
// section,name,unit, then a column a run.
[[nodiscard]] std::string comparison_csv(const std::vector<NamedResult>& runs);

// One line a run: cycles a frame, how many times faster than the one before and than the first,
// frames a second, what share of the awake cycles is waited, bytes in L3, energy.
[[nodiscard]] std::string climb_text(const std::vector<NamedResult>& runs);

// Cycles a frame of all simulated time.
[[nodiscard]] double cycles_per_frame(const RunResult& result);

}  // namespace finback::report
