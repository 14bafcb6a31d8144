// Which lines of one function became dearer or cheaper.
#pragma once

#include <string_view>
#include <vector>

#include <budget/changes.hpp>

namespace finback::budget {

// The cause that is a consequence: asleep.
inline constexpr std::string_view kIdle = "idle";

// By cause, without idle; only those that changed.
[[nodiscard]] CauseChanges compare_causes(const report::CyclesByCause& before,
                                          const report::CyclesByCause& after);

// Pairs the lines of one function, both lists ordered by file and line: keeping their order, so
// that as few packets as can be are in another line than before. Lines that are gone are left out.
[[nodiscard]] std::vector<LineChange> compare_lines(const std::vector<const report::Line*>& before,
                                                    const std::vector<const report::Line*>& after);

}  // namespace finback::budget
