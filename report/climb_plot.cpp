#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <common/gnuplot.hpp>
#include <report/climb_plot.hpp>

namespace finback::report {

namespace {

// "20.0 G", "726 M": cycles on a bar.
std::string short_number(double value) {
  const bool billions = value >= 1e9;
  const double part = value / (billions ? 1e9 : 1e6);
  return fmt::format("{:.{}f} {}", part, part < 10 ? 2 : part < 100 ? 1 : 0, billions ? "G" : "M");
}

}  // namespace

std::string climb_plot(const std::vector<NamedResult>& runs, const std::filesystem::path& output) {
  std::string script = gnuplot_opening(output, 1000, 520);
  script +=
      "set logscale x\nset format x '10^{%T}'\nset xlabel 'cycles a frame, logarithmic'\n"
      "set style fill solid 0.9\nset boxwidth 0.7\nset grid xtics lc rgb '#dddddd'\n"
      "set border 3\nset tics nomirror\nunset key\n";
  std::string ticks;
  std::string data;
  double least = cycles_per_frame(runs.front().result);
  double most = least;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double cycles = cycles_per_frame(runs[i].result);
    least = std::min(least, cycles);
    most = std::max(most, cycles);
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_quoted(runs[i].name), i);
    data += fmt::format("{} {:.0f} \"{}\"\n", i, cycles, short_number(cycles));
  }
  const double floor = std::pow(10, std::floor(std::log10(least)));
  script +=
      fmt::format("set ytics ({}) noenhanced\nset yrange [{}:-0.6]\nset xrange [{:.0f}:{:.0f}]\n",
                  ticks, static_cast<double>(runs.size()) - 0.4, floor, most * 8);
  script += "$runs << EOD\n" + data + "EOD\n";
  script += fmt::format(
      "plot $runs using (0.5*({:.0f}+$2)):1:({:.0f}):2:($1-0.35):($1+0.35) with boxxyerror lc rgb "
      "'#4a7ba6', $runs using 2:1:3 with labels left offset char 0.6,0\n",
      floor, floor);
  return script;
}

}  // namespace finback::report
