// The reference on real pairs with ground truth: is what it computes stereo at all?
//
// The bounds are what was measured (the test prints it), rounded up after adding 0.5, so that a
// broken transform, a swapped sign or a shifted window cannot pass.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

#include <scenes/luma.hpp>
#include <stereo_reference/evaluation.hpp>

namespace finback::stereo_reference {
namespace {

namespace fs = std::filesystem;

fs::path data_folder() {
  const char* chosen = std::getenv("FINBACK_SHARED_DATA");
  return chosen != nullptr ? fs::path(chosen) : fs::path(FINBACK_DEFAULT_DATA);
}

struct DataScene {
  std::string path;  // below middlebury/
  std::string left;
  std::string right;
  std::string truth;
  float scale;
  double bad_limit;  // percent of the pixels outside an 8-pixel border, after the left-right check
};

void PrintTo(const DataScene& scene, std::ostream* out) { *out << scene.path; }

FloatImage load_truth(const fs::path& path, float scale) {
  const ByteImage grey = scenes::load_luma(path);
  FloatImage truth(grey.width(), grey.height());
  std::transform(grey.pixels().begin(), grey.pixels().end(), truth.data(),
                 [scale](std::uint8_t value) { return value / scale; });
  return truth;
}

class Middlebury : public testing::TestWithParam<DataScene> {};

TEST_P(Middlebury, BadPixelsStayWithinBounds) {
  const DataScene& scene = GetParam();
  const fs::path folder = data_folder() / "middlebury" / scene.path;
  if (!fs::exists(folder)) {
    GTEST_SKIP() << folder << " is not there; set FINBACK_SHARED_DATA to a data folder";
  }
  const ByteImage left = scenes::load_luma(folder / scene.left);
  const ByteImage right = scenes::load_luma(folder / scene.right);
  const FloatImage truth = load_truth(folder / scene.truth, scene.scale);
  const float largest = *std::max_element(truth.pixels().begin(), truth.pixels().end());
  const MatchParameters parameters{15, 1, static_cast<int>(std::ceil(largest))};
  const Region inner = inner_region(left.width(), left.height(), 8);

  const DisparityPair maps = match_recursive(census_3x3(left), census_3x3(right), parameters);
  const MapQuality raw = evaluate(maps.left, truth, inner);
  const MapQuality checked = evaluate(check_left_right(maps), truth, inner);
  fmt::print("{:<18} bad {:5.2f} % matched, {:5.2f} % checked; wrong of valid {:5.2f} %\n",
             scene.path, raw.bad_percent(), checked.bad_percent(), checked.wrong_percent());
  EXPECT_GT(checked.compared, left.width() * left.height() / 2);
  EXPECT_LT(checked.bad_percent(), scene.bad_limit);
  // The check must pay: what it keeps is more often right than what matching alone says.
  EXPECT_LT(checked.wrong_percent(), raw.wrong_percent());

  const ByteImage swapped = disparity_map(right, left, parameters);
  EXPECT_GT(evaluate(swapped, truth, inner).bad_percent(), 85.0);
}

DataScene planar(const std::string& name, double bad_limit) {
  return {"2001/" + name, "im2.png", "im6.png", "disp2.png", 8, bad_limit};
}

DataScene scene_2006(const std::string& name, double bad_limit) {
  return {"2006/" + name, "view1.png", "view5.png", "disp1.png", 3, bad_limit};
}

INSTANTIATE_TEST_SUITE_P(
    All, Middlebury,
    testing::Values(DataScene{"2001/tsukuba", "im2.png", "im6.png", "disp2.png", 16, 20},
                    planar("venus", 7), planar("sawtooth", 8), planar("bull", 4),
                    planar("poster", 8), planar("barn1", 7), planar("barn2", 6),
                    DataScene{"2003/teddy", "im2.png", "im6.png", "disp2.png", 4, 21},
                    DataScene{"2003/cones", "im2.png", "im6.png", "disp2.png", 4, 18},
                    scene_2006("Aloe", 21), scene_2006("Baby1", 14), scene_2006("Baby2", 17),
                    scene_2006("Baby3", 21), scene_2006("Bowling1", 29), scene_2006("Bowling2", 23),
                    scene_2006("Cloth1", 12), scene_2006("Cloth2", 20), scene_2006("Cloth3", 14),
                    scene_2006("Cloth4", 19), scene_2006("Flowerpots", 26),
                    scene_2006("Lampshade1", 37), scene_2006("Lampshade2", 38),
                    scene_2006("Midd1", 54), scene_2006("Midd2", 51), scene_2006("Monopoly", 34),
                    scene_2006("Plastic", 63), scene_2006("Rocks1", 15), scene_2006("Rocks2", 14),
                    scene_2006("Wood1", 23), scene_2006("Wood2", 16)),
    [](const auto& scene) {
      std::string name = scene.param.path;
      std::replace(name.begin(), name.end(), '/', '_');
      return name;
    });

}  // namespace
}  // namespace finback::stereo_reference
