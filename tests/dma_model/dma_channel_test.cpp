// Registers, and what they refuse.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using DmaChannelTest = DmaTest;

TEST_F(DmaChannelTest, RegistersReadBackWhatWasWritten) {
  for (const std::uint32_t channel : {kD0, kS0, kD1, kS1}) {
    for (const std::uint32_t wide : {kNextDescriptorPointer, kStartAddress}) {
      dma1_->write(channel + wide, 4, 0xFF800000 + channel + wide, 0);
      EXPECT_EQ(dma1_->read(channel + wide, 4, 0), 0xFF800000 + channel + wide);
    }
    for (const std::uint32_t narrow : {kXCount, kXModify, kYCount, kYModify}) {
      dma1_->write(channel + narrow, 2, 0x8000 + channel + narrow, 0);
      EXPECT_EQ(dma1_->read(channel + narrow, 2, 0), 0x8000 + channel + narrow);
      EXPECT_EQ(dma1_->read(channel + narrow, 4, 0), 0x8000 + channel + narrow);
    }
    dma1_->write(channel + kConfig, 2, 0x10C8, 0);
    EXPECT_EQ(dma1_->read(channel + kConfig, 2, 0), 0x10C8U);
    EXPECT_EQ(dma1_->read(channel + kPeripheralMap, 2, 0), 0x40U);
  }
  EXPECT_EQ(dma2_->read(kD0 + kStartAddress, 4, 0), 0U);
}

TEST_F(DmaChannelTest, WideRegistersTakeHalves) {
  dma1_->write(kStartAddress, 2, 0x5678, 0);
  dma1_->write(kStartAddress + 2, 2, 0x1234, 0);
  EXPECT_EQ(dma1_->read(kStartAddress, 4, 0), 0x12345678U);
  EXPECT_EQ(dma1_->read(kStartAddress + 2, 2, 0), 0x1234U);
  EXPECT_EQ(dma1_->read(kStartAddress, 2, 0), 0x5678U);
}

TEST_F(DmaChannelTest, ReadOnlyRegistersAreFaults) {
  EXPECT_THAT([&] { dma1_->write(kS0 + kCurrentXCount, 2, 1, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("MDMA1_S0_CURR_X_COUNT = 0x1: it is read-only")));
}

struct Refusal {
  const char* name;
  std::uint32_t source_config, destination_config;
  Address source, destination;
  std::uint32_t source_count, destination_count;
  std::int32_t modify;
  const char* message;
};

class DmaRefusal : public DmaTest, public testing::WithParamInterface<Refusal> {};

TEST_P(DmaRefusal, IsOneLineThatNamesTheRegister) {
  const Refusal& refusal = GetParam();
  program(*dma1_, kS1, refusal.source, refusal.source_count, refusal.modify);
  program(*dma1_, kD1, refusal.destination, refusal.destination_count, refusal.modify);
  EXPECT_THAT(
      [&] {
        dma1_->write(kS1 + kConfig, 2, refusal.source_config | kEnable, 0);
        dma1_->write(kD1 + kConfig, 2, refusal.destination_config | kEnable, 0);
        finish(*dma1_);
      },
      ThrowsMessage<GuestFault>(HasSubstr(refusal.message)));
}

constexpr std::uint32_t kTo = kBits32 | kWriteMemory;
INSTANTIATE_TEST_SUITE_P(
    All, DmaRefusal,
    testing::Values(
        Refusal{"widths", kBits32, kBits16 | kWriteMemory, kL3, kL1A, 4, 4, 4,
                "WDSIZE of MDMA1_S1_CONFIG (32 bits) and MDMA1_D1_CONFIG (16 bits) differ"},
        Refusal{"counts", kBits32, kTo, kL3, kL1A, 4, 5, 4,
                "MDMA1_S1 moves 4 x 1 elements, MDMA1_D1 5 x 1"},
        Refusal{"reserved", 3U << 2, kTo, kL3, kL1A, 4, 4, 4, "MDMA1_S1_CONFIG = 0xd: WDSIZE 3"},
        Refusal{"direction", kBits32, kBits32, kL3, kL1A, 4, 4, 4,
                "MDMA1_D1_CONFIG = 0x9: a destination channel needs WNR = 1"},
        Refusal{"descriptors", kBits32 | 7U << 12, kTo, kL3, kL1A, 4, 4, 4,
                "FLOW 7 (descriptors) is not modelled"},
        Refusal{"misaligned", kBits32, kTo, kL3 + 2, kL1A, 4, 4, 4,
                "MDMA1_S1_START_ADDR = 0x10002: must be a multiple of the element size, 4 bytes"},
        Refusal{"modify", kBits32, kTo, kL3, kL1A, 4, 4, 2, "MDMA1_S1_X_MODIFY = 0x2: must be"},
        Refusal{"nowhere", kBits32, kTo, 0x80000000, kL1A, 4, 4, 4,
                "MDMA1_S1_CURR_ADDR = 0x80000000: no memory is mapped there"},
        Refusal{"scratchpad", kBits32, kTo, kL3, 0xFFB00000, 4, 4, 4,
                "MDMA1_D1_CURR_ADDR = 0xffb00000: DMA does not reach l1.scratch"},
        Refusal{"end", kBits32, kTo, kL3, kL1A + 0x7FF0, 5, 5, 4,
                "the transfer leaves l1.data.a, which ends at 0xff807fff"}),
    [](const testing::TestParamInfo<Refusal>& refusal) { return refusal.param.name; });

TEST(InternalMemoryDma, KeepsRegistersAndRefusesToRun) {
  InternalMemoryDma fast(600);
  fast.write(kS1 + kXCount, 2, 77, 0);
  EXPECT_EQ(fast.read(kS1 + kXCount, 2, 0), 77U);
  EXPECT_THAT([&] { fast.write(kD0 + kConfig, 2, kEnable, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("anomaly 05000182")));
  InternalMemoryDma slow(500);
  EXPECT_THAT([&] { slow.write(kD0 + kConfig, 2, kEnable, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("not modelled")));
}

}  // namespace
}  // namespace finback::dma
