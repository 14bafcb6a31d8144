#include <algorithm>
#include <limits>
#include <numeric>

#include <explorer/front.hpp>

namespace finback::explorer {

std::vector<bool> pareto_front(const std::vector<Merit>& points) {
  // From the fastest down: a point is on the front when it needs less than all that are faster, and
  // no more than those that are as fast.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t one, std::size_t other) {
    return points[one].frames_per_second > points[other].frames_per_second;
  });
  std::vector<bool> front(points.size(), false);
  double least_of_faster = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < order.size();) {
    const double rate = points[order[i]].frames_per_second;
    std::size_t end = i;
    double least = std::numeric_limits<double>::infinity();
    for (; end < order.size() && points[order[end]].frames_per_second == rate; ++end) {
      least = std::min(least, points[order[end]].watts);
    }
    for (; i < end; ++i) {
      front[order[i]] = points[order[i]].watts == least && least < least_of_faster;
    }
    least_of_faster = std::min(least_of_faster, least);
  }
  return front;
}

}  // namespace finback::explorer
