// Peripherals at their channels: capture, transmission, what is lost and when, who comes first.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kCapture = kEnable | kWriteMemory;

class PeripheralPortTest : public DmaTest {
 protected:
  // Enables a peripheral channel of DMA1 at time 0 and lets its start-up pass.
  void start(std::uint32_t channel, std::uint32_t config) {
    dma1_->write(channel + kConfig, 2, config, 0);
    dma1_->advance(8 * kSclk);
  }
  // Pushes `bytes` in chunks, one every `period` cycles; returns how many were taken.
  std::size_t push_all(std::uint32_t peripheral, const std::vector<std::uint8_t>& bytes,
                       std::size_t chunk, Cycles begin, Cycles period) {
    std::size_t taken = 0;
    Cycles now = begin;
    for (std::size_t i = 0; i < bytes.size(); i += chunk, now += period) {
      dma1_->advance(now);
      const std::span<const std::uint8_t> all(bytes);
      const auto part = all.subspan(i, std::min(chunk, bytes.size() - i));
      taken += dma1_->port(peripheral).push(part, now) ? part.size() : 0;
    }
    return taken;
  }
};

TEST_F(PeripheralPortTest, AFrameIsCapturedByRowsWithAnInterruptEach) {
  // 4 rows of 32 bytes into a picture 100 bytes wide; a chunk of 16 bytes every 500 cycles.
  const auto frame = pattern(128);
  program(*dma1_, kPpi0, kL3, 8, 4);
  program_rows(*dma1_, kPpi0, 4, 100 - 28);
  start(kPpi0, kCapture | kBits32 | kTwoDimensional | kInterruptEnable | kInterruptPerRow);
  std::vector<Cycles> rows;
  Cycles now = 1000;
  for (std::size_t i = 0; i < 8; ++i, now += 500) {
    dma1_->advance(now);
    ASSERT_TRUE(dma1_->port(0).push(std::span(frame).subspan(16 * i, 16), now));
    dma1_->advance(now + 499);
    if (!lines_.empty() && lines_.back().level) {
      rows.push_back(lines_.back().at);
      EXPECT_EQ(bytes_at(kL3 + 100 * static_cast<Address>(rows.size() - 1), 32),
                std::vector<std::uint8_t>(frame.begin() + 32 * (rows.size() - 1),
                                          frame.begin() + 32 * rows.size()));
      dma1_->write(kPpi0 + kIrqStatus, 2, kDone, lines_.back().at + 1);
    }
  }
  // A further burst of four words into the open row: 4 SCLK.
  EXPECT_THAT(rows, testing::ElementsAre(1500 + 4 * kSclk, 2500 + 4 * kSclk, 3500 + 4 * kSclk,
                                         4500 + 4 * kSclk));
  EXPECT_EQ(lines_[0].source, 11);
  EXPECT_EQ(status(*dma1_, kPpi0), 0U);
  EXPECT_FALSE(dma1_->port(0).running());
  EXPECT_EQ(
      memory_->level_traffic(memory::Level::l3, memory::Initiator::ppi0, memory::Direction::write)
          .bytes,
      128U);
}

TEST_F(PeripheralPortTest, WhatFindsNoRoomIsLostWholeAndNothingElseIs) {
  parameters_.peripheral_fifo_bytes.set(64);
  build();
  const auto bytes = pattern(96);
  for (const std::size_t chunk : {0U, 1U}) {  // not enabled: the FIFO fills
    EXPECT_TRUE(dma1_->port(1).push(std::span(bytes).subspan(32 * chunk, 32), 0));
  }
  EXPECT_FALSE(dma1_->port(1).push(std::span(bytes).subspan(64, 32), 0));
  EXPECT_FALSE(dma1_->port(1).push(std::span(bytes).subspan(64, 1), 0));
  program(*dma1_, kPpi1, kL1A, 24, 4);
  start(kPpi1, kCapture | kBits32);
  finish(*dma1_);
  EXPECT_TRUE(dma1_->port(1).push(std::span(bytes).subspan(64, 32), 2000));
  finish(*dma1_);
  EXPECT_EQ(bytes_at(kL1A, 96), bytes);
  EXPECT_EQ(status(*dma1_, kPpi1), kDone);
}

