// The one external bus, on which the SDRAM and the asynchronous memories take turns.
//
// Models: one access at a time, each for the whole of its time; the idle time that an asynchronous
// bank wants between its read and an access to somebody else. Does not model: bus requests from
// outside the chip (BR, BG), the phase of SCLK. Source: hardware.md 2.4, 2.5.
#pragma once

#include <algorithm>

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>

namespace finback::memory {

class ExternalBus {
 public:
  // Somebody on the bus that is not an asynchronous bank.
  static constexpr int kSynchronous = -1;

  // From when on an access that was asked for at `now` can have the bus: behind those who have it.
  // `bank`: of asynchronous memory, or kSynchronous.
  [[nodiscard]] Cycles acquire(Cycles now, int bank = kSynchronous, bool write = false) {
    from_ = std::max(now, free_at_);
    if (last_read_ != kSynchronous && (bank != last_read_ || write)) {
      from_ = std::max(from_, free_at_ + transition_);
    }
    last_read_ = kSynchronous;
    return from_;
  }
  // The access that acquired the bus last begins later (a refresh comes before it).
  void delay_to(Cycles start) { from_ = start; }
  // It holds the bus until `end`.
  void hold_until(Cycles end) {
    busy_cycles_ += end - from_;
    free_at_ = from_ = end;
  }
  // It was a read of an asynchronous bank, which wants `transition` before somebody else's access.
  void was_read_of(int bank, Cycles transition) {
    last_read_ = bank;
    transition_ = transition;
  }

  [[nodiscard]] Cycles free_at() const { return free_at_; }
  [[nodiscard]] const Cycles& busy_cycles() const { return busy_cycles_; }
  // What is under way goes on in the new clocks.
  void change_clock(const clock::ClockChange& change) {
    free_at_ = change.system_time(free_at_);
    from_ = change.system_time(from_);
    transition_ = change.to.cycles(change.from.left(transition_));
  }

 private:
  Cycles free_at_ = 0;
  Cycles from_ = 0;  // when the access that has the bus acquired it
  int last_read_ = kSynchronous;
  Cycles transition_ = 0;
  Cycles busy_cycles_ = 0;
};

}  // namespace finback::memory
