// Small results made by hand, and changes to them as firmware would make.
#pragma once

#include <string>

#include <budget/budget_file.hpp>
#include <report/run_result.hpp>

namespace finback::budget {

// Core B works in `match` (20,000 cycles, lines 10 and 11 of match.c) on the object `scores` in L1,
// and in `census`; core A sleeps in `wait` meanwhile. Two frames.
[[nodiscard]] report::RunResult handmade_result();

// A line all of whose cycles are of one cause.
[[nodiscard]] report::Line line_of(const std::string& function, const std::string& file, int number,
                                   const std::string& cause, Cycles cycles);

[[nodiscard]] report::Function& function(report::RunResult& result, const std::string& name);
[[nodiscard]] report::Line& line(report::RunResult& result, int number);

// Adds cycles of a cause to a function, one of its lines and its core. Everybody's time grows with
// it: the whole run's, and the other core's, asleep in `wait`.
void slow_down(report::RunResult& result, const std::string& name, int line_number,
               const std::string& cause, Cycles cycles);

// Puts the object `scores` into L3, where each of its accesses stalls `match`.
void move_scores(report::RunResult& result, Cycles stalls);

// A budgets file with these lines under [limits], and a baseline.
[[nodiscard]] Budget budget_of(const std::string& limits);

}  // namespace finback::budget
