// The core timer: TCNTL, TPERIOD, TSCALE, TCOUNT.
//
// Models: a count that goes down by one every TSCALE + 1 core cycles and requests IVTMR when it
// reaches 0, once or, with TAUTORLD, again and again from TPERIOD. It is an event in time: between
// its events nothing is done, and the count is worked out when it is read. Does not model: power
// (TMPWR only gates the count). Source: Programming Reference, "Core Timer".
#pragma once

#include <cstdint>

#include <common/units.hpp>

namespace finback::core {

// Closer to the timer's request than this, a core runs block by block. More than a block can take
// without stalls.
inline constexpr Cycles kTimerMargin = 1024;

class CoreTimer {
 public:
  static constexpr Address kFirstRegister = 0xFFE03000;
  static constexpr Address kLastRegister = 0xFFE0300C;

  // When it requests the next time; kNever while it stands still.
  [[nodiscard]] Cycles next_event() const { return expires_; }
  // Its clock stood still for so long.
  void postpone(Cycles stood) { expires_ += expires_ == kNever ? 0 : stood; }
  // It has just expired: starts anew or stops.
  void expire();

  // Registers from kFirstRegister to kLastRegister, multiples of 4. TPERIOD is copied to TCOUNT
  // when it is written.
  [[nodiscard]] std::uint32_t read(Address address, Cycles now) const;
  void write(Address address, std::uint32_t value, Cycles now);

 private:
  [[nodiscard]] bool runs() const { return (control_ & kRunning) == kRunning; }
  [[nodiscard]] Cycles step() const { return scale_ + Cycles{1}; }
  [[nodiscard]] std::uint32_t count(Cycles now) const;

  static constexpr std::uint32_t kRunning = 0x3;  // TMPWR and TMREN
  static constexpr std::uint32_t kAutoReload = 0x4;
  static constexpr std::uint32_t kExpired = 0x8;  // TINT

  std::uint32_t control_ = 0;
  std::uint32_t period_ = 0;
  std::uint32_t scale_ = 0;  // 8 bits
  std::uint32_t count_ = 0;  // while it stands still
  Cycles expires_ = kNever;
};

}  // namespace finback::core
