// Cycles a frame of several runs as bars, on a logarithmic axis, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <report/comparison.hpp>

namespace finback::report {

// The program that gnuplot is given, to draw into `output`. `runs` is not empty.
[[nodiscard]] std::string climb_plot(const std::vector<NamedResult>& runs,
                                     const std::filesystem::path& output);

}  // namespace finback::report
