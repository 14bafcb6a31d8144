#include <bit>
#include <fmt/format.h>

#include <common/error.hpp>
#include <memory_model/sdram_timing.hpp>
#include <memory_model/strided.hpp>

namespace finback::memory {

SdramTiming::SdramTiming(const MemoryParameters& parameters, const ClockParameters& clock,
                         const Region* region, ExternalBus& bus)
    : bus_(bus), ratio_(clock.ratio()) {
  const auto sclk = [](std::int64_t number) { return static_cast<Cycles>(number); };
  read_overhead_ = sclk(parameters.sdram_core_read_overhead_sclk);
  read_hold_ = sclk(parameters.sdram_core_read_hold_sclk);
  write_ = sclk(parameters.sdram_write_sclk);
  beat_ = sclk(parameters.sdram_beat_sclk);
  bus_bytes_ = static_cast<std::uint32_t>(parameters.sdram_bus_bytes);
  if (bus_bytes_ == 3) {
    throw InputError("memory.sdram.bus_bytes = 3 must be 2 or 4");
  }
  dma_overhead_sclk_ = sclk(parameters.sdram_dma_overhead_sclk);
  turnaround_sclk_ = sclk(parameters.sdram_turnaround_sclk);
  refresh_sclk_ = sclk(parameters.sdram_refresh_sclk);
  set({.cl = sclk(parameters.sdram_cl_sclk),
       .trcd = sclk(parameters.sdram_trcd_sclk),
       .trp = sclk(parameters.sdram_trp_sclk),
       .tras = sclk(parameters.sdram_tras_sclk),
       .twr = sclk(parameters.sdram_twr_sclk),
       .refresh_period = 0});
  // Finer than in whole SCLK, until software sets it.
  const double nanoseconds = static_cast<double>(parameters.sdram_refresh_period_ns);
  refresh_period_ = static_cast<Cycles>(nanoseconds * clock.cclk_mhz / 1000.0);
  settings_.refresh_period = ratio_.passed(refresh_period_);
  next_refresh_ = refresh_ > 0 ? refresh_period_ : kNever;

  const auto page_bytes = static_cast<std::uint32_t>(parameters.sdram_page_bytes);
  if (!std::has_single_bit(page_bytes)) {
    throw InputError(
        fmt::format("memory.sdram.page_bytes = {} must be a power of two", page_bytes));
  }
  page_shift_ = std::countr_zero(page_bytes);
  const auto bank_count = static_cast<std::uint32_t>(parameters.sdram_banks);
  const std::uint32_t size = region == nullptr ? page_bytes * bank_count : region->size;
  if (size % (page_bytes * bank_count) != 0) {
    throw InputError(fmt::format(
        "region {}: {} bytes do not make memory.sdram.banks = {} equal banks of {}-byte pages",
        region->name, size, bank_count, page_bytes));
  }
  base_ = region == nullptr ? 0 : region->base;
  bank_bytes_ = size / bank_count;
  banks_.resize(bank_count);
}

void SdramTiming::set(const SdramSettings& settings) {
  settings_ = settings;
  derive();
  if (settings.refresh_period > 0) {
    refresh_period_ = ratio_.cycles(settings.refresh_period);
  }
}

// From SCLK.
void SdramTiming::derive() {
  cl_ = ratio_.cycles(settings_.cl);
  trcd_ = ratio_.cycles(settings_.trcd);
  trp_ = ratio_.cycles(settings_.trp);
  tras_ = ratio_.cycles(settings_.tras);
  twr_ = ratio_.cycles(settings_.twr);
  dma_overhead_ = ratio_.cycles(dma_overhead_sclk_);
  turnaround_ = ratio_.cycles(turnaround_sclk_);
  refresh_ = ratio_.cycles(refresh_sclk_);
  // A read takes its issue cycle at least.
  core_read_ = std::max<Cycles>(ratio_.cycles(read_overhead_ + settings_.cl), 1);
  core_read_hold_ = std::min(ratio_.cycles(read_hold_), core_read_);
}

void SdramTiming::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  derive();
  next_refresh_ = change.system_time(next_refresh_);
  if (change.from != change.to) {
    refresh_period_ = std::max<Cycles>(1, ratio_.cycles(change.from.left(refresh_period_)));
  }
}

Cycles SdramTiming::refresh(Cycles start) {
  const std::uint64_t due = (start - next_refresh_) / refresh_period_ + 1;
  const Cycles last_due = next_refresh_ + (due - 1) * refresh_period_;
  const Cycles done = std::max(last_due, bus_.free_at()) + refresh_;
  next_refresh_ = last_due + refresh_period_;
  counters_.refreshes += due;
  for (Bank& bank : banks_) {
    bank.row = kNoRow;
  }
  const Cycles from = std::max(start, done);
  bus_.delay_to(from);
  return from;
}

Cycles SdramTiming::dma_start(Initiator who, Direction direction, bool further, Cycles now) {
  const bool goes_on = further && bus_.was_last(who, direction);
  const Cycles turn = direction == last_dma_ ? 0 : turnaround_;
  last_dma_ = direction;
  const Cycles start = acquire(now);
  bus_.is_dma(who, direction);
  if (goes_on) {
    return start;
  }
  return start + turn + dma_overhead_ + (direction == Direction::write ? twr_ : cl_);
}

Cycles SdramTiming::dma_words(Direction direction, Address address, std::int32_t stride,
                              std::uint32_t count, std::uint32_t bytes, Cycles start) {
  Cycles now = start;
  while (count > 0) {
    const std::uint64_t page = std::uint64_t{(address - base_) >> page_shift_} << page_shift_;
    const std::uint64_t page_base = base_ + page;
    const std::uint32_t here =
        elements_within(address, stride, count, page_base, page_base + (1ULL << page_shift_));
    now = open(address, now, direction == Direction::write ? twr_ : 0) +
          ratio_.cycles(here * beats(bytes) * beat_);
    count -= here;
    address += here * static_cast<std::uint32_t>(stride);
  }
  release(now, 0);
  return now;
}

}  // namespace finback::memory
