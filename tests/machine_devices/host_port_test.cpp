// Frames in, maps and text out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <isa_sim/machine/host_port.hpp>

namespace finback::machine {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kBytes = kFrameWidth * kFrameHeight;

StereoFrame frame(std::uint8_t value) {
  return {std::vector<std::uint8_t>(kBytes, value),
          std::vector<std::uint8_t>(kBytes, static_cast<std::uint8_t>(value + 100))};
}

class HostPortTest : public testing::Test {
 protected:
  void grab(Cycles now) {
    port_.write(kFrameLeftAddress, 4, 0x100000, now);
    port_.write(kFrameRightAddress, 4, 0x200000, now);
    port_.write(kFrameGrab, 4, 1, now);
  }
  std::uint8_t byte(Address address) { return memory_.view_bytes(address, 1)[0]; }

  memory::MemoryParameters parameters_;
  memory::ClockParameters clock_;
  memory::MemorySystem memory_{memory::bf561_map(), parameters_, clock_, {}};
  HostPort port_{memory_};
};

TEST_F(HostPortTest, GrabFillsBothBuffersAndCounts) {
  port_.set_frames({frame(1), frame(2)}, 3);
  EXPECT_EQ(port_.read(kFramesLeft, 4, 0), 3U);
  grab(10);
  EXPECT_EQ(port_.read(kFramesLeft, 4, 0), 2U);
  EXPECT_EQ(port_.read(kFrameNumber, 4, 0), 0U);
  EXPECT_EQ(byte(0x100000), 1);
  EXPECT_EQ(byte(0x200000 + kBytes - 1), 101);
  EXPECT_EQ(byte(0x200000 + kBytes), 0);
  grab(20);
  EXPECT_EQ(byte(0x100000), 2);
  grab(30);  // the first again
  EXPECT_EQ(byte(0x100000), 1);
  EXPECT_EQ(port_.read(kFrameNumber, 4, 0), 2U);
  EXPECT_EQ(
      memory_.level_traffic(memory::Level::l3, memory::Initiator::host, memory::Direction::write)
          .bytes,
      6U * kBytes);
  EXPECT_THAT([&] { grab(40); }, ThrowsMessage<GuestFault>(HasSubstr("all 3 frames were grabbed")));
}

TEST_F(HostPortTest, GrabIntoNowhereNamesTheRegister) {
  port_.set_frames({frame(1)}, 1);
  port_.write(kFrameLeftAddress, 4, 0xFEB00000, 0);  // L2 is too small
  EXPECT_THAT(
      [&] { port_.write(kFrameGrab, 4, 1, 0); },
      ThrowsMessage<GuestFault>(HasSubstr("HOST_FRAME_LEFT_ADDRESS = 0xfeb00000: 307200 bytes")));
  EXPECT_THROW(port_.write(kFrameGrab, 4, 2, 0), GuestFault);
}

TEST_F(HostPortTest, FramesOfAnotherSizeAreRefused) {
  StereoFrame small = frame(1);
  small.right.resize(100);
  EXPECT_THAT(
      [&] {
        port_.set_frames({frame(1), small}, 2);
      },
      ThrowsMessage<InputError>(HasSubstr("frame 1 has 307200 and 100 bytes")));
  EXPECT_THROW(port_.set_frames({}, 1), InputError);
}

TEST_F(HostPortTest, PublishingCopiesTheMapAndItsTimes) {
  port_.set_frames({frame(1)}, 2);
  grab(1000);
  grab(2000);
  const std::array<std::uint8_t, 6> map = {1, 2, 3, 4, 5, 6};
  memory_.store_bytes(0xFEB00010, map);
  port_.write(kMapAddress, 4, 0xFEB00010, 0);
  port_.write(kMapSize, 4, 3 | 2 << 16, 0);
  EXPECT_EQ(port_.read(kMapSize, 4, 0), 0x20003U);
  std::uint32_t heard = 99;
  port_.set_map_listener([&](const PublishedMap& published) { heard = published.frame_number; });
  port_.write(kMapPublish, 4, 1, 5000);
  memory_.store_bytes(0xFEB00010, std::array<std::uint8_t, 1>{77});
  ASSERT_EQ(port_.maps().size(), 1U);
  const PublishedMap& published = port_.maps()[0];
  EXPECT_EQ(heard, 1U);
  EXPECT_THAT(published.bytes, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(published.width, 3U);
  EXPECT_EQ(published.height, 2U);
  EXPECT_EQ(published.grabbed_at, 2000U);
  EXPECT_EQ(published.published_at, 5000U);
}

TEST_F(HostPortTest, WrongMapsAreFaults) {
  port_.set_frames({frame(1)}, 1);
  grab(0);
  port_.write(kMapSize, 4, 160, 0);
  EXPECT_THAT([&] { port_.write(kMapPublish, 4, 0, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("160 x 0 is empty")));
  port_.write(kMapSize, 4, 160 | 120 << 16, 0);
  EXPECT_THAT([&] { port_.write(kMapPublish, 4, 1, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("HOST_MAP_PUBLISH = 1: 1 frames")));
  port_.write(kMapAddress, 4, 0xFF807FFF, 0);
  EXPECT_THAT([&] { port_.write(kMapPublish, 4, 0, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("HOST_MAP_ADDRESS = 0xff807fff")));
}

TEST_F(HostPortTest, ConsoleDeliversLinesAndExitTheRest) {
  std::vector<std::string> lines;
  std::vector<std::pair<std::uint32_t, Cycles>> exits;
  port_.set_console([&](const std::string& line) { lines.push_back(line); });
  port_.set_exit([&](std::uint32_t status, Cycles at) { exits.emplace_back(status, at); });
  for (const char character : std::string("one\n\ntwo")) {
    port_.write(kConsole, 4, static_cast<std::uint8_t>(character), 0);
  }
  EXPECT_THAT(lines, ElementsAre("one", ""));
  port_.write(kExit, 4, 3, 77);
  EXPECT_THAT(lines, ElementsAre("one", "", "two"));
  EXPECT_THAT(exits, ElementsAre(std::pair<std::uint32_t, Cycles>{3, 77}));
}

TEST_F(HostPortTest, RegistersHaveTheirDirection) {
  EXPECT_THAT([&] { static_cast<void>(port_.read(kExit, 4, 0)); },
              ThrowsMessage<GuestFault>(HasSubstr("HOST_EXIT is write-only")));
  EXPECT_THAT([&] { port_.write(kFramesLeft, 4, 1, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("HOST_FRAMES_LEFT is read-only")));
  EXPECT_THROW(static_cast<void>(port_.read(kFrameNumber, 4, 0)), GuestFault);
}

}  // namespace
}  // namespace finback::machine
