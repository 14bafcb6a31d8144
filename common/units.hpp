// The units that every room speaks in. Time is exact: whole cycles of the core clock (CCLK).
#pragma once

#include <cstdint>

namespace finback {

using Address = std::uint32_t;  // a byte address in the machine's 32-bit space
using Cycles = std::uint64_t;   // core clock cycles (CCLK)
using Bytes = std::uint64_t;

inline constexpr Cycles kNever = ~Cycles{0};

inline constexpr int kCoreCount = 2;  // core A is 0, core B is 1
enum class CoreId : std::uint8_t { a = 0, b = 1 };

// "core_a", "core_b": as they stand in counter names and in placement files.
[[nodiscard]] constexpr const char* name_of(CoreId core) {
  return core == CoreId::a ? "core_a" : "core_b";
}

}  // namespace finback
