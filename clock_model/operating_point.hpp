// The operating points of the chip: which clocks run, how fast, at which core voltage.
//
// Models: the five modes of the dynamic power management. Source: hardware.md 5.6.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace finback::clock {

enum class Mode : std::uint8_t {
  full_on,     // CCLK and SCLK from the PLL
  active,      // the PLL is bypassed: both are CLKIN
  sleep,       // CCLK stands still
  deep_sleep,  // both stand still
  hibernate,   // ... and the core's supply is off
};
inline constexpr std::array<std::string_view, 5> kModeNames = {"full_on", "active", "sleep",
                                                               "deep_sleep", "hibernate"};
[[nodiscard]] constexpr std::string_view name_of(Mode mode) {
  return kModeNames[static_cast<std::size_t>(mode)];
}

struct OperatingPoint {
  Mode mode = Mode::full_on;
  // A clock that stands still has the frequency that it had before: time is counted in its cycles.
  double core_hertz = 0;
  double system_hertz = 0;
  double core_volts = 0;  // 0: not known, as the clock is outside the table of voltages

  [[nodiscard]] bool operator==(const OperatingPoint&) const = default;
};

}  // namespace finback::clock
