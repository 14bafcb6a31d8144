// How many core cycles a system clock takes, and what becomes of times when that changes.
//
// Models: CCLK = VCO / 2^CSEL and SCLK = VCO / SSEL, so that an SCLK is SSEL / 2^CSEL core cycles;
// where that is no whole number, what takes n SCLK ends with the first core cycle after it. Does
// not model: the phase between the clocks. Source: hardware.md 0.1 (1).
#pragma once

#include <cstdint>

#include <common/units.hpp>

namespace finback::clock {

class ClockRatio {
 public:
  // Not explicit: a whole ratio reads like the number that it is.
  constexpr ClockRatio(Cycles whole) : multiple_(whole) {}
  // SSEL, and CSEL as in PLL_DIV.
  constexpr ClockRatio(Cycles system_select, unsigned core_select)
      : multiple_(system_select), shift_(core_select), round_((Cycles{1} << core_select) - 1) {}

  // Core cycles that `sclk` system clocks take, rounded up.
  [[nodiscard]] constexpr Cycles cycles(Cycles sclk) const {
    return (sclk * multiple_ + round_) >> shift_;
  }
  // System clocks that have passed in so many core cycles, and that it takes until they have.
  [[nodiscard]] constexpr Cycles passed(Cycles cycles) const {
    return (cycles << shift_) / multiple_;
  }
  [[nodiscard]] constexpr Cycles left(Cycles cycles) const {
    return ((cycles << shift_) + multiple_ - 1) / multiple_;
  }
  [[nodiscard]] bool operator==(const ClockRatio&) const = default;

 private:
  Cycles multiple_;
  unsigned shift_ = 0;
  Cycles round_ = 0;
};

// The clocks change at a time. Time goes on in core cycles, which are shorter or longer from there
// on: whoever planned something in another unit plans it anew.
struct ClockChange {
  Cycles at = 0;
  ClockRatio from = 1;
  ClockRatio to = 1;
  std::uint64_t from_hertz = 0;  // CCLK
  std::uint64_t to_hertz = 0;
  double core_mhz = 0;  // from now on
  double system_mhz = 0;

  // When something comes that was to come at `when`, if it counts system clocks. What is over, or
  // never comes, stays.
  [[nodiscard]] Cycles system_time(Cycles when) const;
};

}  // namespace finback::clock
