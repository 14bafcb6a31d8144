// The declared numbers of the PLL and of the power modes: what the board gives, what the chip
// bears.
#pragma once

#include <common/parameter.hpp>

namespace finback::clock {

struct PllParameters final : ParameterGroup {
  RealParameter clkin_mhz{
      this,
      {"clock.clkin_mhz", "MHz", 25, 10, 40, 'M', "hardware.md 5.6 (CM-BF561)",
       "CLKIN, the board's crystal; clock.cclk_mhz must be a whole multiple of it, or of its half, "
       "where a program uses the PLL's registers"}};
  RealParameter vco_minimum_mhz{
      this, {"clock.vco_minimum_mhz", "MHz", 50, 10, 1000, 'V', "hardware.md 5.1", "slowest VCO"}};
  RealParameter vco_maximum_mhz{
      this,
      {"clock.vco_maximum_mhz", "MHz", 600, 50, 1000, 'M', "hardware.md 5.6",
       "fastest VCO; a machine that starts with a faster CCLK may keep that"}};
  RealParameter sclk_limit_mhz{
      this,
      {"clock.sclk_limit_mhz", "MHz", 133.34, 10, 1000, 'V', "hardware.md 5.1",
       "fastest SCLK; a machine that starts with a faster one may keep that"}};
  RealParameter sclk_limit_low_mhz{this,
                                   {"clock.sclk_limit_low_mhz", "MHz", 100, 10, 1000, 'V',
                                    "hardware.md 5.1", "the same below 1.15 V"}};
  IntegerParameter both_cores_idle{
      this,
      {"clock.both_cores_idle", "", 1, 0, 1, 'M', "hardware.md 5.6",
       "1: a write to PLL_CTL or VR_CTL takes effect when both cores are in IDLE (one that never "
       "started is); 0: when the one that wrote is, unless CCLK is to stand still"}};
  RealParameter reset_after_us{
      this,
      {"clock.reset_after_us", "us", 0, 0, 1e9, 'E', "docs/clocks.md",
       "when the board pulls RESET, from the beginning of deep sleep or hibernation on; the run "
       "ends there. 0: never"}};
};

}  // namespace finback::clock
