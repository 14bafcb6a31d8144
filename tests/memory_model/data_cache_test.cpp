// The data cache against a plain one that can be believed, and the time that its lines take.
#include <cstring>
#include <list>
#include <map>
#include <random>
#include <vector>

#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

constexpr std::uint32_t kSite = 7;

// What a data cache is, told without haste: for each set the lines it holds, the one that was not
// used for longest in front.
class PlainCache {
 public:
  struct Line {
    Address address;
    bool dirty;
    std::vector<std::uint8_t> bytes;
  };

  PlainCache(int banks, bool high_select, std::vector<std::uint8_t>& memory)
      : banks_(banks), high_select_(high_select), memory_(memory) {}

  // Whether it was there.
  bool access(Address address, int bytes, bool write, CachePolicy policy, std::uint32_t& value) {
    std::list<Line>& lines = sets_[set_of(address)];
    auto line = find(lines, address);
    const bool hit = line != lines.end();
    if (!hit && (!write || policy != CachePolicy::write_through)) {
      if (lines.size() == 2) {
        write_back(lines.front());
        lines.pop_front();
      }
      const auto from = memory_.begin() + std::ptrdiff_t{address / 32} * 32;
      line = lines.insert(lines.end(), {address / 32 * 32, false, {from, from + 32}});
    }
    if (line != lines.end()) {
      lines.splice(lines.end(), lines, line);
    }
    for (int i = 0; i < bytes; ++i) {
      const std::size_t within = address % 32 + static_cast<std::size_t>(i);
      if (!write) {
        value = (i == 0 ? 0 : value) | std::uint32_t{line->bytes[within]} << 8 * i;
        continue;
      }
      const auto byte = static_cast<std::uint8_t>(value >> 8 * i);
      if (line != lines.end()) {
        line->bytes[within] = byte;
        line->dirty |= policy == CachePolicy::write_back;
      }
      if (policy != CachePolicy::write_back) {
        memory_[address + static_cast<std::size_t>(i)] = byte;
      }
    }
    return hit;
  }
  void flush(Address address, bool forget) {
    std::list<Line>& lines = sets_[set_of(address)];
    const auto line = find(lines, address);
    if (line != lines.end()) {
      write_back(*line);
      if (forget) {
        lines.erase(line);
      }
    }
  }

 private:
  static std::list<Line>::iterator find(std::list<Line>& lines, Address address) {
    return std::find_if(lines.begin(), lines.end(),
                        [&](const Line& line) { return line.address == address / 32 * 32; });
  }
  // Bank, sub-bank and set, spelt out.
  [[nodiscard]] std::tuple<Address, Address, Address> set_of(Address address) const {
    const Address bank = banks_ < 2 ? 0 : address / (high_select_ ? 0x800000 : 0x4000) % 2;
    return {bank, address / 4096 % 4, address / 32 % 64};
  }
  void write_back(Line& line) {
    if (line.dirty) {
      std::copy(line.bytes.begin(), line.bytes.end(), memory_.begin() + line.address);
      line.dirty = false;
    }
  }

  int banks_;
  bool high_select_;
  std::vector<std::uint8_t>& memory_;
  std::map<std::tuple<Address, Address, Address>, std::list<Line>> sets_;
};

class DataCacheTest : public MemoryTest {
 protected:
  void turn_on(int banks = 1, bool high_select = false, int core = 0) {
    memory().configure_data_cache(core, banks, high_select, {}, 0);
  }
  CachedAccess access(Address address, bool write, CachePolicy policy, Cycles now, int bytes = 4,
                      int core = 0) {
    return memory().cached_access(core, span(core, address), address, bytes, write, policy, kSite,
                                  now);
  }
  Cycles load(Address address, Cycles now, int core = 0) {
    return access(address, false, CachePolicy::write_back, now, 4, core).stall;
  }
  Cycles store(Address address, Cycles now, int core = 0) {
    return access(address, true, CachePolicy::write_back, now, 4, core).stall;
  }
  [[nodiscard]] std::uint64_t counter(const std::string& name) {
    if (!registered_) {
      memory().register_counters(registry_);
      registered_ = true;
    }
    return registry_.snapshot().at(name).value;
  }
  CounterRegistry registry_;
  bool registered_ = false;
};

// Random accesses, flushes and changes by others, on few enough lines that they push each other
// out.
class AgainstPlain : public DataCacheTest,
                     public testing::WithParamInterface<std::tuple<int, bool>> {};

