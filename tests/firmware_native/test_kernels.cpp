#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

#include <scenes/luma.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/measures.hpp>
#include <stereo_reference/rectification.hpp>
#include <stereo_reference/texture.hpp>

extern "C" {
#include "geometry.h"
#include "matching.h"
#include "postprocess.h"
#include "prepare.h"
#include "rectify.h"
#include "settings.h"
#include "shd.h"
#include "stereo_config.h"
#include "variance.h"
}

namespace finback {
namespace {

namespace fs = std::filesystem;
using scenes::ByteImage;

stereo_reference::MatchParameters parameters() {
  return {static_cast<int>(stereo_settings.window), static_cast<int>(stereo_settings.disparity_min),
          static_cast<int>(stereo_settings.disparity_max)};
}

// The reference's codes and measure of this configuration.
stereo_reference::WordImage codes(const ByteImage& image) {
  switch (CODE) {
    case CODE_CENSUS:
      return stereo_reference::census_transform(image, 3);
    case CODE_RANK:
      return stereo_reference::rank_transform(image, 3);
    default:
      return stereo_reference::as_words(image);
  }
}
stereo_reference::Measure measure() {
  switch (MEASURE) {
    case MEASURE_SHD:
      return stereo_reference::Measure::shd;
    case MEASURE_SAD:
      return stereo_reference::Measure::sad;
    default:
      return stereo_reference::Measure::ssd;
  }
}

ByteImage sampled(const ByteImage& image) {
  ByteImage small(MAP_WIDTH, MAP_HEIGHT);
  for (int y = 0; y < MAP_HEIGHT; ++y) {
    for (int x = 0; x < MAP_WIDTH; ++x) {
      small.at(x, y) = image.at(SUBSAMPLING * x, SUBSAMPLING * y);
    }
  }
  return small;
}

ByteImage random_image(std::mt19937& generator, unsigned levels) {
  ByteImage image(MAP_WIDTH, MAP_HEIGHT);
  std::generate_n(image.data(), MAP_PIXELS,
                  [&] { return static_cast<std::uint8_t>(generator() % levels); });
  return image;
}

// What core A makes of a rectified picture; of the left one also flags.
ByteImage firmware_codes(const ByteImage& picture, bool is_left) {
  ByteImage result(MAP_WIDTH, MAP_HEIGHT, 0);
  for (int y = 0; y < MAP_HEIGHT; y += BAND_ROWS) {
    std::array<std::uint8_t[MAP_WIDTH], BAND_ROWS + 1> band;
    std::copy_n(picture.data() + y * MAP_WIDTH, BAND_PIXELS, rectified_line(y));
    prepare_codes(y, band.data());
    if (is_left) {
      prepare_texture(y, plain_flags + y);
    }
    for (int row = first_code_row(y); row < end_of_code_rows(y); ++row) {
      std::copy_n(band[static_cast<std::size_t>(row)], MAP_WIDTH, &result.at(0, y + row - 1));
    }
  }
  return result;
}

// The map of a rectified pair.
ByteImage firmware_map(const ByteImage& left_picture, const ByteImage& right_picture) {
  geometry_start();
  const ByteImage left = firmware_codes(left_picture, true);
  const ByteImage right = firmware_codes(right_picture, false);
  ByteImage map(MAP_WIDTH, MAP_HEIGHT, 255);
  int matched = 0;
  for (int y = 0; y < MAP_HEIGHT; ++y) {
    for (; matched < std::min(y + HALF_VARIANCE_WINDOW + 1, MAP_HEIGHT); ++matched) {
      match_row(left.data(), right.data(), matched, checked_row(matched));
    }
    post_process_row(y, &map.at(0, y));
  }
  return map;
}

void expect_equal(const ByteImage& left, const ByteImage& right) {
  const ByteImage map = firmware_map(left, right);
  const ByteImage truth = stereo_reference::post_process(
      stereo_reference::check_left_right(
          stereo_reference::match_by(measure(), codes(left), codes(right), parameters()),
          static_cast<int>(stereo_settings.lrc_threshold)),
      left,
      {VARIANCE_WINDOW, static_cast<double>(stereo_settings.texture_threshold),
       static_cast<double>(stereo_settings.disparity_threshold)});
  for (int y = 0; y < MAP_HEIGHT; ++y) {
    for (int x = 0; x < MAP_WIDTH; ++x) {
      ASSERT_EQ(map.at(x, y), truth.at(x, y)) << "column " << x << ", row " << y;
    }
  }
}

TEST(FirmwareKernels, CodesEqualTheReference) {
  std::mt19937 generator(21);
  for (const unsigned levels : {2U, 256U}) {
    const ByteImage image = random_image(generator, levels);
    const ByteImage firmware = firmware_codes(image, false);
    const stereo_reference::WordImage truth = codes(image);
    for (std::size_t i = 0; i < MAP_PIXELS; ++i) {
      const std::uint32_t code = truth.pixels()[i];
      const bool rank_as_bits = CODE == CODE_RANK && MEASURE_BY_BITS;
      ASSERT_EQ(firmware.pixels()[i], rank_as_bits ? (1U << code) - 1 : code) << i;
    }
  }
}

TEST(FirmwareKernels, MapsOfRandomImagesEqualTheReference) {
  std::mt19937 generator(22);
  for (const unsigned levels : {1U, 2U, 3U, 16U, 256U}) {
    expect_equal(random_image(generator, levels), random_image(generator, levels));
  }
}

#if MAP_WIDTH <= 256  // as far as the reference's tables go
// Sources everywhere, also outside the picture; corners and edges exactly.
stereo_reference::RectificationTable random_table(std::mt19937& generator) {
  stereo_reference::PixelMap map{MAP_WIDTH, MAP_HEIGHT, stereo_reference::Points2(2, MAP_PIXELS)};
  std::uniform_real_distribution<double> x(-2, MAP_WIDTH + 1);
  std::uniform_real_distribution<double> y(-2, MAP_HEIGHT + 1);
  for (int i = 0; i < MAP_PIXELS; ++i) {
    map.sources.col(i) = Eigen::Vector2d{x(generator), y(generator)};
  }
  map.sources.col(0) = Eigen::Vector2d{MAP_WIDTH - 1, MAP_HEIGHT - 1};
  map.sources.col(1) = Eigen::Vector2d{0, MAP_HEIGHT - 1};
  return stereo_reference::rectification_table(map);
}

TEST(FirmwareKernels, RectificationEqualsTheReference) {
  std::mt19937 generator(24);
  const ByteImage image = random_image(generator, 256);
  const stereo_reference::RectificationTable table = random_table(generator);
  std::vector<rectification_row> rows(MAP_HEIGHT);
  for (std::size_t i = 0; i < MAP_PIXELS; ++i) {
    rectification_row& row = rows[i / MAP_WIDTH];
    row.source[i % MAP_WIDTH][0] = table.column[i];
    row.source[i % MAP_WIDTH][1] = table.row[i];
    std::copy(table.weights[i].begin(), table.weights[i].end(), row.weights[i % MAP_WIDTH]);
  }
  ByteImage rectified(MAP_WIDTH, MAP_HEIGHT);
  rectify_rows(image.data(), rows.data(), MAP_HEIGHT, rectified.data());
  EXPECT_EQ(rectified, stereo_reference::remap(image, table));
}
#endif

TEST(FirmwareKernels, TheIdentityRectifiesNothing) {
  std::mt19937 generator(25);
  const ByteImage image = random_image(generator, 256);
  std::vector<rectification_row> rows(MAP_HEIGHT);
  for (int y = 0; y < MAP_HEIGHT; ++y) {
    identity_row(y, &rows[static_cast<std::size_t>(y)]);
  }
  ByteImage rectified(MAP_WIDTH, MAP_HEIGHT);
  rectify_rows(image.data(), rows.data(), MAP_HEIGHT, rectified.data());
  EXPECT_EQ(rectified, image);
}

TEST(FirmwareKernels, AFrameDoesNotDependOnTheOneBefore) {
  std::mt19937 generator(23);
  const ByteImage left = random_image(generator, 8);
  const ByteImage right = random_image(generator, 8);
  const ByteImage first = firmware_map(left, right);
  (void)firmware_map(right, left);
  EXPECT_EQ(firmware_map(left, right), first);
}

TEST(FirmwareKernels, SettingsAreReadAndHeld) {
  const struct settings before = stereo_settings;
  EXPECT_EQ(settings_read("\xFF\xFF"), 0);
  EXPECT_EQ(settings_read(""), 0);
  EXPECT_EQ(stereo_settings.texture_threshold, before.texture_threshold);
  EXPECT_EQ(settings_read("lrc_threshold 3\ntexture_threshold 9000\ndisparity_threshold 4\n\xFF"),
            0);
  std::mt19937 generator(26);
  expect_equal(random_image(generator, 200), random_image(generator, 200));
  EXPECT_EQ(stereo_settings.lrc_threshold, 3U);
  EXPECT_EQ(stereo_settings.texture_threshold, 9000U);
  EXPECT_EQ(stereo_settings.disparity_threshold, 4U);
  stereo_settings = before;
}

#if WINDOW >= 5 && DISPARITY_MAX > DISPARITY_MIN + 3
TEST(FirmwareKernels, SmallerWindowsAndOtherDisparitiesEqualTheReference) {
  const struct settings before = stereo_settings;
  std::mt19937 generator(27);
  EXPECT_EQ(settings_read("window 5\ndisparity_min 2\ndisparity_max 5\n"), 0);
  EXPECT_TRUE(settings_range_fits());
  expect_equal(random_image(generator, 20), random_image(generator, 20));
  EXPECT_EQ(settings_read("window 3\ndisparity_min 12\ndisparity_max 13\n"), 0);
  expect_equal(random_image(generator, 20), random_image(generator, 20));
  stereo_settings = before;
}
#endif

TEST(FirmwareKernels, RangesThatDoNotFitAreRefused) {
  const struct settings before = stereo_settings;
  stereo_settings.disparity_max = stereo_settings.disparity_min;
  EXPECT_FALSE(settings_range_fits());
  stereo_settings.disparity_max = stereo_settings.disparity_min + DISPARITY_COUNT;
  EXPECT_FALSE(settings_range_fits());
  stereo_settings = before;
}

TEST(FirmwareKernels, SettingsThatAreNoneAreRefused) {
  const struct settings before = stereo_settings;
  for (const char* text :
       {"texture_threshold 65026\n", "lrc_threshold 256\n", "lrc_threshold 4294967297\n",
        "lrc_threshold \n", "lrc_threshold 1", "lrc_threshold 1 \n", "lrc_threshold\n", "lrc 1\n",
        " \n", "lrc_threshold -1\n", "window 4\n", "window 99\n", "window 1\n", "disparity_min 0\n",
        "disparity_max 256\n"}) {
    EXPECT_EQ(settings_read(text), 1) << text;
  }
  EXPECT_EQ(settings_read("lrc_threshold 2\nwindows 9\n"), 2);
  stereo_settings = before;
}

TEST(FirmwareKernels, MapsOfScenesEqualTheReference) {
  for (const std::string& name : scenes::scene_names()) {
    SCOPED_TRACE(name);
    const scenes::Scene scene = scenes::load_scene(name, FINBACK_SCENES);
    expect_equal(sampled(scene.left), sampled(scene.right));
  }
}

// Every pair of the data folder that has two views, brought to the camera's size.
TEST(FirmwareKernels, MapsOfRealPairsEqualTheReference) {
  const char* chosen = std::getenv("FINBACK_SHARED_DATA");
  const fs::path folder =
      fs::path(chosen != nullptr ? chosen : FINBACK_DEFAULT_DATA) / "middlebury";
  if (!fs::exists(folder)) {
    GTEST_SKIP() << folder << " is not there; set FINBACK_SHARED_DATA to a data folder";
  }
  int pairs = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    for (const auto& [left, right] :
         {std::pair{"view1.png", "view5.png"}, {"im2.png", "im6.png"}}) {
      if (!fs::exists(entry.path() / left) || !fs::exists(entry.path() / right)) {
        continue;
      }
      SCOPED_TRACE(entry.path().string());
      const auto pair = scenes::load_luma_vga_pair(entry.path() / left, entry.path() / right);
      expect_equal(sampled(pair.left), sampled(pair.right));
      ++pairs;
    }
  }
  EXPECT_GE(pairs, 30);
}

}  // namespace
}  // namespace finback
