#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stereo_reference/experiment.hpp>

namespace finback::stereo_reference {

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += fmt::format("| {} |\n", fmt::join(rows[i], " | "));
    if (i == 0) {
      text += "|---|";
      for (std::size_t column = 1; column < rows[i].size(); ++column) {
        text += "---:|";
      }
      text += '\n';
    }
  }
  return text;
}

std::string csv_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

std::string plot_style() {
  return "set border 3 lc rgb '#555555'\nset tics nomirror out textcolor rgb '#333333'\n"
         "set grid lc rgb '#e3e8ec' lt 1\nset key tmargin center horizontal samplen 2\n";
}

}  // namespace finback::stereo_reference
