// The PLL and the chip's power modes: PLL_CTL, PLL_DIV, VR_CTL, PLL_STAT, PLL_LOCKCNT.
//
// Models: PLL_DIV at once; PLL_CTL and VR_CTL when the cores are in IDLE: a new MSEL, DF or VLEV
// bypasses the PLL (both clocks are CLKIN) until LOCKCNT system clocks have passed; then, and for
// all other changes at once, comes the PLL's wake-up; active mode, sleep, deep sleep, hibernation;
// values that the chip does not bear are a GuestFault. Does not model: input and output delays, the
// regulator's frequency and gain, a lock count that is too short, what a program does behind the
// reset that ends deep sleep and hibernation. Source: hardware.md 5.6; docs/clocks.md.
#pragma once

#include <functional>
#include <string>

#include <clock_model/clock_ratio.hpp>
#include <clock_model/operating_point.hpp>
#include <clock_model/pll_limits.hpp>
#include <common/device.hpp>

namespace finback::clock {

class Pll final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x14;

  struct Outputs {
    // Clocks, voltage or mode are others from `at` on.
    std::function<void(const OperatingPoint& point, ClockRatio ratio, Cycles at)> changed;
    // The PLL's wake-up, for cores whose wake-up mask admits it.
    std::function<void(Cycles at)> wake;
  };

  // At first the chip is as a boot loader left it: full on, at these clocks.
  Pll(const PllParameters& parameters, double cclk_mhz, double sclk_mhz, Cycles ratio,
      Outputs outputs);

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;

  // A write waits for IDLE.
  [[nodiscard]] bool waits_for_idle() const { return phase_ == Phase::settled && due_; }
  // CCLK will stand still then.
  [[nodiscard]] bool will_stop_cores() const {
    return (written_.control & (kStopCore | kPowerDown)) != 0 ||
           (written_.regulator & kRegulatorFrequency) == 0;
  }
  // The cores are, from `at` on.
  void idle(Cycles at);
  // In sleep: something that may wake a core has come.
  void wake(Cycles at);
  [[nodiscard]] const OperatingPoint& point() const { return point_; }
  [[nodiscard]] bool asleep() const { return point_.mode == Mode::sleep; }

 private:
  enum class Phase : std::uint8_t { settled, begins, locks };

  void write_settings(const char* name, std::uint32_t value, const PllSettings& settings);
  void begin(Cycles at);
  void finish(Cycles at);
  void run_clocks();
  void bypass();
  void announce(Cycles at);
  [[nodiscard]] std::uint32_t status() const;

  PllLimits limits_;
  Outputs outputs_;
  PllSettings settings_;  // in force
  PllSettings written_;
  bool due_ = false;  // something was written that waits for IDLE
  std::uint32_t lock_count_ = 0x200;
  Phase phase_ = Phase::settled;
  OperatingPoint point_;
  ClockRatio ratio_;
};

}  // namespace finback::clock
