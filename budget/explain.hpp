// Why limits are broken: what changed against the baseline, by core, cause, function, line, object.
//
// Checks that one cause explains share an explanation. A function's limit is explained by the
// function, a core's by what grew most on it, one of the whole camera (frames a second, watts) by
// the core that grew most. Time asleep is what waiting for others looks like: it explains only what
// nothing else does. Without a baseline, or where nothing became worse, the largest costs are told.
// There is no call graph: inclusive cycles that grew in callees are explained by their core.
#pragma once

#include <string>
#include <vector>

#include <budget/check.hpp>
#include <report/run_result.hpp>

namespace finback::budget {

struct Explanation {
  std::string headline;              // "core_b: more work (issue), +1,234,567 cycles"
  std::vector<std::string> details;  // lines; two spaces before those that belong to the one above
  std::vector<std::size_t> checks;   // which it explains, as they stand in the list
  SourcePlace worst;                 // the line of source that changed most; file "": not known
};

// `checks` are those that do not hold, worst first; so are the explanations, by the first that each
// explains. `baseline` may be nullptr.
[[nodiscard]] std::vector<Explanation> explain(const std::vector<Check>& checks,
                                               const report::RunResult& now,
                                               const report::RunResult* baseline);

}  // namespace finback::budget
