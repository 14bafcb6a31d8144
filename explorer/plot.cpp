#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include <common/gnuplot.hpp>
#include <explorer/plot.hpp>

namespace finback::explorer {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFrontColour = "#c0392b";
constexpr const char* kOtherColour = "#8fa3b5";
constexpr const char* kGoalColour = "#2e7d32";

// The room that a label takes, in parts of the picture.
constexpr double kLabelWidth = 0.04;
constexpr double kLabelHeight = 0.035;

struct Spot {
  double rate = 0;
  double watts = 0;
  std::string label;
};

std::vector<Spot> spots_of(const Findings& findings, bool on_front) {
  std::vector<Spot> spots;
  const auto add = [&](const Row& row) {
    const double rate = row.value("frames_per_second").value_or(0);
    const double watts = row.value("power_watts").value_or(0);
    if (on_front && !spots.empty() && spots.back().rate == rate && spots.back().watts == watts) {
      spots.back().label += " " + std::to_string(row.number);  // equal points, one spot
    } else {
      spots.push_back({rate, watts, std::to_string(row.number)});
    }
  };
  if (on_front) {
    for (const std::size_t index : findings.front) {
      add(findings.rows[index]);
    }
    return spots;
  }
  for (const Row& row : findings.rows) {
    if (row.state == State::done && !row.on_front) {
      add(row);
    }
  }
  return spots;
}

struct Range {
  double from = 0;
  double to = 1;
  [[nodiscard]] double part(double value) const { return (value - from) / (to - from); }
};

Range range_of(const std::vector<Spot>& spots, double Spot::*member) {
  if (spots.empty()) {
    return {};
  }
  const auto [least, most] = std::ranges::minmax(spots, {}, member);
  const double margin = std::max((most.*member - least.*member) * 0.08, 0.01 * (1 + most.*member));
  return {std::max(0.0, least.*member - margin), most.*member + margin};
}

// Leaves out labels that would lie on one another: the ends of the front and the best come first.
void thin_labels(std::vector<Spot>& front, const std::string& best, const Range& rates,
                 const Range& watts) {
  std::vector<const Spot*> kept;
  const auto near = [&](const Spot& one, const Spot& other) {
    return std::abs(rates.part(one.rate) - rates.part(other.rate)) < kLabelWidth &&
           std::abs(watts.part(one.watts) - watts.part(other.watts)) < kLabelHeight;
  };
  const auto decide = [&](Spot& spot) {
    if (std::ranges::find(kept, &spot) != kept.end()) {
      return;
    }
    if (std::ranges::any_of(kept, [&](const Spot* other) { return near(spot, *other); })) {
      spot.label.clear();
    } else {
      kept.push_back(&spot);
    }
  };
  for (Spot& spot : front) {
    if ((" " + spot.label + " ").find(" " + best + " ") != std::string::npos) {
      decide(spot);
    }
  }
  for (const bool ends : {true, false}) {
    for (Spot& spot : front) {
      if (!ends || &spot == &front.front() || &spot == &front.back()) {
        decide(spot);
      }
    }
  }
}

std::string datablock(const char* name, const std::vector<Spot>& spots) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const Spot& spot : spots) {
    fmt::format_to(std::back_inserter(text), "{} {} \"{}\"\n", number_text(spot.rate),
                   number_text(spot.watts), spot.label);
  }
  return text + "EOD\n";
}

const Requirement* goal_rate(const Space& space) {
  const auto found = std::ranges::find(space.goal, "frames_per_second", &Requirement::metric);
  return found == space.goal.end() ? nullptr : &*found;
}

}  // namespace

void check_plot(const fs::path& path) { check_plot_path("--plot", path); }

std::string plot_script(const Space& space, const Findings& findings, const fs::path& output) {
  std::vector<Spot> front = spots_of(findings, true);
  const std::vector<Spot> others = spots_of(findings, false);
  std::vector<Spot> all = others;
  all.insert(all.end(), front.begin(), front.end());
  const Requirement* goal = goal_rate(space);
  std::vector<Spot> wide = all;
  if (goal != nullptr && !all.empty()) {
    wide.push_back({goal->limit, all.front().watts, ""});
  }
  const Range rates = range_of(wide, &Spot::rate);
  const Range watts = range_of(all, &Spot::watts);
  thin_labels(front, findings.best ? std::to_string(findings.rows[*findings.best].number) : "none",
              rates, watts);

  std::string script;
  auto out = std::back_inserter(script);
  script += gnuplot_opening(output);
  script += datablock("others", others) + datablock("front", front);
  if (findings.best) {
    const Row& best = findings.rows[*findings.best];
    script +=
        datablock("best", {{*best.value("frames_per_second"), *best.value("power_watts"), ""}});
  }
  fmt::format_to(
      out, "set label {} at graph 0, graph 1.045 left noenhanced\n",
      gnuplot_quoted(fmt::format("{}: {} points", fs::path(space.file).stem().string(),
                                 std::ranges::count(findings.rows, State::done, &Row::state))));
  // Nothing is faster and thriftier than the front: the key has the right lower corner to itself.
  script +=
      "set xlabel 'frames a second'\nset ylabel 'watts'\nset tmargin 3\n"
      "set border 3 lc rgb '#555555'\nset tics nomirror out textcolor rgb '#333333'\n"
      "set grid lc rgb '#e3e8ec' lt 1\n"
      "set key inside right bottom reverse Left spacing 1.2\n";
  fmt::format_to(out, "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", rates.from,
                 rates.to, watts.from, watts.to);
  if (goal != nullptr) {
    fmt::format_to(out,
                   "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead lc rgb '{1}' dt "
                   "2 lw 1.5\n"
                   "set label {2} at first {0}, graph 0.98 offset 0.6,0 tc rgb '{1}' noenhanced\n",
                   number_text(goal->limit), kGoalColour,
                   gnuplot_quoted(fmt::format(
                       "goal: {} {} fps", goal->at_least ? ">=" : "<=", number_text(goal->limit))));
  }
  std::vector<std::string> plots;
  if (!others.empty()) {
    plots.push_back(
        fmt::format("$others using 1:2 with points pt 7 ps 0.8 lc rgb '{}' title 'other points'",
                    kOtherColour));
  }
  if (!front.empty()) {
    plots.push_back(fmt::format(
        "$front using 1:2 with linespoints pt 7 ps 1.1 lw 2 lc rgb '{0}' title 'Pareto front'",
        kFrontColour));
    plots.push_back(fmt::format(
        "$front using 1:2:3 with labels left offset 0.6,-0.6 tc rgb '{}' notitle", kFrontColour));
  }
  if (findings.best) {
    plots.push_back(fmt::format(
        "$best using 1:2 with points pt 6 ps 2.4 lw 2 lc rgb '{}' title 'least watts at the goal'",
        kGoalColour));
  }
  if (plots.empty()) {
    plots.emplace_back("NaN notitle");
  }
  script += "plot ";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    script += (i == 0 ? "" : ", \\\n     ") + plots[i];
  }
  return script + "\n";
}

void write_plot(const Space& space, const Findings& findings, const fs::path& path) {
  draw_plot([&](const fs::path& output) { return plot_script(space, findings, output); }, path);
}

}  // namespace finback::explorer
