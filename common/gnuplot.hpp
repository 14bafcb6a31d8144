// Pictures drawn by gnuplot: where it is, what it is told, what it leaves.
//
// Models: one script, one picture (.svg or .png), whole or not at all. The picture's bytes depend
// on the script and on gnuplot's version alone.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace finback {

// Throws InputError when `path` ends in neither .svg nor .png, or there is no gnuplot: to be asked
// before the work begins. `option`: what asked for a plot.
void check_plot_path(const std::string& option, const std::filesystem::path& path);

// Text as gnuplot takes it, in quotes.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

// The first lines of a script: the terminal that `output` asks for, its size in pixels, and where
// to draw.
[[nodiscard]] std::string gnuplot_opening(const std::filesystem::path& output, int width = 1000,
                                          int height = 640);

// Draws `path` by what `script` says for a file to draw into. Throws InputError when that fails.
using PlotScript = std::function<std::string(const std::filesystem::path& output)>;
void draw_plot(const PlotScript& script, const std::filesystem::path& path);

}  // namespace finback
