// The reference on real pairs with ground truth: is what it computes stereo at all?
//
// The bounds are what was measured (the test prints it), rounded up after adding 0.5, so that a
// broken transform, a swapped sign or a shifted window cannot pass.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

#include "data_folder.hpp"
#include <common/error.hpp>
#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/middlebury.hpp>

namespace finback::stereo_reference {
namespace {

namespace fs = std::filesystem;

struct Bound {
  std::string scene;
  double bad_limit;  // percent of the pixels outside an 8-pixel border, after the left-right check
};

void PrintTo(const Bound& bound, std::ostream* out) { *out << bound.scene; }

class Middlebury : public testing::TestWithParam<Bound> {};

TEST_P(Middlebury, BadPixelsStayWithinBounds) {
  const MiddleburyScene scene = find_middlebury_scene(GetParam().scene).value();
  const fs::path folder = data_folder() / "middlebury";
  FINBACK_NEEDS_DATA(folder / scene.path());
  const StereoSample sample = load_middlebury(folder, scene);
  const auto& [left, right, truth, right_truth] = sample;
  EXPECT_EQ(right_truth.empty(), scene.name == "tsukuba");
  const MatchParameters parameters{15, 1, sample.largest_disparity()};
  const Region inner = inner_region(left.width(), left.height(), 8);

  const DisparityPair maps = match_recursive(census_3x3(left), census_3x3(right), parameters);
  const MapQuality raw = evaluate(maps.left, truth, inner);
  const MapQuality checked = evaluate(check_left_right(maps), truth, inner);
  fmt::print("{:<18} bad {:5.2f} % matched, {:5.2f} % checked; wrong of valid {:5.2f} %\n",
             scene.path(), raw.bad_percent(), checked.bad_percent(), checked.wrong_percent());
  EXPECT_GT(checked.compared, left.width() * left.height() / 2);
  EXPECT_LT(checked.bad_percent(), GetParam().bad_limit);
  // The check must pay: what it keeps is more often right than what matching alone says.
  EXPECT_LT(checked.wrong_percent(), raw.wrong_percent());

  const ByteImage swapped = disparity_map(right, left, parameters);
  EXPECT_GT(evaluate(swapped, truth, inner).bad_percent(), 85.0);
}

INSTANTIATE_TEST_SUITE_P(
    All, Middlebury,
    testing::Values(Bound{"2001/tsukuba", 20}, Bound{"2001/venus", 7}, Bound{"2001/sawtooth", 8},
                    Bound{"2001/bull", 4}, Bound{"2001/poster", 8}, Bound{"2001/barn1", 7},
                    Bound{"2001/barn2", 6}, Bound{"2003/teddy", 21}, Bound{"2003/cones", 18},
                    Bound{"2006/Aloe", 21}, Bound{"2006/Baby1", 14}, Bound{"2006/Baby2", 17},
                    Bound{"2006/Baby3", 21}, Bound{"2006/Bowling1", 29}, Bound{"2006/Bowling2", 23},
                    Bound{"2006/Cloth1", 12}, Bound{"2006/Cloth2", 20}, Bound{"2006/Cloth3", 14},
                    Bound{"2006/Cloth4", 19}, Bound{"2006/Flowerpots", 26},
                    Bound{"2006/Lampshade1", 37}, Bound{"2006/Lampshade2", 38},
                    Bound{"2006/Midd1", 54}, Bound{"2006/Midd2", 51}, Bound{"2006/Monopoly", 34},
                    Bound{"2006/Plastic", 63}, Bound{"2006/Rocks1", 15}, Bound{"2006/Rocks2", 14},
                    Bound{"2006/Wood1", 23}, Bound{"2006/Wood2", 16}),
    [](const auto& scene) {
      std::string name = scene.param.scene;
      std::replace(name.begin(), name.end(), '/', '_');
      return name;
    });

TEST(MiddleburyScenes, AreThoseOfTheYears) {
  EXPECT_EQ(middlebury_scenes(2001).size(), 7U);
  EXPECT_EQ(middlebury_scenes(2003).size(), 2U);
  EXPECT_EQ(middlebury_scenes(2005).size(), 6U);
  EXPECT_EQ(middlebury_scenes(2006).size(), 21U);
  EXPECT_TRUE(middlebury_scenes(2004).empty());
  EXPECT_EQ(find_middlebury_scene("2001/tsukuba")->scale, 16);
  EXPECT_EQ(find_middlebury_scene("2001/venus")->scale, 8);
  EXPECT_FALSE(find_middlebury_scene("2006/Nowhere"));
}

TEST(MiddleburyScenes, AMissingPictureIsNamed) {
  try {
    (void)load_middlebury("/nowhere", middlebury_scenes(2006).front());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/2006/Aloe/view1.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace finback::stereo_reference
