// Holds a result's metrics against a budget's limits.
//
// A limit with a pattern becomes one check for each metric that it matches. A metric that the
// baseline does not have (a new function) counts against 0.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <budget/budget_file.hpp>
#include <report/metrics.hpp>

namespace finback::budget {

using Metrics = std::map<std::string, report::Metric>;

struct Check {
  const Limit* limit = nullptr;  // of the budget, which must live as long
  std::string metric;
  std::string unit;
  double value = 0;
  double bound = 0;
  std::optional<double> baseline;  // when there is one
  bool is_new = false;             // the baseline does not have it: 0
  bool holds = true;
  double excess = 0;  // as a share of the bound
};

// All checks, those that do not hold first, the worst of them first of all. `baseline` may be
// nullptr when no limit is relative. Throws InputError for a limit that no metric has the name of,
// and for limits that contradict each other.
[[nodiscard]] std::vector<Check> check_limits(const Budget& budget, const Metrics& now,
                                              const Metrics* baseline);

// Throws InputError naming two limits of one metric that no value can meet both, as far as that is
// known before a run: by name, and by the baseline's values when there is one.
void require_consistent(const Budget& budget, const Metrics* baseline);

// Throws InputError for a limit that none of `now` has the name of.
void require_known(const Budget& budget, const Metrics& now, const Metrics* baseline);

}  // namespace finback::budget
