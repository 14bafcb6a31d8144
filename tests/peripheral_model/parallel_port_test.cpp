// A port between a camera and a channel: what is taken, when, and what goes wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <peripheral_model/parallel_port.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kControl = 0, kStatus = 4, kCount = 8, kDelay = 12, kFrameLines = 16;
constexpr std::uint32_t kOn = 1, kItuAll = 1U << 2, kSyncs = 3U << 2, kTwoSyncs = 2U << 4,
                        kPack = 1U << 7, kDma32 = 1U << 8, kSkip = 1U << 9, kSkipEven = 1U << 10;
constexpr std::uint32_t kFrameTrack = 0x0800, kOverrun = 0x1000;
constexpr Cycles kFrame = 20'000'000;

std::uint8_t pixel(std::uint32_t frame, int x, int y) {
  return static_cast<std::uint8_t>(static_cast<int>(frame) * 5 + 3 * y + x);
}

class ParallelPortTest : public testing::Test {
 protected:
  ParallelPortTest() { make(); }

  void set(ParameterGroup& group, std::string_view name, double value) {
    for (ParameterBase* parameter : group.parameters()) {
      if (parameter->declaration().name == name) {
        parameter->set(value);
      }
    }
    make();
  }
  void make() {
    camera_ = std::make_unique<Camera>(Camera::Side::left, camera_parameters_, 600);
    camera_->connect(
        [this](std::uint32_t number) {
          auto picture =
              std::make_shared<Picture>(Picture{camera_->width(), camera_->height(), {}});
          for (int y = 0; y < picture->height; ++y) {
            for (int x = 0; x < picture->width; ++x) {
              picture->luma.push_back(pixel(number, x, y));
            }
          }
          return picture;
        },
        troubles_);
    port_ = std::make_unique<ParallelPort>(
        "PPI0", *camera_, parameters_, 120,
        ParallelPort::Outputs{
            .push =
                [this](std::span<const std::uint8_t> bytes, Cycles at) {
                  if (!drained_) {
                    return false;
                  }
                  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
                  times_.push_back(at);
                  return true;
                },
            .element_bytes = [this] { return element_; },
            .error_line = [this](bool level, Cycles at) { errors_.emplace_back(level, at); },
            .captured = [this](std::uint32_t frame,
                               Cycles at) { frames_.emplace_back(frame, at); }});
  }
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    port_->write(offset, 2, value, now);
  }
  std::uint32_t read(std::uint32_t offset) { return port_->read(offset, 2, 0); }
  // Y only of whole frames, as the firmware of a stereo camera takes them.
  void start_luma(Cycles now = 0) {
    write(kCount, 1279, now);
    write(kFrameLines, 480, now);
    write(kControl, kOn | kSyncs | kTwoSyncs | kPack | kSkip, now);
  }

  CameraParameters camera_parameters_;
  PeripheralParameters parameters_;
  std::vector<FrameTrouble> troubles_;
  std::unique_ptr<Camera> camera_;
  std::unique_ptr<ParallelPort> port_;
  bool drained_ = true;
  std::uint32_t element_ = 2;
  std::vector<std::uint8_t> bytes_;
  std::vector<Cycles> times_;
  std::vector<std::pair<bool, Cycles>> errors_;
  std::vector<std::pair<std::uint32_t, Cycles>> frames_;
};

TEST_F(ParallelPortTest, RegistersKeepWhatIsWrittenAndStatusIsCleared) {
  for (const std::uint32_t offset : {kCount, kDelay, kFrameLines}) {
    write(offset, 0x1234 + offset);
    EXPECT_EQ(read(offset), 0x1234 + offset);
  }
  write(kControl, kSyncs);
  EXPECT_EQ(read(kControl), kSyncs);
  EXPECT_EQ(port_->next_event_time(), kNever) << "a port that is off does nothing";
}

TEST_F(ParallelPortTest, SkippingTakesTheLumaOfWholeFrames) {
  start_luma(5);
  EXPECT_EQ(port_->next_event_time(), kFrame) << "frame 0 has begun before";
  port_->advance(2 * kFrame - 1);
  ASSERT_EQ(bytes_.size(), 640U * 480);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      ASSERT_EQ(bytes_[static_cast<std::size_t>(y * 640 + x)], pixel(1, x, y)) << x << ' ' << y;
    }
  }
  const Camera::Frame frame{1, kFrame};
  EXPECT_EQ(times_.size(), 480U * 20);
  EXPECT_EQ(times_.front(), camera_->time_of(frame, 20, 63));
  EXPECT_EQ(times_.back(), camera_->time_of(frame, 20 + 479, 1279));
  EXPECT_THAT(frames_, ElementsAre(std::pair(1U, times_.back())));
  EXPECT_EQ(port_->next_event_time(), 2 * kFrame) << "begun, nothing taken yet";
  EXPECT_EQ(read(kStatus), 0U);
}

