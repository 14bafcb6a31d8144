#include <isa_sim/core/event_controller.hpp>

namespace finback::core {

namespace {

constexpr Address kVectorEnd = EventController::kFirstRegister + 16 * 4;
constexpr Address kOverride = 0xFFE02100;
constexpr Address kMask = 0xFFE02104;
constexpr Address kPending = 0xFFE02108;
constexpr Address kLatch = 0xFFE0210C;
constexpr Address kPriority = 0xFFE02110;

constexpr std::uint32_t kMaskable = 0xFFE0;
constexpr std::uint32_t kClearable = 0xFFEE;    // ILAT
constexpr std::uint32_t kOverridable = 0xFF80;  // IVG7 to IVG15
constexpr std::uint32_t kPriorityBits = 0xF;
constexpr Address kBootRom = 0xEF000000;

}  // namespace

Address EventController::enter(int event) {
  latched_ &= ~(1U << event);
  pending_ |= 1U << event;
  if (event >= kHardwareError) {
    hold_interrupts(true);
  }
  return (override_ & kOverridable & 1U << event) != 0 ? kBootRom : handler(event);
}

void EventController::leave(bool keep) {
  const int now = level();
  if (!keep) {
    pending_ &= ~(1U << now);
  }
  if (now >= kHardwareError || now == kReset) {
    hold_interrupts(false);
  }
}

void EventController::hold_interrupts(bool hold) {
  pending_ = hold ? pending_ | 1U << kGlobalDisable : pending_ & ~(1U << kGlobalDisable);
}

bool EventController::read(Address address, std::uint32_t mask, std::uint32_t& value) const {
  if (address >= kFirstRegister && address < kVectorEnd) {
    value = vectors_[(address - kFirstRegister) / 4];
    return true;
  }
  switch (address) {
    case kOverride:
      value = override_;
      return true;
    case kMask:
      value = mask | kUnmaskable;
      return true;
    case kPending:
      value = pending_;
      return true;
    case kLatch:
      value = lines_ | latched_;
      return true;
    case kPriority:
      value = priority_;
      return true;
    default:
      return false;
  }
}

bool EventController::write(Address address, std::uint32_t& mask, std::uint32_t value) {
  if (address >= kFirstRegister && address < kVectorEnd) {
    vectors_[(address - kFirstRegister) / 4] = value;
    return true;
  }
  switch (address) {
    case kOverride:
      override_ = value;
      return true;
    case kMask:
      mask = value & kMaskable;
      return true;
    case kPending:
      return true;  // read only: a write changes nothing
    case kLatch:
      latched_ &= ~(value & kClearable);
      return true;
    case kPriority:
      priority_ = value & kPriorityBits;
      return true;
    default:
      return false;
  }
}

std::string_view event_name(int event) {
  constexpr std::array<std::string_view, 16> kNames = {
      "EMU",  "RST",  "NMI",   "EVX",   "IRPTEN", "IVHW",  "IVTMR", "IVG7",
      "IVG8", "IVG9", "IVG10", "IVG11", "IVG12",  "IVG13", "IVG14", "IVG15"};
  return event >= 0 && event < 16 ? kNames[static_cast<std::size_t>(event)] : "user mode";
}

}  // namespace finback::core
