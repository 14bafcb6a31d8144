// Which clocks ran when, and so how long a time in core cycles is in seconds.
//
// Models: stretches of time between changes. Time is counted in core cycles throughout, whatever a
// cycle's length was: seconds are summed stretch by stretch.
#pragma once

#include <vector>

#include <clock_model/operating_point.hpp>
#include <common/units.hpp>

namespace finback::clock {

struct ClockSegment {
  Cycles from = 0;
  OperatingPoint point;
};

class ClockHistory {
 public:
  ClockHistory() = default;
  explicit ClockHistory(const OperatingPoint& first) : segments_{{0, first}} {}

  // `at` does not go back.
  void change(Cycles at, const OperatingPoint& point);
  // Not empty, but where nobody has filled it.
  [[nodiscard]] const std::vector<ClockSegment>& segments() const { return segments_; }
  [[nodiscard]] bool changed() const { return segments_.size() > 1; }

  // Of the time between two times. Needs a segment.
  [[nodiscard]] double seconds(Cycles from, Cycles to) const;
  // By which cycles become seconds there: their number over it.
  [[nodiscard]] double mean_hertz(Cycles from, Cycles to) const;

 private:
  std::vector<ClockSegment> segments_;
};

}  // namespace finback::clock
