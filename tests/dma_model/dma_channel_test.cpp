// Registers, and what they refuse.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using DmaChannelTest = DmaTest;

TEST_F(DmaChannelTest, RegistersReadBackWhatWasWritten) {
  for (std::uint32_t channel = kPpi0; channel <= kS1; channel += kChannelBytes) {
    for (const std::uint32_t wide :
         {kNextDescriptorPointer, kStartAddress, kCurrentDescriptorPointer, kCurrentAddress}) {
      dma1_->write(channel + wide, 4, 0xFF800000 + channel + wide, 0);
      EXPECT_EQ(dma1_->read(channel + wide, 4, 0), 0xFF800000 + channel + wide);
    }
    for (const std::uint32_t narrow :
         {kXCount, kXModify, kYCount, kYModify, kCurrentXCount, kCurrentYCount}) {
      dma1_->write(channel + narrow, 2, 0x8000 + channel + narrow, 0);
      EXPECT_EQ(dma1_->read(channel + narrow, 2, 0), 0x8000 + channel + narrow);
      EXPECT_EQ(dma1_->read(channel + narrow, 4, 0), 0x8000 + channel + narrow);
    }
    dma1_->write(channel + kConfig, 2, 0x10C8, 0);
    EXPECT_EQ(dma1_->read(channel + kConfig, 2, 0), 0x10C8U);
    EXPECT_EQ(dma1_->read(channel + kIrqStatus, 2, 0), 0U);
  }
  EXPECT_EQ(dma2_->read(kD0 + kStartAddress, 4, 0), 0U);
  EXPECT_TRUE(lines_.empty());
}

TEST_F(DmaChannelTest, NamesAreThoseOfTheChip) {
  EXPECT_EQ(dma1_->register_name(kPpi0 + kConfig), "DMA1_0_CONFIG");
  EXPECT_EQ(dma2_->register_name(kD0 - 0x40 + kStartAddress), "DMA2_11_START_ADDR");
  EXPECT_EQ(dma2_->register_name(kS1 + kCurrentAddress), "MDMA2_S1_CURR_ADDR");
  EXPECT_EQ(dma1_->register_name(DmaController::kTrafficPeriods), "DMA1_TC_PER");
  EXPECT_EQ(dma1_->register_name(kPpi0 + 0x3C), "");
}

