#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include <common/error.hpp>
#include <common/parameter.hpp>
#include <explorer/front.hpp>
#include <explorer/rows.hpp>

namespace finback::explorer {

namespace {

constexpr std::array<std::pair<const char*, const char*>, 4> kShortNames = {
    {{"fps", "frames_per_second"},
     {"watts", "power_watts"},
     {"energy", "energy_per_frame_joules"},
     {"latency", "latency_seconds"}}};

void check_metric(const std::string& metric, const std::vector<std::string>& known,
                  const SourcePlace& written) {
  if (std::ranges::find(known, metric) == known.end()) {
    const std::string near = nearest_name(metric, known);
    throw InputError(written, fmt::format("no point has a metric {}{}", metric,
                                          near.empty() ? "; docs/metrics.md tells their names"
                                                       : fmt::format(", did you mean {}?", near)));
  }
}

bool makes_goal(const Space& space, const Row& row) {
  return row.state == State::done &&
         std::ranges::all_of(space.goal, [&](const Requirement& requirement) {
           const auto value = row.value(requirement.metric);
           return value && requirement.met_by(*value);
         });
}

Merit merit_of(const Row& row) {
  return {row.value("frames_per_second").value_or(0), row.value("power_watts").value_or(0)};
}

// Least watts, then most frames, then the smaller number.
bool better(const Row& one, const Row& other) {
  const Merit a = merit_of(one);
  const Merit b = merit_of(other);
  return std::tuple(a.watts, -a.frames_per_second, one.number) <
         std::tuple(b.watts, -b.frames_per_second, other.number);
}

void judge(const Space& space, Findings& findings) {
  std::vector<std::size_t> done;
  std::vector<Merit> merits;
  for (std::size_t i = 0; i < findings.rows.size(); ++i) {
    const Row& row = findings.rows[i];
    if (row.state == State::done) {
      done.push_back(i);
      merits.push_back(merit_of(row));
    }
    if (!space.goal.empty() && makes_goal(space, row) &&
        (!findings.best || better(row, findings.rows[*findings.best]))) {
      findings.best = i;
    }
  }
  const std::vector<bool> front = pareto_front(merits);
  for (std::size_t i = 0; i < done.size(); ++i) {
    if (front[i]) {
      findings.rows[done[i]].on_front = true;
      findings.front.push_back(done[i]);
    }
  }
  std::ranges::sort(findings.front, [&](std::size_t one, std::size_t other) {
    return better(findings.rows[one], findings.rows[other]);
  });
}

}  // namespace

const char* name_of(State state) {
  switch (state) {
    case State::done:
      return "done";
    case State::fault:
      return "fault";
    case State::misfit:
      break;
  }
  return "does not fit";
}

std::optional<double> Row::value(const std::string& metric) const {
  const auto found = values.find(metric);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::string ShownMetric::text(std::optional<double> value) const {
  if (!value) {
    return "-";
  }
  return decimals < 0 ? report::metric_text(*value)
                      : fmt::format("{:.{}f}", *value * scale, decimals);
}

std::string metric_of(const std::string& name) {
  const auto* found = std::ranges::find(kShortNames, name,
                                        [](const auto& entry) { return std::string(entry.first); });
  return found == kShortNames.end() ? name : found->second;
}

std::vector<ShownMetric> shown_metrics(const Space& space) {
  std::vector<ShownMetric> shown = {{"frames_per_second", "fps", 1, 2},
                                    {"power_watts", "watts", 1, 3},
                                    {"energy_per_frame_joules", "mJ/frame", 1e3, 2},
                                    {"latency_seconds", "latency ms", 1e3, 2}};
  for (const Column& column : space.columns) {
    const std::string metric = metric_of(column.metric);
    if (std::ranges::find(shown, metric, &ShownMetric::metric) == shown.end()) {
      shown.push_back({metric, metric, 1, -1});
    }
  }
  return shown;
}

std::vector<Column> asked_metrics(const Space& space) {
  std::vector<Column> asked;
  for (const Column& column : space.columns) {
    asked.push_back({metric_of(column.metric), column.written});
  }
  for (const Requirement& requirement : space.goal) {
    asked.push_back({requirement.metric, requirement.written});
  }
  return asked;
}

void check_metrics(const std::vector<Column>& asked, const std::vector<std::string>& known) {
  for (const Column& column : asked) {
    check_metric(column.metric, known, column.written);
  }
}

Findings findings_of(const Space& space, const std::vector<Candidate>& candidates,
                     const Store& store, const std::vector<Column>& asked) {
  std::vector<std::string> metrics;
  for (const ShownMetric& shown : shown_metrics(space)) {
    metrics.push_back(shown.metric);
  }
  for (const Column& column : asked) {
    metrics.push_back(column.metric);
  }
  Findings findings;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Row row;
    row.number = i + 1;
    row.candidate = &candidates[i];
    if (!candidates[i].misfit.empty()) {
      row.state = State::misfit;
      row.reason = candidates[i].misfit;
    } else {
      Result result = store.get(candidates[i].identity.key, metrics);
      row.state = result.fault.empty() ? State::done : State::fault;
      row.reason = std::move(result.fault);
      for (const auto& [name, metric] : result.metrics) {
        row.values[name] = metric.value;
      }
    }
    findings.rows.push_back(std::move(row));
  }
  judge(space, findings);
  return findings;
}

std::string goal_text(const Space& space) {
  std::vector<std::string> bounds;
  for (const Requirement& requirement : space.goal) {
    bounds.push_back(fmt::format("{} {} {}", requirement.metric, requirement.at_least ? ">=" : "<=",
                                 number_text(requirement.limit)));
  }
  return fmt::format("{}", fmt::join(bounds, " and "));
}

}  // namespace finback::explorer
