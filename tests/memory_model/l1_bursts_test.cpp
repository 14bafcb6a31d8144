// DMA in the core's way in L1, word by word, against a list of who is where when.
#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

constexpr std::uint32_t kSubBank = 4096;

class L1BurstsTest : public MemoryTest {
 protected:
  void mind() { memory().mind_sub_banks(0, kSubBank); }
  bool met(Address address, Cycles now) { return memory().dma_in_the_way(0, address, now); }
};

// Sixteen words from 10 SCLK after the beginning, one every five cycles, in both halves by turns.
TEST_F(L1BurstsTest, AWordTakesItsSubBankAndHalfForOneCycle) {
  mind();
  EXPECT_EQ(dma(Direction::write, kL1A + 64, 16, 0), 18 * kSclk);
  constexpr Cycles kFirst = 2 * kSclk;
  for (Cycles now = 0; now < 18 * kSclk; ++now) {
    const bool word = now >= kFirst && (now - kFirst) % kSclk == 0;
    const bool odd = (now - kFirst) / kSclk % 2 == 1;
    EXPECT_EQ(met(kL1A + 0xFF8, now), word && !odd) << now;
    EXPECT_EQ(met(kL1A + 0xFFC, now), word && odd) << now;
    EXPECT_FALSE(met(kL1A + kSubBank, now)) << now;
  }
}

TEST_F(L1BurstsTest, WindowsAreClosedWhileABurstIsNear) {
  places_ = {{"near", "core_a", kL1A, 512}, {"far", "core_a", kL1A + 2 * kSubBank, 512}};
  mind();
  const MemoryWindow& near = span(0, kL1A)->window;
  const MemoryWindow& far = span(0, kL1A + 2 * kSubBank)->window;
  EXPECT_EQ(near.size, 512U);
  const Cycles done = dma(Direction::read, kL1A + 1024, 16, 100);
  EXPECT_EQ(near.size, 0U);
  EXPECT_EQ(far.size, 512U);
  met(kL1A, done - 1);
  EXPECT_EQ(near.size, 0U);
  met(kL1A, done);
  EXPECT_EQ(near.size, 512U);
}

TEST_F(L1BurstsTest, NobodyMindsWhereNobodySaidSo) {
  dma(Direction::write, kL1A, 16, 0);
  EXPECT_FALSE(met(kL1A, 2 * kSclk));
  EXPECT_NE(span(0, kL1A)->window.size, 0U);
}

}  // namespace
}  // namespace finback::memory
