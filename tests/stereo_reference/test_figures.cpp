// Figures 8, 26 and 29: the equations by hand, census against rank on the real pairs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data_folder.hpp"
#include <common/error.hpp>
#include <stereo_reference/figure26.hpp>
#include <stereo_reference/figure29.hpp>
#include <stereo_reference/figure8.hpp>
#include <stereo_reference/masks.hpp>

namespace finback::stereo_reference {
namespace {

using ::testing::HasSubstr;

TEST(Figure8, IsTheEquation) {
  const RangeGeometry camera;
  // 28 mm * 2.8 mm / (10 * 0.017 mm)
  EXPECT_NEAR(camera.range(10), 461.18, 0.01);
  EXPECT_NEAR(camera.uncertainty(500), 54.21, 0.01);
  // Half the way to the neighbours' ranges on both sides, nearly.
  EXPECT_NEAR(camera.uncertainty(camera.range(20)), (camera.range(19) - camera.range(21)) / 2,
              0.05);
  const Experiment page = figure8_experiment(camera);
  EXPECT_THAT(page.page, HasSubstr("Disparities 5 to 35 are 13.2 to 92.2 cm"));
  EXPECT_THAT(page.tables[0].text, HasSubstr("\n10,46.12,4.61\n"));
}

TEST(Figure8, RefusesCamerasThatCannotBe) {
  RangeGeometry camera;
  camera.disparity_max = 4;
  EXPECT_THROW((void)figure8_experiment(camera), InputError);
  camera = {};
  camera.pixel = 0;
  EXPECT_THROW((void)figure8_experiment(camera), InputError);
}

// Disparity 2, with a block of disparity 5 in columns 10 to 14: it hides what lands on 5 to 9.
TEST(Masks, OneTruthTellsWhatIsHidden) {
  FloatImage truth(20, 1, 2.0F);
  for (int x = 10; x < 15; ++x) {
    truth.at(x, 0) = 5;
  }
  truth.at(17, 0) = 0;
  const ByteImage mask = occluded_mask(truth);
  for (int x = 0; x < 20; ++x) {
    const bool outside = x < 2;
    const bool hidden = x >= 7 && x < 10;
    EXPECT_EQ(mask.at(x, 0) != 0, outside || hidden || x == 17) << x;
  }
}

TEST(Figure26, CensusIsBelowRank3UnderEveryChange) {
  const std::filesystem::path folder = data_folder() / "middlebury";
  FINBACK_NEEDS_DATA(folder / "2003");
  std::vector<LightChange> changes = figure26_changes();
  ASSERT_EQ(changes.size(), 4U);
  changes[0].levels = {0.3};
  changes[1].levels = {2.5};
  changes[2].levels = {0.3};
  changes[3].levels = {20};
  const Figure26 figure = measure_figure26(folder, changes, {2, {}});
  ASSERT_EQ(figure.scenes.size(), 4U);
  for (std::size_t change = 0; change < changes.size(); ++change) {
    const auto [rank3, rank5, census3] = figure.average(change, 0);
    EXPECT_LT(census3.of_all, rank3.of_all - 2) << changes[change].name;
    EXPECT_LT(census3.of_valid, rank3.of_valid - 0.5) << changes[change].name;
    EXPECT_GT(census3.of_all, census3.of_valid);
  }
  EXPECT_THAT(figure26_experiment(figure).page, HasSubstr("Census 3x3 is below rank3 at 1 of 1"));
}

TEST(Figure29, CensusIsBelowRank3UnderEveryLight) {
  const std::filesystem::path folder = data_folder() / "middlebury";
  FINBACK_NEEDS_DATA(folder / "radiometric");
  const std::vector<LightTrial> trials = measure_figure29(folder, {2, {}});
  EXPECT_EQ(trials.size(), 6U + 8 + 1);
  EXPECT_EQ(std::ranges::count(trials, true, &LightTrial::other_light), 7);
  for (const LightTrial& trial : trials) {
    EXPECT_LT(trial.errors[2].of_all, trial.errors[0].of_all) << trial.name;
    // A wrong truth, or views taken for each other, would be far above.
    EXPECT_LT(trial.errors[2].of_all, 31) << trial.name;
  }
}

}  // namespace
}  // namespace finback::stereo_reference