TEST_F(ParallelPortTest, TheOtherElementsAreTheChroma) {
  write(kCount, 1279);
  write(kFrameLines, 480);
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack | kSkip | kSkipEven);
  port_->advance(kFrame - 1);
  ASSERT_EQ(bytes_.size(), 640U * 480);
  EXPECT_EQ(std::ranges::count(bytes_, 128), 640 * 480);
}

TEST_F(ParallelPortTest, DelayAndCountCutAWindowOutOfEachLine) {
  write(kDelay, 100);
  write(kCount, 7);
  write(kFrameLines, 480);
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack);
  port_->advance(camera_->time_of({0, 0}, 21, 107));
  EXPECT_THAT(bytes_, ElementsAre(50, 128, 51, 128, 52, 128, 53, 128,  //
                                  53, 128, 54, 128, 55, 128, 56, 128));
  EXPECT_THAT(times_,
              ElementsAre(camera_->time_of({0, 0}, 20, 107), camera_->time_of({0, 0}, 21, 107)));
}

TEST_F(ParallelPortTest, WithoutPackingASampleFillsAWordOfTheChannel) {
  for (const auto& [element, control, expected] :
       std::vector<std::tuple<std::uint32_t, std::uint32_t, std::vector<std::uint8_t>>>{
           {2, 0, {0, 0, 128, 0, 1, 0, 128, 0}},
           {1, 0, {0, 128, 1, 128}},
           {2, 2U << 11, {0, 0, 128, 0, 1, 0, 128, 0}},  // DLEN: 11 bits
           {4, kDma32 | kPack, {0, 128, 1, 128}},
           {4, kDma32, {0, 0, 128, 0, 1, 0, 128, 0}}}) {
    make();
    bytes_.clear();
    element_ = element;
    write(kCount, 3);
    write(kFrameLines, 480);
    write(kControl, kOn | kSyncs | kTwoSyncs | control);
    port_->advance(camera_->time_of({0, 0}, 20, 3));
    EXPECT_EQ(bytes_, expected) << element << ' ' << control;
  }
}

TEST_F(ParallelPortTest, AnOddRestOfALineWaitsForTheNext) {
  write(kCount, 2);
  write(kFrameLines, 480);
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack);
  port_->advance(camera_->time_of({0, 0}, 20, 2));
  EXPECT_EQ(bytes_.size(), 2U);
  port_->advance(camera_->time_of({0, 0}, 21, 2));
  EXPECT_THAT(bytes_, ElementsAre(0, 128, 1, 3, 128, 4));
}

TEST_F(ParallelPortTest, WhatNobodyTakesIsOverrunAndRaisesTheErrorInterruptOnce) {
  drained_ = false;
  start_luma();
  port_->advance(kFrame - 1);
  EXPECT_EQ(read(kStatus), kOverrun);
  const Cycles at = camera_->time_of({0, 0}, 20, 63);
  EXPECT_THAT(errors_, ElementsAre(std::pair(true, at)));
  write(kStatus, 0xFFFF, kFrame - 1);
  EXPECT_EQ(read(kStatus), 0U);
  EXPECT_THAT(errors_, ElementsAre(std::pair(true, at), std::pair(false, kFrame - 1)));
  CounterRegistry registry;
  port_->register_counters(registry);
  EXPECT_EQ(registry.snapshot().at("ppi0.lost.bytes").value, 640U * 480);
  EXPECT_EQ(registry.snapshot().at("ppi0.captured.bytes").value, 0U);
}

TEST_F(ParallelPortTest, ALineBeyondFrameIsATrackErrorWhenItBegins) {
  write(kCount, 1279);
  write(kFrameLines, 10);
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack | kSkip);
  port_->advance(kFrame - 1);
  EXPECT_EQ(bytes_.size(), 6400U);
  EXPECT_EQ(read(kStatus), kFrameTrack);
  EXPECT_THAT(errors_, ElementsAre(std::pair(true, camera_->time_of({0, 0}, 30, 0))));
}

TEST_F(ParallelPortTest, AFrameThatIsTooShortIsATrackErrorAtTheNext) {
  write(kCount, 1279);
  write(kFrameLines, 481);
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack | kSkip);
  port_->advance(kFrame - 1);
  EXPECT_EQ(read(kStatus), 0U);
  port_->advance(kFrame);
  EXPECT_EQ(read(kStatus), kFrameTrack);
  EXPECT_THAT(errors_, ElementsAre(std::pair(true, kFrame)));
}

