#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

#include <common/error.hpp>
#include <scenes/luma.hpp>

namespace finback::scenes {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A folder of its own for every test, removed with it.
class LumaFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("finback_luma_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  // A binary PGM or PPM: the simplest files that OpenCV reads.
  fs::path write_pnm(const std::string& name, int width, int height, const std::string& bytes) {
    const bool colour = static_cast<int>(bytes.size()) == 3 * width * height;
    return write(name, std::string(colour ? "P6 " : "P5 ") + std::to_string(width) + " " +
                           std::to_string(height) + " 255\n" + bytes);
  }

  fs::path folder_;
};

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(LumaFiles, VgaGreyStaysAsItIs) {
  std::string bytes(std::size_t{640} * 480, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<char>(i * 2654435761U >> 13U);
  }
  const ByteImage image = load_luma_vga(write_pnm("grey.pgm", 640, 480, bytes));
  ASSERT_EQ(image.pixels().size(), bytes.size());
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), image.pixels().begin(),
                         [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
}

TEST_F(LumaFiles, ColourBecomesBt601Luma) {
  const ByteImage image =
      load_luma(write_pnm("rgb.ppm", 3, 1, std::string("\xFF\0\0\0\xFF\0\0\0\xFF", 9)));
  EXPECT_EQ(image.at(0, 0), 76);   // 0.299 * 255
  EXPECT_EQ(image.at(1, 0), 150);  // 0.587 * 255
  EXPECT_EQ(image.at(2, 0), 29);   // 0.114 * 255
}

TEST_F(LumaFiles, AnyShapeBecomesVga) {
  for (const auto& [width, height] :
       {std::pair{640, 480}, {1280, 960}, {427, 370}, {160, 120}, {1000, 100}, {7, 900}, {4, 3}}) {
    const ByteImage image = load_luma_vga(write_pnm(
        "any.pgm", width, height, std::string(static_cast<std::size_t>(width * height), 'x')));
    EXPECT_EQ(image, ByteImage(640, 480, 'x')) << width << "x" << height;
  }
}

TEST(Luma, CropKeepsTheCentre) {
  ByteImage wide(10, 3);
  wide.at(3, 1) = 7;
  wide.at(6, 1) = 8;
  const ByteImage part = crop_to_4_by_3(wide);
  EXPECT_EQ(part.width(), 4);
  EXPECT_EQ(part.height(), 3);
  EXPECT_EQ(part.at(0, 1), 7);
  EXPECT_EQ(part.at(3, 1), 8);

  ByteImage high(4, 9);
  high.at(1, 3) = 5;
  EXPECT_EQ(crop_to_4_by_3(high).at(1, 0), 5);
  EXPECT_THROW((void)crop_to_4_by_3(ByteImage(3, 9)), InputError);
  EXPECT_THROW((void)crop_to_4_by_3(ByteImage(9, 2)), InputError);
}

TEST(Luma, ShrinkingTakesTheMeanOverTheArea) {
  ByteImage image(4, 2);
  const int values[] = {10, 20, 100, 101, 30, 41, 102, 103};
  for (int i = 0; i < 8; ++i) {
    image.at(i % 4, i / 4) = static_cast<std::uint8_t>(values[i]);
  }
  const ByteImage half = resize(image, 2, 1);
  EXPECT_EQ(half.at(0, 0), 25);   // 101 / 4 = 25.25
  EXPECT_EQ(half.at(1, 0), 102);  // 406 / 4 = 101.5, rounded up
  // Three pixels on two: each target covers one and a half.
  ByteImage three(3, 1);
  three.at(0, 0) = 30;
  three.at(1, 0) = 60;
  three.at(2, 0) = 90;
  const ByteImage two = resize(three, 2, 1);
  EXPECT_EQ(two.at(0, 0), 40);  // (30 + 60 / 2) / 1.5
  EXPECT_EQ(two.at(1, 0), 80);
}

TEST(Luma, GrowingInterpolatesBetweenCentres) {
  ByteImage image(2, 1);
  image.at(0, 0) = 0;
  image.at(1, 0) = 100;
  const ByteImage four = resize(image, 4, 1);
  EXPECT_EQ(four.at(0, 0), 0);
  EXPECT_EQ(four.at(1, 0), 25);
  EXPECT_EQ(four.at(2, 0), 75);
  EXPECT_EQ(four.at(3, 0), 100);
  EXPECT_THROW((void)resize(ByteImage(), 2, 2), InputError);
}

TEST_F(LumaFiles, ErrorsAreOneLineThatNamesTheFile) {
  EXPECT_THAT(error_of([&] { (void)load_luma_vga(folder_ / "absent.png"); }),
              AllOf(HasSubstr("absent.png: no such image file"), Not(HasSubstr("\n"))));
  EXPECT_THAT(error_of([&] { (void)load_luma_vga(folder_); }), HasSubstr("is a folder"));
  EXPECT_THAT(error_of([&] { (void)load_luma_vga(write("empty.png", "")); }),
              HasSubstr("empty.png: the image file is empty"));
  EXPECT_THAT(error_of([&] { (void)load_luma_vga(write("text.png", "no picture")); }),
              HasSubstr("text.png: not an image"));
  EXPECT_THAT(error_of([&] { (void)load_luma_vga(write_pnm("dot.pgm", 1, 1, "x")); }),
              HasSubstr("dot.pgm: image of 1x1: too small"));
}

TEST_F(LumaFiles, PairsMustHaveOneSize) {
  const fs::path left = write_pnm("left.pgm", 8, 6, std::string(48, 'l'));
  const fs::path right = write_pnm("right.pgm", 4, 3, std::string(12, 'r'));
  EXPECT_THAT(
      error_of([&] { (void)load_luma_vga_pair(left, right); }),
      AllOf(HasSubstr("left.pgm is 8x6"), HasSubstr("right.pgm is 4x3"), Not(HasSubstr("\n"))));
  const LumaPair pair = load_luma_vga_pair(left, left);
  EXPECT_EQ(pair.left, ByteImage(640, 480, 'l'));
  EXPECT_EQ(pair.right, pair.left);
}

TEST_F(LumaFiles, DisparityPngIsScaledToItsRange) {
  ByteImage map(3, 1);
  map.at(1, 0) = 5;
  map.at(2, 0) = 35;
  const fs::path path = folder_ / "map.png";
  write_disparity_png(map, 5, 35, path);
  const ByteImage grey = load_luma(path);
  EXPECT_EQ(grey.at(0, 0), 0);    // invalid
  EXPECT_EQ(grey.at(1, 0), 8);    // 255 / 31
  EXPECT_EQ(grey.at(2, 0), 255);  //
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "the temporary file must be gone";
}

TEST_F(LumaFiles, DisparityPngRefusesWhatItCannotShow) {
  ByteImage map(2, 1);
  map.at(1, 0) = 36;
  EXPECT_THAT(error_of([&] { write_disparity_png(map, 5, 35, folder_ / "m.png"); }),
              HasSubstr("disparity 36 at (1, 0) is outside 5..35"));
  EXPECT_THAT(error_of([&] { write_disparity_png(map, 9, 8, folder_ / "m.png"); }),
              HasSubstr("disparities 9..8"));
  EXPECT_THAT(error_of([&] { write_disparity_png(map, 5, 36, folder_ / "no" / "m.png"); }),
              HasSubstr("m.png"));
  EXPECT_THROW(write_png(ByteImage(), folder_ / "m.png"), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "m.png"));
}

}  // namespace
}  // namespace finback::scenes
