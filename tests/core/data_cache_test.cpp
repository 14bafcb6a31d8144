// The data cache as a program meets it: set up by registers, flushed by instructions, and old data
// where it was not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core_harness.hpp"

namespace finback::core {
namespace {

constexpr Address kL2 = 0xFEB00000;

// Writes a word, by P0 and R0.
std::string poke(Address address, std::uint32_t value) {
  const auto half = [](std::uint32_t word, bool high) {
    return std::to_string(high ? word >> 16 : word & 0xFFFF);
  };
  return "P0.L = " + half(address, false) + "; P0.H = " + half(address, true) +
         "; R0.L = " + half(value, false) + "; R0.H = " + half(value, true) + "; [P0] = R0;\n";
}

constexpr std::uint32_t kRights = 0x1D;  // valid; user reads, writes; supervisor writes
constexpr std::uint32_t kDirty = 0x80, kCacheable = 0x1000, kThrough = 0x4000, kAllocate = 0x8000;
constexpr std::uint32_t kPage1M = 0x20000;
constexpr std::uint32_t kWriteBack = kCacheable | kDirty;
constexpr std::uint32_t kWriteThrough = kCacheable | kThrough;

// Data CPLB 0 is L2's megabyte; bank A's upper half is cache.
std::string enable(std::uint32_t cached, std::uint32_t control = 0xA) {
  return poke(0xFFE00100, kL2) + poke(0xFFE00200, kRights | kPage1M | cached) +
         poke(0xFFE00004, control) + "SSYNC;\n";
}
std::string point(const char* reg, Address address) {
  return std::string(reg) + ".L = " + std::to_string(address & 0xFFFF) + "; " + reg +
         ".H = " + std::to_string(address >> 16) + "; NOP; NOP; NOP; NOP;\n";
}

class DataCacheProgram : public testing::Test {
 protected:
  void run(const std::string& body) {
    harness_ = std::make_unique<CoreHarness>(program(body));
    const std::vector<std::uint8_t> words = {0x11, 0x11, 0x11, 0x11, 0x22, 0x22, 0x22, 0x22};
    harness_->memory().store_bytes(kL2, words);
    harness_->run();
  }
  [[nodiscard]] Cycles stalls(Cause cause) {
    return harness_->core().profile().causes[static_cast<std::size_t>(cause)];
  }
  [[nodiscard]] std::uint32_t in_memory(Address address) {
    const auto bytes = harness_->memory().view_bytes(address, 4);
    return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24);
  }
  std::unique_ptr<CoreHarness> harness_;
};

TEST_F(DataCacheProgram, LoadsMissOnceALine) {
  run(enable(kWriteBack) + point("P1", kL2) +
      "R1 = [P1]; NOP; NOP; NOP; NOP; NOP; NOP; R2 = [P1 + 4]; R3 = [P1 + 28];");
  EXPECT_EQ(harness_->reg(isa::R1), 0x11111111U);
  EXPECT_EQ(harness_->reg(isa::R2), 0x22222222U);
  EXPECT_EQ(stalls(Cause::data_cache), 8U);
  EXPECT_EQ(stalls(Cause::l2_read), 0U);
}

TEST_F(DataCacheProgram, WithoutCplbsNothingIsCached) {
  run(poke(0xFFE00004, 0x8) + point("P1", kL2) + "R1 = [P1]; R2 = [P1];");
  EXPECT_EQ(stalls(Cause::data_cache), 0U);
  EXPECT_EQ(stalls(Cause::l2_read), 16U);
}

TEST_F(DataCacheProgram, WriteBackKeepsStoresUntilTheFlush) {
  const std::string store = enable(kWriteBack) + point("P1", kL2) + "R1 = 5; [P1] = R1; R2 = [P1];";
  run(store);
  EXPECT_EQ(harness_->reg(isa::R2), 5U);
  EXPECT_EQ(in_memory(kL2), 0x11111111U);
  run(store + "FLUSH [P1++]; P2 = 1; P2 = P1;");
  EXPECT_EQ(in_memory(kL2), 5U);
  EXPECT_EQ(harness_->reg(isa::P1), kL2 + 32);
}

TEST_F(DataCacheProgram, WriteThroughReachesMemoryAndTheCache) {
  run(enable(kWriteThrough) + point("P1", kL2) + "R3 = [P1 + 4]; R1 = 5; [P1] = R1; R2 = [P1];");
  EXPECT_EQ(harness_->reg(isa::R2), 5U);
  EXPECT_EQ(in_memory(kL2), 5U);
}

// Without allocation a store that misses leaves the line where it is.
TEST_F(DataCacheProgram, OnlyAllocatingStoresBringLinesIn) {
  const std::string body = point("P1", kL2) + "R1 = 5; [P1] = R1; SSYNC; SSYNC; R2 = [P1];";
  run(enable(kWriteThrough) + body);
  EXPECT_EQ(stalls(Cause::data_cache), 8U);
  run(enable(kWriteThrough | kAllocate) + body);
  EXPECT_EQ(stalls(Cause::data_cache), 0U);
  EXPECT_EQ(harness_->reg(isa::R2), 5U);
}

// Memory changes under the cache: the program sees the old word until it forgets the line.
TEST_F(DataCacheProgram, OldDataIsReallyOld) {
  constexpr Cycles kPause = 500;
  CoreHarness harness(program(enable(kWriteBack) + point("P1", kL2) + point("P2", kL2 + 0x800) +
                              "R1 = [P1]; P3 = 1000; LSETUP (.Lpause, .Lpause) LC0 = P3;"
                              ".Lpause: NOP; TESTSET (P2); R2 = [P1]; FLUSHINV [P1]; R3 = [P1];"));
  harness.memory().store_bytes(kL2, std::vector<std::uint8_t>{1, 0, 0, 0});
  Core core(CoreId::a, harness.image().cores[0], harness.parameters(), 1, harness.memory(),
            harness);
  core.start(0);
  while (core.time() <= kPause) {  // up to TESTSET, which has to wait
    core.run({.horizon = kNever, .shared_until = kPause});
  }
  ASSERT_EQ(core.state().reg[isa::R1], 1U);
  harness.memory().host_access(kL2, 4, memory::Direction::write)[0] = 9;
  while (!core.sleeping()) {
    core.run({});
  }
  EXPECT_EQ(core.state().reg[isa::R2], 1U);
  EXPECT_EQ(core.state().reg[isa::R3], 9U);
  EXPECT_EQ(harness.memory().stale_watch().count(memory::StaleKind::old_in_cache), 1U);
}

TEST_F(DataCacheProgram, AHalfWithSomethingInItCannotBecomeCache) {
  CoreHarness harness(program(enable(kWriteBack, 0xE),
                              ".data\n.align 8\n.type _big, @object\n_big: .space 20000\n"
                              ".size _big, 20000\n"));
  try {
    harness.run();
    FAIL() << "accepted";
  } catch (const GuestFault& fault) {
    EXPECT_THAT(fault.what(), testing::HasSubstr("lies there"));
  }
}

// Two cached accesses of a packet meet in a sub-bank as two in memory do: by bits 13:12 and 2.
TEST_F(DataCacheProgram, SubBanksHoldForTheCacheToo) {
  const auto conflicts = [&](Address apart) {
    run(enable(kWriteBack) + point("P1", kL2) + point("I0", kL2 + apart) +
        "R1 = [P1]; R2 = [I0]; MNOP || R1 = [P1] || R2 = [I0];");
    return stalls(Cause::sub_bank);
  };
  EXPECT_EQ(conflicts(0x4000), 1U);
  EXPECT_EQ(conflicts(0x4004), 0U);
  EXPECT_EQ(conflicts(0x1000), 0U);
}

// Bytes by packet, the cache's and the lines', are the core's traffic.
TEST_F(DataCacheProgram, BytesAddUp) {
  run(enable(kWriteBack) + point("P1", kL2) +
      "P2 = 100; LSETUP (.Ltop, .Lend) LC0 = P2; .Ltop: R1 = [P1++]; W[P1 + 64] = R1;"
      ".Lend: [--SP] = (R7:4); SP += 16;");
  LevelBytes sum{};
  for (const PacketProfile& packet : harness_->core().profile().packet_profiles) {
    for (std::size_t level = 0; level < sum.size(); ++level) {
      sum[level] += packet.bytes[level];
    }
  }
  for (std::size_t level = 0; level < sum.size(); ++level) {
    Bytes traffic = 0;
    for (const memory::Direction direction : {memory::Direction::read, memory::Direction::write}) {
      traffic += harness_->memory()
                     .level_traffic(static_cast<memory::Level>(level), memory::Initiator::core_a,
                                    direction)
                     .bytes;
    }
    EXPECT_EQ(sum[level], traffic) << level;
  }
  EXPECT_GT(sum[1], 400U);
}

TEST_F(DataCacheProgram, PagesAreLookedUpAnewWhenACplbChanges) {
  run(enable(kWriteBack) + point("P1", kL2) + "R1 = [P1];" + poke(0xFFE00200, kRights | kPage1M) +
      "R2 = [P1];");
  EXPECT_EQ(stalls(Cause::data_cache), 8U);
  EXPECT_EQ(stalls(Cause::l2_read), 8U);
}

}  // namespace
}  // namespace finback::core
