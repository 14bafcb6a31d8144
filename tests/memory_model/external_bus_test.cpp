// Who is next on the external bus: lines of caches, single reads, core A, core B, DMA.
#include <gtest/gtest.h>

#include <memory_model/external_bus.hpp>

namespace finback::memory {
namespace {

constexpr Cycles kFree = 100;  // when the access under way ends
constexpr int kA = 0, kB = 1;

class ExternalBusTest : public testing::Test {
 protected:
  explicit ExternalBusTest(Cycles patience = 64) : bus_(patience, 5) { take(0, kFree); }
  void take(Cycles now, Cycles end) {
    static_cast<void>(bus_.acquire(now));
    bus_.hold_until(end);
  }
  Cycles single(int core, Cycles now) { return bus_.core_from(core, false, now); }
  Cycles line(int core, Cycles now) { return bus_.core_from(core, true, now); }

  ExternalBus bus_;
};

TEST_F(ExternalBusTest, AFreeBusIsHisWhoAsks) {
  EXPECT_EQ(single(kB, kFree), kFree);
  EXPECT_EQ(line(kB, kFree + 1), kFree + 1);
}

TEST_F(ExternalBusTest, OfTwoThatWaitCoreAIsNext) {
  EXPECT_EQ(single(kB, 10), kFree);
  EXPECT_EQ(single(kA, 20), kFree);
  EXPECT_EQ(single(kA, kFree), kFree);
  take(kFree, kFree + 40);
  EXPECT_EQ(single(kB, kFree), kFree) << "in line behind it: one passes, once";
}

TEST_F(ExternalBusTest, OfTwoLinesThatWaitCoreAsIsNext) {
  EXPECT_EQ(line(kB, 10), kFree);
  EXPECT_EQ(line(kA, 20), 20U) << "nothing of a core goes before it";
  take(20, kFree + 75);
  EXPECT_EQ(line(kB, kFree), kFree);
}

TEST_F(ExternalBusTest, ALineOfCoreBGoesBeforeASingleReadOfCoreAThatWaits) {
  EXPECT_EQ(single(kA, 10), kFree);
  EXPECT_EQ(line(kB, 20), kFree);
  EXPECT_EQ(single(kA, kFree), kFree + 1);
  EXPECT_EQ(line(kB, kFree), kFree);
  take(kFree, kFree + 75);
  EXPECT_EQ(single(kA, kFree + 1), kFree + 1) << "in line";
}

TEST_F(ExternalBusTest, PostedWritesThatComeMeanwhileOvertakeOnce) {
  EXPECT_EQ(single(kA, 10), kFree);
  take(20, kFree + 25);
  EXPECT_EQ(single(kA, kFree), kFree);
}

TEST_F(ExternalBusTest, DmaGoesBehindACoreThatWaits) {
  EXPECT_EQ(bus_.dma_from(0, false, 5), kFree);
  EXPECT_EQ(single(kB, 10), kFree);
  EXPECT_EQ(bus_.dma_from(0, false, kFree), kFree + 1);
  EXPECT_EQ(single(kB, kFree), kFree);
  take(kFree, kFree + 20);
  EXPECT_EQ(bus_.dma_from(0, false, kFree + 1), kFree + 20);
  EXPECT_EQ(bus_.dma_from(0, false, kFree + 20), kFree + 20);
}

TEST_F(ExternalBusTest, UrgentDmaGoesBeforeACoreThatWaits) {
  EXPECT_EQ(single(kB, 10), kFree);
  EXPECT_EQ(bus_.dma_from(1, true, 20), 20U);
  take(20, kFree + 80);
  bus_.is_dma(Initiator::ppi0, Direction::write);
  EXPECT_EQ(single(kB, kFree), kFree) << "it has waited for one already";
}

class ImpatientBusTest : public ExternalBusTest {
 protected:
  ImpatientBusTest() : ExternalBusTest(0) {}
};

TEST_F(ImpatientBusTest, ServesInTheOrderOfAsking) {
  EXPECT_EQ(single(kB, 10), 10U);
  EXPECT_EQ(line(kA, 20), 20U);
  EXPECT_EQ(bus_.dma_from(0, false, 30), 30U);
}

}  // namespace
}  // namespace finback::memory
