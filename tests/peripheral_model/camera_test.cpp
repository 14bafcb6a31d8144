// A camera's bytes and the times at which they come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <peripheral_model/camera.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kCclk = 600;  // MHz
constexpr Cycles kFrame = 20'000'000;

// Frame n, row y, column x: n + 3 y + x.
std::shared_ptr<const Picture> numbered(std::uint32_t number, int width = 640, int height = 480) {
  auto picture = std::make_shared<Picture>(Picture{width, height, {}});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture->luma.push_back(static_cast<std::uint8_t>(static_cast<int>(number) + 3 * y + x));
    }
  }
  return picture;
}

class CameraTest : public testing::Test {
 protected:
  Camera camera(Camera::Side side = Camera::Side::left, std::vector<FrameTrouble> troubles = {}) {
    Camera made(side, parameters_, kCclk);
    made.connect([](std::uint32_t number) { return numbered(number); }, troubles);
    return made;
  }
  void set(std::string_view name, double value) {
    for (ParameterBase* parameter : parameters_.parameters()) {
      if (parameter->declaration().name == name) {
        parameter->set(value);
        return;
      }
    }
    FAIL() << name;
  }

  CameraParameters parameters_;
};

std::vector<std::uint8_t> bytes_of(Camera& camera, const Camera::Frame& frame, std::uint32_t line,
                                   std::uint32_t clock, std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  camera.fill(frame, line, clock, bytes);
  return bytes;
}

