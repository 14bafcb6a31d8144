// Which points of a space are looked at: the whole grid, or a random part of it.
//
// A point is the number of the choice on each axis. The grid counts like an odometer, the last axis
// fastest; a sample keeps that order. Depends on nothing but the space: the same file gives the
// same points on every computer.
#pragma once

#include <cstdint>
#include <vector>

#include <explorer/space.hpp>

namespace finback::explorer {

using Point = std::vector<std::uint32_t>;  // into Axis::choices, by axis

// How many points the grid has; 2^63 stands for more than can be counted.
[[nodiscard]] std::uint64_t grid_size(const std::vector<Axis>& axes);

// The points in their order: all of the grid, or `Sample::points` of it without repetition (all,
// when it has no more). Throws InputError when these are more than kMostPoints, or the grid's size
// cannot be counted.
[[nodiscard]] std::vector<Point> points_of(const Space& space);

}  // namespace finback::explorer
