#include <clock_model/clock_ratio.hpp>

namespace finback::clock {

Cycles ClockChange::system_time(Cycles when) const {
  if (when == kNever || when <= at || from == to) {
    return when;
  }
  return at + to.cycles(from.left(when - at));
}

}  // namespace finback::clock
