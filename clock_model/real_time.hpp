// Real time beside the core's cycles, for what has no clock of the chip's: cameras, pins, limits.
//
// Models: time in reference cycles, those of CCLK as it was at the start, exact in whole numbers;
// until the first change of clock both are the same. Only times from the last change on can be
// converted. Does not model: drift of the crystal.
#pragma once

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>

namespace finback::clock {

class RealTime {
 public:
  void change(const ClockChange& change);

  // Rounded down.
  [[nodiscard]] Cycles to_reference(Cycles time) const {
    return reference_hertz_ == 0 ? time : scaled_to_reference(time);
  }
  // Rounded up; what is over comes at once, kNever stays.
  [[nodiscard]] Cycles from_reference(Cycles reference) const {
    return reference_hertz_ == 0 ? reference : scaled_from_reference(reference);
  }

 private:
  [[nodiscard]] Cycles scaled_to_reference(Cycles time) const;
  [[nodiscard]] Cycles scaled_from_reference(Cycles reference) const;

  std::uint64_t reference_hertz_ = 0;  // 0: nothing has changed yet
  std::uint64_t hertz_ = 0;            // from the last change on
  Cycles at_ = 0;
  Cycles reference_at_ = 0;
};

}  // namespace finback::clock
