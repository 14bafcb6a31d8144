// Descriptors: what each flow loads, when, and from where; chains; what they refuse.
#include "dma_fixture.hpp"
#include "dma_reference.hpp"

namespace finback::dma {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kArray = 4U << 12, kSmall = 6U << 12, kLarge = 7U << 12;

constexpr std::uint32_t words_of(std::uint32_t n) { return n << 8; }

class DescriptorTest : public DmaTest {
 protected:
  void store_halves(Address address, const std::vector<std::uint32_t>& halves) {
    for (const std::uint32_t half : halves) {
      const std::array<std::uint8_t, 2> bytes = {static_cast<std::uint8_t>(half),
                                                 static_cast<std::uint8_t>(half >> 8)};
      memory_->store_bytes(address, bytes);
      address += 2;
    }
  }
  // A source of bytes in a row that lasts as long as the destination wants, from kL3.
  void source_by_autobuffer(std::uint32_t elements) {
    program(*dma1_, kS0, kL3, elements, 1);
    dma1_->write(kS0 + kConfig, 2, kEnable | kAutobuffer, 0);
  }
  std::uint32_t reg(std::uint32_t offset) { return dma1_->read(kD0 + offset, 4, 0); }
};

struct Layout {
  std::uint32_t flow, most;
};

class DescriptorLayout : public DescriptorTest,
                         public testing::WithParamInterface<std::tuple<Layout, std::uint32_t>> {};

// Every flow with every NDSIZE: exactly the first NDSIZE words of its layout go into the registers.
TEST_P(DescriptorLayout, LoadsWhatItsSizeSays) {
  const auto& [layout, size] = GetParam();
  if (size > layout.most) {
    return;  // refused: DmaRefusal
  }
  DmaChannel channel("X", ChannelKind::peripheral);
  ReferenceRegisters before{
      .next_descriptor = 0xFEB01234,
      .current_descriptor = 0xFEB05678,
      .start = 0xFF801000,
      .config = static_cast<std::uint16_t>(kEnable | kWriteMemory | layout.flow | words_of(size)),
      .x_count = 0x11,
      .y_count = 0x22,
      .x_modify = 0x33,
      .y_modify = -0x44};
  channel.write(kNextDescriptorPointer, 4, before.next_descriptor);
  channel.write(kCurrentDescriptorPointer, 4, before.current_descriptor);
  channel.write(kStartAddress, 4, before.start);
  channel.write(kXCount, 2, before.x_count);
  channel.write(kYCount, 2, before.y_count);
  channel.write(kXModify, 2, static_cast<std::uint16_t>(before.x_modify));
  channel.write(kYModify, 2, static_cast<std::uint16_t>(before.y_modify));
  channel.write(kConfig, 2, before.config);
  channel.start();
  EXPECT_TRUE(channel.wants_descriptor());
  EXPECT_EQ(channel.read(kIrqStatus, 2), kRun | kDescriptorFetch);
  EXPECT_EQ(channel.descriptor().count, size);
  EXPECT_EQ(channel.descriptor().address,
            layout.flow == kArray ? before.current_descriptor : before.next_descriptor);

  std::vector<std::uint16_t> words;
  for (std::uint32_t i = 0; i < size; ++i) {
    words.push_back(static_cast<std::uint16_t>(0xA000 + 0x111 * i));
  }
  const std::uint32_t config_at = layout.flow == kArray ? 2 : layout.flow == kSmall ? 3 : 4;
  if (config_at < size) {
    words[config_at] = kEnable | kWriteMemory;
  }
  const Address first = channel.descriptor().address;
  const ReferenceChannel after(before, [&](Address at) { return words.at((at - first) / 2); });
  channel.load_descriptor(words);

  const ReferenceRegisters& r = after.registers();
  EXPECT_EQ(channel.read(kNextDescriptorPointer, 4), r.next_descriptor);
  EXPECT_EQ(channel.read(kCurrentDescriptorPointer, 4), first + 2 * size);
  EXPECT_EQ(channel.read(kStartAddress, 4), r.start);
  EXPECT_EQ(channel.read(kConfig, 2), r.config);
  EXPECT_EQ(channel.read(kXCount, 2), r.x_count);
  EXPECT_EQ(channel.read(kXModify, 2), static_cast<std::uint16_t>(r.x_modify));
  EXPECT_EQ(channel.read(kYCount, 2), r.y_count);
  EXPECT_EQ(channel.read(kYModify, 2), static_cast<std::uint16_t>(r.y_modify));
  EXPECT_EQ(channel.read(kCurrentAddress, 4), r.start);
  EXPECT_EQ(channel.read(kIrqStatus, 2), kRun);
}

INSTANTIATE_TEST_SUITE_P(All, DescriptorLayout,
                         testing::Combine(testing::Values(Layout{kArray, 7}, Layout{kSmall, 8},
                                                          Layout{kLarge, 9}),
                                          testing::Range(1U, 10U)));

// Start-up 8; a fetch from L2 takes 2 and a word each, and the descriptor's own.
Cycles fetch_sclk(std::uint32_t words, Cycles overhead) { return 2 + words + overhead; }

TEST_F(DescriptorTest, AFetchTakesTheBusForItsWordsAndReadsMemoryWhenItEnds) {
  for (const int overhead : {0, 1, 7}) {
    parameters_.descriptor_overhead_sclk.set(overhead);
    build();
    memory_->store_bytes(kL3, pattern(100));
    store_halves(kL2, {0, 0, kEnable | kWriteMemory, 16, 1});
    source_by_autobuffer(16);
    dma1_->write(kD0 + kCurrentDescriptorPointer, 4, kL2, 0);
    dma1_->write(kD0 + kConfig, 2, kEnable | kWriteMemory | kArray | words_of(5), 100);
    const Cycles loaded = 100 + (8 + fetch_sclk(5, static_cast<Cycles>(overhead))) * kSclk;
    dma1_->advance(loaded - 1);
    EXPECT_EQ(status(*dma1_, kD0), kRun | kDescriptorFetch);
    EXPECT_EQ(reg(kXCount), 0U);
    store_halves(kL2, {kL1A & 0xFFFF, kL1A >> 16});  // in time
    dma1_->advance(loaded);
    EXPECT_EQ(status(*dma1_, kD0), kRun);
    EXPECT_EQ(reg(kXCount), 16U);
    EXPECT_EQ(reg(kCurrentDescriptorPointer), kL2 + 10);
    dma1_->advance(loaded + 1000);
    EXPECT_EQ(bytes_at(kL1A, 16), pattern(16));
    EXPECT_EQ(status(*dma1_, kD0), kDone);
    EXPECT_EQ(
        memory_
            ->level_traffic(memory::Level::l2, memory::Initiator::mdma1_0, memory::Direction::read)
            .bytes,
        10U);
  }
}

TEST_F(DescriptorTest, AnArrayGoesOnBehindItselfAndStopsWhereFlowIsZero) {
  memory_->store_bytes(kL3, pattern(48));
  const std::uint32_t config = kEnable | kWriteMemory | kArray | words_of(3);
  store_halves(kL2, {0x0000, 0xFF80, config | kInterruptEnable});
  store_halves(kL2 + 6, {0x0100, 0xFF80, config});
  store_halves(kL2 + 12, {0x0200, 0xFF80, kEnable | kWriteMemory | kInterruptEnable});
  source_by_autobuffer(48);
  program(*dma1_, kD0, 0, 16, 1);
  dma1_->write(kD0 + kCurrentDescriptorPointer, 4, kL2, 0);
  dma1_->write(kD0 + kNextDescriptorPointer, 4, 0x12345678, 0);
  dma1_->write(kD0 + kConfig, 2, config, 0);
  int interrupts = 0;
  while (dma1_->next_event_time() != kNever && (status(*dma1_, kD0) & kRun) != 0) {
    dma1_->advance(dma1_->next_event_time());
    if (!lines_.empty() && lines_.back().level) {
      ++interrupts;
      dma1_->write(kD0 + kIrqStatus, 2, kDone, lines_.back().at);
    }
  }
  const auto bytes = pattern(48);
  for (const std::ptrdiff_t i : {0, 1, 2}) {
    EXPECT_EQ(bytes_at(kL1A + 0x100 * static_cast<Address>(i), 16),
              std::vector<std::uint8_t>(bytes.begin() + 16 * i, bytes.begin() + 16 * (i + 1)));
  }
  EXPECT_EQ(interrupts, 2);
  EXPECT_EQ(reg(kCurrentDescriptorPointer), kL2 + 18);
  EXPECT_EQ(reg(kNextDescriptorPointer), 0x12345678U);
  EXPECT_EQ(status(*dma1_, kD0), 0U);
}

TEST_F(DescriptorTest, ARingOfTwoGoesRoundUntilDmaenIsCleared) {
  memory_->store_bytes(kL3, pattern(32));
  const std::uint32_t config = kEnable | kWriteMemory | kLarge | words_of(5) | kInterruptEnable;
  const Address second = kL2 + 0x10000;
  store_halves(kL2, {second & 0xFFFF, second >> 16, 0x0000, 0xFF80, config});
  store_halves(second, {kL2 & 0xFFFF, kL2 >> 16, 0x0100, 0xFF80, config});
  source_by_autobuffer(32);
  program(*dma1_, kD0, 0, 16, 1);
  dma1_->write(kD0 + kNextDescriptorPointer, 4, kL2, 0);
  dma1_->write(kD0 + kConfig, 2, config, 0);
  std::vector<Address> ends;
  while (dma1_->next_event_time() != kNever) {
    dma1_->advance(dma1_->next_event_time());
    if (!lines_.empty() && lines_.back().level) {
      ends.push_back(reg(kCurrentDescriptorPointer));
      dma1_->write(kD0 + kIrqStatus, 2, kDone, lines_.back().at);
    }
    if (ends.size() == 5) {  // the sixth fetch is under way and finds this
      store_halves(second + 8, {config & ~std::uint32_t{kEnable}});
    }
  }
  // When a unit ends, the next one's descriptor is the current one.
  EXPECT_THAT(ends, testing::ElementsAre(second, kL2, second, kL2, second));
  EXPECT_EQ(status(*dma1_, kD0), 0U);
  EXPECT_EQ(bytes_at(kL1A + 0x100, 16), std::vector<std::uint8_t>(bytes_at(kL3 + 16, 16)));
}

TEST_F(DescriptorTest, ADescriptorWithoutDmaenStopsTheChannel) {
  store_halves(kL2, {0x0000, 0xFF80, kWriteMemory});
  source_by_autobuffer(16);
  dma1_->write(kD0 + kCurrentDescriptorPointer, 4, kL2, 0);
  dma1_->write(kD0 + kConfig, 2, kEnable | kWriteMemory | kArray | words_of(3), 0);
  finish(*dma1_);
  EXPECT_EQ(status(*dma1_, kD0), 0U);
  EXPECT_EQ(bytes_at(kL1A, 16), std::vector<std::uint8_t>(16));
}

TEST_F(DescriptorTest, ASmallListKeepsTheUpperHalfOfItsPointer) {
  memory_->store_bytes(kL3, pattern(32));
  const std::uint32_t config = kEnable | kWriteMemory | kSmall | words_of(4);
  store_halves(kL2 + 0x20, {0x0040, 0x0000, 0xFF80, config});
  store_halves(kL2 + 0x40, {0x0060, 0x0010, 0xFF80, kEnable | kWriteMemory});
  source_by_autobuffer(32);
  program(*dma1_, kD0, 0, 16, 1);
  dma1_->write(kD0 + kNextDescriptorPointer, 4, kL2 + 0x20, 0);
  dma1_->write(kD0 + kConfig, 2, config, 0);
  finish(*dma1_);
  EXPECT_EQ(bytes_at(kL1A, 32), pattern(32));
  // FLOW 0 stops behind its unit; the pointer to what would come has been loaded.
  EXPECT_EQ(reg(kNextDescriptorPointer), kL2 + 0x60);
}

struct BadDescriptor {
  const char* name;
  Address at;
  std::vector<std::uint32_t> words;
  const char* message;
};

class DescriptorRefusal : public DescriptorTest, public testing::WithParamInterface<BadDescriptor> {
 protected:
  void run() {
    const BadDescriptor& bad = GetParam();
    dma1_->set_writer([] { return std::string("core_b in capture (0xff600010, capture.c:7)"); });
    if (bad.at < 0x80000000) {
      memory_->store_bytes(bad.at, {});
    }
    source_by_autobuffer(16);
    program(*dma1_, kD0, kL1A, 16, 1);
    dma1_->write(kD0 + kNextDescriptorPointer, 4, bad.at, 0);
    const auto size = static_cast<std::uint32_t>(bad.words.size());
    if (memory_->map().find(bad.at) != nullptr) {
      store_halves(bad.at, bad.words);
    }
    dma1_->write(kD0 + kConfig, 2, kEnable | kWriteMemory | kSmall | words_of(size), 0);
    finish(*dma1_);
  }
};

TEST_P(DescriptorRefusal, TellsWhoStartedTheChannel) {
  EXPECT_THAT([&] { run(); }, ThrowsMessage<GuestFault>(testing::AllOf(
                                  HasSubstr(GetParam().message),
                                  testing::EndsWith("; the channel was started by core_b in "
                                                    "capture (0xff600010, capture.c:7)"))));
}

TEST_P(DescriptorRefusal, IsAnErrorInterruptWhereTheChipIsAskedFor) {
  parameters_.errors_fault.set(0);
  build();
  run();
  EXPECT_EQ(status(*dma1_, kD0) & ~kDone, kError);  // a unit may have come to its end before
  ASSERT_EQ(lines_.size(), 1U);
  EXPECT_EQ(lines_[0].source, 1);
  EXPECT_TRUE(lines_[0].level);
  dma1_->write(kD0 + kIrqStatus, 2, kError, lines_[0].at + 50);
  EXPECT_EQ(lines_.back(), (LineChange{1, false, lines_[0].at + 50}));
  EXPECT_EQ(status(*dma1_, kD0) & ~kDone, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    All, DescriptorRefusal,
    testing::Values(
        BadDescriptor{"nowhere", 0x90000000, {0, 0, 0}, "CURR_DESC_PTR = 0x90000000: no memory"},
        BadDescriptor{"scratchpad",
                      0xFFB00000,
                      {0, 0, 0},
                      "CURR_DESC_PTR = 0xffb00000: DMA does not reach l1.scratch"},
        BadDescriptor{"reserved_flow",
                      kL2,
                      {0, 0, 0xFF80, kEnable | kWriteMemory | 3U << 12},
                      "MDMA1_D0_CONFIG = 0x3003: FLOW 3 is reserved"},
        BadDescriptor{"next_size",
                      kL2,
                      {0, 0, 0xFF80, kEnable | kWriteMemory | kSmall},
                      "NDSIZE 0 does not fit FLOW 6"},
        BadDescriptor{"direction", kL2, {0, 0, 0xFF80, kEnable}, "needs WNR = 1"},
        BadDescriptor{"width",
                      kL2,
                      {0, 0, 0xFF80, kEnable | kWriteMemory | kBits16, 8, 2},
                      "WDSIZE of MDMA1_S0_CONFIG (8 bits) and MDMA1_D0_CONFIG (16 bits) differ"},
        BadDescriptor{"alignment",
                      kL2,
                      {0, 1, 0xFF80, kEnable | kWriteMemory | kBits32},
                      "MDMA1_D0_START_ADDR = 0xff800001: must be a multiple"},
        BadDescriptor{"odd_successor",
                      kL2,
                      {1, 0, 0xFF80, kEnable | kWriteMemory | kSmall | 1 << 8},
                      "MDMA1_D0_NEXT_DESC_PTR = 0xfeb00001: a descriptor must lie at an even"},
        BadDescriptor{"target",
                      kL2,
                      {0, 0, 0x9000, kEnable | kWriteMemory},
                      "MDMA1_D0_CURR_ADDR = 0x90000000: no memory is mapped there"}),
    [](const testing::TestParamInfo<BadDescriptor>& bad) { return bad.param.name; });

TEST_F(DescriptorTest, BothSidesOfAStreamKeepTheirDescriptorsInOneKindOfMemory) {
  store_halves(kL2, {0x0000, 0xFF80, kEnable | kWriteMemory | kArray | words_of(3)});
  store_halves(kL3 + 0x1000, {0x0000, 0x0001, kEnable | kArray | words_of(3)});
  for (const std::uint32_t channel : {kS0, kD0}) {
    program(*dma1_, channel, 0, 16, 1);
  }
  dma1_->write(kS0 + kCurrentDescriptorPointer, 4, kL3 + 0x1000, 0);
  dma1_->write(kD0 + kCurrentDescriptorPointer, 4, kL2, 0);
  dma1_->write(kS0 + kConfig, 2, kEnable | kArray | words_of(3), 0);
  dma1_->write(kD0 + kConfig, 2, kEnable | kWriteMemory | kArray | words_of(3), 0);
  EXPECT_THAT([&] { finish(*dma1_); },
              ThrowsMessage<GuestFault>(testing::AllOf(HasSubstr("anomaly 05000301"),
                                                       HasSubstr("MDMA1_S0_CURR_DESC_PTR"))));
}

}  // namespace
}  // namespace finback::dma
