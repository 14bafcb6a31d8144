// The maps of MESVS-II and MESVS-I, computed by compiled C on two simulated cores, are the
// reference's in every pixel.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "firmware_copy.hpp"
#include "firmware_run.hpp"
#include <common/error.hpp>

namespace finback {
namespace {

namespace fs = std::filesystem;

void expect_reference_map(const scenes::Scene& scene) {
  for (const bool by_rank : {false, true}) {
    const std::string firmware = by_rank ? "mesvs1" : "mesvs2";
    const runner::RunOutcome outcome = runner::run_firmware(firmware_inputs(firmware, scene));
    ASSERT_EQ(outcome.maps.size(), 1U);
    const machine::PublishedMap& map = outcome.maps[0];
    EXPECT_EQ(map.width, 160U);
    EXPECT_EQ(map.height, 120U);
    const std::vector<std::uint8_t> expected = reference_map(scene, by_rank);
    ASSERT_EQ(map.bytes.size(), expected.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      different += map.bytes[i] != expected[i];
    }
    EXPECT_EQ(different, 0U) << firmware << ", of " << expected.size() << " pixels";
  }
}

TEST(FirmwareMap, EqualsReferenceOnNamedScenes) {
  for (const std::string& name : scenes::scene_names()) {
    SCOPED_TRACE(name);
    expect_reference_map(scenes::load_scene(name, share_folder() / "scenes"));
  }
}

TEST(FirmwareMap, EqualsReferenceOnEveryFrameOfAPipelinedRun) {
  const scenes::Scene scene = scenes::make_synthetic_scene(7);
  const runner::RunOutcome outcome = runner::run_firmware(mesvs2_inputs(scene, 5));
  ASSERT_EQ(outcome.maps.size(), 5U);
  const std::vector<std::uint8_t> expected = reference_map(scene);
  for (std::uint32_t frame = 0; frame < 5; ++frame) {
    EXPECT_EQ(outcome.maps[frame].frame_number, frame);
    EXPECT_EQ(outcome.maps[frame].bytes, expected) << "frame " << frame;
  }
}

// Ties everywhere, and the largest distances: what a key of 16 bits must hold.
TEST(FirmwareMap, EqualsReferenceOnNoiseAndOnNothing) {
  std::mt19937 generator(31);
  for (const unsigned levels : {1U, 2U, 256U}) {
    SCOPED_TRACE(levels);
    scenes::Scene scene = scenes::make_synthetic_scene();
    for (scenes::ByteImage* image : {&scene.left, &scene.right}) {
      std::generate_n(image->data(), 640 * 480,
                      [&] { return static_cast<std::uint8_t>(generator() % levels); });
    }
    expect_reference_map(scene);
  }
}

// Settings in flash change what is kept, and one that is none is refused.
TEST(FirmwareMap, SettingsInFlashAreHeld) {
  const scenes::Scene scene = scenes::make_synthetic_scene();
  const FirmwareCopy copy("settings");
  const fs::path file = copy.folder() / "settings.txt";
  const auto run_with = [&](const std::string& text) {
    write_file_whole(file, text);
    runner::RunInputs inputs = mesvs2_inputs(scene);
    ir::add_flash(inputs.firmware.firmware.units, "settings", file, 0x20100000, {});
    return runner::run_firmware(inputs);
  };
  const scenes::ByteImage left = stereo_reference::subsample_by_4(scene.left);
  const scenes::ByteImage map =
      stereo_reference::disparity_map(left, stereo_reference::subsample_by_4(scene.right), {}, 0);
  const scenes::ByteImage expected = stereo_reference::post_process(map, left, {9, 2000, 3});
  EXPECT_TRUE(run_with("lrc_threshold 0\ntexture_threshold 2000\ndisparity_threshold 3\n")
                  .maps.at(0)
                  .bytes == expected.pixels());
  EXPECT_NE(expected.pixels(), reference_map(scene));
  EXPECT_THROW((void)run_with("lrc_threshold 0\nwindows 9\n"), GuestFault);

  // Both parities of the range's beginning and of its length, an odd one by the kernel for one.
  for (const auto& [window, least, most] :
       {std::array{9, 1, 31}, std::array{3, 6, 9}, std::array{13, 40, 66}, std::array{5, 2, 20}}) {
    SCOPED_TRACE(fmt::format("window {}, disparities {} to {}", window, least, most));
    const scenes::ByteImage other = stereo_reference::disparity_map(
        left, stereo_reference::subsample_by_4(scene.right), {window, least, most}, 1);
    EXPECT_TRUE(run_with(fmt::format("window {}\ndisparity_min {}\ndisparity_max {}\n", window,
                                     least, most))
                    .maps.at(0)
                    .bytes == stereo_reference::post_process(other, left).pixels());
  }
  EXPECT_THROW((void)run_with("disparity_max 36\n"), GuestFault) << "32 disparities";
  EXPECT_THROW((void)run_with("window 8\n"), GuestFault);
}

#ifdef FINBACK_QVGA
TEST(FirmwareMap, PicturesOf320x240EqualTheReference) {
  const scenes::Scene scene = scenes::make_synthetic_scene();
  const auto sampled = [](const scenes::ByteImage& image) {
    scenes::ByteImage small(320, 240);
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        small.at(x, y) = image.at(2 * x, 2 * y);
      }
    }
    return small;
  };
  const scenes::ByteImage left = sampled(scene.left);
  const scenes::ByteImage expected = stereo_reference::post_process(
      stereo_reference::disparity_map(left, sampled(scene.right), {15, 10, 25}), left);
  const runner::RunOutcome outcome = runner::run_firmware(firmware_inputs(FINBACK_QVGA, scene, 2));
  ASSERT_EQ(outcome.maps.size(), 2U);
  EXPECT_EQ(outcome.maps[0].width, 320U);
  EXPECT_TRUE(outcome.maps[0].bytes == expected.pixels());
  EXPECT_TRUE(outcome.maps[1].bytes == expected.pixels());
}
#endif

struct DataSet {
  const char* folder;  // below middlebury/
  const char* left;
  const char* right;
  std::size_t scenes;
};
class Middlebury : public testing::TestWithParam<DataSet> {};

TEST_P(Middlebury, EqualsReferenceOnEveryPair) {
  const char* chosen = std::getenv("FINBACK_SHARED_DATA");
  const fs::path folder = fs::path(chosen != nullptr ? chosen : FINBACK_DEFAULT_DATA) /
                          "middlebury" / GetParam().folder;
  if (!fs::exists(folder)) {
    GTEST_SKIP() << folder << " is not there; set FINBACK_SHARED_DATA to a data folder";
  }
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) {
      SCOPED_TRACE(entry.path().string());
      expect_reference_map(
          scenes::load_scene_pair(entry.path() / GetParam().left, entry.path() / GetParam().right));
      ++count;
    }
  }
  EXPECT_EQ(count, GetParam().scenes);
}

INSTANTIATE_TEST_SUITE_P(Years, Middlebury,
                         testing::Values(DataSet{"2001", "im2.png", "im6.png", 7},
                                         DataSet{"2003", "im2.png", "im6.png", 2},
                                         DataSet{"2006", "view1.png", "view5.png", 21}),
                         [](const auto& year) { return std::string(year.param.folder); });

}  // namespace
}  // namespace finback
