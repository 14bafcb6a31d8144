// The meeting point of a core and its own memory: bytes that can be touched without asking anybody.
#pragma once

#include <array>
#include <cstdint>

#include <common/units.hpp>

namespace finback {

// A piece of memory that one core reaches without a stall and that no other core does: its bytes
// can be touched directly. Accesses are counted here, by log2 of their size (1, 2, 4 bytes).
struct MemoryWindow {
  Address base = 0;
  std::uint32_t size = 0;  // 0: never matches, every access is slow
  std::uint8_t* bytes = nullptr;
  std::array<std::uint64_t, 3> reads{};
  std::array<std::uint64_t, 3> writes{};
};

}  // namespace finback
