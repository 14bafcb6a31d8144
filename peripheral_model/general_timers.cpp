#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <peripheral_model/general_timers.hpp>

namespace finback::peripheral {

namespace {

// Of a timer, and behind the timers of the block.
constexpr std::uint32_t kConfig = 0x0, kCounter = 0x4, kPeriod = 0x8, kWidth = 0xC;
constexpr std::uint32_t kBlockEnable = 0x0, kBlockDisable = 0x4, kBlockStatus = 0x8;

enum ConfigBit : std::uint32_t {
  kMode = 3U << 0,
  kContinuous = 1U << 3,  // PERIOD_CNT
  kInterruptEnable = 1U << 4,
  kPinClock = 1U << 7,  // CLK_SEL
};
constexpr std::uint32_t kPwmOut = 1;

// Where a timer's bits stand in STATUS: four timers share a half.
constexpr std::uint32_t status_shift(std::size_t timer) {
  return static_cast<std::uint32_t>(timer / 4 * 16 + timer % 4);
}
constexpr std::uint32_t kRunShift = 12;

}  // namespace

GeneralTimers::GeneralTimers(int first, int count, const PeripheralParameters& parameters,
                             clock::ClockRatio ratio, InterruptLine line)
    : first_(first),
      ratio_(ratio),
      start_delay_(static_cast<Cycles>(parameters.timer_start)),
      line_(std::move(line)),
      timers_(static_cast<std::size_t>(count)) {}

const DeviceRegister* GeneralTimers::find_register(std::uint32_t offset) const {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 4> kTimer = {
      {{kConfig, "CONFIG", half}, {kCounter, "COUNTER"}, {kPeriod, "PERIOD"}, {kWidth, "WIDTH"}}};
  static constexpr std::array<DeviceRegister, 3> kBlock = {
      {{kBlockEnable, "ENABLE", half}, {kBlockDisable, "DISABLE", half}, {kBlockStatus, "STATUS"}}};
  return offset < block_offset() ? finback::find_register(kTimer, offset % kTimerBytes)
                                 : finback::find_register(kBlock, offset - block_offset());
}

std::string GeneralTimers::register_name(std::uint32_t offset) const {
  const DeviceRegister* found = find_register(offset);
  if (found == nullptr) {
    return "";
  }
  return offset < block_offset()
             ? fmt::format("TIMER{}_{}", first_ + static_cast<int>(offset / kTimerBytes),
                           found->name)
             : fmt::format("TMRS{}_{}", timers_.size(), found->name);
}

void GeneralTimers::fault(std::size_t number, const char* name, std::uint32_t value,
                          const std::string& why) const {
  throw GuestFault(
      fmt::format("TIMER{}_{} = {:#x}: {}", first_ + static_cast<int>(number), name, value, why));
}

std::uint32_t GeneralTimers::read(std::uint32_t offset, int /*bytes*/, Cycles now) {
  if (offset < block_offset()) {
    const Timer& timer = timers_[offset / kTimerBytes];
    switch (offset % kTimerBytes) {
      case kConfig:
        return timer.config;
      case kCounter:
        return counter(timer, now);
      case kPeriod:
        return timer.period;
      default:
        return timer.width;
    }
  }
  if (offset - block_offset() == kBlockStatus) {
    return status();
  }
  std::uint32_t enabled = 0;
  for (std::size_t i = 0; i < timers_.size(); ++i) {
    enabled |= static_cast<std::uint32_t>(timers_[i].enabled) << i;
  }
  return enabled;
}

void GeneralTimers::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  if (offset < block_offset()) {
    write_timer(offset / kTimerBytes, offset % kTimerBytes, value);
    return;
  }
  if (offset - block_offset() == kBlockStatus) {
    write_status(value, now);
  } else {
    for (std::size_t i = 0; i < timers_.size(); ++i) {
      if ((value >> i & 1U) == 0) {
        continue;
      }
      if (offset - block_offset() == kBlockDisable) {
        timers_[i].enabled = false;  // it runs on to the end of its period
      } else if (!timers_[i].enabled) {
        start(i, now);
      }
    }
  }
  plan_next_event();
}

