// SDRAM: rows, banks, write recovery, refresh, bursts; in system clocks of 5 core cycles.
#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

constexpr Address kBankBytes = 16U << 20;
constexpr Address kPage = 2048;

class SdramTimingTest : public MemoryTest {
 protected:
  SdramTimingTest() { parameters_.sdram_refresh_sclk.set(0); }
  std::uint64_t counter(const std::string& name) {
    CounterRegistry registry;
    memory().register_counters(registry);
    return registry.snapshot().at(name).value;
  }
};

TEST_F(SdramTimingTest, CoreReadOfAnOpenRowTakes40Cycles) {
  EXPECT_EQ(read(0, kL3, 0), (8 + 3) * kSclk - 1);  // the bank was closed: tRCD
  EXPECT_EQ(read(0, kL3 + 4, 100), 8 * kSclk - 1);
  EXPECT_EQ(read(0, kL3 + kPage - 4, 200), 8 * kSclk - 1);
}

TEST_F(SdramTimingTest, AnotherRowOfTheBankAddsPrechargeAndActivation) {
  read(0, kL3, 0);
  EXPECT_EQ(read(0, kL3 + kPage, 100), (8 + 3 + 3) * kSclk - 1);
  EXPECT_EQ(read(0, kL3, 200), (8 + 3 + 3) * kSclk - 1);
  EXPECT_EQ(counter("memory.sdram.row_miss.accesses"), 3U);
  EXPECT_EQ(counter("memory.sdram.row_hit.accesses"), 0U);
}

TEST_F(SdramTimingTest, EachBankKeepsItsRow) {
  for (Address bank = 0; bank < 4; ++bank) {
    EXPECT_EQ(read(0, bank * kBankBytes, Cycles{100} * bank), (8 + 3) * kSclk - 1);
  }
  for (Address bank = 0; bank < 4; ++bank) {
    EXPECT_EQ(read(0, bank * kBankBytes + 8, 1000 + 100 * bank), 8 * kSclk - 1);
  }
  EXPECT_EQ(counter("memory.sdram.row_hit.accesses"), 4U);
}

TEST_F(SdramTimingTest, ARowStaysOpenForItsLeastTime) {
  parameters_.sdram_tras_sclk.set(20);
  build();
  read(0, kL3, 0);  // opened at 0
  // Asked for at 50, closed at 100 at the earliest, then tRP + tRCD + 8.
  EXPECT_EQ(read(0, kL3 + kPage, 50), 50 + (3 + 3 + 8) * kSclk - 1);
}

TEST_F(SdramTimingTest, TheBusIsHeldForPartOfACoresRead) {
  read(0, kL3, 0);
  read(1, kL3 + 4, 1000);                                  // holds the bus for 4 SCLK
  EXPECT_EQ(read(0, kL3 + 8, 1000), (4 + 8) * kSclk - 1);  // the loser
  EXPECT_EQ(read(1, kL3 + 8, 1000 + 8 * kSclk), 8 * kSclk - 1);
}

TEST_F(SdramTimingTest, WritesCostOneSclkInTheRowAndRecoveryOutsideIt) {
  EXPECT_EQ(write(0, kL3, 0), 0U);
  EXPECT_EQ(memory().writes_drained_at(0), (3 + 1) * kSclk);
  write(0, kL3 + 4, 100);
  EXPECT_EQ(memory().writes_drained_at(0), 100 + kSclk);
  write(0, kL3 + kPage, 200);  // tWR + tRP + tRCD = 8
  EXPECT_EQ(memory().writes_drained_at(0), 200 + (8 + 1) * kSclk);
}

TEST_F(SdramTimingTest, SequentialWritesSettleAtFiveCyclesEach) {
  Cycles now = 0;
  for (Address i = 0; i < 400; ++i) {
    now += 1 + write(0, kL3 + 4 * i, now);
  }
  EXPECT_NEAR(static_cast<double>(now) / 400, 5.0, 0.1);
}

TEST_F(SdramTimingTest, RefreshTakesTheBusOnItsCycleAndClosesAllRows) {
  parameters_.sdram_refresh_sclk.set(12);
  const Cycles due = 7812 * 600 / 1000;
  build();
  read(0, kL3, 0);
  EXPECT_EQ(read(0, kL3, due - 1), 8 * kSclk - 1);  // not yet
  build();
  read(0, kL3, 0);
  EXPECT_EQ(read(0, kL3, due), (12 + 3 + 8) * kSclk - 1);
  EXPECT_EQ(counter("memory.sdram.refresh.events"), 1U);
  // After a long pause all refreshes but the last are history.
  EXPECT_EQ(read(0, kL3, 10 * due + 1000), (3 + 8) * kSclk - 1);
  EXPECT_EQ(counter("memory.sdram.refresh.events"), 10U);
}

