#include <algorithm>
#include <fmt/format.h>
#include <random>
#include <set>

#include <common/error.hpp>
#include <explorer/points.hpp>

namespace finback::explorer {

namespace {

constexpr std::uint64_t kUncountable = std::uint64_t{1} << 63;

Point point_at(const std::vector<Axis>& axes, std::uint64_t index) {
  Point point(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    const std::uint64_t choices = axes[i].choices.size();
    point[i] = static_cast<std::uint32_t>(index % choices);
    index /= choices;
  }
  return point;
}

// A number below `bound`, every one equally likely. std::uniform_int_distribution is no use here:
// each standard library draws its own numbers.
std::uint64_t draw(std::mt19937_64& generator, std::uint64_t bound) {
  const std::uint64_t most = std::mt19937_64::max() - std::mt19937_64::max() % bound;
  std::uint64_t number = generator();
  while (number >= most) {
    number = generator();
  }
  return number % bound;
}

// `count` numbers below `size`, ordered; Floyd's algorithm: one draw for each.
std::set<std::uint64_t> draw_many(std::uint64_t count, std::uint64_t size, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::set<std::uint64_t> drawn;
  for (std::uint64_t last = size - count; last < size; ++last) {
    if (!drawn.insert(draw(generator, last + 1)).second) {
      drawn.insert(last);
    }
  }
  return drawn;
}

}  // namespace

std::uint64_t grid_size(const std::vector<Axis>& axes) {
  std::uint64_t size = 1;
  for (const Axis& axis : axes) {
    if (size > kUncountable / axis.choices.size()) {
      return kUncountable;
    }
    size *= axis.choices.size();
  }
  return size;
}

std::vector<Point> points_of(const Space& space) {
  const std::uint64_t size = grid_size(space.axes);
  if (size == kUncountable) {
    throw InputError(SourcePlace{space.file}, "the grid has 2^63 points or more: shorten its axes");
  }
  const std::uint64_t wanted = space.sample ? std::min(space.sample->points, size) : size;
  if (wanted > kMostPoints) {
    throw InputError(SourcePlace{space.file},
                     fmt::format("the grid has {} points, and {} is the most: shorten its axes, or "
                                 "add [sample] with points = 1000",
                                 size, kMostPoints));
  }
  std::vector<Point> points;
  points.reserve(wanted);
  if (wanted == size) {
    for (std::uint64_t index = 0; index < size; ++index) {
      points.push_back(point_at(space.axes, index));
    }
  } else {
    for (const std::uint64_t index : draw_many(wanted, size, space.sample->seed)) {
      points.push_back(point_at(space.axes, index));
    }
  }
  return points;
}

}  // namespace finback::explorer