TEST_F(CameraTest, VgaHasTheSensorsTimingAtThirtyFramesASecond) {
  Camera vga = camera();
  EXPECT_NEAR(vga.pixel_clock_mhz(), 784 * 2 * 510 * 30 / 1e6, 1e-9);
  const Camera::Frame first = vga.next_frame(0);
  EXPECT_EQ(first.start, 0U);
  // Clock k is over after (k + 1) * 20'000'000 / 799'680 cycles, rounded up.
  EXPECT_EQ(vga.time_of(first, 0, 0), 26U);
  EXPECT_EQ(vga.time_of(first, vga.picture_line(), 0), 784'339U);      // 31'361 clocks
  EXPECT_EQ(vga.time_of(first, vga.picture_line(), 1279), 816'327U);   // 32'640
  EXPECT_EQ(vga.time_of(first, vga.picture_line() + 1, 0), 823'555U);  // 32'929
  EXPECT_EQ(vga.time_of(first, vga.picture_line() + 479, 1279), 19'600'641U);
  EXPECT_EQ(vga.next_frame(1).start, kFrame);
  EXPECT_EQ(vga.next_frame(kFrame).start, kFrame);
  EXPECT_EQ(vga.next_frame(5 * kFrame - 7).start, 5 * kFrame);
  EXPECT_EQ(vga.next_frame(5 * kFrame - 7).number, 5U);
}

TEST_F(CameraTest, SmallerPicturesKeepTheFrameTimeAtASlowerClock) {
  set("camera.halvings", 2);
  Camera small = camera();
  EXPECT_EQ(small.width(), 160);
  EXPECT_EQ(small.height(), 120);
  EXPECT_NEAR(small.pixel_clock_mhz(), 784 * 2 * 127.5 * 30 / 1e6, 1e-9);
  EXPECT_EQ(small.picture_line(), 5U);
  static_cast<void>(small.next_frame(0));
  EXPECT_EQ(small.next_frame(1).start, kFrame);
}

TEST_F(CameraTest, LumaAndGreyChromaTakeTurns) {
  Camera vga = camera();
  static_cast<void>(vga.next_frame(0));
  const Camera::Frame second = vga.next_frame(1);
  const std::uint32_t line = vga.picture_line() + 2;
  EXPECT_THAT(bytes_of(vga, second, line, 0, 5), ElementsAre(7, 128, 8, 128, 9));
  EXPECT_THAT(bytes_of(vga, second, line, 1277, 5),
              ElementsAre(128, (1 + 6 + 639) % 256, 128, 16, 128));
}

TEST_F(CameraTest, Itu656HasTheCodesOfOneField) {
  set("camera.itu656", 1);
  Camera coded = camera();
  const Camera::Frame frame = coded.next_frame(0);
  EXPECT_EQ(coded.picture_clock(), 1568U - 1280U);
  const std::uint32_t shown = coded.picture_line();
  EXPECT_THAT(bytes_of(coded, frame, shown, 0, 5), ElementsAre(0xFF, 0, 0, 0x9D, 16));
  EXPECT_THAT(bytes_of(coded, frame, shown, 284, 5), ElementsAre(0xFF, 0, 0, 0x80, 0));
  EXPECT_THAT(bytes_of(coded, frame, shown - 1, 3, 1), ElementsAre(0xB6));
  EXPECT_THAT(bytes_of(coded, frame, shown - 1, 287, 3), ElementsAre(0xAB, 16, 128));
  EXPECT_THAT(bytes_of(coded, frame, shown + 480, 287, 3), ElementsAre(0xAB, 16, 128));
}

TEST_F(CameraTest, TheTwoCamerasMayBeginApart) {
  set("camera.right_offset_us", 100);
  EXPECT_EQ(camera(Camera::Side::left).next_frame(0).start, 0U);
  EXPECT_EQ(camera(Camera::Side::right).next_frame(0).start, 60'000U);
}

TEST_F(CameraTest, JitterIsBoundedAndDiffersAndCanBeRepeated) {
  set("camera.jitter_us", 50);
  Camera left = camera();
  Camera again = camera();
  Camera right = camera(Camera::Side::right);
  Cycles largest = 0;
  int equal = 0;
  Cycles from = 0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Camera::Frame frame = left.next_frame(from);
    EXPECT_EQ(frame.start, again.next_frame(from).start);
    equal += frame.start == right.next_frame(from).start ? 1 : 0;
    EXPECT_EQ(frame.number, i);
    const Cycles late = frame.start - i * kFrame;
    EXPECT_LE(late, 30'000U);
    largest = std::max(largest, late);
    from = frame.start + 1;
  }
  EXPECT_GT(largest, 25'000U);
  EXPECT_LT(equal, 3);
}

TEST_F(CameraTest, FramesAreDroppedAndLateAsAsked) {
  Camera troubled = camera(Camera::Side::left, {{.frame = 1, .dropped = true},
                                                {.frame = 3, .late_us = 1000},
                                                {.frame = 4, .late_us = 40'000}});
  std::vector<std::pair<std::uint32_t, Cycles>> frames;
  for (Cycles from = 0; frames.size() < 5; from = frames.back().second + 1) {
    const Camera::Frame frame = troubled.next_frame(from);
    frames.emplace_back(frame.number, frame.start);
  }
  // Frame 5 waits for the end of frame 4's picture, which is later than its own time.
  const Cycles picture_end = (500 * 1568 + 1) * kFrame / 799'680 + 1;
  EXPECT_THAT(frames, ElementsAre(std::pair(0U, Cycles{0}), std::pair(2U, 2 * kFrame),
                                  std::pair(3U, 3 * kFrame + 600'000),
                                  std::pair(4U, 4 * kFrame + 24'000'000),
                                  std::pair(5U, 4 * kFrame + 24'000'000 + picture_end)));
}

TEST_F(CameraTest, SharesOfDroppedAndLateFramesAreMetByChance) {
  set("camera.dropped_share", 0.1);
  set("camera.late_share", 0.2);
  set("camera.late_us", 500);  // less than the blanking: nobody waits
  Camera troubled = camera();
  int sent = 0;
  int late = 0;
  for (Cycles from = 0;;) {
    const Camera::Frame frame = troubled.next_frame(from);
    if (frame.number >= 1000) {
      break;
    }
    ++sent;
    late += frame.start != frame.number * kFrame ? 1 : 0;
    from = frame.start + 1;
  }
  EXPECT_NEAR(1000 - sent, 100, 30);
  EXPECT_NEAR(late, 180, 40);
}

TEST_F(CameraTest, APictureOfAnotherSizeAndAFrameTooShortAreRefused) {
  Camera other(Camera::Side::right, parameters_, kCclk);
  other.connect([](std::uint32_t number) { return numbered(number, 320, 240); }, {});
  const Camera::Frame frame = other.next_frame(0);
  EXPECT_THAT(
      [&] { bytes_of(other, frame, 30, 0, 1); },
      ThrowsMessage<InputError>("the right camera got a picture of 320x240 and sends 640x480"));
  set("camera.top_lines", 30);
  EXPECT_THAT([&] { camera(); }, ThrowsMessage<InputError>(HasSubstr("raise camera.frame_lines")));
}

}  // namespace
}  // namespace finback::peripheral
