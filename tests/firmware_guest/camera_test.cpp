// A firmware that captures both cameras by PPI and 2-D DMA: what it publishes is what they see.
#include <gtest/gtest.h>
#include <string>

#include <common/counters.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/peripherals.hpp>

namespace finback {
namespace {

using peripheral::Camera;
using peripheral::FrameTrouble;
using peripheral::Picture;

constexpr Cycles kFramePeriod = 20'000'000;  // 30 Hz at 600 MHz
constexpr std::uint32_t kPpiOverrun = 0x1000;

// No two frames, sides or rows alike.
std::shared_ptr<const Picture> picture_of(Camera::Side side, std::uint32_t number) {
  auto picture = std::make_shared<Picture>(Picture{640, 480, {}});
  const unsigned start = 37 * number + (side == Camera::Side::right ? 101 : 0);
  for (unsigned y = 0; y < 480; ++y) {
    for (unsigned x = 0; x < 640; ++x) {
      picture->luma.push_back(static_cast<std::uint8_t>(start + 7 * y + x + (x >> 3U) * y));
    }
  }
  return picture;
}

class CaptureTest : public testing::Test {
 protected:
  machine::StopInfo run(std::uint32_t frames) {
    firmware_ = ir::load_firmware(FINBACK_CAPTURE "/firmware.toml");
    image_ = ir::link(firmware_.units, firmware_.placement, description_.map);
    machine_ = std::make_unique<machine::Machine>(description_, image_);
    machine_->host().set_frame_source({}, frames);
    for (const Camera::Side side : {Camera::Side::left, Camera::Side::right}) {
      machine_->peripherals().connect_camera(
          side, [side](std::uint32_t number) { return picture_of(side, number); },
          troubles_[static_cast<std::size_t>(side)]);
    }
    return machine_->run({.cycles = (frames + 6) * kFramePeriod, .cancelled = {}});
  }
  // Maps 2 n and 2 n + 1 are the views of the camera's frame `expected[n]`.
  void expect_frames(const std::vector<std::uint32_t>& expected) {
    const auto& maps = machine_->host().maps();
    ASSERT_EQ(maps.size(), 2 * expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_TRUE(maps[2 * i].bytes == picture_of(Camera::Side::left, expected[i])->luma) << i;
      EXPECT_TRUE(maps[2 * i + 1].bytes == picture_of(Camera::Side::right, expected[i])->luma) << i;
      EXPECT_EQ(maps[2 * i].picture, expected[i]);
    }
  }
  std::uint64_t counter(const std::string& name) {
    return machine_->counters().snapshot().at(name).value;
  }

  machine::MachineDescription description_;
  std::array<std::vector<FrameTrouble>, 2> troubles_;
  ir::Firmware firmware_;
  ir::Image image_;
  std::unique_ptr<machine::Machine> machine_;
};

TEST_F(CaptureTest, WhatIsPublishedIsWhatTheCamerasSaw) {
  const machine::StopInfo stop = run(3);
  ASSERT_EQ(stop.reason, machine::Stop::exited);
  EXPECT_EQ(stop.exit_status, 0U);
  expect_frames({1, 2, 3});  // frame 0 had begun before the firmware
  EXPECT_EQ(counter("ppi0.frames.events"), 3U);
  EXPECT_EQ(counter("ppi1.captured.bytes"), 3U * 640 * 480);
  EXPECT_EQ(counter("traffic.l3.ppi0.write.bytes"), 3U * 640 * 480);
  // A frame is whole when its last pixel has come, and the map of it follows soon.
  for (std::uint32_t i = 0; i < 3; ++i) {
    const machine::PublishedMap& map = machine_->host().maps()[2 * i];
    EXPECT_EQ(map.grabbed_at, (i + 1) * kFramePeriod + 19'600'641);
    EXPECT_LT(map.published_at - map.grabbed_at, 5000U);
  }
}

TEST_F(CaptureTest, OffsetAndLateAndDroppedFramesAreSeenAsTheyCome) {
  // Both begin when the firmware is ready.
  description_.set("camera.left_offset_us", 300);
  description_.set("camera.right_offset_us", 100);
  troubles_[0] = {{.frame = 2, .dropped = true}, {.frame = 4, .late_us = 3000}};
  troubles_[1] = {{.frame = 2, .dropped = true}};
  const machine::StopInfo stop = run(4);
  ASSERT_EQ(stop.reason, machine::Stop::exited);
  EXPECT_EQ(stop.exit_status, 0U);
  expect_frames({0, 1, 3, 4});
  EXPECT_EQ(machine_->host().maps()[6].grabbed_at,
            4 * kFramePeriod + 180'000 + 1'800'000 + 19'600'641);
}

TEST_F(CaptureTest, FasterThanMemoryTakesItIsOverrunAndReported) {
  description_.set("memory.sdram.beat_sclk", 16);
  description_.set("memory.sdram.dma_overhead_sclk", 64);
  const machine::StopInfo stop = run(1);
  // The channel goes on with the next frame for what was lost: the picture slides.
  ASSERT_EQ(stop.reason, machine::Stop::exited);
  EXPECT_EQ(stop.exit_status & kPpiOverrun, kPpiOverrun);
  EXPECT_GT(counter("ppi0.lost.bytes"), 0U);
  EXPECT_FALSE(machine_->host().maps()[0].bytes == picture_of(Camera::Side::left, 1)->luma);
}

}  // namespace
}  // namespace finback
