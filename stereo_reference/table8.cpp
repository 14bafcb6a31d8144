#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

#include <stereo_reference/table8.hpp>

namespace finback::stereo_reference {

namespace {

using Row = std::array<double, kTableStages>;

// Table 8 in percent: mean, median and mode of each region after matching, check, post-processing.
constexpr std::array<std::array<Row, kStatistics>, kTableRegions> kThesis = {
    {{{{37.30, 24.02, 20.75}, {34.36, 23.54, 19.61}, {19.74, 10.65, 10.13}}},
     {{{30.29, 23.04, 19.99}, {27.12, 22.57, 19.11}, {12.38, 10.53, 10.07}}},
     {{{33.99, 25.33, 21.30}, {29.29, 22.83, 21.60}, {11.95, 9.285, 8.838}}},
     {{{47.72, 42.77, 39.19}, {46.11, 42.36, 36.79}, {27.12, 23.27, 21.32}}}}};

template <class Enum>
std::size_t index(Enum value) {
  return static_cast<std::size_t>(value);
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double mode_of(const std::vector<double>& values) {
  std::map<double, int> counts;
  for (const double value : values) {
    ++counts[value];
  }
  return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })
      ->first;
}

template <class Act>
void for_each_mean(const Table8& table, const Act& act) {
  for (std::size_t region = 0; region < kTableRegions; ++region) {
    for (std::size_t stage = 0; stage < kTableStages; ++stage) {
      const auto r = static_cast<TableRegion>(region);
      const auto s = static_cast<TableStage>(stage);
      act(std::abs(table.value(Statistic::mean, r, s) - thesis_table8(Statistic::mean, r, s)));
    }
  }
}

}  // namespace

const char* name_of(TableRegion region) {
  constexpr std::array kNames = {"all", "non-occluded", "texture-less", "depth-discontinuous"};
  return kNames[index(region)];
}

const char* name_of(TableStage stage) {
  constexpr std::array kNames = {"matched", "checked", "post-processed"};
  return kNames[index(stage)];
}

const char* name_of(Statistic statistic) {
  constexpr std::array kNames = {"mean", "median", "mode"};
  return kNames[index(statistic)];
}

std::string Reading::to_string() const {
  const Reading chosen;
  std::vector<std::string> words;
  const auto add = [&](bool differs, const std::string& word) {
    if (differs) {
      words.push_back(word);
    }
  };
  add(window != chosen.window, fmt::format("window {0}x{0}", window));
  add(whole_range != chosen.whole_range, "whole range only");
  add(consistency != chosen.consistency, fmt::format("check within {}", consistency));
  add(bad == BadRule::pixels, "bad beyond 1 pixel");
  add(bad == BadRule::floored, "bad beyond 1 pixel of the floored truth");
  add(invalid_is_bad != chosen.invalid_is_bad, "invalid is bad");
  add(hidden_counts != chosen.hidden_counts, "occluded pixels in all regions");
  add(gap_in_greys != chosen.gap_in_greys, "gap of 3 greys");
  add(variance_is_texture != chosen.variance_is_texture, "texture by variance");
  add(disparity_threshold != chosen.disparity_threshold,
      fmt::format("T_H {}", disparity_threshold));
  add(either != chosen.either, "either threshold");
  return words.empty() ? "as chosen" : fmt::format("{}", fmt::join(words, "; "));
}

double Table8::value(Statistic statistic, TableRegion region, TableStage stage) const {
  std::vector<double> values;
  for (const SceneFigures& figures : scenes) {
    if (const auto& figure = figures[index(region)][index(stage)]) {
      values.push_back(*figure);
    }
  }
  if (values.empty()) {
    return 0;
  }
  if (statistic != Statistic::mean) {
    return statistic == Statistic::median ? median_of(std::move(values)) : mode_of(values);
  }
  double sum = 0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double Table8::average_distance() const {
  double sum = 0;
  for_each_mean(*this, [&](double distance) { sum += distance; });
  return sum / (kTableRegions * kTableStages);
}

double Table8::largest_distance() const {
  double largest = 0;
  for_each_mean(*this, [&](double distance) { largest = std::max(largest, distance); });
  return largest;
}

double thesis_table8(Statistic statistic, TableRegion region, TableStage stage) {
  return kThesis[index(region)][index(statistic)][index(stage)];
}

std::vector<Table8> measure_table8(const std::filesystem::path& folder,
                                   const std::vector<Reading>& readings, const Parallel& how) {
  const std::vector<MiddleburyScene> scenes = middlebury_scenes(2006);
  std::vector<std::vector<SceneFigures>> figures(scenes.size());
  const bool complete = run_all(scenes.size(), how, [&](std::size_t i) {
    figures[i] = measure_scene(load_middlebury(folder, scenes[i]), scenes[i].scale, readings);
  });
  std::vector<Table8> tables;
  for (std::size_t r = 0; complete && r < readings.size(); ++r) {
    Table8& table = tables.emplace_back(Table8{readings[r], {}});
    for (const auto& scene : figures) {
      table.scenes.push_back(scene[r]);
    }
  }
  return tables;
}

}  // namespace finback::stereo_reference
