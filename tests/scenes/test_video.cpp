// Are videos read picture by picture, forwards and back, side by side and from two files?
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <scenes/sequence.hpp>

// What videoio's plugins of GStreamer leave behind at the end is not Finback's.
extern "C" const char* __lsan_default_options() { return "detect_leaks=0"; }

namespace finback::scenes {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class VideoTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!reads_videos()) {
      GTEST_SKIP() << "built without OpenCV's videoio";
    }
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Frame n is grey 40 + 20 n in its left half and 10 more in the right one, of raw YUV 4:2:0.
  fs::path video(const std::string& name, int width, int frames, int start = 40) {
    constexpr int kHeight = 48;
    fs::path path = folder_ / name;
    std::ofstream out(path, std::ios::binary);
    out << "YUV4MPEG2 W" << width << " H" << kHeight << " F30:1 Ip A1:1 C420\n";
    for (int n = 0; n < frames; ++n) {
      out << "FRAME\n";
      for (int i = 0; i < width * kHeight; ++i) {
        out << static_cast<char>(start + 20 * n + (i % width >= width / 2 ? 10 : 0));
      }
      out << std::string(static_cast<std::size_t>(width * kHeight / 2), '\x80');
    }
    return path;
  }
  // Video range, 16 to 235, becomes 0 to 255.
  static int grey(int y) { return static_cast<int>(std::lround((y - 16) * 255.0 / 219)); }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("finback_video_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(VideoTest, SideBySideIsSplitInTheMiddle) {
  const auto sequence = video_sequence({video("both.y4m", 128, 5)});
  ASSERT_EQ(sequence->size(), 5U);
  for (const std::uint32_t number : {0U, 1U, 4U, 2U, 7U}) {
    const int y = 40 + 20 * static_cast<int>(number % 5);
    EXPECT_NEAR(sequence->pair(number).left.at(320, 240), grey(y), 3) << number;
    EXPECT_NEAR(sequence->pair(number).right.at(320, 240), grey(y + 10), 3) << number;
    EXPECT_EQ(sequence->pair(number).left.width(), kVgaWidth);
  }
}

TEST_F(VideoTest, OfTwoFilesTheShorterOneSaysHowMany) {
  const auto sequence = video_sequence({video("left.y4m", 64, 4), video("right.y4m", 64, 3, 100)});
  ASSERT_EQ(sequence->size(), 3U);
  EXPECT_NEAR(sequence->pair(2).left.at(10, 10), grey(80), 3);
  EXPECT_NEAR(sequence->pair(2).right.at(10, 10), grey(140), 3);
}

TEST_F(VideoTest, WhatIsNoneIsRefused) {
  EXPECT_THAT([&] { static_cast<void>(video_sequence({folder_ / "none.mp4"})); },
              ThrowsMessage<InputError>(HasSubstr("none.mp4: is no video that OpenCV can read")));
}

TEST(Video, WithoutItsLibraryTheMessageSaysWhatToDo) {
  if (reads_videos()) {
    GTEST_SKIP() << "built with OpenCV's videoio";
  }
  EXPECT_THAT([] { static_cast<void>(video_sequence({"film.mp4"})); },
              ThrowsMessage<InputError>(HasSubstr("give a folder of left_* and right_* pictures")));
}

}  // namespace
}  // namespace finback::scenes
