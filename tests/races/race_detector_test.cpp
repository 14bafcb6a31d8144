// What is ordered and what is not, told event by event.
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <races/race_detector.hpp>

namespace finback::races {
namespace {

using memory::Direction;
using memory::DmaRun;
using memory::Initiator;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int kA = 0, kB = 1;
constexpr Address kData = 0xFEB00000, kFlag = 0xFEB01000, kRegister = 0xFFC01F08;

class RaceDetectorTest : public testing::Test {
 protected:
  void write(int core, Address address, int bytes = 4, std::uint32_t packet = 1) {
    detector_.core_access(core, packet, address, bytes, Direction::write, ++now_);
  }
  void read(int core, Address address, int bytes = 4, std::uint32_t packet = 2) {
    detector_.core_access(core, packet, address, bytes, Direction::read, ++now_);
  }
  void dma(Direction direction, Address address, std::uint32_t count = 4) {
    const std::array<DmaRun, 1> run = {DmaRun{address, 4, count}};
    detector_.dma_access(Initiator::mdma1_0, run, 4, direction, ++now_);
  }
  // A register of the stream's channel.
  void channel(int core, Direction direction) {
    detector_.device_access(core, 7, kRegister, direction, ++now_);
    detector_.channel_access(Initiator::mdma1_0, direction);
  }
  [[nodiscard]] const std::vector<Race>& races() const { return detector_.races(); }

