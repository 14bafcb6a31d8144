// Every rung of the ladder computes the reference's map in every pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <common/file.hpp>
#include <runner/ladder.hpp>
#include <runner/run_request.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/matching.hpp>

namespace finback {
namespace {

using stereo_reference::ByteImage;

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSlow = true;
#else
constexpr bool kSlow = false;
#endif

// The rungs that are run here. Those below need seconds; docs/finback-lab.md, which is executed,
// says that all maps are equal, theirs too.
std::vector<runner::Rung> rungs() {
  const std::vector<runner::Rung> ladder = runner::load_ladder();
  const std::string first = kSlow ? "packed" : "vertical";
  return {std::ranges::find(ladder, first, &runner::Rung::name), ladder.end()};
}

// The best disparity of the left view, not checked against the right one.
std::vector<std::uint8_t> expected_map(const scenes::Scene& scene) {
  const auto census = [](const ByteImage& view) {
    return stereo_reference::census_3x3(stereo_reference::subsample_by_4(view));
  };
  return stereo_reference::match_recursive(census(scene.left), census(scene.right), {})
      .left.pixels();
}

runner::RunOutcome run(const runner::Rung& rung, const std::string& scene, std::uint32_t frames,
                       bool check_races = false) {
  runner::RunRequest request;
  request.firmware = rung.firmware;
  request.scene = scene;
  request.frames = frames;
  request.check_races = check_races;
  return runner::run_firmware(runner::load_inputs(request));
}

TEST(LadderMaps, EqualTheReferenceOnEveryScene) {
  for (const std::string& name : scenes::scene_names()) {
    const std::vector<std::uint8_t> expected =
        expected_map(scenes::load_scene(name, share_folder() / "scenes"));
    for (const runner::Rung& rung : rungs()) {
      const runner::RunOutcome outcome = run(rung, name, 1);
      ASSERT_EQ(outcome.maps.size(), 1U);
      EXPECT_EQ(outcome.maps[0].width, 160U);
      EXPECT_EQ(outcome.maps[0].height, 120U);
      EXPECT_EQ(outcome.maps[0].bytes, expected) << rung.name << " on " << name;
    }
  }
}

// What a frame leaves behind does not reach the next one, and nothing needs luck.
TEST(LadderMaps, EqualTheReferenceInEveryFrameAndHaveNoRaces) {
  const std::vector<std::uint8_t> expected =
      expected_map(scenes::load_scene("aloe", share_folder() / "scenes"));
  for (const char* name : {"packed", "dma", "two_cores"}) {
    const runner::RunOutcome outcome =
        run(runner::find_rung(runner::load_ladder(), name), "aloe", 3, true);
    ASSERT_EQ(outcome.maps.size(), 3U);
    for (const machine::PublishedMap& map : outcome.maps) {
      EXPECT_EQ(map.bytes, expected) << name << ", frame " << map.frame_number;
    }
    EXPECT_TRUE(outcome.races.empty()) << name;
  }
}

TEST(LadderMaps, AreComparedPixelByPixel) {
  machine::PublishedMap map;
  map.bytes = {1, 2, 3};
  machine::PublishedMap other = map;
  EXPECT_EQ(runner::differing_maps({"one", "other"}, {{map}, {other}}), "");
  other.bytes = {1, 0, 0};
  EXPECT_EQ(runner::differing_maps({"one", "other"}, {{map}, {other}}),
            "the map of other differs from that of one in 2 pixels of frame 0");
}

}  // namespace
}  // namespace finback