TEST_F(PeripheralPortTest, RestartBeginsWithAnEmptyFifo) {
  const auto bytes = pattern(32);
  EXPECT_TRUE(dma1_->port(0).push(std::span(bytes).first(16), 0));
  program(*dma1_, kPpi0, kL1A, 4, 4);
  start(kPpi0, kCapture | kBits32 | kRestart);
  EXPECT_TRUE(dma1_->port(0).push(std::span(bytes).subspan(16, 16), 100));
  finish(*dma1_);
  EXPECT_EQ(bytes_at(kL1A, 16), std::vector<std::uint8_t>(bytes.begin() + 16, bytes.end()));
}

TEST_F(PeripheralPortTest, AnOverrunComesWhenTheBusIsTakenForLonger) {
  // 32 bytes every 160 cycles need the bus for 12 SCLK of 32: fine alone, and fine beside memory
  // DMA, which a peripheral's burst passes between two of its own.
  const auto bytes = pattern(6400);
  for (const bool beside : {false, true}) {
    build();
    program(*dma1_, kPpi0, kL3 + 0x100000, 1600, 4);
    start(kPpi0, kCapture | kBits32);
    if (beside) {
      for (const std::uint32_t stream : {0U, 1U}) {
        program(*dma1_, 0x80 * stream + kS0, kL3, 30000, 4);
        program(*dma1_, 0x80 * stream + kD0, kL3 + 0x800000, 30000, 4);
        enable(*dma1_, stream, kBits32, 40);
      }
    }
    EXPECT_EQ(push_all(0, bytes, 32, 1000, 160), bytes.size()) << beside;
    EXPECT_EQ(bytes_at(kL3 + 0x100000, 6300),
              std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 6300));
  }
  // Bursts of 64 words under way keep it waiting for longer than its FIFO lasts.
  parameters_.burst_elements.set(64);
  build();
  program(*dma1_, kPpi0, kL3 + 0x100000, 1600, 4);
  start(kPpi0, kCapture | kBits32);
  program(*dma1_, kS0, kL3, 30000, 4);
  program(*dma1_, kD0, kL3 + 0x800000, 30000, 4);
  enable(*dma1_, 0, kBits32, 40);
  EXPECT_LT(push_all(0, bytes, 32, 1000, 160), bytes.size());
}

TEST_F(PeripheralPortTest, TheLowerChannelGoesFirstUnlessTheOtherIsUrgent) {
  for (const bool urgent : {false, true}) {
    build();
    program(*dma1_, kPpi0, kL1A, 64, 4);
    program(*dma1_, kPpi1, kL1A + 0x1000, 64, 4);
    program(*dma1_, kS0, kL1A2, 16, 4);
    program(*dma1_, kD0, kL3, 16, 4);
    dma1_->write(kPpi0 + kConfig, 2, kCapture | kBits32, 0);
    dma1_->write(kPpi1 + kConfig, 2, kCapture | kBits32, 0);
    enable(*dma1_, 0, kBits32, 100);
    dma1_->advance(150);  // the stream reads L1 until 140 + 18 * 5 = 230
    const auto bytes = pattern(32);
    EXPECT_TRUE(dma1_->port(1).push(bytes, 160));
    if (urgent) {  // no room for another 32 bytes
      EXPECT_TRUE(dma1_->port(1).push(bytes, 161));
    }
    EXPECT_TRUE(dma1_->port(0).push(bytes, 170));
    dma1_->advance(230);
    const Address at0 = dma1_->read(kPpi0 + kCurrentAddress, 4, 230);
    const Address at1 = dma1_->read(kPpi1 + kCurrentAddress, 4, 230);
    EXPECT_EQ(at0, urgent ? kL1A : kL1A + 32);
    EXPECT_EQ(at1, urgent ? kL1A + 0x1000 + 64 : kL1A + 0x1000);
  }
}

