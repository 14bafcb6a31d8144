// The core event controller: which interrupt is taken, and where its handler is.
//
// Models: EVT0-15, IMASK, ILAT, IPEND; requests from the system interrupt controller (level) and
// RAISE (latched); priority by number; RTI. Does not model: nesting (an interrupt waits until the
// running handler has returned), user mode, the core timer. The program starts as if in IVG15 with
// nothing pending. Source: hardware.md 4.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <common/units.hpp>

namespace finback::core {

class EventController {
 public:
  static constexpr Address kFirstRegister = 0xFFE02000;
  static constexpr Address kLastRegister = 0xFFE0210C;

  // Level-sensitive requests: bit n is IVGn.
  void set_requests(std::uint32_t lines) { lines_ = lines; }
  void raise(int event) { latched_ |= 1U << event; }

  // The event to take now under `mask`, or -1.
  [[nodiscard]] int pending_event(std::uint32_t mask) const {
    const std::uint32_t ready = (lines_ | latched_) & (mask | kUnmaskable);
    return ready != 0 && pending_ == 0 ? std::countr_zero(ready) : -1;
  }
  // Something enabled waits, whether or not a handler runs: what ends IDLE.
  [[nodiscard]] bool wants_attention(std::uint32_t mask) const {
    return ((lines_ | latched_) & (mask | kUnmaskable)) != 0;
  }
  // Enters the handler of `event` and returns its address.
  Address enter(int event) {
    latched_ &= ~(1U << event);
    pending_ |= 1U << event;
    return vectors_[static_cast<std::size_t>(event)];
  }
  // RTI: leaves the handler that runs. False when none does.
  bool leave() {
    if (pending_ == 0) {
      return false;
    }
    pending_ &= pending_ - 1;
    return true;
  }

  // Core registers at kFirstRegister..kLastRegister; IMASK is the core's own and is passed in.
  // False: no register.
  [[nodiscard]] bool read(Address address, std::uint32_t mask, std::uint32_t& value) const;
  [[nodiscard]] bool write(Address address, std::uint32_t& mask, std::uint32_t value);

 private:
  static constexpr std::uint32_t kUnmaskable = 0x1F;  // EMU, RST, NMI, EVX and the reserved one
  std::array<Address, 16> vectors_{};
  std::uint32_t lines_ = 0;
  std::uint32_t latched_ = 0;
  std::uint32_t pending_ = 0;
};

}  // namespace finback::core
