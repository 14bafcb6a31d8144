// L1, L2, write buffers and instruction fetch: each latency is pinned by a probe.
#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

using AccessTiming = MemoryTest;

TEST_F(AccessTiming, OwnL1CostsNothing) {
  EXPECT_EQ(read(0, kL1A, 100), 0U);
  EXPECT_EQ(write(0, kL1A + 0x7FFC, 100), 0U);
}

TEST_F(AccessTiming, L2ReadTakesItsCyclesForEveryValue) {
  for (const Cycles cycles : {1, 7, 9, 10, 64}) {
    parameters_.l2_read_cycles.set(static_cast<double>(cycles));
    build();
    EXPECT_EQ(read(0, kL2, 1000), cycles - 1);
    // The port is free again when the datum is there, not a cycle before.
    EXPECT_EQ(read(0, kL2 + 4, 1000 + cycles), cycles - 1);
    EXPECT_EQ(read(0, kL2 + 4, 1000 + 2 * cycles - 1), 1 + cycles - 1);
  }
}

TEST_F(AccessTiming, TheLoserInL2WaitsForTheRestAndTwoCycles) {
  EXPECT_EQ(read(0, kL2, 0), 8U);           // port taken until 9
  EXPECT_EQ(read(1, kL2 + 64, 3), 16U);     // starts at 9 + 2, ends at 20
  EXPECT_EQ(read(0, kL2, 20), 8U);          // free on the very cycle
  EXPECT_EQ(read(1, kL2, 28), 1U + 2 + 8);  // one cycle early: waits for it, and loses two
}

TEST_F(AccessTiming, L2WritesArePostedUntilTheBufferIsFull) {
  // Five entries, three cycles each: writes of one cycle fill it, then the bus sets the pace.
  Cycles now = 0;
  Cycles stalls = 0;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(write(0, kL2, now), 0U) << i;
    ++now;
  }
  EXPECT_EQ(memory().writes_drained_at(0), 15U);
  for (int i = 0; i < 30; ++i) {
    const Cycles stall = write(0, kL2, now);
    stalls += stall;
    now += 1 + stall;
  }
  // 35 writes; the last enters when the 30th has arrived, at 90.
  EXPECT_EQ(memory().writes_drained_at(0), 105U);
  EXPECT_EQ(now, 91U);
  EXPECT_EQ(stalls, 91U - 35U);
  EXPECT_EQ(memory().writes_drained_at(1), 0U);
}

TEST_F(AccessTiming, AFullBufferStallsToTheCycleOfItsOldestArrival) {
  parameters_.write_buffer_entries.set(1);
  build();
  EXPECT_EQ(write(0, kL2, 0), 0U);  // arrives at 3
  EXPECT_EQ(write(0, kL2, 2), 1U);  // not free a cycle before; arrives at 6
  EXPECT_EQ(write(0, kL2, 6), 0U);  // free on it
}

TEST_F(AccessTiming, ADmaBurstDelaysCoresInItsL2SubBankOnly) {
  const Cycles done = dma(Direction::write, kL2, 16, 0);
  EXPECT_EQ(done, (2 + 16) * kSclk);
  EXPECT_EQ(read(0, kL2 + 16384, 10), 8U);      // the next sub-bank
  EXPECT_EQ(read(0, kL2 + 16380, 20), 8U + 2);  // the same
  EXPECT_EQ(read(0, kL2, done - 1), 8U + 2);    // last cycle of the burst
  EXPECT_EQ(read(0, kL2, done + 10), 8U);
}

TEST_F(AccessTiming, DmaPortsServeOneBurstAfterTheOther) {
  EXPECT_EQ(dma(Direction::read, kL2, 8, 0), 10 * kSclk);
  EXPECT_EQ(dma(Direction::read, kL2, 8, 0, Initiator::mdma2_0), 20 * kSclk);
  EXPECT_EQ(dma(Direction::read, kL1A, 8, 0), 10 * kSclk);
  EXPECT_EQ(dma(Direction::write, kL1B, 8, 0), 10 * kSclk);  // the other core's port
  EXPECT_EQ(dma(Direction::write, kL1A, 8, 7), 20 * kSclk);
  EXPECT_EQ(memory().level_traffic(Level::l1, Initiator::mdma1_0, Direction::write).stall_cycles,
            10 * kSclk - 7);
}

TEST_F(AccessTiming, TestAndSetIsAReadAndACompletedWriteWithThePortKept) {
  EXPECT_EQ(memory().core_test_and_set(0, span(0, kL2), kL2, 0), 18U);
  EXPECT_EQ(read(1, kL2, 0), 18U + 2 + 8);
  EXPECT_EQ(memory().core_test_and_set(0, span(0, kL3), kL3, 1000), (2 * 8 + 3) * kSclk);
  EXPECT_THROW(memory().core_test_and_set(0, span(0, kL1A), kL1A, 2000), GuestFault);
}

TEST_F(AccessTiming, InstructionFetchOf64Bits) {
  EXPECT_EQ(memory().fetch_code(0, Level::l2, kL2, 8, 100), 8U);
  EXPECT_EQ(memory().fetch_code(0, Level::l3, kL3, 8, 1000), (3 + 9) * kSclk - 1);  // opens the row
  EXPECT_EQ(memory().fetch_code(0, Level::l3, kL3 + 8, 8, 2000), 9 * kSclk - 1);
}

// Fetches take the ports from others, and wait for them.
TEST_F(AccessTiming, InstructionFetchContends) {
  read(1, kL2, 100);  // until 109
  EXPECT_EQ(memory().fetch_code(0, Level::l2, kL2, 8, 100), 9U + 2 + 8);
  EXPECT_EQ(read(1, kL2, 119), 1U + 2 + 8);
}

}  // namespace
}  // namespace finback::memory
