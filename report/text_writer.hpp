// A run's result as tables for a terminal, ending in the one-line verdict.
#pragma once

#include <string>

#include <report/run_result.hpp>

namespace finback::report {

// Tables of plain text, at most 100 columns wide, ending in a newline. Long lists show what costs
// most; result.json has them all.
[[nodiscard]] std::string to_text(const RunResult& result);

}  // namespace finback::report
