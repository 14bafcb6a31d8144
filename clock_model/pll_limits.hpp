// What PLL_CTL, PLL_DIV and VR_CTL mean together, and whether the chip bears it.
//
// Models: VCO = CLKIN x MSEL, or half of it (DF); CCLK = VCO / 2^CSEL, SCLK = VCO / SSEL; the range
// of the VCO, SCLK's limit by voltage, CCLK's limit by voltage. Source: hardware.md 5.1, 5.6.
#pragma once

#include <cstdint>
#include <string>

#include <clock_model/clock_ratio.hpp>
#include <clock_model/pll_parameters.hpp>

namespace finback::clock {

enum PllBit : std::uint32_t {
  kDivideInput = 1U << 0,  // DF
  kPllOff = 1U << 1,
  kStopCore = 1U << 3,   // STOPCK
  kPowerDown = 1U << 5,  // PDWN
  kBypass = 1U << 8,
  kMultiplier = 0x3FU << 9,  // MSEL
  kReservedControl = 1U << 2 | 1U << 4,
};
inline constexpr std::uint32_t kRegulatorFrequency = 3U;   // VR_CTL: FREQ
inline constexpr std::uint32_t kVoltageLevel = 0xFU << 4;  // VLEV
inline constexpr std::uint32_t kReservedDivider = 0xFFC0;  // PLL_DIV

// A set of the three registers.
struct PllSettings {
  std::uint32_t control = 0;
  std::uint32_t divider = 0;
  std::uint32_t regulator = 0;

  [[nodiscard]] std::uint32_t system_select() const { return divider & 0xFU; }
  [[nodiscard]] unsigned core_select() const { return divider >> 4U & 3U; }
  [[nodiscard]] bool bypassed() const { return (control & kBypass) != 0; }
  [[nodiscard]] double vco_mhz(double clkin_mhz) const;
  [[nodiscard]] std::uint32_t level() const { return (regulator & kVoltageLevel) >> 4U; }
  // As VLEV says; 0 for a reserved level.
  [[nodiscard]] double volts() const;
  [[nodiscard]] bool operator==(const PllSettings&) const = default;
};

class PllLimits {
 public:
  // As a boot loader leaves the chip: at the machine's clocks, at the lowest voltage for them.
  PllLimits(const PllParameters& parameters, double cclk_mhz, double sclk_mhz, Cycles ratio);

  [[nodiscard]] const PllSettings& start() const { return start_; }
  // Why the PLL cannot be had at all on this machine; "" when it can.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  // Why the chip does not bear `settings`; "" when it does.
  [[nodiscard]] std::string refusal(const PllSettings& settings) const;
  [[nodiscard]] double clkin_mhz() const { return clkin_mhz_; }

 private:
  double clkin_mhz_;
  double vco_minimum_;
  double vco_maximum_;
  double sclk_limit_;
  double sclk_limit_low_;
  double start_cclk_;
  double start_sclk_;
  PllSettings start_;
  std::string trouble_;
};

}  // namespace finback::clock