TEST_P(AgainstPlain, SameHitsBytesAndMemory) {
  const auto [banks, high_select] = GetParam();
  turn_on(banks, high_select);
  constexpr std::size_t kBytes = 0x900000;
  std::vector<std::uint8_t> plain_memory(kBytes);
  PlainCache plain(banks, high_select, plain_memory);
  std::mt19937 random(1);
  const auto pick = [&](std::uint32_t below) {
    return static_cast<std::uint32_t>(random() % below);
  };
  Cycles now = 0;
  std::uint64_t hits = 0;
  for (int step = 0; step < 200'000; ++step, now += 100) {
    const int bytes = 1 << pick(3);
    // A few sets, tags of each kind: bits 11, 14 and 23.
    const Address address = (pick(2) * 0x800000 + pick(2) * 0x4000 + pick(2) * 0x8000 +
                             pick(2) * 0x1000 + pick(2) * 0x800 + pick(3) * 32 + pick(32)) &
                            ~static_cast<Address>(bytes - 1);
    const std::uint32_t what = pick(40);
    if (what == 0) {
      plain.flush(address, (step & 1) != 0);
      memory().flush_line(0, address, (step & 1) != 0, kSite, now);
    } else if (what == 1) {
      const auto byte = static_cast<std::uint8_t>(random());
      plain_memory[address] = byte;
      memory().store_bytes(address, std::vector{byte});
    } else {
      const bool write = pick(2) == 0;
      const auto policy = static_cast<CachePolicy>(1 + pick(3));
      std::uint32_t value = static_cast<std::uint32_t>(random());
      const bool there = memory().stays_in_cache(0, address, false, CachePolicy::write_back);
      const CachedAccess real = access(address, write, policy, now, bytes);
      if (write) {
        std::memcpy(real.bytes, &value, static_cast<std::size_t>(bytes));
        if (real.also != nullptr) {
          std::memcpy(real.also, &value, static_cast<std::size_t>(bytes));
        }
      }
      const bool hit = plain.access(address, bytes, write, policy, value);
      hits += hit;
      ASSERT_EQ(there, hit) << "step " << step;
      ASSERT_EQ(std::memcmp(real.bytes, &value, static_cast<std::size_t>(bytes)), 0)
          << "step " << step;
    }
  }
  EXPECT_GT(hits, 20'000U);
  EXPECT_EQ(
      counter("core_a.data_cache.a.hit.accesses") + counter("core_a.data_cache.b.hit.accesses"),
      hits);
  const auto memory_now = memory().view_bytes(0, kBytes);
  EXPECT_TRUE(std::equal(memory_now.begin(), memory_now.end(), plain_memory.begin()));
}

INSTANTIATE_TEST_SUITE_P(DataCache, AgainstPlain,
                         testing::Values(std::tuple{1, false}, std::tuple{2, false},
                                         std::tuple{2, true}));

// ---- time ----

TEST_F(DataCacheTest, AMissWaitsForItsWordAndAHitForNothing) {
  turn_on();
  EXPECT_EQ(load(kL2, 100), 8U);  // 9 CCLK, its own included
  EXPECT_EQ(load(kL2, 200), 0U);
  EXPECT_EQ(load(kL2 + 28, 300), 0U);
  EXPECT_EQ(load(kL3 + 64, 10000), 54U);  // 8 SCLK and the row's opening: 40 + 15 - 1
  EXPECT_EQ(load(kL3 + 68, 11000), 0U);
}

// The rest of the line comes two cycles a word (L2), a system clock a word (SDRAM).
TEST_F(DataCacheTest, AHitInAComingLineWaitsForItsWord) {
  turn_on();
  EXPECT_EQ(load(kL2 + 8, 100), 8U);  // there at 109; +16 at 111, +24 at 113, +0 at 115
  EXPECT_EQ(load(kL2 + 12, 109), 0U);
  EXPECT_EQ(load(kL2 + 24, 109), 3U);
  EXPECT_EQ(load(kL2, 109), 5U);
  EXPECT_EQ(load(kL2, 115), 0U);
  EXPECT_EQ(load(kL3 + 32 + 4, 10000), 54U);  // there at 10055
  EXPECT_EQ(load(kL3 + 32, 10055), 7 * kSclk - 1);
}

TEST_F(DataCacheTest, AMissWaitsForTheLineBefore) {
  turn_on();
  EXPECT_EQ(load(kL2, 100), 8U);  // until 115
  EXPECT_EQ(load(kL2 + 32, 109), 6U + 8U);
}

TEST_F(DataCacheTest, AStoreThatMissesWaitsOnlyForTheLineBefore) {
  turn_on();
  EXPECT_EQ(store(kL2, 100), 0U);
  EXPECT_EQ(load(kL2, 101), 7U);  // the line that the store began at 100
  EXPECT_EQ(store(kL2 + 32, 109), 6U);
}

TEST_F(DataCacheTest, AVictimFollowsTheFillAndHoldsUpTheNext) {
  turn_on();
  constexpr Address kSameSet = 0x4000;
  store(kL2, 0);
  store(kL2 + kSameSet, 1000);
  EXPECT_EQ(load(kL2 + 2 * kSameSet, 2000), 8U);  // fill to 2015, write-back 3 + 6 to 2024
  EXPECT_EQ(memory().writes_drained_at(0), 2024U);
  // The victim's buffer is taken until 2024, then the port is free.
  EXPECT_EQ(load(kL2 + 3 * kSameSet, 2020), 4U + 8U);
  EXPECT_EQ(counter("core_a.data_cache.a.write_back.accesses"), 2U);
}

TEST_F(DataCacheTest, DmaWaitsForALineThatIsUnderWayInItsSubBankOfL2) {
  turn_on();
  const auto burst = [&](Address address, Cycles now) {
    return dma(Direction::read, address, 16, now, Initiator::mdma1_0, true);
  };
  EXPECT_EQ(load(kL2, 100), 8U);  // until 115
  EXPECT_EQ(burst(kL2 + 64, 105), 115 + 16 * kSclk);
  EXPECT_EQ(memory().level_traffic(Level::l2, Initiator::mdma1_0, Direction::read).stall_cycles,
            10U);
  load(kL2 + 32, 1000);
  EXPECT_EQ(burst(kL2 + 16384, 1005), 1005 + 16 * kSclk) << "the next sub-bank";
  load(kL2 + 64, 2000);
  EXPECT_EQ(burst(kL2, 2015), 2015 + 16 * kSclk) << "it is over";
}

TEST_F(DataCacheTest, EachFurtherWordFromL2TakesItsBeat) {
  parameters_.l2_burst_beat_cycles.set(5);
  turn_on();
  EXPECT_EQ(load(kL2, 100), 8U);
  EXPECT_EQ(load(kL2 + 24, 109), 3U * 5U - 1U);
}

TEST_F(DataCacheTest, FlushWritesBackOnceAndKeepsTheLine) {
  turn_on();
  *access(kL3, true, CachePolicy::write_back, 0).bytes = 0x5A;
  EXPECT_EQ(memory().view_bytes(kL3, 1)[0], 0);
  EXPECT_EQ(memory().flush_line(0, kL3, false, kSite, 1000).moved[2], 32U);
  EXPECT_EQ(memory().view_bytes(kL3, 1)[0], 0x5A);
  EXPECT_EQ(memory().flush_line(0, kL3, false, kSite, 2000).moved[2], 0U);
  EXPECT_EQ(load(kL3, 3000), 0U);
  memory().flush_line(0, kL3, true, kSite, 4000);
  EXPECT_GT(load(kL3, 5000), 0U);
}

TEST_F(DataCacheTest, PrefetchTakesNoTimeOfTheCore) {
  turn_on();
  EXPECT_EQ(memory().prefetch_line(0, span(0, kL2), kL2, kSite, 100).stall, 0U);
  EXPECT_EQ(load(kL2 + 8, 200), 0U);
  EXPECT_EQ(memory().prefetch_line(0, span(0, kL2), kL2, kSite, 300).moved[1], 0U);
}

// ---- the half that is cache ----

TEST_F(DataCacheTest, NobodyReachesTheHalfThatIsCache) {
  turn_on();
  constexpr Address kHalf = kL1A + 0x4000;
  EXPECT_EQ(memory().find_span(0, kHalf), nullptr);
  EXPECT_THAT(memory().core_fault(0, kHalf, 4, false), testing::HasSubstr("is cache"));
  EXPECT_THAT(memory().dma_fault({kHalf - 4, 4, 2}, 4, Direction::read),
              testing::HasSubstr("is cache"));
  EXPECT_EQ(memory().dma_fault({kHalf - 8, 4, 2}, 4, Direction::write), "");
  EXPECT_NE(memory().find_span(0, kL1A + 0x104000), nullptr);  // bank B
  memory().configure_data_cache(0, 0, false, {}, 0);
  EXPECT_NE(memory().find_span(0, kHalf), nullptr);
}

TEST_F(DataCacheTest, WhatLiesThereStandsInTheWay) {
  places_ = {{"table", "core_a", kL1A + 0x3FF0, 64}};
  try {
    turn_on();
    FAIL() << "accepted";
  } catch (const GuestFault& fault) {
    EXPECT_THAT(fault.what(), testing::HasSubstr("core_a.table lies there"));
  }
}

// ---- traffic ----

TEST_F(DataCacheTest, LinesCountWhereTheyComeFromAndAccessesInTheCache) {
  places_ = {{"left", "shared", kL2, 16}, {"right", "shared", kL2 + 16, 16}};
  turn_on();
  load(kL2, 0);
  load(kL2 + 4, 100);
  EXPECT_EQ(memory().level_traffic(Level::l2, Initiator::core_a, Direction::read).bytes, 32U);
  EXPECT_EQ(memory().level_traffic(Level::l1, Initiator::core_a, Direction::read).bytes, 8U);
  for (const ObjectTraffic& object : memory().objects()) {
    const Traffic& read = object.traffic[0][0];
    if (object.name == "left" || object.name == "right") {
      EXPECT_EQ(read.bytes, 16U) << object.name;
    } else {
      EXPECT_EQ(read.bytes, object.name == "(cache)" ? 8U : 0U) << object.name;
    }
  }
}

// ---- the watch ----

TEST_F(DataCacheTest, TellsOfOldBytesInTheCache) {
  turn_on();
  load(kL3, 0);
  const std::vector<std::uint8_t> words(8, 1);
  const DmaRun run{.address = kL3 + 4, .stride = 4, .count = 2};
  memory().scatter({&run, 1}, 4, words.data(), Initiator::mdma1_1);
  load(kL3, 1000);  // not those bytes
  EXPECT_EQ(memory().stale_watch().reports().size(), 0U);
  load(kL3 + 4, 1100);
  load(kL3 + 8, 1200);
  ASSERT_EQ(memory().stale_watch().reports().size(), 1U);
  const StaleReport& report = memory().stale_watch().reports()[0];
  EXPECT_EQ(report.kind, StaleKind::old_in_cache);
  EXPECT_EQ(report.other.initiator, Initiator::mdma1_1);
  EXPECT_EQ(report.reader, (Accessor{Initiator::core_a, kSite}));
  EXPECT_EQ(report.times, 2U);
  EXPECT_EQ(report.address, kL3 + 4);
  memory().flush_line(0, kL3, true, kSite, 1300);
  load(kL3 + 4, 1400);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_cache), 2U);
}