void GeneralTimers::write_timer(std::size_t number, std::uint32_t reg, std::uint32_t value) {
  Timer& timer = timers_[number];
  switch (reg) {
    case kConfig:
      value &= 0xFFFFU;
      if (timer.running) {
        fault(number, "CONFIG", value, "the timer runs; disable it and wait for TRUN = 0");
      }
      if ((value & kMode) > kPwmOut) {
        fault(number, "CONFIG", value,
              (value & kMode) == 2 ? "WDTH_CAP is not modelled: no signal is at the pin"
                                   : "EXT_CLK is not modelled: no signal is at the pin");
      }
      if ((value & kPinClock) != 0) {
        fault(number, "CONFIG", value, "CLK_SEL = 1, a clock from a pin, is not modelled");
      }
      timer.config = value;
      return;
    case kCounter:
      fault(number, "COUNTER", value, "it is read-only");
    case kPeriod:
      timer.period = value;
      return;
    default:
      timer.width = value;
      return;
  }
}

void GeneralTimers::write_status(std::uint32_t value, Cycles now) {
  for (std::size_t i = 0; i < timers_.size(); ++i) {
    const std::uint32_t bits = value >> status_shift(i);
    if ((bits & 1U) != 0) {
      set_interrupt(i, false, now);
    }
    if ((bits >> kRunShift & 1U) != 0) {
      timers_[i].enabled = false;
      stop(timers_[i], now);
    }
  }
}

std::uint32_t GeneralTimers::status() const {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < timers_.size(); ++i) {
    value |= (static_cast<std::uint32_t>(timers_[i].interrupt) |
              static_cast<std::uint32_t>(timers_[i].running) << kRunShift)
             << status_shift(i);
  }
  return value;
}

void GeneralTimers::check(std::size_t number) const {
  const Timer& timer = timers_[number];
  if ((timer.config & kMode) != kPwmOut) {
    fault(number, "CONFIG", timer.config, "a timer that is enabled needs TMODE = 1, PWM_OUT");
  }
  const bool continuous = (timer.config & kContinuous) != 0;
  if (continuous && timer.period < 2) {
    fault(number, "PERIOD", timer.period, "must be at least 2");
  }
  if (timer.width == 0 || (continuous && timer.width >= timer.period)) {
    fault(number, "WIDTH", timer.width,
          continuous ? fmt::format("must be 1 to PERIOD - 1, {}", timer.period - 1)
                     : "must be at least 1");
  }
}

void GeneralTimers::start(std::size_t number, Cycles now) {
  check(number);
  timers_[number].enabled = true;
  timers_[number].running = true;
  begin_period(number, now + ratio_.cycles(start_delay_));
}

void GeneralTimers::begin_period(std::size_t number, Cycles at) {
  check(number);
  Timer& timer = timers_[number];
  timer.length = (timer.config & kContinuous) != 0 ? timer.period : timer.width;
  timer.ends = at + ratio_.cycles(timer.length);
}

void GeneralTimers::end_period(std::size_t number, Cycles at) {
  Timer& timer = timers_[number];
  if ((timer.config & kContinuous) == 0) {
    timer.enabled = false;
  }
  if (timer.enabled) {
    begin_period(number, at);
  } else {
    stop(timer, at);
  }
  if ((timer.config & kInterruptEnable) != 0) {
    set_interrupt(number, true, at);
  }
}

void GeneralTimers::stop(Timer& timer, Cycles now) {
  timer.counter = counter(timer, now);
  timer.running = false;
  timer.ends = kNever;
}

// It counts from 1 to the length of the period.
std::uint32_t GeneralTimers::counter(const Timer& timer, Cycles now) const {
  if (!timer.running) {
    return timer.counter;
  }
  const Cycles left = std::min<Cycles>(ratio_.left(timer.ends - now), timer.length);
  return static_cast<std::uint32_t>(std::min<Cycles>(timer.length - left + 1, timer.length));
}

void GeneralTimers::set_interrupt(std::size_t number, bool level, Cycles now) {
  if (timers_[number].interrupt != level) {
    timers_[number].interrupt = level;
    line_(first_ + static_cast<int>(number), level, now);
  }
}

void GeneralTimers::advance(Cycles now) {
  while (next_event_ <= now) {
    const auto due = std::ranges::find(timers_, next_event_, &Timer::ends);
    end_period(static_cast<std::size_t>(due - timers_.begin()), next_event_);
    plan_next_event();
  }
}

void GeneralTimers::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  for (Timer& timer : timers_) {
    timer.ends = change.system_time(timer.ends);
  }
  plan_next_event();
}

void GeneralTimers::plan_next_event() {
  next_event_ = std::ranges::min(timers_, {}, &Timer::ends).ends;
}

}  // namespace finback::peripheral
