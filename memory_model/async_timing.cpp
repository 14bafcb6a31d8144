#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <memory_model/async_timing.hpp>

namespace finback::memory {

namespace {

// Fields of a bank's half of AMBCTL0 and AMBCTL1. Of two bits, 0 means 4 for setup and transition.
constexpr std::uint32_t kReady = 1U << 0;
Cycles transition_of(std::uint32_t half) { return (half >> 2 & 3U) == 0 ? 4 : half >> 2 & 3U; }
Cycles setup_of(std::uint32_t half) { return (half >> 4 & 3U) == 0 ? 4 : half >> 4 & 3U; }
Cycles hold_of(std::uint32_t half) { return half >> 6 & 3U; }
Cycles read_of(std::uint32_t half) { return half >> 8 & 0xFU; }
Cycles write_of(std::uint32_t half) { return half >> 12 & 0xFU; }

}  // namespace

AsyncTiming::AsyncTiming(const MemoryParameters& parameters, clock::ClockRatio ratio,
                         ExternalBus& bus)
    : bus_(bus),
      ratio_(ratio),
      read_overhead_(static_cast<Cycles>(parameters.async_core_read_overhead_sclk)),
      dma_overhead_(static_cast<Cycles>(parameters.sdram_dma_overhead_sclk)) {
  set_banks(0, kBanksAfterReset);
  set_banks(1, kBanksAfterReset);
}

void AsyncTiming::set_banks(int pair, std::uint32_t value) {
  for (int i = 0; i < 2; ++i) {
    const std::uint32_t half = value >> (16 * i) & 0xFFFFU;
    const int number = 2 * pair + i;
    if ((half & kReady) != 0) {
      throw GuestFault(
          fmt::format("EBIU_AMBCTL{} = {:#010x}: ARDY of bank {} (bit {}) is not modelled; leave "
                      "it 0",
                      pair, value, number, 16 * i));
    }
    if (read_of(half) == 0 || write_of(half) == 0) {
      throw GuestFault(fmt::format(
          "EBIU_AMBCTL{} = {:#010x}: bank {} has a read access time of {} and a write access time "
          "of {}; both are 1 to 15",
          pair, value, number, read_of(half), write_of(half)));
    }
  }
  for (int i = 0; i < 2; ++i) {
    const std::uint32_t half = value >> (16 * i) & 0xFFFFU;
    const int number = 2 * pair + i;
    banks_[static_cast<std::size_t>(number)] = {.setup = setup_of(half),
                                                .read = read_of(half),
                                                .write = write_of(half),
                                                .hold = hold_of(half),
                                                .transition = transition_of(half)};
  }
  bank_words_[static_cast<std::size_t>(pair)] = value;
}

std::string AsyncTiming::fault(Address address) const {
  return fmt::format(
      "asynchronous bank {} is not enabled (EBIU_AMGCTL = {:#06x}: AMBEN, bits 3:1, enables {} of "
      "them)",
      async_bank(address), global_, global_ >> 1 & 7U);
}

Cycles AsyncTiming::beat_bytes(Address address) const {
  constexpr unsigned kPacking = 4;  // AMGCTL: the bank has 16 data lines
  return (global_ >> (kPacking + static_cast<unsigned>(async_bank(address))) & 1U) != 0 ? 2 : 4;
}

Cycles AsyncTiming::beats(Address address, std::uint32_t bytes) const {
  return std::max<Cycles>(bytes / beat_bytes(address), 1);
}

// The last word is there before its hold time.
Cycles AsyncTiming::core_read(Address address, std::uint32_t bytes, Cycles now) {
  const Bank& b = bank(address);
  const Cycles start = bus_.acquire(now, async_bank(address));
  const Cycles on_bus = beats(address, bytes) * (b.setup + b.read + b.hold);
  bus_.hold_until(start + ratio_.cycles(on_bus));
  bus_.was_read_of(async_bank(address), ratio_.cycles(b.transition));
  return start + ratio_.cycles(on_bus - b.hold + read_overhead_) - now - 1;
}

LineFill AsyncTiming::line_fill(Address address, Cycles now) {
  const Bank& b = bank(address);
  const Cycles start = bus_.acquire(now, async_bank(address));
  const Cycles beat = b.setup + b.read + b.hold;
  bus_.hold_until(start + ratio_.cycles(beats(address, kLineBytes) * beat));
  bus_.was_read_of(async_bank(address), ratio_.cycles(b.transition));
  return {.first = start + ratio_.cycles(b.setup + b.read + read_overhead_),
          .beat = beat,
          .beat_bytes = beat_bytes(address),
          .clock = ratio_};
}

Cycles AsyncTiming::posted_write(Address address, std::uint32_t bytes, Cycles start) {
  const Bank& b = bank(address);
  const Cycles from = bus_.acquire(start, async_bank(address), true);
  bus_.hold_until(from + ratio_.cycles(beats(address, bytes) * (b.setup + b.write + b.hold)));
  return bus_.free_at();
}

Cycles AsyncTiming::dma_start(Initiator who, Direction direction, bool further, Address address,
                              Cycles now) {
  const bool goes_on = further && bus_.was_last(who, direction);
  const Cycles start = bus_.acquire(now, async_bank(address), direction == Direction::write);
  bus_.is_dma(who, direction);
  return goes_on ? start : start + ratio_.cycles(dma_overhead_);
}

Cycles AsyncTiming::dma_words(Direction direction, Address address, std::uint32_t count,
                              std::uint32_t bytes, Cycles start) {
  const Bank& b = bank(address);
  const bool write = direction == Direction::write;
  const Cycles beat = b.setup + (write ? b.write : b.read) + b.hold;
  bus_.hold_until(start + ratio_.cycles(count * beats(address, bytes) * beat));
  if (!write) {
    bus_.was_read_of(async_bank(address), ratio_.cycles(b.transition));
  }
  return bus_.free_at();
}

}  // namespace finback::memory
