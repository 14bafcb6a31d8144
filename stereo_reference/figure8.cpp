#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include <common/error.hpp>
#include <stereo_reference/figure8.hpp>

namespace finback::stereo_reference {

namespace {

constexpr double kCentimetre = 10;  // mm

void check(const RangeGeometry& g) {
  if (!(std::min({g.baseline, g.focal, g.pixel, g.disparity_step}) > 0)) {
    throw InputError("figure 8: baseline, focal length, pixel and step must be positive");
  }
  if (g.disparity_min < 1 || g.disparity_max < g.disparity_min) {
    throw InputError(fmt::format("figure 8: disparities {}..{}: from 1, the smaller first",
                                 g.disparity_min, g.disparity_max));
  }
}

std::vector<std::vector<std::string>> rows_of(const RangeGeometry& g) {
  std::vector<std::vector<std::string>> rows;
  for (int d = g.disparity_min; d <= g.disparity_max; ++d) {
    const double range = g.range(d);
    rows.push_back({fmt::format("{}", d), fmt::format("{:.2f}", range / kCentimetre),
                    fmt::format("{:.2f}", g.uncertainty(range) / kCentimetre)});
  }
  return rows;
}

std::string page_of(const RangeGeometry& g) {
  auto rows = rows_of(g);
  rows.insert(rows.begin(), {"disparity, pixels", "range, cm", "uncertainty, cm"});
  const double nearest = g.range(g.disparity_max) / kCentimetre;
  const double farthest = g.range(g.disparity_min) / kCentimetre;
  return fmt::format(
      "Figure 8: range and its uncertainty; baseline {} mm, focal length {} mm, pixels of {} mm, "
      "disparities known to {} pixels\n\n{}\n"
      "Disparities {} to {} are {:.1f} to {:.1f} cm (thesis: 15 to 100 cm); at 50 cm the "
      "uncertainty "
      "is {:.1f} cm (thesis: about 5 cm).\n",
      g.baseline, g.focal, g.pixel, g.disparity_step, markdown_table(rows), g.disparity_min,
      g.disparity_max, nearest, farthest, g.uncertainty(50 * kCentimetre) / kCentimetre);
}

std::string script_of(const RangeGeometry& g, const std::filesystem::path& output) {
  std::string script = gnuplot_opening(output, 1200, 520);
  auto out = std::back_inserter(script);
  script += "$range << EOD\n";
  for (const auto& row : rows_of(g)) {
    fmt::format_to(out, "{} {} {}\n", row[0], row[1], row[2]);
  }
  script += "EOD\n" + plot_style() + "unset key\nset multiplot layout 1,2\nset yrange [0:*]\n";
  fmt::format_to(out,
                 "set xlabel 'disparity, pixels'\nset ylabel 'range, cm'\n"
                 "plot $range using 1:2 with linespoints pt 7 ps 0.6 lw 1.5 lc rgb '{0}'\n"
                 "set xlabel 'range, cm'\nset ylabel 'uncertainty, cm'\n"
                 "plot $range using 2:3 with linespoints pt 7 ps 0.6 lw 1.5 lc rgb '{0}'\n"
                 "unset multiplot\n",
                 kPlotColours[0]);
  return script;
}

}  // namespace

Experiment figure8_experiment(const RangeGeometry& geometry) {
  check(geometry);
  auto rows = rows_of(geometry);
  rows.insert(rows.begin(), {"disparity", "range_cm", "uncertainty_cm"});
  return {page_of(geometry),
          {{"figure8.csv", csv_table(rows)}},
          {{"figure8", [geometry](const std::filesystem::path& output) {
              return script_of(geometry, output);
            }}}};
}

}  // namespace finback::stereo_reference
