#include <clock_model/real_time.hpp>

namespace finback::clock {

namespace {

// Cycles times hertz pass 64 bits within a minute.
__extension__ using Wide = unsigned __int128;

}  // namespace

void RealTime::change(const ClockChange& change) {
  reference_at_ = to_reference(change.at);
  if (reference_hertz_ == 0) {
    reference_hertz_ = change.from_hertz;
  }
  at_ = change.at;
  hertz_ = change.to_hertz;
}

Cycles RealTime::scaled_to_reference(Cycles time) const {
  if (time <= at_) {
    return reference_at_;
  }
  return reference_at_ + static_cast<Cycles>(Wide{time - at_} * reference_hertz_ / hertz_);
}

Cycles RealTime::scaled_from_reference(Cycles reference) const {
  if (reference == kNever) {
    return kNever;
  }
  if (reference <= reference_at_) {
    return at_;
  }
  const Wide cycles =
      (Wide{reference - reference_at_} * hertz_ + reference_hertz_ - 1) / reference_hertz_;
  return cycles > kNever - 1 - at_ ? kNever : at_ + static_cast<Cycles>(cycles);
}

}  // namespace finback::clock
