#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include <stereo_reference/readings.hpp>

namespace finback::stereo_reference {

namespace {

constexpr std::size_t kNearest = 10;

// Every reading once for each value of one of its choices.
template <class Value>
void spread(std::vector<Reading>& readings, Value Reading::*choice,
            const std::vector<Value>& values) {
  std::vector<Reading> all;
  for (const Reading& reading : readings) {
    for (const Value& value : values) {
      all.push_back(reading);
      all.back().*choice = value;
    }
  }
  readings = std::move(all);
}

// In how many choices two readings differ.
int differences(const Reading& a, const Reading& b) {
  const auto differ = [](auto one, auto other) { return one != other ? 1 : 0; };
  return differ(a.window, b.window) + differ(a.whole_range, b.whole_range) +
         differ(a.consistency, b.consistency) + differ(a.bad, b.bad) +
         differ(a.invalid_is_bad, b.invalid_is_bad) + differ(a.hidden_counts, b.hidden_counts) +
         differ(a.gap_in_greys, b.gap_in_greys) +
         differ(a.variance_is_texture, b.variance_is_texture) +
         differ(a.disparity_threshold, b.disparity_threshold) + differ(a.either, b.either);
}

const char* name_of(BadRule rule) {
  constexpr std::array kNames = {"scaled", "pixels", "floored"};
  return kNames[static_cast<std::size_t>(rule)];
}

std::vector<std::string> means_of(const Table8& table) {
  std::vector<std::string> cells;
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      cells.push_back(
          fmt::format("{:.2f}", table.value(Statistic::mean, static_cast<TableRegion>(region),
                                            static_cast<TableStage>(stage))));
    }
  }
  return cells;
}

std::vector<std::string> mean_names() {
  std::vector<std::string> names;
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      names.push_back(
          fmt::format("{} {}", finback::stereo_reference::name_of(static_cast<TableRegion>(region)),
                      finback::stereo_reference::name_of(static_cast<TableStage>(stage))));
    }
  }
  return names;
}

std::vector<std::string> thesis_means() {
  std::vector<std::string> cells;
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      cells.push_back(
          fmt::format("{:.2f}", thesis_table8(Statistic::mean, static_cast<TableRegion>(region),
                                              static_cast<TableStage>(stage))));
    }
  }
  return cells;
}

// Only the regions' initials: twelve columns must fit.
std::vector<std::string> page_row(const std::string& name, const Table8& table) {
  std::vector<std::string> cells = {name, fmt::format("{:.2f}", table.average_distance()),
                                    fmt::format("{:.2f}", table.largest_distance())};
  const auto means = means_of(table);
  cells.insert(cells.end(), means.begin(), means.end());
  return cells;
}

std::vector<std::vector<std::string>> page_head() {
  std::vector<std::string> head = {"reading", "on average", "farthest"};
  for (const char* region : {"all", "non-occ.", "texture-l.", "discont."}) {
    for (const char* stage : {"", "LRC", "post"}) {
      head.push_back(stage == std::string() ? region : stage);
    }
  }
  std::vector<std::string> thesis = {"*the thesis*", "", ""};
  const auto means = thesis_means();
  thesis.insert(thesis.end(), means.begin(), means.end());
  return {head, thesis};
}

std::string csv_of(const std::vector<Table8>& tables, const std::vector<std::size_t>& order) {
  std::vector<std::vector<std::string>> rows = {
      {"rank", "average_distance", "largest_distance", "window", "whole_range", "consistency",
       "bad", "invalid_is_bad", "hidden_counts", "gap_in_greys", "variance_is_texture",
       "disparity_threshold", "either"}};
  const auto names = mean_names();
  rows[0].insert(rows[0].end(), names.begin(), names.end());
  for (const std::size_t i : order) {
    const Table8& table = tables[i];
    const Reading& r = table.reading;
    std::vector<std::string> row = {fmt::format("{}", rows.size()),
                                    fmt::format("{:.4f}", table.average_distance()),
                                    fmt::format("{:.4f}", table.largest_distance()),
                                    fmt::format("{}", r.window),
                                    fmt::format("{:d}", r.whole_range),
                                    fmt::format("{}", r.consistency),
                                    name_of(r.bad),
                                    fmt::format("{:d}", r.invalid_is_bad),
                                    fmt::format("{:d}", r.hidden_counts),
                                    fmt::format("{:d}", r.gap_in_greys),
                                    fmt::format("{:d}", r.variance_is_texture),
                                    fmt::format("{}", r.disparity_threshold),
                                    fmt::format("{:d}", r.either)};
    const auto means = means_of(table);
    row.insert(row.end(), means.begin(), means.end());
    rows.push_back(std::move(row));
  }
  return csv_table(rows);
}

}  // namespace

std::vector<Reading> readings_to_try() {
  std::vector<Reading> readings = {Reading()};
  const std::vector<bool> both = {false, true};
  spread(readings, &Reading::window, {9, 11, 13, 15, 17});
  spread(readings, &Reading::whole_range, both);
  spread(readings, &Reading::consistency, {0, 1, 2});
  spread(readings, &Reading::bad, {BadRule::scaled, BadRule::pixels, BadRule::floored});
  spread(readings, &Reading::invalid_is_bad, both);
  spread(readings, &Reading::hidden_counts, both);
  spread(readings, &Reading::gap_in_greys, both);
  spread(readings, &Reading::variance_is_texture, both);
  spread(readings, &Reading::disparity_threshold, {17.0, 135.0});
  spread(readings, &Reading::either, both);
  return readings;
}

Experiment readings_experiment(const std::vector<Table8>& tables) {
  std::vector<std::size_t> order(tables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return tables[i].average_distance(); });

  auto nearest = page_head();
  auto changes = page_head();
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const Table8& table = tables[order[rank]];
    if (rank < kNearest) {
      nearest.push_back(page_row(table.reading.to_string(), table));
    }
    if (differences(table.reading, Reading()) <= 1) {
      changes.push_back(page_row(table.reading.to_string(), table));
    }
  }
  Experiment result;
  result.page = fmt::format(
      "Mean percentage of bad pixels over the 21 scenes of 2006, and how far the twelve means lie "
      "from the thesis's, in points: on average and the farthest.\n\n"
      "The {} nearest of {} readings:\n\n{}\n"
      "The chosen reading with one choice changed, the nearest first:\n\n{}",
      std::min(kNearest, tables.size()), tables.size(), markdown_table(nearest),
      markdown_table(changes));
  result.tables.push_back({"readings.csv", csv_of(tables, order)});
  return result;
}

}  // namespace finback::stereo_reference
