// Priorities, traffic periods, turns: the order itself, and what it does to transfers.
#include "dma_fixture.hpp"
#include <dma_model/traffic_control.hpp>

namespace finback::dma {
namespace {

using memory::Direction;
using memory::DmaPort;

constexpr std::uint32_t kLaneD0 = 12, kLaneS0 = 13, kLaneD1 = 14, kLaneS1 = 15;

std::uint32_t turns(std::uint32_t period) { return period << 11; }
std::uint32_t external_period(std::uint32_t period) { return period << 4; }

TEST(TrafficControl, LowerNumbersFirstAndUrgentOnesBeforeAll) {
  const TrafficControl traffic;
  const auto rank = [&](std::uint32_t lane, bool urgent) {
    return traffic.rank(lane, DmaPort::external, Direction::read, urgent);
  };
  for (std::uint32_t lane = 0; lane + 1 < TrafficControl::kLaneCount; ++lane) {
    EXPECT_LT(rank(lane, false), rank(lane + 1, false));
  }
  EXPECT_LT(rank(11, true), rank(0, false));
  EXPECT_LT(rank(0, true), rank(11, true));
}

TEST(TrafficControl, WithATrafficPeriodTheDirectionGoesOnUntilItIsOver) {
  TrafficControl traffic;
  traffic.set_periods(external_period(8));
  const auto first = [&](DmaPort port) {
    return traffic.rank(0, port, Direction::read, false) <
                   traffic.rank(1, port, Direction::write, false)
               ? Direction::read
               : Direction::write;
  };
  traffic.granted(1, DmaPort::external, Direction::write, 5, false);
  EXPECT_EQ(traffic.counts(), external_period(3));
  EXPECT_EQ(first(DmaPort::external), Direction::write);
  traffic.granted(1, DmaPort::external, Direction::write, 3, false);
  EXPECT_EQ(traffic.counts(), 0U);
  EXPECT_EQ(first(DmaPort::external), Direction::read);
  traffic.granted(0, DmaPort::external, Direction::read, 8, false);
  EXPECT_EQ(first(DmaPort::external), Direction::write);
  EXPECT_EQ(first(DmaPort::l2), Direction::read);  // DCB has no period: by number
  // Bursts end with the period where somebody waits to turn round.
  EXPECT_EQ(traffic.most_elements(0, DmaPort::external, true, false), 8U);
  EXPECT_GT(traffic.most_elements(0, DmaPort::external, false, false), 64U);
  EXPECT_GT(traffic.most_elements(0, DmaPort::l1_a, true, false), 64U);
}

TEST(TrafficControl, StreamsTakeTurnsOfThePeriodsElements) {
  TrafficControl traffic;
  traffic.set_periods(turns(20));
  EXPECT_EQ(traffic.periods(), turns(20));
  const auto first = [&] {
    return traffic.rank(kLaneD0, DmaPort::l1_a, Direction::write, false) <
                   traffic.rank(kLaneD1, DmaPort::l1_a, Direction::write, false)
               ? 0
               : 1;
  };
  EXPECT_EQ(first(), 0);
  EXPECT_EQ(traffic.most_elements(kLaneD0, DmaPort::l1_a, false, true), 20U);
  traffic.granted(kLaneD0, DmaPort::l1_a, Direction::write, 16, true);
  EXPECT_EQ(traffic.counts(), turns(4));
  EXPECT_EQ(first(), 0);
  EXPECT_EQ(traffic.most_elements(kLaneS0, DmaPort::l1_a, false, true), 4U);
  traffic.granted(kLaneS0, DmaPort::external, Direction::read, 16, true);  // reads do not count
  EXPECT_EQ(first(), 0);
  traffic.granted(kLaneD0, DmaPort::l1_a, Direction::write, 4, true);
  EXPECT_EQ(first(), 1);
  EXPECT_LT(traffic.rank(kLaneS1, DmaPort::l1_a, Direction::read, false),
            traffic.rank(kLaneD0, DmaPort::l1_a, Direction::write, false));
  EXPECT_LT(traffic.rank(11, DmaPort::l1_a, Direction::read, false),
            traffic.rank(kLaneD1, DmaPort::l1_a, Direction::write, false));
  traffic.granted(kLaneD1, DmaPort::l1_a, Direction::write, 20, true);
  EXPECT_EQ(first(), 0);
  // Alone, one idle SCLK for 20 elements.
  EXPECT_EQ(traffic.granted(kLaneD0, DmaPort::l1_a, Direction::write, 16, false), 0U);
  EXPECT_EQ(traffic.granted(kLaneD0, DmaPort::l1_a, Direction::write, 16, false), 1U);
  EXPECT_EQ(traffic.granted(kLaneD0, DmaPort::l1_a, Direction::write, 48, false), 3U);
}

constexpr Cycles kBursts = 30;  // of each stream

class Streams : public DmaTest {
 protected:
  void SetUp() override {
    memory_parameters_.sdram_refresh_sclk.set(0);
    memory_parameters_.sdram_page_bytes.set(65536);
    build();
  }
  // Both streams from SDRAM, each in a bank of its own, to the L1 of one core each; returns when
  // each of those that shall run is complete.
  std::array<Cycles, 2> run(bool first, bool second, std::uint32_t periods) {
    build();
    dma1_->write(DmaController::kTrafficPeriods, 2, periods, 0);
    const std::array<bool, 2> runs = {first, second};
    for (const std::uint32_t stream : {0U, 1U}) {
      program(*dma1_, 0x80 * stream + kS0, kL3 + (stream << 24U),
              static_cast<std::uint32_t>(16 * kBursts), 4);
      program(*dma1_, 0x80 * stream + kD0, stream == 0 ? kL1A : kL1B,
              static_cast<std::uint32_t>(16 * kBursts), 4);
      if (runs[stream]) {
        enable(*dma1_, stream, kBits32 | kInterruptEnable, 0);
      }
    }
    finish(*dma1_);
    std::array<Cycles, 2> ends{};
    for (const LineChange& line : lines_) {
      ends[static_cast<std::size_t>(line.source - 53)] = line.at;
    }
    return ends;
  }
};

// In SCLK: start-up 8, each read 16 and each start of reads 4, the row of the bank 3, the last
// write 16.
constexpr Cycles by_formula(Cycles reads, Cycles starts, Cycles rows) {
  return (8 + 16 * reads + 4 * starts + 3 * rows + 16) * kSclk;
}
// The writes start once, 2.
constexpr Cycles kAlone = by_formula(kBursts, 1, 1) + 2 * kSclk;

TEST_F(Streams, StreamOneReadsWhileStreamZeroWaits) {
  EXPECT_EQ(run(true, false, 0)[0], kAlone);
  EXPECT_EQ(run(false, true, 0)[1], kAlone);
  // One burst, while the first writes start; then both start anew.
  const auto both = run(true, true, 0);
  EXPECT_EQ(both[0], by_formula(kBursts + 1, 3, 2));
  EXPECT_EQ(both[1], by_formula(2 * kBursts, 4, 2));
}

TEST_F(Streams, WithTurnsBothEndTogether) {
  const auto both = run(true, true, turns(16));
  EXPECT_GT(std::max(both[0], both[1]), by_formula(2 * kBursts, kBursts, 2));
  EXPECT_LE(std::max(both[0], both[1]), by_formula(2 * kBursts, 2 * kBursts, 2));
  EXPECT_LE(std::max(both[0], both[1]) - std::min(both[0], both[1]), 60 * kSclk);
}

TEST_F(Streams, TurnsOfALoneStreamCostItOneCycleEach) {
  // Behind each burst of 16 words one SCLK, which the last does not wait for.
  EXPECT_EQ(run(true, false, turns(16))[0], kAlone + (kBursts - 1) * kSclk);
  EXPECT_EQ(run(true, false, turns(8))[0], kAlone + 2 * (kBursts - 1) * kSclk);
}

TEST_F(Streams, ShortTurnsOfTwoStreamsInSdramCostTheirStarts) {
  const auto both = run(true, true, turns(4));
  EXPECT_GT(std::max(both[0], both[1]), by_formula(2 * kBursts, 3 * kBursts, 2));
  EXPECT_LE(std::max(both[0], both[1]), by_formula(2 * kBursts, 8 * kBursts, 2));
}

}  // namespace
}  // namespace finback::dma