TEST_F(PeripheralPortTest, TransmissionReadsAheadAndRunsUntilItsFifoIsEmpty) {
  const auto bytes = pattern(100);
  memory_->store_bytes(kL3, bytes);
  std::vector<Cycles> refills;
  dma1_->port(2).set_refilled([&](Cycles now) { refills.push_back(now); });
  constexpr std::uint32_t kChannel2 = kPpi0 + 2 * kChannelBytes;
  program(*dma1_, kChannel2, kL3, 50, 2);
  start(kChannel2, kEnable | kBits16 | kInterruptEnable);
  finish(*dma1_);
  // Two bursts of 16 elements fill the 64 bytes of the FIFO.
  EXPECT_EQ(refills.size(), 2U);
  std::vector<std::uint8_t> sent;
  Cycles now = 1000;
  for (; sent.size() < 100; now += 200) {
    dma1_->advance(now);
    std::array<std::uint8_t, 4> part{};
    ASSERT_TRUE(dma1_->port(2).pull(part, now));
    sent.insert(sent.end(), part.begin(), part.end());
    dma1_->advance(now + 199);
    // DONE comes with the last word read; RUN stays for what is in the FIFO.
    EXPECT_EQ((status(*dma1_, kChannel2) & kRun) != 0, sent.size() < 100);
  }
  EXPECT_EQ(sent, bytes);
  EXPECT_EQ(status(*dma1_, kChannel2), kDone);
  EXPECT_EQ(lines_, (std::vector<LineChange>{{13, true, lines_.at(0).at}}));
  EXPECT_LT(lines_[0].at, now - 400);
  std::array<std::uint8_t, 1> more{};
  EXPECT_FALSE(dma1_->port(2).pull(more, now));
}

TEST_F(PeripheralPortTest, PeripheralMapMovesAPeripheralToAnotherChannel) {
  dma1_->write(kPpi0 + kPeripheralMap, 2, 0x1000, 0);
  dma1_->write(kPpi1 + kPeripheralMap, 2, 0x0000, 0);
  program(*dma1_, kPpi1, kL1A, 4, 4);
  start(kPpi1, kCapture | kBits32);
  const auto bytes = pattern(16);
  EXPECT_TRUE(dma1_->port(0).running());
  EXPECT_TRUE(dma1_->port(0).push(bytes, 100));
  finish(*dma1_);
  EXPECT_EQ(bytes_at(kL1A, 16), bytes);

  dma1_->write(kPpi0 + kPeripheralMap, 2, 0x3000, 0);
  program(*dma1_, kPpi0, kL1A, 4, 4);
  start(kPpi0, kCapture | kBits32);
  EXPECT_THAT([&] { start(kPpi0 + 3 * kChannelBytes, kCapture); },
              ThrowsMessage<GuestFault>(
                  HasSubstr("DMA1_3_PERIPHERAL_MAP = 0x3000: DMA1_0 runs for that peripheral")));
}

TEST_F(PeripheralPortTest, APeripheralAndItsChannelMustAgreeOnTheDirection) {
  program(*dma1_, kPpi0, kL1A, 4, 4);
  start(kPpi0, kEnable | kBits32);
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_THAT([&] { dma1_->port(0).push(bytes, 100); },
              ThrowsMessage<GuestFault>(HasSubstr(
                  "DMA1_0_CONFIG = 0x9: WNR = 0, but its peripheral receives: it needs 1")));
  program(*dma1_, kPpi1, kL1A, 4, 4);
  start(kPpi1, kCapture | kBits32);
  EXPECT_THAT([&] { dma1_->port(1).pull(bytes, 100); },
              ThrowsMessage<GuestFault>(HasSubstr("WNR = 1, but its peripheral transmits")));
}

TEST_F(PeripheralPortTest, EveryChannelOfBothControllersHasItsSource) {
  const auto bytes = pattern(4);
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (DmaController* dma : {dma1_.get(), dma2_.get()}) {
      lines_.clear();
      program(*dma, kPpi0 + kChannelBytes * i, kL2 + 4 * i, 4, 1);
      dma->write(kPpi0 + kChannelBytes * i + kConfig, 2, kCapture | kInterruptEnable, 0);
      EXPECT_TRUE(dma->port(i).push(bytes, 10));
      finish(*dma);
      ASSERT_EQ(lines_.size(), 1U);
      EXPECT_EQ(lines_[0].source, static_cast<int>((dma == dma1_.get() ? 11 : 23) + i));
      EXPECT_EQ(bytes_at(kL2 + 4 * i, 4), bytes);
    }
  }
}

}  // namespace
}  // namespace finback::dma
