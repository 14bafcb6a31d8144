// The one external bus, on which the SDRAM and the asynchronous memories take turns.
//
// Models: one access at a time, each for the whole of its time; the idle time that an asynchronous
// bank wants between its read and an access to somebody else; who goes first: urgent DMA, lines of
// the cores' caches, single reads of the cores, DMA, or with CDPRIO all DMA before the cores; of
// two cores A; whoever was passed over for long is next. Does not model: an access that is broken
// off; precedence over posted writes that are in line already; a line of core B before a single
// read of core A that was asked for in the same cycle, on a bus that is free; bus requests from
// outside the chip (BR, BG). Source: hardware.md 2.4, 2.5.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>
#include <memory_model/traffic.hpp>

namespace finback::memory {

class ExternalBus {
 public:
  // Somebody on the bus that is not an asynchronous bank.
  static constexpr int kSynchronous = -1;

  // `patience`: the longest that an access is passed over by those that go before it, in SCLK.
  ExternalBus(Cycles patience, clock::ClockRatio ratio)
      : patience_sclk_(patience), patience_(ratio.cycles(patience)) {
    asking_since_.fill(kNever);
  }

  // --- who goes first ---
  // CDPRIO of EBIU_AMGCTL: DMA goes before the cores.
  void set_dma_first(bool first) { dma_first_ = first; }
  // From when on a core may ask for the bus, for a `line` of a cache or a single read: `now`, or
  // the time at which to call again. Who may ask is in line at once: while the bus is taken, others
  // could come that go before it. Of the cores one is let pass once, so that posted writes do not
  // overtake it for ever; DMA that goes before the cores, as long as patience lasts.
  [[nodiscard]] Cycles core_from(int core, bool line, Cycles now) {
    Standing& mine = standing_[static_cast<std::size_t>(core)];
    const Standing& other = standing_[static_cast<std::size_t>(1 - core)];
    mine.line = line;
    mine.since = std::min(mine.since, now);
    const bool taken = free_at_ > now;
    const bool behind_dma = dma_ != kNobody && (dma_first_ || urgent_[0] || urgent_[1]);
    const bool first = line && core == 0;
    if (now - mine.since < patience_) {
      if (taken && (behind_dma || (!first && !mine.let_pass))) {
        mine.let_pass = mine.let_pass || !behind_dma;
        return mine.asks_at = free_at_;
      }
      if (!taken && other.asks_at == now && other.line && !line) {
        mine.let_pass = true;
        return mine.asks_at = now + 1;  // the other one asks at this time, too
      }
    }
    mine = {};
    return now;
  }
  // The same for the burst that DMA `controller` (0 or 1) wants next; a core goes before it. Of two
  // controllers that wait the one goes first that waits for longer.
  [[nodiscard]] Cycles dma_from(std::size_t controller, bool urgent, Cycles now) {
    Cycles& since = asking_since_[controller];
    since = std::min(since, now);
    if (dma_first_ || urgent || now - since >= patience_) {
      since = kNever;
      return now;
    }
    if (free_at_ > now) {
      return std::min(free_at_, since + patience_);
    }
    const bool core_asks = standing_[0].asks_at == now || standing_[1].asks_at == now;
    if (core_asks || asking_since_[1 - controller] < since) {
      return now + 1;  // they act at this time, too
    }
    since = kNever;
    return now;
  }
  // It wants nothing any more. `urgent`: it has something urgent behind its burst that is under
  // way.
  void nothing_asked(std::size_t controller) { asking_since_[controller] = kNever; }
  void set_urgent(std::size_t controller, bool urgent) { urgent_[controller] = urgent; }

  // --- the bus ---
  // From when on an access that was asked for at `now` can have the bus: behind those who have it.
  // `bank`: of asynchronous memory, or kSynchronous.
  [[nodiscard]] Cycles acquire(Cycles now, int bank = kSynchronous, bool write = false) {
    from_ = std::max(now, free_at_);
    if (last_read_ != kSynchronous && (bank != last_read_ || write)) {
      from_ = std::max(from_, free_at_ + transition_);
    }
    last_read_ = kSynchronous;
    dma_ = kNobody;
    return from_;
  }
  // The access that acquired the bus last is a burst of `who`.
  void is_dma(Initiator who, Direction direction) { dma_ = stream(who, direction); }
  // Nobody has had the bus since a burst of `who` in that direction.
  [[nodiscard]] bool was_last(Initiator who, Direction direction) const {
    return dma_ == stream(who, direction);
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
    patience_ = change.to.cycles(patience_sclk_);
  }

 private:
  static constexpr int kNobody = -1;
  // A core that was told to call again.
  struct Standing {
    Cycles since = kNever;    // kNever: it does not wait
    Cycles asks_at = kNever;  // next
    bool line = false;
    bool let_pass = false;  // the other core, once
  };
  static constexpr int stream(Initiator who, Direction direction) {
    return 2 * static_cast<int>(who) + static_cast<int>(direction);
  }

  Cycles free_at_ = 0;
  Cycles from_ = 0;  // when the access that has the bus acquired it
  int last_read_ = kSynchronous;
  Cycles transition_ = 0;
  Cycles busy_cycles_ = 0;

  Cycles patience_sclk_;
  Cycles patience_;
  bool dma_first_ = false;
  int dma_ = kNobody;  // whose burst has or had the bus last
  std::array<Standing, kCoreCount> standing_{};
  std::array<Cycles, 2> asking_since_;  // by DMA controller; kNever: it does not wait
  std::array<bool, 2> urgent_{};
};

}  // namespace finback::memory