TEST_F(DmaChannelTest, PeripheralMapBeginsWithTheChannelsNumber) {
  for (std::uint32_t i = 0; i < 12; ++i) {
    EXPECT_EQ(dma1_->read(kPpi0 + kChannelBytes * i + kPeripheralMap, 2, 0), i << 12U);
  }
  EXPECT_EQ(dma1_->read(kD0 + kPeripheralMap, 2, 0), 0x40U);
  dma1_->write(kPpi0 + kPeripheralMap, 2, 0x1040, 0);
  EXPECT_EQ(dma1_->read(kPpi0 + kPeripheralMap, 2, 0), 0x1000U);
  EXPECT_THAT([&] { dma1_->write(kPpi0 + kPeripheralMap, 2, 0xC000, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("DMA1_0_PERIPHERAL_MAP = 0xc000: PMAP must be "
                                                  "below 12")));
}

TEST_F(DmaChannelTest, WideRegistersTakeHalves) {
  dma1_->write(kD0 + kStartAddress, 2, 0x5678, 0);
  dma1_->write(kD0 + kStartAddress + 2, 2, 0x1234, 0);
  EXPECT_EQ(dma1_->read(kD0 + kStartAddress, 4, 0), 0x12345678U);
  EXPECT_EQ(dma1_->read(kD0 + kStartAddress + 2, 2, 0), 0x1234U);
  EXPECT_EQ(dma1_->read(kD0 + kStartAddress, 2, 0), 0x5678U);
}

TEST_F(DmaChannelTest, TrafficCountsAreReadOnly) {
  EXPECT_THAT([&] { dma1_->write(DmaController::kTrafficCounts, 2, 1, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("DMA1_TC_CNT = 0x1: it is read-only")));
}

TEST_F(DmaChannelTest, ARunningChannelTakesConfigAndStatusOnly) {
  for (const std::uint32_t reg : {kNextDescriptorPointer, kStartAddress, kXCount, kXModify, kYCount,
                                  kYModify, kCurrentDescriptorPointer, kCurrentAddress,
                                  kCurrentXCount, kCurrentYCount, kPeripheralMap, kConfig}) {
    build();
    program(*dma1_, kS0, kL3, 64, 4);
    program(*dma1_, kD0, kL1A, 64, 4);
    enable(*dma1_, 0, kBits32, 0);
    const std::string name = dma1_->register_name(kS0 + reg);
    EXPECT_THAT([&] { dma1_->write(kS0 + reg, 2, 1, 10); },
                ThrowsMessage<GuestFault>(HasSubstr(name + " = ")));
    build();
    program(*dma1_, kS0, kL3, 64, 4);
    program(*dma1_, kD0, kL1A, 64, 4);
    enable(*dma1_, 0, kBits32, 0);
    dma1_->write(kS0 + kIrqStatus, 2, kDone, 10);
    dma1_->write(kS0 + kConfig, 2, 0, 10);
    EXPECT_EQ(status(*dma1_, kS0), 0U);
    dma1_->write(kS0 + reg, 2, 0, 10);
  }
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

constexpr std::uint32_t kToMemory = kBits32 | kWriteMemory;
INSTANTIATE_TEST_SUITE_P(
    All, DmaRefusal,
    testing::Values(
        Refusal{"widths", kBits32, kBits16 | kWriteMemory, kL3, kL1A, 4, 4, 4,
                "WDSIZE of MDMA1_S1_CONFIG (32 bits) and MDMA1_D1_CONFIG (16 bits) differ"},
        Refusal{"counts", kBits32, kToMemory, kL3, kL1A, 4, 5, 4,
                "MDMA1_S1 moves 4 x 1 elements, MDMA1_D1 5 x 1"},
        Refusal{"reserved", 3U << 2, kToMemory, kL3, kL1A, 4, 4, 4,
                "MDMA1_S1_CONFIG = 0xd: WDSIZE 3"},
        Refusal{"direction", kBits32, kBits32, kL3, kL1A, 4, 4, 4,
                "MDMA1_D1_CONFIG = 0x9: a destination channel needs WNR = 1"},
        Refusal{"flow_2", kBits32 | 2U << 12, kToMemory, kL3, kL1A, 4, 4, 4, "FLOW 2 is reserved"},
        Refusal{"flow_5", kBits32 | 5U << 12, kToMemory, kL3, kL1A, 4, 4, 4, "FLOW 5 is reserved"},
        Refusal{"bit_15", kBits32 | 1U << 15, kToMemory, kL3, kL1A, 4, 4, 4, "and 0 for bit 15"},
        Refusal{"stop_with_size", kBits32 | 3U << 8, kToMemory, kL3, kL1A, 4, 4, 4,
                "NDSIZE 3 with FLOW 0, which has no descriptors; it must be 0"},
        Refusal{"array_without_size", kBits32 | 4U << 12, kToMemory, kL3, kL1A, 4, 4, 4,
                "NDSIZE 0 does not fit FLOW 4; use 1 to 7"},
        Refusal{"array_too_long", kBits32 | 4U << 12 | 8U << 8, kToMemory, kL3, kL1A, 4, 4, 4,
                "NDSIZE 8 does not fit FLOW 4; use 1 to 7"},
        Refusal{"small_too_long", kBits32 | 6U << 12 | 9U << 8, kToMemory, kL3, kL1A, 4, 4, 4,
                "NDSIZE 9 does not fit FLOW 6; use 1 to 8"},
        Refusal{"large_too_long", kBits32 | 7U << 12 | 10U << 8, kToMemory, kL3, kL1A, 4, 4, 4,
                "NDSIZE 10 does not fit FLOW 7; use 1 to 9"},
        Refusal{"misaligned", kBits32, kToMemory, kL3 + 2, kL1A, 4, 4, 4,
                "MDMA1_S1_START_ADDR = 0x10002: must be a multiple of the element size, 4 bytes"},
        Refusal{"modify", kBits32, kToMemory, kL3, kL1A, 4, 4, 2,
                "MDMA1_S1_X_MODIFY = 0x2: must be"},
        Refusal{"nowhere", kBits32, kToMemory, 0x80000000, kL1A, 4, 4, 4,
                "MDMA1_S1_CURR_ADDR = 0x80000000: no memory is mapped there"},
        Refusal{"scratchpad", kBits32, kToMemory, kL3, 0xFFB00000, 4, 4, 4,
                "MDMA1_D1_CURR_ADDR = 0xffb00000: DMA does not reach l1.scratch"},
        Refusal{"end", kBits32, kToMemory, kL3, kL1A + 0x7FF0, 5, 5, 4,
                "the transfer leaves l1.data.a, which ends at 0xff807fff"}),
    [](const testing::TestParamInfo<Refusal>& refusal) { return refusal.param.name; });

}  // namespace
}  // namespace finback::dma
