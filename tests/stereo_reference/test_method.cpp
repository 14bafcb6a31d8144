// Methods by name against what they stand for; maps as pictures.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "random_images.hpp"
#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/map_file.hpp>
#include <stereo_reference/measures.hpp>
#include <stereo_reference/method.hpp>

namespace finback::stereo_reference {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Method, NamesStandForTransformAndMeasure) {
  std::mt19937 random(3);
  const ByteImage left = test::random_image(random, 50, 30);
  const ByteImage right = test::shifted(random, left, 7);
  const MatchParameters p{7, 2, 12};
  const auto by = [&](Measure measure, const auto& transform) {
    return match_by(measure, transform(left), transform(right), p).left;
  };
  const auto rank = [](int window) {
    return [window](const ByteImage& image) { return rank_transform(image, window); };
  };
  const auto census = [](int window) {
    return [window](const ByteImage& image) { return census_transform(image, window); };
  };
  const auto named = [&](const char* name) {
    return match(parse_method(name), left, right, p).left;
  };
  EXPECT_EQ(named("census3"), by(Measure::shd, census(3)));
  EXPECT_EQ(named("census5"), by(Measure::shd, census(5)));
  EXPECT_EQ(named("rank3"), by(Measure::sad, rank(3)));
  EXPECT_EQ(named("rank5"), by(Measure::sad, rank(5)));
  EXPECT_EQ(named("sad"), by(Measure::sad, as_words));
  EXPECT_EQ(named("ssd"), by(Measure::ssd, as_words));
  EXPECT_EQ(named("ncc"), by(Measure::ncc, as_words));
  for (const std::string& name : method_names()) {
    EXPECT_EQ(name_of(parse_method(name)), name);
  }
  EXPECT_THROW((void)parse_method("Census3"), InputError);
}

class MapFile : public testing::Test {
 protected:
  MapFile()
      : path_(std::filesystem::temp_directory_path() /
              ("finback_map_" + std::to_string(::getpid()) + ".png")) {}
  ~MapFile() override { std::filesystem::remove(path_); }
  std::filesystem::path path_;
};

TEST_F(MapFile, ReadsBack) {
  ByteImage map(3, 2);
  map.at(1, 0) = 63;
  map.at(2, 1) = 5;
  write_map(map, 4, path_);
  EXPECT_EQ(load_map(path_, 4), map);
  EXPECT_FLOAT_EQ(load_truth(path_, 8).at(2, 1), 2.5F);
  EXPECT_THAT(
      [&] { (void)load_map(path_, 3); },
      ThrowsMessage<InputError>(HasSubstr("grey 20 at (2, 1) is no multiple of the scale 3")));
  EXPECT_THAT([&] { write_map(map, 5, path_); },
              ThrowsMessage<InputError>(HasSubstr("take a scale of at most 4")));
  EXPECT_THROW((void)load_map(path_, 0), InputError);
  EXPECT_THROW((void)load_truth(path_, 256), InputError);
}

TEST(Evaluation, AMaskTakesWhatIsNotBlack) {
  ByteImage map(4, 1, 5);
  map.at(3, 0) = 9;
  const FloatImage truth(4, 1, 5.0F);
  ByteImage mask(4, 1);
  mask.at(1, 0) = 1;
  mask.at(3, 0) = 255;
  const MapQuality quality = evaluate(map, truth, {0, 0, 4, 1}, mask, 1.0);
  EXPECT_EQ(quality.compared, 2);
  EXPECT_EQ(quality.wrong, 1);
  EXPECT_THROW((void)evaluate(map, truth, {0, 0, 4, 1}, ByteImage(3, 1), 1.0), InputError);
}

}  // namespace
}  // namespace finback::stereo_reference
