// Who goes first on the external port: cores, DMA, urgent DMA; and that nobody starves.
#include <utility>

#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using memory::Direction;
using memory::Initiator;
using memory::Level;

constexpr std::array<Initiator, 4> kActors = {Initiator::core_a, Initiator::core_b,
                                              Initiator::mdma1_0, Initiator::mdma2_0};

// What the actors had from L2 and L3 until the end.
struct Share {
  std::array<Bytes, 4> bytes{};
  std::array<Cycles, 2> longest{};  // of the cores: an access with all that it waited
  bool operator==(const Share&) const = default;
};

// One core's loop: reads and writes in turn, of L2 and of two rows of SDRAM.
struct CoreLoop {
  Cycles time = 0;
  Cycles asked_at = kNever;
  std::uint64_t count = 0;
  bool only_writes = false;
  bool only_l3 = false;
};

class Precedence : public DmaTest {
 protected:
  // The core's next access, or its waiting for DMA. Returns what the access took, 0 while it waits.
  Cycles step(int core, CoreLoop& loop) {
    const auto turn = static_cast<Address>(loop.count);
    const bool l3 = loop.only_l3 || (turn & 1U) != 0;
    const bool write = loop.only_writes || (turn & 2U) != 0;
    const Address base = l3 ? kL3 + (turn & 4U) * 0x8000 : kL2;
    const Address address = base + static_cast<Address>(core) * 0x4000 + turn * 4 % 0x1000;
    memory::Span* span = memory_->find_span(core, address);
    loop.asked_at = std::min(loop.asked_at, loop.time);
    if (l3 && !write) {
      const Cycles from = memory_->core_turn(core, span, false, loop.time);
      if (from > loop.time) {
        loop.time = from;
        return 0;
      }
    }
    loop.time += 1 + (write ? memory_->core_write(core, span, address, 4, loop.time)
                            : memory_->core_read(core, span, address, 4, loop.time));
    ++loop.count;
    return loop.time - std::exchange(loop.asked_at, kNever);
  }

  // `who`, a bit each, until `end`: the earliest acts, DMA before cores.
  Share run(unsigned who, Cycles end, bool dma_first = false, const CoreLoop& loop = {}) {
    build();
    memory_->external_bus().set_dma_first(dma_first);
    if ((who & 4U) != 0) {
      begin(*dma1_, kL3 + 0x100000, kL2 + 0x10000);
    }
    if ((who & 8U) != 0) {
      begin(*dma2_, kL2 + 0x18000, kL3 + 0x200000);
    }
    std::array<CoreLoop, 2> cores = {loop, loop};
    Share share;
    for (;;) {
      std::size_t next = 2;
      for (const std::size_t core : {1U, 0U}) {
        const bool there = (who >> core & 1U) != 0;
        next = there && (next == 2 || cores[core].time <= cores[next].time) ? core : next;
      }
      const Cycles event = std::min(dma1_->next_event_time(), dma2_->next_event_time());
      const Cycles now = next == 2 ? event : std::min(event, cores[next].time);
      if (now >= end) {
        break;
      }
      if (event <= now) {
        dma1_->advance(now);
        dma2_->advance(now);
        continue;
      }
      const Cycles took = step(static_cast<int>(next), cores[next]);
      share.longest[next] = std::max(share.longest[next], took);
    }
    for (std::size_t i = 0; i < kActors.size(); ++i) {
      for (const Level level : {Level::l2, Level::l3}) {
        for (const Direction direction : {Direction::read, Direction::write}) {
          share.bytes[i] += memory_->level_traffic(level, kActors[i], direction).bytes;
        }
      }
    }
    return share;
  }
  // 64 KB again and again, in words.
  static void begin(DmaController& dma, Address from, Address to) {
    program(dma, kS0, from, 0x1000, 4);
    program(dma, kD0, to, 0x1000, 4);
    enable(dma, 0, kBits32 | kAutobuffer, 0);
  }
};

constexpr Cycles kEnd = 150'000;
// A burst that opens its rows, a refresh, two reads with theirs.
constexpr Cycles kOneTurn = (16 + 4 + 8 + 12 + 2 * (8 + 8)) * kSclk;

TEST_F(Precedence, NobodyStarvesInAnyCombination) {
  const Cycles patience = 64 * kSclk;
  for (const bool dma_first : {false, true}) {
    std::array<Bytes, 4> alone{};
    for (std::size_t i = 0; i < 4; ++i) {
      alone[i] = run(1U << i, kEnd, dma_first).bytes[i];
    }
    for (unsigned who = 0; who < 16; ++who) {
      const Share share = run(who, kEnd, dma_first);
      for (std::size_t i = 0; i < 4; ++i) {
        if ((who >> i & 1U) == 0) {
          EXPECT_EQ(share.bytes[i], 0U) << who << ", actor " << i;
          continue;
        }
        EXPECT_GT(share.bytes[i], alone[i] / 12) << who << ", actor " << i << dma_first;
        EXPECT_LE(share.bytes[i], alone[i] + alone[i] / 50) << who << ", actor " << i;
      }
      for (const Cycles longest : share.longest) {
        EXPECT_LE(longest, patience + 2 * kOneTurn) << who << dma_first;
      }
      EXPECT_EQ(run(who, kEnd, dma_first), share) << who;
    }
  }
}

