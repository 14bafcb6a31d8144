// A block of general-purpose timers: TIMER0 to 7, or TIMER8 to 11.
//
// Models: PWM_OUT with the system clock, without its pin: continuous (PERIOD_CNT, an interrupt at
// the end of each period) and single pulse (an interrupt after WIDTH, then it stops); PERIOD and
// WIDTH that are taken over with the next period; stopping at the end of a period, or at once by
// TRUN; reads of the running COUNTER. A timer is an event in time: nothing is done between its
// periods. Does not model: WDTH_CAP, EXT_CLK and clocks from pins (a GuestFault), error bits (what
// would set them is a GuestFault). Source: defBF561.h for addresses and bits (V), timer chapter of
// the ADSP-BF533 Hardware Reference as remembered (M).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <clock_model/clock_ratio.hpp>
#include <common/device.hpp>
#include <peripheral_model/peripheral_parameters.hpp>

namespace finback::peripheral {

class GeneralTimers final : public Device {
 public:
  // Told about every change of a timer's interrupt line; `timer` counts from 0 over all blocks.
  using InterruptLine = std::function<void(int timer, bool level, Cycles at)>;

  // `count` timers (8 or 4), the first of them TIMER`first`. `ratio`: CCLK cycles of an SCLK.
  GeneralTimers(int first, int count, const PeripheralParameters& parameters,
                clock::ClockRatio ratio, InterruptLine line);

  // Offsets of a block with so many timers.
  [[nodiscard]] static std::uint32_t register_bytes(int count) {
    return static_cast<std::uint32_t>(count) * kTimerBytes + 0x0C;
  }

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  // "TIMER3_PERIOD", "TMRS8_ENABLE".
  [[nodiscard]] std::string register_name(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;
  void change_clock(const clock::ClockChange& change);

 private:
  static constexpr std::uint32_t kTimerBytes = 0x10;

  struct Timer {
    std::uint32_t config = 0;
    std::uint32_t counter = 0;  // while it stands still
    std::uint32_t period = 0;   // as written; taken over with the next period
    std::uint32_t width = 0;
    bool enabled = false;      // TIMEN
    bool running = false;      // TRUN
    bool interrupt = false;    // TIMIL
    std::uint32_t length = 0;  // SCLKs of the present period, or of the pulse
    Cycles ends = kNever;
  };

  void write_timer(std::size_t number, std::uint32_t reg, std::uint32_t value);
  void write_status(std::uint32_t value, Cycles now);
  void start(std::size_t number, Cycles now);
  void begin_period(std::size_t number, Cycles at);
  void end_period(std::size_t number, Cycles at);
  void stop(Timer& timer, Cycles now);
  void set_interrupt(std::size_t number, bool level, Cycles now);
  void check(std::size_t number) const;
  [[nodiscard]] std::uint32_t counter(const Timer& timer, Cycles now) const;
  [[nodiscard]] std::uint32_t status() const;
  [[nodiscard]] std::uint32_t block_offset() const {
    return static_cast<std::uint32_t>(timers_.size()) * kTimerBytes;
  }
  void plan_next_event();
  [[noreturn]] void fault(std::size_t number, const char* name, std::uint32_t value,
                          const std::string& why) const;

  int first_;
  clock::ClockRatio ratio_;
  Cycles start_delay_;  // in SCLK
  InterruptLine line_;
  std::vector<Timer> timers_;
};

}  // namespace finback::peripheral
