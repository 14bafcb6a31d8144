// A watchdog timer: WDOGA or WDOGB, each its core's.
//
// Models: CTL, CNT, STAT; a count down from CNT with the system clock, begun anew by any write to
// STAT; at 0 it stands still, sets WDRO and does what CTL says: reset (the run ends, with a
// message), NMI, the watchdog's interrupt, nothing. Does not model: the reset's own work, the bits
// of SWRST that tell of it. Source: defBF561.h for addresses and bits (V), watchdog chapter of the
// ADSP-BF533 Hardware Reference as remembered (M).
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <clock_model/clock_ratio.hpp>
#include <common/device.hpp>

namespace finback::peripheral {

class Watchdog final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x0C;

  struct Outputs {
    std::function<void(Cycles at)> reset;
    std::function<void(Cycles at)> non_maskable;
    std::function<void(bool level, Cycles at)> line;
  };

  // `name` as its registers are called: "WDOGA". `ratio`: CCLK cycles of an SCLK.
  Watchdog(std::string name, clock::ClockRatio ratio, Outputs outputs);

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;
  void change_clock(const clock::ClockChange& change) {
    ratio_ = change.to;
    next_event_ = change.system_time(next_event_);
  }

 private:
  void write_control(std::uint32_t value, Cycles now);
  void reload(Cycles now);
  [[nodiscard]] std::uint32_t left(Cycles now) const;
  [[nodiscard]] bool enabled() const;
  void update_line(Cycles now);

  std::string name_;
  clock::ClockRatio ratio_;
  Outputs outputs_;
  std::uint32_t control_;
  std::uint32_t count_ = 0;   // CNT
  std::uint32_t status_ = 0;  // STAT while it stands still
  bool rolled_over_ = false;  // WDRO
  bool line_ = false;
};

}  // namespace finback::peripheral
