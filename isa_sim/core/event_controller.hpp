// The core event controller: which event is taken, at which level the core runs, and where the
// handlers are.
//
// Models: EVT0-15, EVT_OVERRIDE, IMASK, ILAT, IPEND, IPRIO; requests from the system interrupt
// controller (level) and RAISE (latched); priority by number; nesting under IPEND[4], which an
// interrupt sets and a push of RETI clears; self-nesting (SYSCFG.SNEN); user and supervisor mode.
// Does not model: what a handler's entry does to registers (Core), emulation without an emulator
// (event 0 stays latched). Sources: Programming Reference, chapter 4; hardware.md 4.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include <common/units.hpp>

namespace finback::core {

// Events and, by the same numbers, levels; a core at level kUser runs a program in user mode.
enum Event : int {
  kEmulation = 0,
  kReset = 1,
  kNonMaskable = 2,
  kException = 3,
  kGlobalDisable = 4,  // no event: IPEND[4] holds all interrupts back
  kHardwareError = 5,
  kCoreTimer = 6,
  kIvg15 = 15,
  kUser = 16,
};

class EventController {
 public:
  static constexpr Address kFirstRegister = 0xFFE02000;
  static constexpr Address kLastRegister = 0xFFE02110;
  // IPEND of a chip after reset, and of a program that others have started: an ordinary supervisor
  // at the lowest level, whom every interrupt may interrupt.
  static constexpr std::uint32_t kAfterReset = 1U << kReset | 1U << kGlobalDisable;
  static constexpr std::uint32_t kSupervisor = 1U << kIvg15;

  void start(std::uint32_t pending) { pending_ = pending; }

  // Level-sensitive requests: bit n is IVGn.
  void set_requests(std::uint32_t lines) { lines_ = lines; }
  void raise(int event) { latched_ |= 1U << event; }
  void set_self_nesting(bool allowed) { self_nesting_ = allowed; }

  // 1..15, or kUser.
  [[nodiscard]] int level() const {
    const std::uint32_t active = pending_ & kLevels;
    return active != 0 ? std::countr_zero(active) : kUser;
  }
  [[nodiscard]] bool user_mode() const { return (pending_ & kLevels) == 0; }

  // The event to take now under `mask`, or -1.
  [[nodiscard]] int pending_event(std::uint32_t mask) const {
    const std::uint32_t ready = (lines_ | latched_) & (mask | kUnmaskable) & kLevels;
    if (ready == 0) {
      return -1;
    }
    const int event = std::countr_zero(ready);
    const bool held = event >= kHardwareError && (pending_ >> kGlobalDisable & 1U) != 0;
    const int now = level();
    return !held && (event < now || (self_nesting_ && event == now)) ? event : -1;
  }
  // Something enabled waits, whether or not a handler runs: what ends IDLE.
  [[nodiscard]] bool wants_attention(std::uint32_t mask) const {
    return ((lines_ | latched_) & (mask | kUnmaskable) & kLevels) != 0;
  }

  [[nodiscard]] Address handler(int event) const {
    return vectors_[static_cast<std::size_t>(event)];
  }
  // Goes to the level of `event` and returns its handler's address. Interrupts are then held back
  // until the handler pushes RETI.
  Address enter(int event);
  // Leaves the level at which the core runs, unless `keep`: the handler had interrupted itself and
  // goes on. Interrupts are let in.
  void leave(bool keep);
  // A push of RETI lets interrupts in, a pop holds them back.
  void hold_interrupts(bool hold);

  // Core registers at kFirstRegister..kLastRegister, word by word; IMASK is the core's own and is
  // passed in. False: no register.
  [[nodiscard]] bool read(Address address, std::uint32_t mask, std::uint32_t& value) const;
  [[nodiscard]] bool write(Address address, std::uint32_t& mask, std::uint32_t value);

  // What IMASK's bits 4..0 read as: those events cannot be masked.
  static constexpr std::uint32_t kUnmaskable = 0x1F;

 private:
  static constexpr std::uint32_t kLevels = ~(1U << kEmulation | 1U << kGlobalDisable);
  std::array<Address, 16> vectors_{};
  std::uint32_t override_ = 0;
  std::uint32_t priority_ = 0;
  std::uint32_t lines_ = 0;
  std::uint32_t latched_ = 0;
  std::uint32_t pending_ = kSupervisor;
  bool self_nesting_ = false;
};

// "RST", "NMI", "EVX", "IVHW", "IVTMR", "IVG7" and so on.
[[nodiscard]] std::string_view event_name(int event);

}  // namespace finback::core
