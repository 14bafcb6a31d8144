#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <clock_model/core_voltage.hpp>
#include <clock_model/pll_limits.hpp>

namespace finback::clock {

namespace {

constexpr std::uint32_t kMultipliers = 64;        // MSEL 0 stands for it
constexpr double kLowVolts = 1.15;                // below it SCLK has its lower limit
constexpr std::uint32_t kRegulatorAtStart = 0xB;  // FREQ 1 MHz, GAIN 20
// Frequencies are given in decimal, so compare with a hair's breadth.
constexpr double kHair = 1e-6;

bool above(double value, double limit) { return value > limit * (1 + kHair); }

}  // namespace

double PllSettings::vco_mhz(double clkin_mhz) const {
  const std::uint32_t field = (control & kMultiplier) >> 9U;
  const std::uint32_t multiplier = field == 0 ? kMultipliers : field;
  return clkin_mhz * multiplier / ((control & kDivideInput) != 0 ? 2 : 1);
}

double PllSettings::volts() const {
  return level() < kFirstVoltageLevel ? 0 : kSpeedGrades.at(level() - kFirstVoltageLevel).volts;
}

PllLimits::PllLimits(const PllParameters& parameters, double cclk_mhz, double sclk_mhz,
                     Cycles ratio)
    : clkin_mhz_(parameters.clkin_mhz),
      vco_minimum_(parameters.vco_minimum_mhz),
      vco_maximum_(std::max(double{parameters.vco_maximum_mhz}, cclk_mhz)),
      sclk_limit_(parameters.sclk_limit_mhz),
      sclk_limit_low_(parameters.sclk_limit_low_mhz),
      start_cclk_(cclk_mhz),
      start_sclk_(sclk_mhz) {
  const SpeedGrade* grade = grade_for(cclk_mhz);
  const auto level = static_cast<std::uint32_t>(
      grade == nullptr ? kSpeedGrades.size() - 1
                       : static_cast<std::size_t>(grade - kSpeedGrades.data()));
  start_.regulator = (level + kFirstVoltageLevel) << 4U | kRegulatorAtStart;
  start_.divider = static_cast<std::uint32_t>(ratio);
  for (const std::uint32_t half : {0U, 1U}) {
    const double multiple = cclk_mhz / clkin_mhz_ * (half + 1);
    const double whole = std::round(multiple);
    if (std::abs(multiple - whole) <= kHair * multiple && whole >= 1 && whole <= kMultipliers) {
      start_.control = (static_cast<std::uint32_t>(whole) % kMultipliers) << 9U | half;
      return;
    }
  }
  trouble_ = fmt::format(
      "clock.cclk_mhz = {} is no whole multiple of clock.clkin_mhz = {}, nor of its half, so that "
      "the PLL has no registers for it; set clock.clkin_mhz to the board's crystal",
      cclk_mhz, clkin_mhz_);
}

std::string PllLimits::refusal(const PllSettings& s) const {
  if (s.system_select() == 0) {
    return "SSEL 0 is reserved; use 1 to 15";
  }
  if (1U << s.core_select() > s.system_select()) {
    return fmt::format("CCLK = VCO / {} would be slower than SCLK = VCO / {}; lower CSEL",
                       1U << s.core_select(), s.system_select());
  }
  if (s.volts() == 0) {
    return fmt::format("VLEV {} is reserved; use {} (0.85 V) to 15 (1.30 V)", s.level(),
                       kFirstVoltageLevel);
  }
  if (s.bypassed()) {
    return "";
  }
  const double vco = s.vco_mhz(clkin_mhz_);
  if (vco < vco_minimum_ || above(vco, vco_maximum_)) {
    return fmt::format("the VCO would run at {} MHz, and {} to {} MHz is its range; change MSEL",
                       vco, vco_minimum_, vco_maximum_);
  }
  const double cclk = vco / (1U << s.core_select());
  double fastest = kSpeedGrades.at(s.level() - kFirstVoltageLevel).megahertz;
  double limit = s.volts() < kLowVolts ? sclk_limit_low_ : sclk_limit_;
  if (s.level() == start_.level()) {
    fastest = std::max(fastest, start_cclk_);
    limit = std::max(limit, start_sclk_);
  }
  if (above(cclk, fastest)) {
    return fmt::format(
        "CCLK would be {} MHz, but {:.2f} V bear {} MHz; raise VLEV of VR_CTL before the clock, "
        "lower it behind it",
        cclk, s.volts(), fastest);
  }
  const double sclk = vco / s.system_select();
  if (above(sclk, limit)) {
    return fmt::format(
        "SCLK would be {:.6g} MHz, above its limit of {} MHz at {:.2f} V; raise SSEL", sclk, limit,
        s.volts());
  }
  return "";
}

}  // namespace finback::clock
