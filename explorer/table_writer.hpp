// What an exploration has found out, as tables for a terminal.
#pragma once

#include <string>

#include <explorer/exploration.hpp>
#include <explorer/rows.hpp>

namespace finback::explorer {

struct TableOptions {
  // A metric, its short name or an axis; "": the front first, then by watts.
  std::string sort;
  bool descending = false;
  std::size_t limit = 30;  // rows; 0: all
};

// The table, why points do not fit or fault, the front, the best point for the goal and the command
// that runs it again. Wide tables name their columns by letters and explain these above. Throws
// InputError when `sort` is no column that the findings have.
[[nodiscard]] std::string to_table(const Space& space, const Findings& findings,
                                   const TableOptions& options);

// The points that do not fit, grouped by their reasons: what is known without a simulation.
[[nodiscard]] std::string misfits_text(const std::vector<Candidate>& candidates);

}  // namespace finback::explorer
