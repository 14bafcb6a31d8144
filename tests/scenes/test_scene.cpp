#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/evaluation.hpp>

namespace finback::scenes {
namespace {

// Mean difference of grey between the left pixels of the 160x120 grid and where the truth, times
// `factor`, finds them in the right view.
double warp_error(const Scene& scene, double factor) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < scene.truth.height(); ++y) {
    for (int x = 0; x < scene.truth.width(); ++x) {
      const double disparity = factor * scene.truth.at(x, y);
      const long right_x = std::lround(4 * (x - disparity));
      if (disparity == 0 || right_x < 0) {
        continue;
      }
      sum +=
          std::abs(scene.left.at(4 * x, 4 * y) - scene.right.at(static_cast<int>(right_x), 4 * y));
      ++count;
    }
  }
  return sum / count;
}

TEST(Scenes, EveryNamedSceneHasTheCamerasShape) {
  for (const std::string& name : scene_names()) {
    const Scene scene = load_scene(name, FINBACK_SCENES);
    EXPECT_EQ(scene.name, name);
    EXPECT_EQ(scene.left.width(), 640);
    EXPECT_EQ(scene.left.height(), 480);
    EXPECT_EQ(scene.right.width(), 640);
    EXPECT_EQ(scene.right.height(), 480);
    ASSERT_EQ(scene.truth.width(), 160);
    ASSERT_EQ(scene.truth.height(), 120);
    for (const float disparity : scene.truth.pixels()) {
      ASSERT_TRUE(disparity == 0 || (disparity >= 5 && disparity <= 35)) << disparity;
    }
  }
}

TEST(Scenes, UnknownNameAndMissingFolderAreClearErrors) {
  try {
    (void)load_scene("aloee", FINBACK_SCENES);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "scene 'aloee' is not known; known scenes: aloe, synthetic");
  }
  EXPECT_THROW((void)load_scene("aloe", "/nonexistent"), InputError);
}

TEST(Scenes, AloesTruthHasTheRightScaleAndSign) {
  const Scene aloe = load_scene("aloe", FINBACK_SCENES);
  const double right_scale = warp_error(aloe, 1.0);
  EXPECT_LT(right_scale, 9.0);  // measured 8.34
  for (const double factor : {-1.0, 0.5, 0.9, 1.1, 2.0}) {
    EXPECT_GT(warp_error(aloe, factor), 2 * right_scale) << factor;
  }
}

// Whether a nearer surface covers the right pixel that left (x, y) of the 160x120 grid goes to.
bool is_hidden(const FloatImage& truth, int x, int y) {
  const float right_x = static_cast<float>(x) - truth.at(x, y);
  for (int other = x + 1; other < truth.width(); ++other) {
    if (static_cast<float>(other) - truth.at(other, y) == right_x) {
      return true;
    }
  }
  return right_x < 0;
}

TEST(Scenes, SyntheticTruthIsExactWhereverTheRightViewSeesIt) {
  const Scene scene = make_synthetic_scene();
  int hidden = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const int d = static_cast<int>(scene.truth.at(x, y));
      ASSERT_EQ(static_cast<float>(d), scene.truth.at(x, y)) << "not an integer";
      if (is_hidden(scene.truth, x, y)) {
        ++hidden;
        continue;
      }
      ASSERT_EQ(scene.left.at(4 * x, 4 * y), scene.right.at(4 * (x - d), 4 * y)) << x << "," << y;
    }
  }
  EXPECT_GT(hidden, 160 * 120 / 20);  // there are occlusions to find
  EXPECT_LT(hidden, 160 * 120 / 5);
}

TEST(Scenes, SyntheticHasSeveralDepthsAndDependsOnItsSeedOnly) {
  const Scene scene = make_synthetic_scene(7);
  std::map<float, int> depths;
  for (const float disparity : scene.truth.pixels()) {
    ++depths[disparity];
  }
  EXPECT_EQ(depths.size(), 9U);
  EXPECT_EQ(depths.begin()->first, 6);
  EXPECT_EQ(depths.rbegin()->first, 34);
  for (const auto& [disparity, count] : depths) {
    EXPECT_GT(count, 400) << "disparity " << disparity;
  }
  const Scene again = make_synthetic_scene(7);
  EXPECT_EQ(again.left, scene.left);
  EXPECT_EQ(again.right, scene.right);
  const Scene other = make_synthetic_scene(8);
  EXPECT_NE(other.left, scene.left);
  EXPECT_EQ(other.truth, scene.truth);
}

// Window 15, disparities 5..35 at 160x120, the configuration of the firmware.
struct Quality {
  const char* scene;
  double bad_limit;    // percent of the computed pixels, invalid ones included
  double wrong_limit;  // percent of the valid ones
};

TEST(Scenes, ReferenceSeesTheScenes) {
  // Measured: aloe 23.97 % bad, 15.24 % of the valid wrong; synthetic 16.63 % and 6.24 %.
  for (const Quality& q : {Quality{"aloe", 25, 16}, Quality{"synthetic", 18, 7}}) {
    const Scene scene = load_scene(q.scene, FINBACK_SCENES);
    const stereo_reference::MatchParameters parameters{15, 5, 35};
    const ByteImage map =
        stereo_reference::disparity_map(stereo_reference::subsample_by_4(scene.left),
                                        stereo_reference::subsample_by_4(scene.right), parameters);
    const auto quality = stereo_reference::evaluate(
        map, scene.truth, stereo_reference::computed_region(160, 120, parameters));
    EXPECT_GT(quality.compared, 14000);
    EXPECT_LT(quality.bad_percent(), q.bad_limit) << q.scene;
    EXPECT_LT(quality.wrong_percent(), q.wrong_limit) << q.scene;
  }
}

}  // namespace
}  // namespace finback::scenes
