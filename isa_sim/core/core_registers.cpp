// The registers of the core itself, from 0xFFE00000: events, timer, identity.
#include <isa_sim/core/core.hpp>

namespace finback::core {

using isa::Operation;

namespace {

constexpr Address kIdentity = 0xFFE05000;  // DSPID
constexpr Address kDebugStatus = 0xFFE05008;
// Of a part of Analog Devices' (0xE5), core version 4; its lowest bit tells core B.
constexpr std::uint32_t kIdentityOfCoreA = 0xE5040000;

bool within(Address address, Address first, Address last) {
  return address >= first && address <= last;
}

}  // namespace

bool Core::read_register(const Operation& operation, Address address, int bytes,
                         std::uint32_t& value) {
  if (bytes != 4 || address % 4 != 0) {
    return false;
  }
  if (within(address, EventController::kFirstRegister, EventController::kLastRegister)) {
    check_timer(now(operation));
    look_for_events(operation);
    return events_.read(address, state_.interrupt_mask, value);
  }
  if (within(address, CoreTimer::kFirstRegister, CoreTimer::kLastRegister)) {
    check_timer(now(operation));
    look_for_events(operation);
    value = timer_.read(address, now(operation));
    return true;
  }
  if (address == kIdentity) {
    value = kIdentityOfCoreA + static_cast<std::uint32_t>(number_);
    return true;
  }
  value = 0;
  return address == kDebugStatus;
}

bool Core::write_register(const Operation& operation, Address address, int bytes,
                          std::uint32_t value) {
  if (bytes != 4 || address % 4 != 0) {
    return false;
  }
  if (within(address, EventController::kFirstRegister, EventController::kLastRegister)) {
    check_timer(now(operation));
    if (!events_.write(address, state_.interrupt_mask, value)) {
      return false;
    }
    choose_block_style(operation);
    look_for_events(operation);  // the mask may let an interrupt in
    return true;
  }
  if (within(address, CoreTimer::kFirstRegister, CoreTimer::kLastRegister)) {
    check_timer(now(operation));
    timer_.write(address, value, now(operation));
    check_timer(now(operation));
    look_for_events(operation);
    if (timer_.next_event() != kNever) {
      end_block_after(operation);  // from there on the timer is minded
    }
    return true;
  }
  return address == kIdentity || address == kDebugStatus;  // read-only
}

}  // namespace finback::core
