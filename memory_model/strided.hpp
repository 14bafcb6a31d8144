// Arithmetic on evenly spaced addresses.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include <common/units.hpp>

namespace finback::memory {

// How many of `count` elements, the first at `address` in [base, end) and each `stride` bytes from
// the one before, start within [base, end) before the first that does not. `end` may be 2^32.
[[nodiscard]] inline std::uint32_t elements_within(Address address, std::int32_t stride,
                                                   std::uint32_t count, std::uint64_t base,
                                                   std::uint64_t end) {
  if (stride == 0) {
    return count;
  }
  const std::uint64_t step = static_cast<std::uint64_t>(std::abs(std::int64_t{stride}));
  const std::uint64_t steps = stride > 0 ? (end - 1 - address) / step : (address - base) / step;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(count, steps + 1));
}

}  // namespace finback::memory
