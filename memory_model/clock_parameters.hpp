// The two clocks of the chip at the start, and their ratio.
//
// Models: one VCO, CCLK = VCO / 1, SCLK = VCO / n with a whole n, so that a system clock is a whole
// number of core cycles; a program may change that (clock_model). Does not model: the phase between
// the clocks: what takes n SCLK takes n x ratio core cycles from whenever it starts. Source:
// hardware.md 0.1 (1): 600 / 120 MHz, ratio 5.
#pragma once

#include <common/parameter.hpp>
#include <common/units.hpp>

namespace finback::memory {

struct ClockParameters final : ParameterGroup {
  RealParameter cclk_mhz{
      this,
      {"clock.cclk_mhz", "MHz", 600, 10, 1000, 'V', "hardware.md 0.1", "core clock of both cores"}};
  RealParameter sclk_mhz{this,
                         {"clock.sclk_mhz", "MHz", 120, 5, 1000, 'V', "hardware.md 0.1",
                          "system clock of DMA, external bus and peripherals"}};

  // Core cycles per system clock. Throws InputError when CCLK is not 1 to 15 times SCLK, whole.
  [[nodiscard]] Cycles ratio() const;
};

}  // namespace finback::memory
