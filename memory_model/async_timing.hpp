// What accesses to the four banks of asynchronous memory (flash) on the external bus cost.
//
// Models: setup, access and hold time and the transition time behind a read, by bank and in SCLK,
// as AMBCTL0 and AMBCTL1 say; banks of 16 or 32 data lines, on which an access is made of as many
// cycles of the bus as it needs; banks that are not enabled. Does not model: ARDY, the access time
// of the memory itself (a bank that is set too fast reads what is there), commands that program or
// erase a flash. Source: hardware.md 2.1, 2.4; bits as in defBF561.h.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>
#include <memory_model/external_bus.hpp>
#include <memory_model/line_fill.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/memory_parameters.hpp>

namespace finback::memory {

class AsyncTiming {
 public:
  // Registers as they are after reset: bank 0 enabled, 16 data lines each, the slowest times.
  static constexpr std::uint32_t kGlobalAfterReset = 0x00F2;
  static constexpr std::uint32_t kBanksAfterReset = 0xFFC2FFC2;

  AsyncTiming(const MemoryParameters& parameters, clock::ClockRatio ratio, ExternalBus& bus);

  // AMGCTL and AMBCTL0, AMBCTL1. set_banks throws GuestFault for times that do not exist.
  void set_global(std::uint32_t value) { global_ = value; }
  [[nodiscard]] std::uint32_t global() const { return global_; }
  void set_banks(int pair, std::uint32_t value);
  [[nodiscard]] std::uint32_t banks(int pair) const {
    return bank_words_[static_cast<std::size_t>(pair)];
  }
  [[nodiscard]] bool enabled(Address address) const {
    return static_cast<std::uint32_t>(async_bank(address)) < (global_ >> 1 & 7U);
  }
  // Why nothing answers at an `address` whose bank is not enabled.
  [[nodiscard]] std::string fault(Address address) const;

  // As SdramTiming's.
  Cycles core_read(Address address, std::uint32_t bytes, Cycles now);
  Cycles fetch(Address address, std::uint32_t bytes, Cycles now) {
    return core_read(address, bytes, now);
  }
  LineFill line_fill(Address address, Cycles now);
  Cycles posted_write(Address address, std::uint32_t bytes, Cycles start);
  Cycles dma_start(Initiator who, Direction direction, bool further, Address address, Cycles now);
  Cycles dma_words(Direction direction, Address address, std::uint32_t count, std::uint32_t bytes,
                   Cycles start);
  void change_clock(const clock::ClockChange& change) { ratio_ = change.to; }

 private:
  struct Bank {
    Cycles setup = 0, read = 0, write = 0, hold = 0, transition = 0;  // SCLK
  };
  [[nodiscard]] const Bank& bank(Address address) const {
    return banks_[static_cast<std::size_t>(async_bank(address))];
  }
  // Bus cycles that `bytes` bytes at `address` take, and the bytes of one.
  [[nodiscard]] Cycles beats(Address address, std::uint32_t bytes) const;
  [[nodiscard]] Cycles beat_bytes(Address address) const;

  ExternalBus& bus_;
  clock::ClockRatio ratio_;
  Cycles read_overhead_;  // of cores, in SCLK
  Cycles dma_overhead_;   // in SCLK
  std::uint32_t global_ = kGlobalAfterReset;
  std::array<std::uint32_t, 2> bank_words_{};
  std::array<Bank, kAsyncBanks> banks_{};
};

}  // namespace finback::memory