TEST_F(ParallelPortTest, OneSyncTakesEveryLineAndHeedsNoFrame) {
  write(kCount, 1279);
  write(kControl, kOn | kSyncs | kPack | kSkip);
  port_->advance(2 * kFrame - 1);
  EXPECT_EQ(bytes_.size(), 2U * 640 * 480);
  EXPECT_EQ(read(kStatus), 0U);
}

TEST_F(ParallelPortTest, Itu656GivesThePixelsOrAll) {
  set(camera_parameters_, "camera.itu656", 1);
  write(kFrameLines, 510);
  write(kControl, kOn | kPack);
  port_->advance(kFrame - 1);
  EXPECT_EQ(bytes_.size(), 1280U * 480);
  EXPECT_EQ(bytes_[1280 * 7 + 4], pixel(0, 2, 7));
  EXPECT_EQ(read(kStatus), 0U);

  make();
  bytes_.clear();
  write(kFrameLines, 510);
  write(kControl, kOn | kPack | kItuAll);
  port_->advance(kFrame);
  EXPECT_EQ(bytes_.size(), 1568U * 510);
  EXPECT_THAT(std::vector(bytes_.begin() + 1568 * 27, bytes_.begin() + 1568 * 27 + 4),
              ElementsAre(0xFF, 0, 0, 0x9D));
  EXPECT_EQ(bytes_[1568 * 27 + 288 + 4], pixel(0, 2, 7));
}

TEST_F(ParallelPortTest, DisablingEndsTheCaptureAtOnceAndEnablingWaitsForAWholeFrame) {
  start_luma();
  const Cycles middle = kFrame / 2;
  port_->advance(middle);
  const std::size_t before = bytes_.size();
  write(kControl, 0, middle);
  EXPECT_EQ(port_->next_event_time(), kNever);
  start_luma(middle + 1);
  EXPECT_EQ(port_->next_event_time(), kFrame);
  port_->advance(2 * kFrame - 1);
  EXPECT_EQ(bytes_.size(), before + 640 * 480);
}

TEST_F(ParallelPortTest, ADroppedFrameIsNoErrorButAGap) {
  troubles_ = {{.frame = 1, .dropped = true}};
  make();
  start_luma();
  port_->advance(3 * kFrame - 1);
  ASSERT_EQ(frames_.size(), 2U);
  EXPECT_EQ(frames_[0].first, 0U);
  EXPECT_EQ(frames_[1].first, 2U);
  EXPECT_EQ(read(kStatus), 0U);
}

TEST_F(ParallelPortTest, WhatCannotWorkIsAFaultThatSaysHowToMendIt) {
  const auto refuses = [&](std::uint32_t control, const char* why) {
    EXPECT_THAT([&] { write(kControl, control); }, ThrowsMessage<GuestFault>(HasSubstr(why)));
  };
  refuses(kOn | 2U, "PORT_DIR = 1");
  refuses(kOn | (2U << 2), "XFR_TYPE 2");
  refuses(kOn | kSyncs | (1U << 4), "PORT_CFG wants 0 (HREF) or 2");
  refuses(kOn | kSyncs | (1U << 15), "POLS = 1");
  refuses(kOn, "set camera.itu656=1");
  write(kCount, 1280);
  refuses(kOn | kSyncs | kTwoSyncs,
          "with DELAY = 0 that is 1281 clocks; a line of the camera has 1280");
  write(kCount, 1279);
  write(kFrameLines, 480);
  element_ = 4;
  write(kControl, kOn | kSyncs | kTwoSyncs | kPack);
  EXPECT_THAT([&] { port_->advance(kFrame); },
              ThrowsMessage<GuestFault>(HasSubstr("words of 16 bits, its DMA channel takes 32")));
}

TEST_F(ParallelPortTest, ThePixelClockMayBeHalfOfSclkAndNoMore) {
  write(kCount, 1279);
  set(camera_parameters_, "camera.frame_rate", 75.04);
  write(kCount, 1279);
  EXPECT_THAT(
      [&] { write(kControl, kOn | kSyncs); },
      ThrowsMessage<GuestFault>(HasSubstr("60.008 MHz is above 60.000 MHz, the port's limit")));
  set(camera_parameters_, "camera.frame_rate", 75.03);
  write(kCount, 1279);
  EXPECT_NO_THROW(write(kControl, kOn | kSyncs));
}

TEST_F(ParallelPortTest, APortWithoutACameraSaysSo) {
  Camera none(Camera::Side::right, camera_parameters_, 600);
  ParallelPort port("PPI1", none, parameters_, 120, {});
  EXPECT_THAT(
      [&] { port.write(kControl, 2, kOn | kSyncs, 0); },
      ThrowsMessage<GuestFault>("PPI1_CONTROL = 0x000d: no camera is connected to this port"));
}

}  // namespace
}  // namespace finback::peripheral