TEST_F(Precedence, ACoreGoesBeforeABurstThatWaits) {
  build();
  begin(*dma1_, kL3 + 0x100000, kL2 + 0x10000);
  begin(*dma2_, kL3 + 0x200000, kL2 + 0x18000);
  memory::Span* span = memory_->find_span(0, kL3);
  for (Cycles now = 500; now < 60'000; now += 997) {
    for (Cycles event = 0; event <= now;) {
      dma1_->advance(event);
      dma2_->advance(event);
      event = std::min(dma1_->next_event_time(), dma2_->next_event_time());
    }
    // One burst under way, though two controllers want the bus; its row, a refresh, our row.
    EXPECT_LE(memory_->core_read(0, span, kL3, 4, now), (20 + 6 + 12 + 6 + 8) * kSclk) << now;
  }
}

TEST_F(Precedence, CdprioTurnsCoresAndDmaRound) {
  const CoreLoop reads{.only_l3 = true};
  const Share cores_first = run(0b0111, kEnd, false, reads);
  const Share dma_first = run(0b0111, kEnd, true, reads);
  EXPECT_GT(cores_first.bytes[0], dma_first.bytes[0] * 5 / 4);
  EXPECT_GT(dma_first.bytes[2], cores_first.bytes[2] * 5 / 4);
}

TEST_F(Precedence, CoreAGoesBeforeCoreB) {
  const CoreLoop reads{.only_l3 = true};
  const Share share = run(0b0111, kEnd, false, reads);
  EXPECT_GT(share.bytes[0], share.bytes[1]);
  EXPECT_GT(share.bytes[1], share.bytes[0] * 3 / 4);
}

// Stores without a pause never leave the bus free.
TEST_F(Precedence, PatienceIsWhatDmaWaitsForCores) {
  const CoreLoop stores{.only_writes = true, .only_l3 = true};
  memory_parameters_.sdram_refresh_sclk.set(0);
  const auto waited = [&](int patience) {
    memory_parameters_.external_patience_sclk.set(patience);
    run(0b0101, 10 * kSclk + static_cast<Cycles>(patience) * kSclk + 200, false, stores);
    return memory_->level_traffic(Level::l3, Initiator::mdma1_0, Direction::read).stall_cycles;
  };
  // From then on it is in line, behind five stores that may open a row.
  const Cycles in_line = 5 * 11 * kSclk;
  for (const int patience : {100, 101, 300}) {
    const Cycles least = static_cast<Cycles>(patience) * kSclk;
    EXPECT_GE(waited(patience), least);
    EXPECT_LE(waited(patience), least + in_line);
  }
  EXPECT_LE(waited(0), in_line);
}

TEST_F(Precedence, OnlyWhatIsUrgentGoesBeforeCoresThatNeverPause) {
  const CoreLoop stores{.only_writes = true, .only_l3 = true};
  memory_parameters_.external_patience_sclk.set(100'000);
  build();
  begin(*dma1_, kL3 + 0x100000, kL2 + 0x10000);
  program(*dma2_, kPpi0, kL3 + 0x300000, 0x1000, 4);
  dma2_->write(kPpi0 + kConfig, 2, kEnable | kWriteMemory | kBits32 | kAutobuffer, 0);
  // Urgent is who has no room for another chunk; behind five stores, each of which opens its row, a
  // burst comes in time.
  constexpr Cycles kPeriod = 120 * kSclk;
  CoreLoop core = stores;
  Cycles push_at = 1000;
  const std::vector<std::uint8_t> chunk = pattern(32);
  while (core.time < kEnd) {
    const Cycles event = std::min({dma1_->next_event_time(), dma2_->next_event_time(), push_at});
    if (event > core.time) {
      step(0, core);
      continue;
    }
    dma1_->advance(event);
    dma2_->advance(event);
    if (event == push_at) {
      EXPECT_TRUE(dma2_->port(0).push(chunk, event)) << "lost at " << event;
      push_at += kPeriod;
    }
  }
  const auto moved = [&](Initiator initiator, Direction direction) {
    return memory_->level_traffic(Level::l3, initiator, direction).bytes;
  };
  EXPECT_EQ(moved(Initiator::mdma1_0, Direction::read), 0U) << "memory DMA is never urgent";
  EXPECT_GT(moved(Initiator::dma2, Direction::write), kEnd / kPeriod * 32 * 9 / 10);
}

}  // namespace
}  // namespace finback::dma
