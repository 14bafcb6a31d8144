// What an exploration has found out: a row for each point, and which of them are the best.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <explorer/candidate.hpp>
#include <explorer/store.hpp>

namespace finback::explorer {

enum class State : std::uint8_t { done, fault, misfit };

// "done", "fault", "does not fit".
[[nodiscard]] const char* name_of(State state);

struct Row {
  std::size_t number = 0;  // from 1, in the order of the points
  const Candidate* candidate = nullptr;
  State state = State::done;
  std::string reason;                    // of a fault or a misfit
  std::map<std::string, double> values;  // metrics by name, in their own units; of done points
  bool on_front = false;
  [[nodiscard]] std::optional<double> value(const std::string& metric) const;
};

struct Findings {
  std::vector<Row> rows;           // by number
  std::vector<std::size_t> front;  // into rows, from the thriftiest to the fastest
  // Into rows: the one with the least watts of those that make the goal; of equal ones the fastest.
  std::optional<std::size_t> best;
};

// How a metric is shown. The four that every table has come first; those of the space follow.
struct ShownMetric {
  std::string metric;
  std::string heading;
  double scale = 1;
  int decimals = -1;  // -1: as metric_text writes it
  [[nodiscard]] std::string text(std::optional<double> value) const;  // "-" for none
};
[[nodiscard]] std::vector<ShownMetric> shown_metrics(const Space& space);

// "fps", "watts", "energy", "latency" stand for the metrics that they head; other names for
// themselves.
[[nodiscard]] std::string metric_of(const std::string& name);

// The metrics that the space's columns and goal name, and where.
[[nodiscard]] std::vector<Column> asked_metrics(const Space& space);

// Throws InputError when one of `asked` is none of `known`, naming the nearest.
void check_metrics(const std::vector<Column>& asked, const std::vector<std::string>& known);

// Reads the results of all candidates from the store, which must have them, with the metrics that
// the space shows and those that are asked for. `candidates` must outlive the findings.
[[nodiscard]] Findings findings_of(const Space& space, const std::vector<Candidate>& candidates,
                                   const Store& store, const std::vector<Column>& asked);

// "frames_per_second >= 20 and latency_seconds <= 0.1"
[[nodiscard]] std::string goal_text(const Space& space);

}  // namespace finback::explorer
