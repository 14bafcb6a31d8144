#include <isa_sim/core/event_controller.hpp>

namespace finback::core {

namespace {

constexpr Address kVectorEnd = EventController::kFirstRegister + 16 * 4;
constexpr Address kMask = 0xFFE02104;
constexpr Address kPending = 0xFFE02108;
constexpr Address kLatch = 0xFFE0210C;

}  // namespace

bool EventController::read(Address address, std::uint32_t mask, std::uint32_t& value) const {
  if (address >= kFirstRegister && address < kVectorEnd) {
    value = vectors_[(address - kFirstRegister) / 4];
  } else if (address == kMask) {
    value = mask | kUnmaskable;
  } else if (address == kPending) {
    value = pending_;
  } else if (address == kLatch) {
    value = lines_ | latched_;
  } else {
    return false;
  }
  return true;
}

bool EventController::write(Address address, std::uint32_t& mask, std::uint32_t value) {
  if (address >= kFirstRegister && address < kVectorEnd) {
    vectors_[(address - kFirstRegister) / 4] = value;
  } else if (address == kMask) {
    mask = value;
  } else if (address == kLatch) {
    latched_ &= ~value;  // write one to clear
  } else {
    return address == kPending;  // read only: a write changes nothing
  }
  return true;
}

}  // namespace finback::core
