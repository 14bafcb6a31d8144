#include <isa_sim/core/core_timer.hpp>

namespace finback::core {

namespace {

constexpr Address kTimerControl = CoreTimer::kFirstRegister;
constexpr Address kPeriod = CoreTimer::kFirstRegister + 4;
constexpr Address kScale = CoreTimer::kFirstRegister + 8;
constexpr std::uint32_t kScaleBits = 0xFF;

}  // namespace

void CoreTimer::expire() {
  control_ |= kExpired;
  count_ = 0;
  if ((control_ & kAutoReload) != 0 && period_ != 0) {
    expires_ += period_ * step();
  } else {
    expires_ = kNever;
  }
}

std::uint32_t CoreTimer::count(Cycles now) const {
  if (expires_ == kNever) {
    return count_;
  }
  return expires_ <= now ? 0 : static_cast<std::uint32_t>((expires_ - now + scale_) / step());
}

std::uint32_t CoreTimer::read(Address address, Cycles now) const {
  switch (address) {
    case kTimerControl:
      return control_;
    case kPeriod:
      return period_;
    case kScale:
      return scale_;
    default:
      return count(now);
  }
}

void CoreTimer::write(Address address, std::uint32_t value, Cycles now) {
  const bool ran = runs();
  const std::uint32_t left = count(now);
  switch (address) {
    case kTimerControl:
      control_ = value;
      if (runs() == ran) {
        return;
      }
      count_ = left;
      break;
    case kPeriod:
      period_ = value;
      count_ = value;
      break;
    case kScale:
      scale_ = value & kScaleBits;
      count_ = left;
      break;
    default:
      count_ = value;
      break;
  }
  // One that is started at 0 requests at once; one that has run out is only started by a new count.
  const bool starts = runs() && (!ran || count_ != 0);
  expires_ = starts ? now + count_ * step() : kNever;
}

}  // namespace finback::core