TEST_F(SdramTimingTest, DmaBurstsStreamAWordASclkBehindTheirOverhead) {
  read(0, kL3, 0);
  EXPECT_EQ(dma(Direction::read, kL3, 16, 1000), 1000 + (1 + 3 + 16) * kSclk);
  // Writing: overhead, tWR and one SCLK to turn the bus round.
  EXPECT_EQ(dma(Direction::write, kL3, 16, 2000), 2000 + (1 + 2 + 1 + 16) * kSclk);
  EXPECT_EQ(dma(Direction::write, kL3, 16, 3000), 3000 + (1 + 2 + 16) * kSclk);
}

TEST_F(SdramTimingTest, AFurtherBurstStartsAnewOnlyBehindSomebodyElse) {
  parameters_.sdram_refresh_sclk.set(0);
  // Cycles that a further burst of 16 words into the open row takes beyond its words.
  const auto start = [&](Address address, Direction direction, Initiator who, Cycles now) {
    return dma(direction, address, 16, now, who, true) - now - 16 * kSclk;
  };
  const Initiator mine = Initiator::mdma1_0;
  read(0, kL3, 0);
  dma(Direction::read, kL3, 16, 1000, mine);
  EXPECT_EQ(start(kL3 + 64, Direction::read, mine, 2000), 0U);
  EXPECT_EQ(start(kL3 + 128, Direction::read, mine, 3000), 0U);
  EXPECT_EQ(start(kL3 + 192, Direction::read, Initiator::mdma1_1, 4000), (1 + 3) * kSclk);
  EXPECT_EQ(start(kL3 + 192, Direction::read, mine, 5000), (1 + 3) * kSclk);
  read(1, kL3, 6000);
  EXPECT_EQ(start(kL3 + 256, Direction::read, mine, 7000), (1 + 3) * kSclk);
  EXPECT_EQ(start(kL3 + 320, Direction::write, mine, 8000), (1 + 1 + 2) * kSclk);
  EXPECT_EQ(start(kL3 + 384, Direction::write, mine, 9000), 0U);
  EXPECT_EQ(start(kL3 + kPage, Direction::write, mine, 10'000), (2 + 3 + 3) * kSclk) << "its row";
  // On the chip it lies under the words before, whoever was between.
  for (const Address memory : {kL2, kL1A}) {
    dma(Direction::read, memory, 16, 11'000, mine);
    dma(Direction::write, memory, 16, 12'000, Initiator::mdma2_0);
    EXPECT_EQ(start(memory + 64, Direction::read, mine, 13'000), 0U);
  }
}

TEST_F(SdramTimingTest, ABurstOverTwoPagesOpensBoth) {
  read(0, kL3, 0);
  EXPECT_EQ(dma(Direction::read, kL3 + kPage - 32, 16, 1000), 1000 + (1 + 3 + 16 + 3 + 3) * kSclk);
}

TEST_F(SdramTimingTest, CoresAndDmaSlowEachOther) {
  read(0, kL3, 0);
  const Cycles done = dma(Direction::read, kL3, 16, 1000);
  EXPECT_EQ(read(0, kL3, 1010), done - 1010 + 8 * kSclk - 1);
  EXPECT_EQ(dma(Direction::read, kL3, 16, 1010), done + (4 + 20) * kSclk);
}

TEST_F(SdramTimingTest, WithEveryLatencyAtItsLeastNothingStalls) {
  for (ParameterBase* parameter : parameters_.parameters()) {
    const std::string_view name = parameter->declaration().name;
    if (name.ends_with("_sclk") || name.ends_with("_cycles")) {
      parameter->set(parameter->declaration().minimum);
    }
  }
  build();
  Cycles now = 0;
  for (const Address address : {kL2, kL3, kL3 + kPage, kL3}) {
    EXPECT_EQ(read(0, address, ++now), 0U);
    EXPECT_EQ(write(1, address, ++now), 0U);
  }
  EXPECT_EQ(memory().fetch_code(0, Level::l2, kL2, 8, ++now), 0U);
}

TEST_F(SdramTimingTest, BankAndPageSizesMustFitTheRegion) {
  parameters_.sdram_page_bytes.set(3000);
  EXPECT_THROW(build(), InputError);
  parameters_.sdram_page_bytes.set(2048);
  parameters_.sdram_banks.set(3);
  EXPECT_THROW(build(), InputError);
}

}  // namespace
}  // namespace finback::memory
