// What accesses to the SDRAM on the external bus cost.
//
// Models: one open row per internal bank; tRCD, tRP, tRAS, tWR, CL; refresh at fixed times, which
// closes all rows; DMA that goes on where nobody was between pays for rows only. Who has the bus is
// external_bus.hpp's. Does not model: the phase of SCLK, command overlap between banks. Source:
// hardware.md 2.4, 2.5, 3.2.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>
#include <memory_model/clock_parameters.hpp>
#include <memory_model/external_bus.hpp>
#include <memory_model/line_fill.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/memory_parameters.hpp>

namespace finback::memory {

struct SdramCounters {
  // One for each access of a core; one for each burst and page of DMA.
  std::uint64_t row_hits = 0;
  std::uint64_t row_misses = 0;  // the bank had another row open, or none
  std::uint64_t refreshes = 0;   // that an access came upon or after; idle tails do not count
};

// What software can change of an SDRAM's time, in SCLK.
struct SdramSettings {
  Cycles cl = 0, trcd = 0, trp = 0, tras = 0, twr = 0;
  Cycles refresh_period = 0;
};

class SdramTiming {
 public:
  // `region`: where the SDRAM lies; nullptr for a machine without one.
  SdramTiming(const MemoryParameters& parameters, const ClockParameters& clock,
              const Region* region, ExternalBus& bus);

  // A read of up to 32 bits: stall beyond the issue cycle `now`.
  Cycles core_read(Address address, std::uint32_t bytes, Cycles now) {
    return fetch(address, bytes, now);
  }
  // A line into a core's cache, the word that is waited for first.
  LineFill line_fill(Address address, Cycles now) {
    const Cycles start = open_for_read(address, acquire(now));
    release(start, core_read_hold_ + ratio_.cycles((beats(kLineBytes) - 1) * beat_));
    return {.first = start + core_read_, .beat = beat_, .beat_bytes = bus_bytes_, .clock = ratio_};
  }
  // Arrival of a line out of a cache, which may start at `start`.
  Cycles line_write(Address address, Cycles start) {
    release(open_for_write(address, acquire(start)), ratio_.cycles(beats(kLineBytes) * write_));
    return bus_.free_at();
  }
  // Arrival of a write of up to 32 bits that may start at `start`.
  Cycles posted_write(Address address, std::uint32_t bytes, Cycles start) {
    release(open_for_write(address, acquire(start)), ratio_.cycles(beats(bytes) * write_));
    return bus_.free_at();
  }
  // A read and a completed write with the bus kept: time until the write has arrived.
  Cycles locked_read_write(Address address, Cycles now) {
    release(open_for_read(address, acquire(now)), 2 * core_read_);
    return bus_.free_at() - now;
  }
  // Instructions: stall beyond the issue cycle.
  Cycles fetch(Address address, std::uint32_t bytes, Cycles now) {
    const Cycles start = open_for_read(address, acquire(now));
    const Cycles further = ratio_.cycles((beats(bytes) - 1) * beat_);
    release(start, core_read_hold_ + further);
    return start + core_read_ + further - now - 1;
  }

  // A DMA burst: when its first word can pass, if its row is open. `further`: not the first of its
  // work unit.
  Cycles dma_start(Initiator who, Direction direction, bool further, Cycles now);
  // `count` elements of `bytes`, `stride` bytes apart, starting at `start`; returns when the last
  // has passed.
  Cycles dma_words(Direction direction, Address address, std::int32_t stride, std::uint32_t count,
                   std::uint32_t bytes, Cycles start);

  [[nodiscard]] const SdramSettings& settings() const { return settings_; }
  // From now on; rows stay open.
  void set(const SdramSettings& settings);
  // Access under way goes on in the new clocks.
  void change_clock(const clock::ClockChange& change);
  [[nodiscard]] std::uint32_t page_bytes() const {
    return 1U << static_cast<unsigned>(page_shift_);
  }
  [[nodiscard]] std::uint32_t size() const {
    return bank_bytes_ * static_cast<std::uint32_t>(banks_.size());
  }
  [[nodiscard]] std::uint32_t bus_bytes() const { return bus_bytes_; }

  [[nodiscard]] const SdramCounters& counters() const { return counters_; }

 private:
  // That `bytes` take on the bus.
  [[nodiscard]] Cycles beats(std::uint32_t bytes) const {
    return std::max<Cycles>(bytes / bus_bytes_, 1);
  }
  static constexpr std::uint32_t kNoRow = ~std::uint32_t{0};
  struct Bank {
    std::uint32_t row = kNoRow;
    Cycles opened_at = 0;
  };

  // The bus from `now` on, behind those who have it and behind a refresh that is due.
  Cycles acquire(Cycles now) {
    const Cycles start = bus_.acquire(now);
    return start < next_refresh_ ? start : refresh(start);
  }
  void release(Cycles start, Cycles duration) { bus_.hold_until(start + duration); }
  Cycles open_for_read(Address address, Cycles now) { return open(address, now, 0); }
  Cycles open_for_write(Address address, Cycles now) { return open(address, now, twr_); }
  // When the row of `address` is open, asked for at `now`; `before_close` is the write recovery.
  Cycles open(Address address, Cycles now, Cycles before_close) {
    const std::uint32_t offset = address - base_;
    Bank& bank = banks_[offset / bank_bytes_];
    const std::uint32_t row = offset >> page_shift_;
    if (bank.row == row) {
      ++counters_.row_hits;
      return now;
    }
    ++counters_.row_misses;
    const Cycles closed =
        bank.row == kNoRow ? now : std::max(now + before_close, bank.opened_at + tras_) + trp_;
    bank.row = row;
    bank.opened_at = closed;
    return closed + trcd_;
  }
  Cycles refresh(Cycles start);
  void derive();

  ExternalBus& bus_;
  SdramSettings settings_;
  clock::ClockRatio ratio_;
  Cycles read_overhead_;  // of cores, besides CL; in SCLK
  Cycles read_hold_;      // in SCLK
  Cycles cl_, trcd_, trp_, tras_, twr_;
  Cycles core_read_;  // overhead + CL
  Cycles core_read_hold_;
  Cycles write_;  // in SCLK
  std::uint32_t bus_bytes_;
  Cycles beat_;  // in SCLK
  Cycles dma_overhead_sclk_;
  Cycles turnaround_sclk_;
  Cycles refresh_sclk_;
  Cycles dma_overhead_;
  Cycles turnaround_;
  Cycles refresh_period_;
  Cycles refresh_;
  Address base_ = 0;
  std::uint32_t bank_bytes_;
  int page_shift_;
  std::vector<Bank> banks_;
  Cycles next_refresh_;
  Direction last_dma_ = Direction::read;
  SdramCounters counters_;
};

}  // namespace finback::memory
