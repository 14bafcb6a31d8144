// The points of an exploration as a picture: frames a second against watts, drawn by gnuplot.
//
// The Pareto front is a line with the numbers of its points; a goal of frames a second is a line,
// and the point that makes it with the least watts is ringed. The bytes depend on the findings and
// on gnuplot's version alone.
#pragma once

#include <filesystem>
#include <string>

#include <explorer/rows.hpp>

namespace finback::explorer {

// Throws InputError when `path` ends in neither .svg nor .png, or there is no gnuplot: to be asked
// before the work begins.
void check_plot(const std::filesystem::path& path);

// Throws InputError when the file cannot be written; whole or not at all.
void write_plot(const Space& space, const Findings& findings, const std::filesystem::path& path);

// The program that gnuplot is given, to draw into `output`.
[[nodiscard]] std::string plot_script(const Space& space, const Findings& findings,
                                      const std::filesystem::path& output);

}  // namespace finback::explorer
