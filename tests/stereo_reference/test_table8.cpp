// Table 8 of the thesis: the tallies against evaluate(), the statistics, and the figures
// themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data_folder.hpp"
#include <common/error.hpp>
#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/fast_matching.hpp>
#include <stereo_reference/readings.hpp>
#include <stereo_reference/texture.hpp>

namespace finback::stereo_reference {
namespace {

using ::testing::HasSubstr;

constexpr auto kAll = TableRegion::all;

// A textured wall at 6 pixels with a block at 12 in front of it; what the right view sees.
StereoSample wall_and_block() {
  constexpr int kWidth = 120;
  constexpr int kHeight = 60;
  StereoSample sample{ByteImage(kWidth, kHeight), ByteImage(kWidth, kHeight),
                      FloatImage(kWidth, kHeight), FloatImage(kWidth, kHeight)};
  const auto texture = [](int x, int y) {
    return static_cast<std::uint8_t>((x * x * 31 + y * 57 + x * y * 7) % 251);
  };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto near = [&](int column) {
        return column >= 50 && column < 90 && y >= 15 && y < 45;
      };
      const int left = near(x) ? 12 : 6;
      const int right = near(x + 12) ? 12 : 6;
      sample.left_truth.at(x, y) = static_cast<float>(left);
      sample.right_truth.at(x, y) = static_cast<float>(right);
      sample.left.at(x, y) = texture(x, y);
      sample.right.at(x, y) = texture(x + right, y);
    }
  }
  return sample;
}

TEST(Table8Scene, TalliesAreThoseOfEvaluate) {
  const StereoSample sample = wall_and_block();
  Reading reading;
  reading.window = 9;
  reading.bad = BadRule::pixels;
  reading.disparity_threshold = 17;
  const DisparityPair maps = match_recursive(census_3x3(sample.left), census_3x3(sample.right),
                                             {9, 1, sample.largest_disparity()});
  const ByteImage checked = check_left_right(maps, 1);
  const ByteImage last = post_process(checked, sample.left, {9, 135, 17, false});
  const Region inner = inner_region(sample.left.width(), sample.left.height(), 4);
  for (const bool invalid_is_bad : {false, true}) {
    reading.invalid_is_bad = invalid_is_bad;
    const SceneFigures figures = measure_scene(sample, 3, {reading}).front();
    std::size_t stage = 0;
    for (const ByteImage* map : {&maps.left, &checked, &last}) {
      const MapQuality quality = evaluate(*map, sample.left_truth, inner, 1.0);
      EXPECT_DOUBLE_EQ(figures[0][stage++].value(),
                       invalid_is_bad ? quality.bad_percent() : quality.wrong_percent());
    }
  }
}

TEST(Table8Scene, ARegionWithoutPixelsHasNoFigure) {
  const StereoSample sample = wall_and_block();
  const SceneFigures figures = measure_scene(sample, 3, {Reading()}).front();
  EXPECT_FALSE(figures[static_cast<std::size_t>(TableRegion::texture_less)][0]);
  EXPECT_TRUE(figures[static_cast<std::size_t>(TableRegion::discontinuous)][0]);
}

TEST(Table8, StatisticsLeaveOutWhatHasNoFigure) {
  Table8 table;
  for (const double value : {5.0, 1.0, 9.0, 9.0}) {
    table.scenes.emplace_back()[0][0] = value;
  }
  table.scenes.emplace_back();
  EXPECT_DOUBLE_EQ(table.value(Statistic::mean, kAll, TableStage::matched), 6);
  EXPECT_DOUBLE_EQ(table.value(Statistic::median, kAll, TableStage::matched), 7);
  EXPECT_DOUBLE_EQ(table.value(Statistic::mode, kAll, TableStage::matched), 9);
  table.scenes.pop_back();
  table.scenes.pop_back();
  EXPECT_DOUBLE_EQ(table.value(Statistic::median, kAll, TableStage::matched), 5);
  EXPECT_DOUBLE_EQ(table.value(Statistic::mode, kAll, TableStage::matched), 1);
}

TEST(Table8, MeansAreTheThesissAndDoNotDependOnThreads) {
  const std::filesystem::path folder = data_folder() / "middlebury";
  FINBACK_NEEDS_DATA(folder / "2006");
  const std::vector<Table8> tables = measure_table8(folder, {Reading()}, {2, {}});
  ASSERT_EQ(tables.size(), 1U);
  // Measured: 0.49 and 1.17 points.
  EXPECT_LT(tables[0].average_distance(), 0.6);
  EXPECT_LT(tables[0].largest_distance(), 1.3);
  const Experiment page = table8_experiment(tables[0]);
  EXPECT_THAT(page.page,
              HasSubstr("| all, mean | 36.84 | 37.30 | 23.87 | 24.02 | 20.92 | 20.75 |"));
  EXPECT_EQ(std::ranges::count(page.tables[1].text, '\n'), 1 + 21 * 4);
  const auto scene = middlebury_scenes(2006).front();
  EXPECT_EQ(measure_scene(load_middlebury(folder, scene), scene.scale, {Reading()}).front(),
            tables[0].scenes.front());
}

TEST(Table8, WhatIsMissingIsNamed) {
  try {
    (void)measure_table8("/nowhere", {Reading()}, {2, {}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/2006/Aloe/view1.png"));
  }
}

TEST(Readings, RankTheNearestFirst) {
  const auto table_of = [](const Reading& reading, double distance) {
    Table8 table{reading, {SceneFigures()}};
    for (std::size_t region = 0; region < kTableRegions; ++region) {
      for (std::size_t stage = 0; stage < kTableStages; ++stage) {
        table.scenes[0][region][stage] =
            distance + thesis_table8(Statistic::mean, static_cast<TableRegion>(region),
                                     static_cast<TableStage>(stage));
      }
    }
    return table;
  };
  Reading other;
  other.window = 9;
  const Experiment ranked = readings_experiment({table_of(Reading(), 2), table_of(other, 1)});
  EXPECT_LT(ranked.page.find("window 9x9 | 1.00 | 1.00"), ranked.page.find("as chosen | 2.00"));
  EXPECT_THAT(ranked.tables[0].text, HasSubstr("\n1,1.0000,1.0000,9,"));
  EXPECT_EQ(readings_to_try().size(), 5U * 2 * 3 * 3 * 64);
}

}  // namespace
}  // namespace finback::stereo_reference
