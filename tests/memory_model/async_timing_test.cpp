// Asynchronous memory, probed: every field of AMBCTL by the time of one access more.
#include <tests/memory_model/memory_fixture.hpp>

namespace finback::memory {
namespace {

constexpr Address kFlash = 0x20000000;
constexpr Address kOtherBank = 0x24000000;

// A bank's half of AMBCTL, in SCLK; 4 of two bits is written as 0.
constexpr std::uint32_t half(std::uint32_t setup, std::uint32_t read, std::uint32_t write,
                             std::uint32_t hold, std::uint32_t transition) {
  return (transition & 3U) << 2 | (setup & 3U) << 4 | hold << 6 | read << 8 | write << 12;
}

class AsyncTimingTest : public MemoryTest {
 protected:
  AsyncTimingTest() {
    Region other = *map_.find(kFlash);
    other.name = "sram";
    other.base = kOtherBank;
    other.read_only = false;
    map_.regions.insert(std::ranges::find(map_.regions, "l2", &Region::name), other);
    parameters_.sdram_refresh_sclk.set(0);
    build();
    memory().asynchronous().set_global(0x00FA);  // all banks, 16 data lines
    set(2, 7, 9, 1, 1);
  }
  // Of banks 0 and 1.
  void set(std::uint32_t setup, std::uint32_t read, std::uint32_t write, std::uint32_t hold,
           std::uint32_t transition) {
    const std::uint32_t one = half(setup, read, write, hold, transition);
    memory().asynchronous().set_banks(0, one << 16U | one);
  }
  Cycles halfword(Address address, Cycles now) {
    return memory().core_read(0, span(0, address), address, 2, now);
  }
  // When the bus is free after an access that began at `now`: what an SDRAM read waits longer.
  Cycles waits_behind(Address address, Cycles now) {
    read(0, kL3, now - 2000);  // opens the row
    const Cycles alone = read(0, kL3, now - 1000);
    halfword(address, now);
    return read(0, kL3, now) - alone;
  }
};

TEST_F(AsyncTimingTest, AReadTakesSetupAccessAndTheClockCrossing) {
  EXPECT_EQ(halfword(kFlash, 1000), (5 + 2 + 7) * kSclk - 1);
  set(2, 8, 9, 1, 1);
  EXPECT_EQ(halfword(kFlash, 2000), (5 + 2 + 8) * kSclk - 1);
  set(4, 8, 9, 1, 1);
  EXPECT_EQ(halfword(kFlash, 3000), (5 + 4 + 8) * kSclk - 1);
  set(4, 8, 9, 3, 1);  // hold comes after the data
  EXPECT_EQ(halfword(kFlash, 4000), (5 + 4 + 8) * kSclk - 1);
}

TEST_F(AsyncTimingTest, AWordIsTwoReadsOnSixteenDataLines) {
  EXPECT_EQ(read(0, kFlash, 1000), (5 + 2 * 10 - 1) * kSclk - 1);
  memory().asynchronous().set_global(0x00EA);  // bank 0 has 32
  EXPECT_EQ(read(0, kFlash, 2000), (5 + 10 - 1) * kSclk - 1);
}

TEST_F(AsyncTimingTest, TheBusIsHeldWithHoldAndTransition) {
  EXPECT_EQ(waits_behind(kFlash, 10'000), (2 + 7 + 1 + 1) * kSclk);
  set(2, 7, 9, 3, 1);
  EXPECT_EQ(waits_behind(kFlash, 20'000), (2 + 7 + 3 + 1) * kSclk);
  set(2, 7, 9, 3, 4);
  EXPECT_EQ(waits_behind(kFlash, 30'000), (2 + 7 + 3 + 4) * kSclk);
}

TEST_F(AsyncTimingTest, TransitionIsForOthersAndForWrites) {
  set(2, 7, 9, 1, 3);
  const Cycles alone = halfword(kFlash, 1000);
  const Cycles held = 10 * kSclk;
  EXPECT_EQ(halfword(kFlash, 1000), alone + held) << "the same bank reads on";
  halfword(kOtherBank, 3000);
  EXPECT_EQ(halfword(kFlash, 3000), alone + held + 3 * kSclk);
  halfword(kOtherBank, 5000);
  write(0, kOtherBank, 5000);  // one word: two writes
  EXPECT_EQ(memory().writes_drained_at(0), 5000 + held + (3 + 2 * 12) * kSclk);
}

TEST_F(AsyncTimingTest, WritesArePosted) {
  EXPECT_EQ(write(0, kOtherBank, 1000), 0U);
  EXPECT_EQ(memory().writes_drained_at(0), 1000 + 2 * 12 * kSclk);
  set(2, 7, 10, 1, 1);
  EXPECT_EQ(write(0, kOtherBank, 2000), 0U);
  EXPECT_EQ(memory().writes_drained_at(0), 2000 + 2 * 13 * kSclk);
}

TEST_F(AsyncTimingTest, CodeIsFetchedThroughIt) {
  EXPECT_EQ(memory().fetch_code(0, Level::l3, kFlash, 8, 1000), (5 + 4 * 10 - 1) * kSclk - 1);
}

TEST_F(AsyncTimingTest, DmaReadsElementByElement) {
  EXPECT_EQ(dma(Direction::read, kFlash, 4, 1000), 1000 + (1 + 4 * 2 * 10) * kSclk);
  EXPECT_EQ(memory().dma_port(kFlash), DmaPort::external);
}

TEST_F(AsyncTimingTest, ALineComesBeatByBeat) {
  MemoryParameters cached;
  cached.cache_l3_policy.set(1);
  MemorySystem system(map_, cached, clock_, {});
  system.asynchronous().set_banks(0, half(2, 7, 9, 1, 1) | half(2, 7, 9, 1, 1) << 16U);
  system.configure_data_cache(0, 1, false, {}, 0);
  const auto load = [&](Address address, Cycles now) {
    return system
        .cached_access(0, system.find_span(0, address), address, 4, false,
                       CachePolicy::write_through, 0, now)
        .stall;
  };
  EXPECT_EQ(load(kFlash, 1000), (5 + 2 + 7) * kSclk - 1);
  EXPECT_EQ(load(kFlash + 28, 1000), (5 + 2 + 7 + 14 * 10) * kSclk - 1);
  EXPECT_EQ(load(kFlash + 28, 3000), 0U);
}

TEST_F(AsyncTimingTest, TheClockCrossingIsAParameter) {
  parameters_.async_core_read_overhead_sclk.set(7);
  build();
  EXPECT_EQ(halfword(kFlash, 1000), (7 + 4 + 15) * kSclk - 1) << "the times after reset";
}

TEST_F(AsyncTimingTest, WhatCannotBeIsRefused) {
  using testing::HasSubstr;
  AsyncTiming& memories = memory().asynchronous();
  const auto refused = [&](std::uint32_t value) {
    try {
      memories.set_banks(1, value);
      return std::string("accepted");
    } catch (const GuestFault& fault) {
      return std::string(fault.what());
    }
  };
  EXPECT_THAT(refused(0xFFC3FFC2), HasSubstr("ARDY of bank 3 (bit 16)"));
  EXPECT_THAT(refused(0xFFC2F0C2), HasSubstr("bank 2 has a read access time of 0"));
  EXPECT_TRUE(memory().refuses(*span(0, kFlash), true));
  EXPECT_FALSE(memory().refuses(*span(0, kOtherBank), true));
  EXPECT_THAT(memory().core_fault(0, kFlash, 4, true), HasSubstr("flash is read-only"));
  EXPECT_THAT(memory().dma_fault({kFlash, 4, 2}, 4, Direction::write), HasSubstr("read-only"));
  EXPECT_EQ(memory().dma_fault({kFlash, 4, 2}, 4, Direction::read), "");
  memories.set_global(0x00F2);  // bank 0 alone
  EXPECT_TRUE(memory().refuses(*span(0, kOtherBank), false));
  EXPECT_THAT(memory().core_fault(0, kOtherBank, 4, false), HasSubstr("bank 1 is not enabled"));
  EXPECT_THAT(memory().dma_fault({kOtherBank, 4, 2}, 4, Direction::read),
              HasSubstr("bank 1 is not enabled"));
  EXPECT_THROW(memory().core_test_and_set(0, span(0, kFlash), kFlash, 1000), GuestFault);
  EXPECT_THROW(memory().host_access(kFlash, 4, Direction::write), InputError);
}

}  // namespace
}  // namespace finback::memory
