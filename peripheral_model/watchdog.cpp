#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <peripheral_model/watchdog.hpp>

namespace finback::peripheral {

namespace {

constexpr std::uint32_t kControl = 0x0, kCount = 0x4, kStatus = 0x8;

constexpr std::uint32_t kEventMask = 3U << 1, kEnableMask = 0xFFU << 4;
constexpr std::uint32_t kDisabled = 0xADU << 4;  // any other value in the field enables
constexpr std::uint32_t kRolledOver = 1U << 15;
enum class Event : std::uint32_t { reset, non_maskable, interrupt, none };

}  // namespace

Watchdog::Watchdog(std::string name, clock::ClockRatio ratio, Outputs outputs)
    : name_(std::move(name)), ratio_(ratio), outputs_(std::move(outputs)), control_(kDisabled) {}

const DeviceRegister* Watchdog::find_register(std::uint32_t offset) const {
  static constexpr std::array<DeviceRegister, 3> kRegisters = {
      {{kControl, "CTL", RegisterWidth::half}, {kCount, "CNT"}, {kStatus, "STAT"}}};
  return finback::find_register(kRegisters, offset);
}

bool Watchdog::enabled() const { return (control_ & kEnableMask) != kDisabled; }

std::uint32_t Watchdog::left(Cycles now) const {
  return next_event_ == kNever ? status_
                               : static_cast<std::uint32_t>(ratio_.left(next_event_ - now));
}

std::uint32_t Watchdog::read(std::uint32_t offset, int /*bytes*/, Cycles now) {
  switch (offset) {
    case kControl:
      return control_ | (rolled_over_ ? kRolledOver : 0);
    case kCount:
      return count_;
    default:
      return left(now);
  }
}

void Watchdog::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  switch (offset) {
    case kControl:
      write_control(value, now);
      return;
    case kCount:
      if (enabled()) {
        throw GuestFault(
            fmt::format("{}_CNT = {:#x}: the watchdog runs; disable it first by {}_CTL = 0x0ad0",
                        name_, value, name_));
      }
      count_ = status_ = value;
      return;
    default:
      reload(now);
      return;
  }
}

void Watchdog::write_control(std::uint32_t value, Cycles now) {
  status_ = left(now);
  control_ = value & (kEventMask | kEnableMask);
  rolled_over_ = rolled_over_ && (value & kRolledOver) == 0;
  const bool counts = enabled() && status_ > 0;
  next_event_ = counts ? now + ratio_.cycles(status_) : kNever;
  update_line(now);
}

void Watchdog::reload(Cycles now) {
  status_ = count_;
  next_event_ = enabled() && status_ > 0 ? now + ratio_.cycles(status_) : kNever;
}

void Watchdog::advance(Cycles now) {
  if (next_event_ > now) {
    return;
  }
  const Cycles at = next_event_;
  next_event_ = kNever;
  status_ = 0;
  rolled_over_ = true;
  switch (static_cast<Event>((control_ & kEventMask) >> 1U)) {
    case Event::reset:
      outputs_.reset(at);
      break;
    case Event::non_maskable:
      outputs_.non_maskable(at);
      break;
    default:
      update_line(at);
      break;
  }
}

void Watchdog::update_line(Cycles now) {
  const bool interrupts = static_cast<Event>((control_ & kEventMask) >> 1U) == Event::interrupt;
  const bool level = rolled_over_ && interrupts;
  if (level != line_) {
    line_ = level;
    outputs_.line(level, now);
  }
}

}  // namespace finback::peripheral
