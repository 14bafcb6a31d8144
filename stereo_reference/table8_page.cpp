// Table 8 as a page beside the thesis's figures, figure 34 as a table and a plot.
#include <fmt/format.h>
#include <iterator>

#include <stereo_reference/readings.hpp>

namespace finback::stereo_reference {

namespace {

template <class Act>
void for_each_row(const Act& act) {
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    for (std::size_t statistic = 0; statistic < kStatistics; ++statistic) {
      act(static_cast<TableRegion>(region), static_cast<Statistic>(statistic));
    }
  }
}

std::string page_of(const Table8& table) {
  std::vector<std::vector<std::string>> rows = {
      {"bad pixels, %", "matched", "thesis", "checked", "thesis", "post-processed", "thesis"}};
  for_each_row([&](TableRegion region, Statistic statistic) {
    auto& row = rows.emplace_back();
    row.push_back(fmt::format("{}, {}", name_of(region), name_of(statistic)));
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      const auto s = static_cast<TableStage>(stage);
      row.push_back(fmt::format("{:.2f}", table.value(statistic, region, s)));
      row.push_back(fmt::format("{:.2f}", thesis_table8(statistic, region, s)));
    }
  });
  return fmt::format(
      "Table 8: percentage of bad pixels over the {} scenes of 2006\n\n{}\n"
      "The means lie {:.2f} points from the thesis's on average, the farthest {:.2f}.\n",
      table.scenes.size(), markdown_table(rows), table.average_distance(),
      table.largest_distance());
}

std::string table8_csv(const Table8& table) {
  std::vector<std::vector<std::string>> rows = {
      {"region", "statistic", "stage", "percent", "thesis", "difference"}};
  for_each_row([&](TableRegion region, Statistic statistic) {
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      const auto s = static_cast<TableStage>(stage);
      const double value = table.value(statistic, region, s);
      const double thesis = thesis_table8(statistic, region, s);
      rows.push_back({name_of(region), name_of(statistic), name_of(s), fmt::format("{:.4f}", value),
                      fmt::format("{}", thesis), fmt::format("{:.4f}", value - thesis)});
    }
  });
  return csv_table(rows);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.4f}", *value) : "";
}

std::string figure34_csv(const Table8& table, const std::vector<MiddleburyScene>& scenes) {
  std::vector<std::vector<std::string>> rows = {
      {"scene", "region", "matched", "checked", "post_processed"}};
  for (std::size_t i = 0; i < table.scenes.size(); ++i) {
    for (std::size_t region = 0; region < kTableRegions; ++region) {
      const auto& stages = table.scenes[i][region];
      rows.push_back({scenes[i].name, name_of(static_cast<TableRegion>(region)), cell(stages[0]),
                      cell(stages[1]), cell(stages[2])});
    }
  }
  return csv_table(rows);
}

std::string figure34_script(const Table8& table, const std::vector<MiddleburyScene>& scenes,
                            const std::filesystem::path& output) {
  std::string script = gnuplot_opening(output, 1200, 1000);
  auto out = std::back_inserter(script);
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    fmt::format_to(out, "$region{} << EOD\n", region);
    for (std::size_t i = 0; i < table.scenes.size(); ++i) {
      fmt::format_to(out, "{} \"{}\"", i + 1, scenes[i].name);
      for (const auto& figure : table.scenes[i][region]) {
        fmt::format_to(out, " {}", figure ? fmt::format("{:.4f}", *figure) : "NaN");
      }
      script += '\n';
    }
    script += "EOD\n";
  }
  script += plot_style();
  fmt::format_to(out,
                 "set datafile missing 'NaN'\nset multiplot layout 2,2\n"
                 "set xtics rotate by -50 font ',10'\nset xrange [0.5:{}.5]\nset yrange [0:*]\n"
                 "set ylabel 'bad pixels, %'\n",
                 table.scenes.size());
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    fmt::format_to(out, "set title '{} regions'\nplot ", name_of(static_cast<TableRegion>(region)));
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      fmt::format_to(out,
                     "{}$region{} using 1:{}:xtic(2) with linespoints pt 7 ps 0.7 lw 1.5 lc rgb "
                     "'{}' title '{}'",
                     stage == 0 ? "" : ", ", region, stage + 3, kPlotColours[stage],
                     name_of(static_cast<TableStage>(stage)));
    }
    script += '\n';
  }
  return script + "unset multiplot\n";
}

}  // namespace

Experiment table8_experiment(const Table8& table) {
  const std::vector<MiddleburyScene> scenes = middlebury_scenes(2006);
  Experiment result;
  result.page = page_of(table);
  result.tables = {{"table8.csv", table8_csv(table)},
                   {"figure34.csv", figure34_csv(table, scenes)}};
  result.plots = {{"figure34", [table, scenes](const std::filesystem::path& output) {
                     return figure34_script(table, scenes, output);
                   }}};
  return result;
}

}  // namespace finback::stereo_reference
