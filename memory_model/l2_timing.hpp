// What accesses to the shared on-chip L2 cost.
//
// Models: one 64-bit port for both cores, taken for the whole of a read and for the posted cost of
// a write, first come first served (on equal times core A comes first, being asked first); a
// separate DMA port at SCLK whose bursts delay core accesses to the same sub-bank, and wait there
// for a line that is under way; IMDMA, which takes the cores' port for a whole burst. Does not
// model: pipelined reads of one core, the anomaly 05000428. Source: hardware.md 2.3.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>
#include <memory_model/line_fill.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/memory_parameters.hpp>

namespace finback::memory {

class L2Timing {
 public:
  // `region`: where L2 lies; nullptr for a machine without one.
  L2Timing(const MemoryParameters& parameters, clock::ClockRatio ratio, const Region* region);

  // Stall beyond the issue cycle `now`.
  Cycles core_read(int core, Address address, Cycles now) {
    const Cycles done = grant(core, address, now) + read_cycles_;
    port_free_at_ = done;
    return done - now - 1;
  }
  // A line into a core's cache, the word that is waited for first.
  LineFill line_fill(int core, Address address, Cycles now) {
    const Cycles first = grant(core, address, now) + read_cycles_;
    port_free_at_ = first + (kLineBytes / kPortBytes - 1) * beat_;
    line_until(address);
    return {.first = first, .beat = beat_, .beat_bytes = kPortBytes};
  }
  // Arrival of a line out of a cache, which may start at `start`.
  Cycles line_write(int core, Address address, Cycles start) {
    port_free_at_ =
        grant(core, address, start) + write_cycles_ + (kLineBytes / kPortBytes - 1) * beat_;
    line_until(address);
    return port_free_at_;
  }
  // Arrival of a write that may start at `start`.
  Cycles posted_write(int core, Address address, Cycles start) {
    port_free_at_ = grant(core, address, start) + write_cycles_;
    return port_free_at_;
  }
  // A read and a completed write with the port kept: time until the write has arrived.
  Cycles locked_read_write(int core, Address address, Cycles now) {
    port_free_at_ = grant(core, address, now) + 2 * read_cycles_;
    return port_free_at_ - now;
  }
  // Instructions, a multiple of 64 bits: stall beyond the issue cycle.
  Cycles fetch(int core, Address address, std::uint32_t bytes, Cycles now) {
    port_free_at_ = grant(core, address, now) + read_cycles_ + (bytes / kPortBytes - 1) * beat_;
    return port_free_at_ - now - 1;
  }

  // When a DMA burst that begins at `address` can have the DMA port and the sub-bank.
  [[nodiscard]] Cycles dma_free_at(Address address) const {
    return sub_bank(address) == line_sub_bank_ ? std::max(dma_free_at_, line_until_) : dma_free_at_;
  }
  // An IMDMA burst on the cores' port, for `cycles`: returns when its last word has passed.
  Cycles internal_dma(Cycles cycles, Cycles now) {
    port_free_at_ = std::max(now, port_free_at_) + cycles;
    port_core_ = kNoCore;
    return port_free_at_;
  }
  [[nodiscard]] Cycles port_free_at() const { return port_free_at_; }

  // A DMA burst: when its first word can pass. `further`: not the first of its work unit.
  [[nodiscard]] Cycles dma_start(bool further, Address address, Cycles now) const {
    return std::max(now, dma_free_at(address)) + (further ? 0 : ratio_.cycles(dma_overhead_));
  }
  // `words` words between the addresses `low` and `high`: returns when they have passed.
  Cycles dma_words(Address low, Address high, std::uint32_t words, Cycles start);
  void change_clock(const clock::ClockChange& change) {
    ratio_ = change.to;
    dma_free_at_ = change.system_time(dma_free_at_);
  }

 private:
  static constexpr int kNoCore = -1;

  Cycles grant(int core, Address address, Cycles now) {
    Cycles start = now;
    if (port_free_at_ > now) {
      start = port_free_at_ + (port_core_ == core ? 0 : contention_cycles_);
    }
    port_core_ = core;
    if (sub_bank_dma_until_[sub_bank(address)] > start) {
      start += dma_collision_cycles_;
    }
    return start;
  }

  [[nodiscard]] std::uint32_t sub_bank(Address address) const {
    return (address - base_) >> sub_bank_shift_;
  }
  // The line at `address` is under way as long as the port is taken now.
  void line_until(Address address) {
    line_sub_bank_ = sub_bank(address);
    line_until_ = port_free_at_;
  }

  static constexpr Cycles kPortBytes = 8;

  Cycles read_cycles_;
  Cycles beat_;
  Cycles write_cycles_;
  Cycles contention_cycles_;
  Cycles dma_collision_cycles_;
  clock::ClockRatio ratio_;
  Cycles dma_overhead_;  // in SCLK
  Cycles dma_word_;      // in SCLK
  Address base_ = 0;
  int sub_bank_shift_;
  int port_core_ = 0;
  Cycles port_free_at_ = 0;
  Cycles dma_free_at_ = 0;
  Cycles line_until_ = 0;  // of the last line to or from a cache
  std::uint32_t line_sub_bank_ = 0;
  std::vector<Cycles> sub_bank_dma_until_;
};

}  // namespace finback::memory