TEST_F(DataCacheTest, TellsOfOldBytesInMemory) {
  turn_on();
  store(kL3 + 8, 0);
  const DmaRun before{.address = kL3, .stride = 4, .count = 2};
  const DmaRun there{.address = kL3, .stride = 8, .count = 2};
  std::array<std::uint8_t, 16> bytes{};
  memory().gather({&before, 1}, 4, bytes.data(), Initiator::mdma2_0, 500);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_memory), 0U);
  memory().gather({&there, 1}, 4, bytes.data(), Initiator::mdma2_0, 600);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_memory), 1U);
  memory().flush_line(0, kL3, false, kSite, 1300);
  memory().gather({&there, 1}, 4, bytes.data(), Initiator::mdma2_0, 1400);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_memory), 1U);
}

TEST_F(DataCacheTest, TellsOfTheOtherCoresNewerBytes) {
  turn_on(1, false, 0);
  turn_on(1, false, 1);
  load(kL3, 0, 0);
  store(kL3, 1000, 1);  // A has it, B changes it in its cache
  load(kL3, 2000, 0);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_cache), 1U);
  store(kL3 + 32, 3000, 1);  // B changes it, then A fetches it
  load(kL3 + 32, 4000, 0);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::old_in_cache), 2U);
}

TEST_F(DataCacheTest, TellsOfBytesThatAWriteBackOverwrites) {
  turn_on();
  store(kL3, 0);
  memory().host_access(kL3 + 4, 4, Direction::write);
  memory().flush_line(0, kL3, false, kSite, 1000);
  ASSERT_EQ(memory().stale_watch().reports().size(), 1U);
  EXPECT_EQ(memory().stale_watch().reports()[0].kind, StaleKind::overwritten);
  store(kL3, 2000);
  turn_on(0);
  EXPECT_EQ(memory().stale_watch().count(StaleKind::dropped), 1U);
}

}  // namespace
}  // namespace finback::memory
