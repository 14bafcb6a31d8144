// Streams and cores on the same memories: bytes are kept, counts are exact, everybody pays.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using DmaContention = DmaTest;

TEST_F(DmaContention, FourStreamsAndTwoCoresConserveBytes) {
  places_ = {{"images", "shared", kL3, 40000}, {"tables", "shared", kL2, 20000}};
  build();
  const auto images = pattern(40000, 7);
  memory_->store_bytes(kL3, images);
  const auto begin = [&](DmaController& dma, std::uint32_t stream, Address from, Address to) {
    program(dma, 0x80 * stream + kS0, from, 2500, 4);
    program(dma, 0x80 * stream + kD0, to, 2500, 4);
    enable(dma, stream, kBits32, 0);
  };
  begin(*dma1_, 0, kL3, kL2);
  begin(*dma1_, 1, kL3 + 10000, kL2 + 10000);
  begin(*dma2_, 0, kL3 + 20000, kL1A);
  begin(*dma2_, 1, kL3 + 30000, kL1B);

  Bytes core_bytes = 0;
  Cycles core_stall = 0;
  std::array<Cycles, kCoreCount> core_time{};
  Cycles end = 0;
  for (;;) {
    const Cycles event = std::min(dma1_->next_event_time(), dma2_->next_event_time());
    if (event == kNever) {
      break;
    }
    const std::size_t core = core_time[1] < core_time[0] ? 1 : 0;
    if (core_time[core] < event) {
      memory::Span* span = memory_->find_span(static_cast<int>(core), kL3);
      const Cycles stall =
          memory_->core_read(static_cast<int>(core), span, kL3, 4, core_time[core]);
      core_time[core] += 20 + stall;
      core_stall += stall;
      core_bytes += 4;
      continue;
    }
    dma1_->advance(event);
    dma2_->advance(event);
    end = event;
  }
  EXPECT_EQ(bytes_at(kL2, 20000),
            std::vector<std::uint8_t>(images.begin(), images.begin() + 20000));
  EXPECT_EQ(bytes_at(kL1A, 10000),
            std::vector<std::uint8_t>(images.begin() + 20000, images.begin() + 30000));
  EXPECT_EQ(bytes_at(kL1B, 10000), std::vector<std::uint8_t>(images.begin() + 30000, images.end()));

  using memory::Direction;
  using memory::Initiator;
  using memory::Level;
  for (const Initiator initiator :
       {Initiator::mdma1_0, Initiator::mdma1_1, Initiator::mdma2_0, Initiator::mdma2_1}) {
    EXPECT_EQ(memory_->level_traffic(Level::l3, initiator, Direction::read).bytes, 10000U);
    EXPECT_EQ(memory_->level_traffic(Level::l1, initiator, Direction::write).bytes +
                  memory_->level_traffic(Level::l2, initiator, Direction::write).bytes,
              10000U);
    EXPECT_GT(memory_->level_traffic(Level::l3, initiator, Direction::read).stall_cycles, 0U);
  }
  const memory::Traffic a = memory_->level_traffic(Level::l3, Initiator::core_a, Direction::read);
  const memory::Traffic b = memory_->level_traffic(Level::l3, Initiator::core_b, Direction::read);
  EXPECT_EQ(a.bytes + b.bytes, core_bytes);
  EXPECT_EQ(a.stall_cycles + b.stall_cycles, core_stall);
  EXPECT_GT(core_stall, (a.accesses + b.accesses) * 39);

  // A word of DMA takes the bus for a SCLK and a core's read for four; less than half of its time
  // is lost.
  const Cycles least = (40000 / 4 + core_bytes / 4 * 4) * kSclk;
  EXPECT_GT(end, least);
  EXPECT_LT(end, 2 * least);
  for (const memory::ObjectTraffic& object : memory_->objects()) {
    if (object.name == "tables") {
      EXPECT_EQ(object.traffic[static_cast<std::size_t>(Initiator::mdma1_0)][1].bytes, 10000U);
    }
  }
}

TEST_F(DmaContention, ACoreWaitsForOneBurstAtMost) {
  program(*dma1_, kS0, kL3, 4000, 4);
  program(*dma1_, kD0, kL2, 4000, 4);
  enable(*dma1_, 0, kBits32, 0);
  memory::Span* span = memory_->find_span(0, kL3);
  for (Cycles now = 500; now < 60000; now += 997) {
    while (dma1_->next_event_time() <= now) {
      dma1_->advance(dma1_->next_event_time());
    }
    // A burst with a row change, a refresh with its row, its own 40 cycles.
    const Cycles worst = (20 + 6 + 12 + 3 + 8) * kSclk;
    EXPECT_LE(memory_->core_read(0, span, kL3, 4, now), worst) << now;
  }
}

TEST_F(DmaContention, BothCorrectAndDeterministicForEveryBurstLength) {
  const auto bytes = pattern(3000);
  for (const int elements : {1, 5, 16, 64}) {
    parameters_.burst_elements.set(elements);
    std::array<Cycles, 2> ends{};
    for (Cycles& end : ends) {
      build();
      memory_->store_bytes(kL3, bytes);
      end = copy(*dma1_, 0, kL3, kL1A, 750, kBits32, 0);
      EXPECT_EQ(bytes_at(kL1A, 3000), bytes);
    }
    EXPECT_EQ(ends[0], ends[1]);
  }
}

}  // namespace
}  // namespace finback::dma
