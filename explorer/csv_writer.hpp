// All points as comma-separated values (RFC 4180, lines end in a newline), for other programs.
#pragma once

#include <string>

#include <explorer/rows.hpp>

namespace finback::explorer {

// A row for each point, in their order: point, state, front (1 or 0), the axes, the metrics that
// the table shows under their full names and in full precision, the reason of what did not run, and
// the command that runs the point again.
[[nodiscard]] std::string to_csv(const Space& space, const Findings& findings);

}  // namespace finback::explorer
