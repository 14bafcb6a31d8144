// Both cores and two DMA streams on L2 and SDRAM at once, in all combinations: every byte is
// counted once, everybody gets on, and the same run gives the same times.
#include <functional>
#include <numeric>

#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

constexpr int kActors = 4;
constexpr Cycles kEnd = 200'000;
// Two bursts of 16 words, two lines in and two out, each in a row to be opened, and a refresh.
constexpr Cycles kLongestWait = (2 * (16 + 4 + 8) + 2 * (15 + 6) + 2 * (8 + 8) + 12) * kSclk;
constexpr std::array<Initiator, kActors> kInitiators = {Initiator::core_a, Initiator::core_b,
                                                        Initiator::mdma1_0, Initiator::mdma1_1};

// What each did until the end.
struct Work {
  std::array<Bytes, kActors> bytes{};
  std::array<std::uint64_t, kActors> steps{};
  std::array<Cycles, kActors> longest{};  // that a step took
  bool operator==(const Work&) const = default;
};

class Contention : public MemoryTest {
 protected:
  // Actor `number`'s next step at `now`; returns when it can make another.
  Cycles step(int number, std::uint64_t count, Cycles now, Bytes& bytes) {
    const auto turn = static_cast<Address>(count);
    const bool l3 = (count & 1) != 0;
    const Address base = l3 ? kL3 : kL2;
    if (number >= 2) {  // a burst from L3 to L2, the next the other way
      constexpr std::uint32_t kWords = 16;
      bytes += Bytes{kWords} * 4;
      const bool reads = ((count >> 1) & 1) == static_cast<std::uint64_t>(number & 1);
      return dma(reads ? Direction::read : Direction::write,
                 base + static_cast<Address>(number) * 0x8000 + turn * 64 % 0x4000, kWords, now,
                 kInitiators[static_cast<std::size_t>(number)]);
    }
    if (caches_) {
      return now + 1 + cached_step(number, base, turn, (count & 2) != 0, now, bytes);
    }
    bytes += 4;
    const Address address = base + static_cast<Address>(number) * 0x8000 + turn * 4 % 0x4000;
    return now + 1 + ((count & 2) != 0 ? write(number, address, now) : read(number, address, now));
  }
  Cycles cached_step(int core, Address base, Address turn, bool is_write, Cycles now,
                     Bytes& bytes) {
    const Address address = base + static_cast<Address>(core) * 0x8000 + turn * 36 % 0x8000 / 4 * 4;
    const CachedAccess access = memory().cached_access(core, span(core, address), address, 4,
                                                       is_write, CachePolicy::write_back, 0, now);
    bytes += std::accumulate(access.moved.begin(), access.moved.end(), Bytes{0});
    return access.stall;
  }

  // The actors of `who`, one bit each, as the machine lets them act: the earliest first.
  Work run(unsigned who) {
    build();
    for (int core = 0; core < kCoreCount && caches_; ++core) {
      memory().configure_data_cache(core, 2, false, {}, 0);
    }
    Work work;
    std::array<Cycles, kActors> time{};
    for (;;) {
      int next = -1;
      for (int i = kActors - 1; i >= 0; --i) {
        const auto at = static_cast<std::size_t>(i);
        if ((who >> i & 1) != 0 && (next < 0 || time[at] <= time[static_cast<std::size_t>(next)])) {
          next = i;
        }
      }
      if (next < 0 || time[static_cast<std::size_t>(next)] >= kEnd) {
        return work;
      }
      const auto at = static_cast<std::size_t>(next);
      const Cycles before = time[at];
      time[at] = step(next, work.steps[at]++, before, work.bytes[at]);
      work.longest[at] = std::max(work.longest[at], time[at] - before);
    }
  }
  Bytes counted(Initiator initiator) {
    Bytes sum = 0;
    for (const Level level : {Level::l2, Level::l3}) {
      for (const Direction direction : {Direction::read, Direction::write}) {
        sum += memory().level_traffic(level, initiator, direction).bytes;
      }
    }
    return sum;
  }
  void check_all_combinations() {
    std::array<std::uint64_t, kActors> alone{};
    for (int i = 0; i < kActors; ++i) {
      const auto at = static_cast<std::size_t>(i);
      alone[at] = run(1U << i).steps[at];
    }
    for (unsigned who = 0; who < 1U << kActors; ++who) {
      const Work work = run(who);
      for (std::size_t i = 0; i < kActors; ++i) {
        EXPECT_EQ(counted(kInitiators[i]), work.bytes[i]) << who << ", actor " << i;
        if ((who >> i & 1) != 0) {
          // Nobody waits for more than what each of the others, and he himself before, has asked
          // for.
          EXPECT_LE(work.longest[i], kLongestWait) << who << ", actor " << i;
          EXPECT_GT(work.steps[i], kEnd / kLongestWait) << who << ", actor " << i;
          EXPECT_LE(work.steps[i], alone[i] + alone[i] / 50) << who << ", actor " << i;
        }
      }
      EXPECT_EQ(run(who), work) << who;
    }
  }
  bool caches_ = false;
};

TEST_F(Contention, OfUncachedCoresAndDma) { check_all_combinations(); }

TEST_F(Contention, OfCachesAndDma) {
  caches_ = true;
  check_all_combinations();
}

}  // namespace
}  // namespace finback::memory
