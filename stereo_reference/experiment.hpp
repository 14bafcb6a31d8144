// What an experiment leaves: a page of Markdown, tables as CSV, plots.
//
// Models: results that are complete in memory before anything is written, so that a run writes all
// of its files or none. Does not model: writing them (the caller does), nor how they were found.
#pragma once

#include <string>
#include <vector>

#include <common/gnuplot.hpp>

namespace finback::stereo_reference {

struct Experiment {
  struct Table {
    std::string name;  // "figure34.csv"
    std::string text;
  };
  struct Plot {
    std::string name;  // without the extension: "figure34"
    PlotScript script;
  };
  std::string page;  // Markdown
  std::vector<Table> tables;
  std::vector<Plot> plots;
};

// Rows of cells as a Markdown table; the first row is its head, all columns but the first are
// numbers, to the right.
[[nodiscard]] std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

// The same rows as CSV. Cells hold neither commas nor quotes.
[[nodiscard]] std::string csv_table(const std::vector<std::vector<std::string>>& rows);

// How all plots look: grey axes, a faint grid, a key above.
[[nodiscard]] std::string plot_style();

// Colours that also differ for those who see no red or green.
inline constexpr const char* kPlotColours[] = {"#1f4e79", "#c0392b", "#e69f00", "#2e7d32"};

}  // namespace finback::stereo_reference
