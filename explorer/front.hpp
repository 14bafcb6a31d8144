// The Pareto front of speed against power: the points that are worth looking at.
#pragma once

#include <vector>

namespace finback::explorer {

// What a point is judged by.
struct Merit {
  double frames_per_second = 0;
  double watts = 0;
};

// One flag for each point: no other is at least as fast and as thrifty, and better in one of both.
// Equal points are on the front together.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<Merit>& points);

}  // namespace finback::explorer
