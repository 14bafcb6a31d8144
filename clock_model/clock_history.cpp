#include <algorithm>

#include <clock_model/clock_history.hpp>

namespace finback::clock {

void ClockHistory::change(Cycles at, const OperatingPoint& point) {
  if (!segments_.empty() && segments_.back().from == at) {
    segments_.back().point = point;
  } else {
    segments_.push_back({at, point});
  }
}

double ClockHistory::seconds(Cycles from, Cycles to) const {
  double sum = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Cycles begin = std::max(from, segments_[i].from);
    const Cycles end = i + 1 < segments_.size() ? std::min(to, segments_[i + 1].from) : to;
    if (begin < end) {
      sum += static_cast<double>(end - begin) / segments_[i].point.core_hertz;
    }
  }
  return sum;
}

double ClockHistory::mean_hertz(Cycles from, Cycles to) const {
  const auto after = std::ranges::upper_bound(segments_, from, {}, &ClockSegment::from);
  const auto here = after == segments_.begin() ? after : after - 1;
  if (after == segments_.end() || to <= after->from) {
    return here->point.core_hertz;
  }
  return static_cast<double>(to - from) / seconds(from, to);
}

}  // namespace finback::clock
