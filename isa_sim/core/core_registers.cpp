// The registers of the core itself, from 0xFFE00000: protection, events, timer, identity; and what
// may not be accessed.
#include <fmt/format.h>

#include <isa_sim/core/core.hpp>
#include <isa_sim/core/placed.hpp>

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

// Whether `operation` is the access of its packet's last slot.
bool by_second_generator(const ir::PlacedPacket& packet, const Operation& operation) {
  constexpr std::size_t kLastSlot = 2;
  if (packet.count <= kLastSlot) {
    return false;
  }
  const Operation last = operation_of(packet.slots[kLastSlot], packet);
  const Operation middle = operation_of(packet.slots[kLastSlot - 1], packet);
  const auto same = [&operation](const Operation& other) {
    return other.execute == operation.execute && other.operand == operation.operand;
  };
  return same(last) && !same(middle);
}

}  // namespace

void Core::check_access(const Operation& operation, Address address, int bytes, bool write) {
  if (!protection_.guards_data() && address >= isa::kDeviceBase && !events_.user_mode() &&
      image_.packets[operation.site].count == 1) {
    return;
  }
  const int cause = protection_.check_data(
      {.address = address,
       .bytes = bytes,
       .write = write,
       .supervisor = !events_.user_mode(),
       .second = by_second_generator(image_.packets[operation.site], operation)});
  if (cause == kMisalignedAccess) {
    raise_exception(operation, cause, memory_.core_fault(number_, address, bytes, write));
  }
  if (cause != 0) {
    raise_exception(
        operation, cause,
        fmt::format("{} of {} byte{} at {:#010x} is not allowed {}", write ? "store" : "load",
                    bytes, bytes == 1 ? "" : "s", address,
                    events_.user_mode() ? "in user mode" : "to this address generator"));
  }
}

void Core::no_register(const Operation& operation, Address address, int bytes, bool write) {
  protection_.note_data_fault({.address = address,
                               .bytes = bytes,
                               .write = write,
                               .supervisor = !events_.user_mode(),
                               .second = false},
                              false);
  raise_exception(operation, kSupervisorResource,
                  fmt::format("{} of {} byte{} at {:#010x}: no such core register",
                              write ? "write" : "read", bytes, bytes == 1 ? "" : "s", address));
}

// CPLBs were enabled: no access takes the short way any more.
void Core::check_every_access() {
  for (const auto& block : blocks_) {
    for (Operation* o = block->operations.get(); o->execute != BlockBuilder::leave(); ++o) {
      o->window = no_window();
    }
  }
}

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
  if (within(address, Protection::kFirstRegister, Protection::kLastRegister)) {
    return protection_.read(address, value);
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
  if (within(address, Protection::kFirstRegister, Protection::kLastRegister)) {
    const int banks = protection_.cache_banks();
    const bool high_select = protection_.cache_high_select();
    const bool known = protection_.write(address, value);
    if (banks != protection_.cache_banks() || high_select != protection_.cache_high_select()) {
      guarded(operation, [&] {
        memory_.configure_data_cache(number_, protection_.cache_banks(),
                                     protection_.cache_high_select(), accessor(operation),
                                     now(operation));
      });
    }
    guarded(operation, [&] { configure_code_cache(); });
    choose_block_style(operation);
    if (protection_.guards_data()) {
      check_every_access();
    }
    return known;
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
