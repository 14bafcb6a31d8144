#include <bit>
#include <fmt/format.h>

#include <common/error.hpp>
#include <memory_model/l2_timing.hpp>

namespace finback::memory {

L2Timing::L2Timing(const MemoryParameters& parameters, clock::ClockRatio ratio,
                   const Region* region)
    : read_cycles_(static_cast<Cycles>(parameters.l2_read_cycles)),
      beat_(static_cast<Cycles>(parameters.l2_burst_beat_cycles)),
      write_cycles_(static_cast<Cycles>(parameters.l2_write_cycles)),
      contention_cycles_(static_cast<Cycles>(parameters.l2_contention_cycles)),
      dma_collision_cycles_(static_cast<Cycles>(parameters.l2_dma_collision_cycles)),
      ratio_(ratio),
      dma_overhead_(static_cast<Cycles>(parameters.l2_dma_overhead_sclk)),
      dma_word_(static_cast<Cycles>(parameters.l2_dma_word_sclk)) {
  const auto bytes = static_cast<std::uint32_t>(parameters.l2_sub_bank_bytes);
  if (!std::has_single_bit(bytes)) {
    throw InputError(fmt::format("memory.l2.sub_bank_bytes = {} must be a power of two", bytes));
  }
  sub_bank_shift_ = std::countr_zero(bytes);
  if (region != nullptr) {
    base_ = region->base;
    sub_bank_dma_until_.resize(((region->size - 1) >> sub_bank_shift_) + 1);
  }
}

Cycles L2Timing::dma_words(Address low, Address high, std::uint32_t words, Cycles start) {
  dma_free_at_ = start + ratio_.cycles(words * dma_word_);
  const std::uint32_t last = sub_bank(high);
  for (std::uint32_t bank = sub_bank(low); bank <= last; ++bank) {
    sub_bank_dma_until_[bank] = dma_free_at_;
  }
  return dma_free_at_;
}

}  // namespace finback::memory
