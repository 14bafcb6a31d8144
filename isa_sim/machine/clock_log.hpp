// What was done at which operating point of the chip, for the power model.
//
// Models: the history of the clocks, and for each operating point the time spent there and the
// work done. Work is counted in whole blocks: what a change of clock interrupts counts where it
// ends. Does not model: anything; watts are the power model's.
#pragma once

#include <array>
#include <vector>

#include <clock_model/clock_history.hpp>
#include <isa_sim/core/profile.hpp>

namespace finback::machine {

// Since the start.
struct ChipWork {
  std::array<core::CoreWork, kCoreCount> cores;
  std::uint64_t external_transfers = 0;  // on the external bus
};

struct PointUse {
  clock::OperatingPoint point;
  Cycles cycles = 0;
  double seconds = 0;
  ChipWork work;
};

class ClockLog {
 public:
  explicit ClockLog(const clock::OperatingPoint& start)
      : history_(start), uses_{{start, 0, 0, {}}} {}

  // `now`: the work done by `at`.
  void change(Cycles at, const clock::OperatingPoint& point, const ChipWork& now);
  // The run stands still at `at`; it may go on.
  void settle(Cycles at, const ChipWork& now);

  [[nodiscard]] const clock::ClockHistory& history() const { return history_; }
  // In the order in which they came first.
  [[nodiscard]] const std::vector<PointUse>& uses() const { return uses_; }

 private:
  clock::ClockHistory history_;
  std::vector<PointUse> uses_;
  std::size_t current_ = 0;  // of uses_
  Cycles counted_to_ = 0;
  ChipWork counted_;
};

}  // namespace finback::machine
