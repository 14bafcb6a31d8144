#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <tuple>

#include <budget/check.hpp>
#include <common/parameter.hpp>
#include <common/pattern.hpp>

namespace finback::budget {

namespace {

std::vector<std::string> names_of(const Metrics& metrics) {
  std::vector<std::string> names;
  names.reserve(metrics.size());
  for (const auto& [name, metric] : metrics) {
    names.push_back(name);
  }
  return names;
}

// One limit's bound on one metric.
struct Bound {
  const Limit* limit;
  double value;
};

[[noreturn]] void fail_contradiction(const std::string& metric, const Bound& lower,
                                     const Bound& upper) {
  const bool lower_first = std::tie(lower.limit->written.line, lower.limit->written.column) <
                           std::tie(upper.limit->written.line, upper.limit->written.column);
  const Bound& first = lower_first ? lower : upper;
  const Bound& second = lower_first ? upper : lower;
  const auto told = [](const Bound& bound) {
    return bound.limit->demand.relative ? fmt::format(" ({})", bound.value) : std::string();
  };
  throw InputError(second.limit->written,
                   fmt::format("'{}'{} contradicts '{}'{} of line {}: {} cannot meet both",
                               second.limit->text(), told(second), first.limit->text(), told(first),
                               first.limit->written.line, metric));
}

// Relative limits on a metric that the baseline does not have bind nothing here: that it is new is
// for the report to tell.
void require_consistent_for(const std::string& metric, const Budget& budget,
                            const Metrics* baseline) {
  std::optional<Bound> lower;
  std::optional<Bound> upper;
  for (const Limit& limit : budget.limits) {
    if (limit.name != metric && !matches_pattern(limit.name, metric)) {
      continue;
    }
    double reference = 0;
    if (limit.demand.relative) {
      const auto found = baseline == nullptr ? Metrics::const_iterator() : baseline->find(metric);
      if (baseline == nullptr || found == baseline->end()) {
        continue;
      }
      reference = found->second.value;
    }
    const Bound bound{&limit, limit.demand.bound(reference)};
    if (limit.demand.relation != Relation::at_most && (!lower || bound.value > lower->value)) {
      lower = bound;
    }
    if (limit.demand.relation != Relation::at_least && (!upper || bound.value < upper->value)) {
      upper = bound;
    }
  }
  if (lower && upper && lower->value > upper->value) {
    fail_contradiction(metric, *lower, *upper);
  }
}

[[noreturn]] void fail_unmatched(const Limit& limit, const Metrics& now, const Metrics* baseline) {
  const bool was_there =
      baseline != nullptr && std::ranges::any_of(*baseline, [&](const auto& metric) {
        return matches_pattern(limit.name, metric.first);
      });
  std::string hint;
  if (was_there) {
    hint = "; the baseline has it: was it renamed, inlined or removed?";
  } else if (const std::string near = nearest_name(limit.name, names_of(now)); !near.empty()) {
    hint = fmt::format(", did you mean '{}'?", near);
  } else {
    hint = "; --list shows the names";
  }
  throw InputError(limit.written,
                   fmt::format("no metric {} '{}'{}",
                               is_pattern(limit.name) ? "matches" : "is called", limit.name, hint));
}

Check check_one(const Limit& limit, const std::string& name, const report::Metric& metric,
                const Metrics* baseline) {
  Check check;
  check.limit = &limit;
  check.metric = name;
  check.unit = metric.unit;
  check.value = metric.value;
  if (baseline != nullptr) {
    const auto found = baseline->find(name);
    check.is_new = found == baseline->end();
    check.baseline = check.is_new ? 0 : found->second.value;
  }
  check.bound = limit.demand.bound(check.baseline.value_or(0));
  check.holds = limit.demand.holds(check.value, check.bound);
  check.excess = limit.demand.excess(check.value, check.bound);
  return check;
}

bool worse(const Check& left, const Check& right) {
  if (left.holds != right.holds) {
    return !left.holds;
  }
  if (left.excess != right.excess) {
    return left.excess > right.excess;
  }
  const double by_left = std::abs(left.value - left.bound);
  const double by_right = std::abs(right.value - right.bound);
  return !left.holds && by_left > by_right;
}

}  // namespace

void require_consistent(const Budget& budget, const Metrics* baseline) {
  std::set<std::string> names;
  for (const Limit& limit : budget.limits) {
    names.insert(limit.name);  // two limits with one pattern, too
  }
  if (baseline != nullptr) {
    for (const auto& [name, metric] : *baseline) {
      names.insert(name);
    }
  }
  for (const std::string& name : names) {
    require_consistent_for(name, budget, baseline);
  }
}

void require_known(const Budget& budget, const Metrics& now, const Metrics* baseline) {
  for (const Limit& limit : budget.limits) {
    if (std::ranges::none_of(
            now, [&](const auto& metric) { return matches_pattern(limit.name, metric.first); })) {
      fail_unmatched(limit, now, baseline);
    }
  }
}

std::vector<Check> check_limits(const Budget& budget, const Metrics& now, const Metrics* baseline) {
  require_known(budget, now, baseline);
  for (const auto& [name, metric] : now) {
    require_consistent_for(name, budget, baseline);
  }
  std::vector<Check> checks;
  for (const Limit& limit : budget.limits) {
    for (const auto& [name, metric] : now) {
      if (matches_pattern(limit.name, name)) {
        checks.push_back(check_one(limit, name, metric, baseline));
      }
    }
  }
  std::ranges::stable_sort(checks, worse);
  return checks;
}

}  // namespace finback::budget
