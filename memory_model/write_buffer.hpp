// The posted writes of one core on their way to L2 and L3.
//
// Models: a first-in first-out buffer; the core stalls only when it is full, until its oldest write
// has arrived. Does not model: merging of neighbouring writes, forwarding to a later read. Source:
// hardware.md 2.3, 2.4 (writes posted).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <common/units.hpp>

namespace finback::memory {

class WriteBuffer {
 public:
  static constexpr std::size_t kMaximumEntries = 16;

  void set_entries(std::size_t entries) { entries_ = entries; }

  // Stall until an entry is free, at `now`.
  [[nodiscard]] Cycles make_room(Cycles now) {
    while (count_ > 0 && arrival_[oldest_] <= now) {
      pop();
    }
    if (count_ < entries_) {
      return 0;
    }
    const Cycles stall = arrival_[oldest_] - now;
    pop();
    return stall;
  }
  // When a write that enters at `now` may use the bus: behind those before it.
  [[nodiscard]] Cycles next_start(Cycles now) const { return std::max(now, drained_at_); }
  void push(Cycles arrival) {
    arrival_[(oldest_ + count_) % kMaximumEntries] = arrival;
    ++count_;
    drained_at_ = arrival;
  }
  [[nodiscard]] Cycles drained_at() const { return drained_at_; }

 private:
  void pop() {
    oldest_ = (oldest_ + 1) % kMaximumEntries;
    --count_;
  }

  std::array<Cycles, kMaximumEntries> arrival_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t entries_ = 1;
  Cycles drained_at_ = 0;
};

}  // namespace finback::memory