  RaceDetector detector_{{{kFlag, 4}}};
  Cycles now_ = 0;
};

TEST_F(RaceDetectorTest, TwoWritersOfAWordThatNothingOrders) {
  write(kA, kData, 4, 10);
  write(kB, kData, 4, 20);
  ASSERT_THAT(races(), SizeIs(1));
  const Race& race = races()[0];
  EXPECT_EQ(race.earlier, (RaceSide{Initiator::core_a, Direction::write, {kA, 10}}));
  EXPECT_EQ(race.later, (RaceSide{Initiator::core_b, Direction::write, {kB, 20}}));
  EXPECT_EQ(race.address, kData);
  EXPECT_EQ(race.bytes, 4U);
  EXPECT_EQ(race.at, 2U);
}

TEST_F(RaceDetectorTest, ReadersDoNotRaceNorDoNeighboursInAWord) {
  read(kA, kData);
  read(kB, kData);
  write(kA, kData + 4, 2);
  write(kB, kData + 6, 1);
  read(kB, kData + 7, 1);
  EXPECT_THAT(races(), IsEmpty());
}

TEST_F(RaceDetectorTest, OnePairOfPlacesIsOneRace) {
  for (Address at = kData; at < kData + 64; at += 4) {
    write(kA, at);
    read(kB, at);
  }
  ASSERT_THAT(races(), SizeIs(1));
  EXPECT_EQ(races()[0].bytes, 64U);
  read(kB, kData, 4, 99);
  EXPECT_THAT(races(), SizeIs(2));
}

TEST_F(RaceDetectorTest, AFlagCarriesWhatCameBeforeIt) {
  write(kA, kData);
  write(kA, kFlag);
  read(kB, kFlag);
  read(kB, kData);
  EXPECT_THAT(races(), IsEmpty());
  write(kA, kData);  // behind the flag: against the read before and the one after
  read(kB, kData);
  EXPECT_THAT(races(), SizeIs(2));
}

TEST_F(RaceDetectorTest, AFlagReadTooEarlyOrdersNothing) {
  read(kB, kFlag);
  write(kA, kData);
  write(kA, kFlag);
  read(kB, kData);
  EXPECT_THAT(races(), SizeIs(1));
}

TEST_F(RaceDetectorTest, ALockOrdersWhoHoldsIt) {
  constexpr Address kLock = kData + 0x100;
  for (int round = 0; round < 3; ++round) {
    for (const int core : {kA, kB}) {
      detector_.core_lock(core, 5, kLock, ++now_);
      read(core, kData);
      write(core, kData);
      write(core, kLock, 1);  // released
    }
  }
  EXPECT_THAT(races(), IsEmpty());
  write(kB, kData);  // without the lock, but behind its own turn
  detector_.core_lock(kA, 5, kLock, ++now_);
  write(kA, kData);
  EXPECT_THAT(races(), SizeIs(1));
}

TEST_F(RaceDetectorTest, DmaIsOrderedByItsRegisters) {
  write(kA, kData);
  channel(kA, Direction::write);
  dma(Direction::read, kData);
  dma(Direction::write, kData + 0x100);
  channel(kA, Direction::read);
  read(kA, kData + 0x100);
  write(kA, kData);
  EXPECT_THAT(races(), IsEmpty());
}

TEST_F(RaceDetectorTest, AReaderThatDoesNotWaitForDma) {
  channel(kA, Direction::write);
  dma(Direction::write, kData);
  read(kA, kData + 4);
  ASSERT_THAT(races(), SizeIs(1));
  EXPECT_EQ(races()[0].earlier, (RaceSide{Initiator::mdma1_0, Direction::write, {kA, 7}}));
}

// The core was there first, but nothing made the stream wait for it.
TEST_F(RaceDetectorTest, DmaThatComesBehindAReader) {
  channel(kA, Direction::write);
  read(kA, kData);
  dma(Direction::write, kData);
  ASSERT_THAT(races(), SizeIs(1));
  EXPECT_EQ(races()[0].earlier.direction, Direction::read);
}

TEST_F(RaceDetectorTest, AnInterruptOrdersWhoTakesIt) {
  constexpr int kSource = 53, kWord = 1;
  channel(kA, Direction::write);
  dma(Direction::write, kData);
  detector_.acts(Initiator::mdma1_0);
  detector_.line_raised(kA, kSource);
  detector_.line_raised(kB, kSource);
  detector_.acts(Initiator::core_a);
  detector_.lines_seen(kA, kWord, 1U << (kSource - 32));
  read(kA, kData);
  EXPECT_THAT(races(), IsEmpty());
  detector_.acts(Initiator::core_b);
  detector_.lines_seen(kB, kWord, ~(1U << (kSource - 32)));  // another one
  read(kB, kData);
  EXPECT_THAT(races(), SizeIs(1));
}

TEST_F(RaceDetectorTest, ADeviceThatMovesNothingOrdersNothing) {
  write(kA, kData);
  detector_.acts(std::nullopt);
  detector_.line_raised(kB, 60);
  detector_.acts(Initiator::core_b);
  detector_.lines_seen(kB, 1, ~0U);
  read(kB, kData);
  EXPECT_THAT(races(), SizeIs(1));
}

TEST_F(RaceDetectorTest, ARegisterCarriesWhatItsWriterKnew) {
  write(kA, kData);
  detector_.device_access(kA, 3, kRegister, Direction::write, 1);
  detector_.device_access(kB, 4, kRegister, Direction::read, 2);
  read(kB, kData);
  EXPECT_THAT(races(), IsEmpty());
}

TEST_F(RaceDetectorTest, EveryReaderIsHeldAgainstTheNextWriter) {
  channel(kA, Direction::write);
  read(kA, kData, 4, 31);
  read(kB, kData, 4, 32);
  dma(Direction::write, kData, 1);
  ASSERT_THAT(races(), SizeIs(2));
  EXPECT_EQ(races()[0].earlier.place, (Place{kA, 31}));
  EXPECT_EQ(races()[1].earlier.place, (Place{kB, 32}));
  channel(kB, Direction::read);
  write(kB, kData);  // readers of before are forgotten, the stream is done
  EXPECT_THAT(races(), SizeIs(2));
}

TEST_F(RaceDetectorTest, WhatCameBeforeTheOtherCoreStarted) {
  write(kA, kData);
  detector_.device_access(kA, 3, 0xFFC00104, Direction::write, 1);
  detector_.core_released(kB);
  read(kB, kData);
  EXPECT_THAT(races(), IsEmpty());
  write(kA, kData + 4);
  read(kB, kData + 4);
  EXPECT_THAT(races(), SizeIs(1));
}

TEST_F(RaceDetectorTest, TheHostActsForTheCoreThatAsked) {
  detector_.device_access(kA, 3, 0xFFC0F00C, Direction::write, 1);
  detector_.host_access(kData, 16, Direction::write);
  read(kA, kData);
  EXPECT_THAT(races(), IsEmpty());
  read(kB, kData + 8);
  ASSERT_THAT(races(), SizeIs(1));
  EXPECT_EQ(races()[0].earlier, (RaceSide{Initiator::core_a, Direction::write, {kA, 3}}));
}

}  // namespace
}  // namespace finback::races
