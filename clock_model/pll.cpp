#include <array>
#include <fmt/format.h>

#include <clock_model/core_voltage.hpp>
#include <clock_model/pll.hpp>
#include <common/error.hpp>

namespace finback::clock {

namespace {

constexpr std::uint32_t kControl = 0x00, kDivider = 0x04, kRegulator = 0x08, kStatus = 0x0C,
                        kLockCount = 0x10;

enum StatusBit : std::uint32_t {
  kActiveEnabled = 1U << 0,
  kFullOn = 1U << 1,
  kActiveDisabled = 1U << 2,
  kLocked = 1U << 5,
  kVoltageReached = 1U << 7,
};

constexpr double kMega = 1e6;

}  // namespace

Pll::Pll(const PllParameters& parameters, double cclk_mhz, double sclk_mhz, Cycles ratio,
         Outputs outputs)
    : limits_(parameters, cclk_mhz, sclk_mhz, ratio),
      outputs_(std::move(outputs)),
      settings_(limits_.start()),
      written_(settings_),
      point_{.mode = Mode::full_on,
             .core_hertz = cclk_mhz * kMega,
             .system_hertz = sclk_mhz * kMega,
             .core_volts = 0},
      ratio_(ratio) {
  if (const SpeedGrade* grade = grade_for(cclk_mhz)) {
    point_.core_volts = grade->volts;
  }
}

const DeviceRegister* Pll::find_register(std::uint32_t offset) const {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 5> kRegisters = {{{kControl, "PLL_CTL", half},
                                                                {kDivider, "PLL_DIV", half},
                                                                {kRegulator, "VR_CTL", half},
                                                                {kStatus, "PLL_STAT", half},
                                                                {kLockCount, "PLL_LOCKCNT", half}}};
  return finback::find_register(kRegisters, offset);
}

std::uint32_t Pll::status() const {
  const bool off = (settings_.control & kPllOff) != 0;
  const std::uint32_t mode = point_.mode == Mode::full_on ? kFullOn
                             : off                        ? kActiveDisabled
                                                          : kActiveEnabled;
  const bool locks = phase_ == Phase::locks;
  return mode | (locks || off ? 0U : kLocked) | (locks ? 0U : kVoltageReached);
}

std::uint32_t Pll::read(std::uint32_t offset, int /*bytes*/, Cycles /*now*/) {
  switch (offset) {
    case kStatus:
      return status();
    case kLockCount:
      return lock_count_;
    case kRegulator:
      return written_.regulator;
    default:
      break;
  }
  if (!limits_.trouble().empty()) {
    throw GuestFault(limits_.trouble());
  }
  return offset == kControl ? written_.control : written_.divider;
}

void Pll::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  value &= 0xFFFFU;
  PllSettings next = written_;
  switch (offset) {
    case kStatus:
      throw GuestFault(fmt::format("PLL_STAT = {:#06x}: it is read-only", value));
    case kLockCount:
      lock_count_ = value;
      return;
    case kControl:
      next.control = value;
      write_settings("PLL_CTL", value, next);
      due_ = written_ != settings_ || (value & kStopCore) != 0;
      return;
    case kRegulator:
      next.regulator = value;
      write_settings("VR_CTL", value, next);
      due_ = due_ || written_ != settings_;
      return;
    default:
      break;
  }
  next.divider = value;
  write_settings("PLL_DIV", value, next);
  const bool other = settings_.divider != value;
  settings_.divider = value;
  if (other && point_.mode == Mode::full_on) {
    run_clocks();
    announce(now);
  }
}

// What is written must be right with what is in force, and, if it waits for IDLE, then.
void Pll::write_settings(const char* name, std::uint32_t value, const PllSettings& settings) {
  std::string why = limits_.trouble();
  if (phase_ != Phase::settled) {
    why = "the PLL is locking; wait for PLL_LOCKED, bit 5 of PLL_STAT";
  } else if ((settings.control & kReservedControl) != 0) {
    why = "bits 2 and 4 are reserved and must be 0";
  } else if ((settings.divider & kReservedDivider) != 0) {
    why = "bits 15 to 6 are reserved and must be 0";
  } else if ((settings.control & kPllOff) != 0 && !settings.bypassed()) {
    why = "PLL_OFF without BYPASS: the chip runs from the PLL; set BYPASS, too";
  }
  if (why.empty()) {
    why = limits_.refusal(settings);
  }
  if (why.empty()) {
    PllSettings now = settings_;
    now.divider = settings.divider;
    why = limits_.refusal(now);
  }
  if (!why.empty()) {
    throw GuestFault(fmt::format("{} = {:#06x}: {}", name, value, why));
  }
  written_ = settings;
}

void Pll::idle(Cycles at) {
  phase_ = Phase::begins;
  next_event_ = at;
}

void Pll::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    next_event_ = kNever;
    if (phase_ == Phase::begins) {
      begin(at);
    } else {
      finish(at);
    }
  }
}

void Pll::begin(Cycles at) {
  const PllSettings before = settings_;
  due_ = false;
  settings_ = written_;
  const bool powers_down = (settings_.control & kPowerDown) != 0;
  if ((settings_.regulator & kRegulatorFrequency) == 0 || powers_down) {
    const bool hibernates = (settings_.regulator & kRegulatorFrequency) == 0;
    phase_ = Phase::settled;
    point_.mode = hibernates ? Mode::hibernate : Mode::deep_sleep;
    point_.core_volts = hibernates ? 0 : point_.core_volts;
    announce(at);
    return;
  }
  constexpr std::uint32_t kVco = kMultiplier | kDivideInput | kPllOff;
  const bool locks = ((before.control ^ settings_.control) & kVco) != 0 ||
                     ((before.regulator ^ settings_.regulator) & kVoltageLevel) != 0;
  if (!locks || (settings_.control & kPllOff) != 0) {
    finish(at);
    return;
  }
  phase_ = Phase::locks;
  bypass();
  announce(at);
  next_event_ = at + ratio_.cycles(lock_count_);
}

void Pll::finish(Cycles at) {
  phase_ = Phase::settled;
  run_clocks();
  if ((settings_.control & kStopCore) != 0) {
    point_.mode = Mode::sleep;
    announce(at);
  } else {
    announce(at);
    outputs_.wake(at);
  }
}

void Pll::wake(Cycles at) {
  point_.mode = settings_.bypassed() ? Mode::active : Mode::full_on;
  announce(at);
}

// As the settings say.
void Pll::run_clocks() {
  point_.core_volts = settings_.volts();
  if (settings_.bypassed()) {
    bypass();
    return;
  }
  const double vco = settings_.vco_mhz(limits_.clkin_mhz());
  point_.mode = Mode::full_on;
  point_.core_hertz = vco / (1U << settings_.core_select()) * kMega;
  point_.system_hertz = vco / settings_.system_select() * kMega;
  ratio_ = ClockRatio(settings_.system_select(), settings_.core_select());
}

void Pll::bypass() {
  point_.mode = Mode::active;
  point_.core_hertz = point_.system_hertz = limits_.clkin_mhz() * kMega;
  ratio_ = 1;
}

void Pll::announce(Cycles at) { outputs_.changed(point_, ratio_, at); }

}  // namespace finback::clock
