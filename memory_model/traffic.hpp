// Who moved how many bytes where, at what cost: the counts that the memory system keeps.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <common/units.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::memory {

enum class Direction : std::uint8_t { read, write };
inline constexpr int kDirectionCount = 2;
inline constexpr std::array<std::string_view, kDirectionCount> kDirectionNames = {"read", "write"};

struct Traffic {
  std::uint64_t accesses = 0;
  Bytes bytes = 0;
  // Cores: cycles lost beyond the issue cycle. DMA: cycles that bursts waited for somebody else.
  Cycles stall_cycles = 0;

  Traffic& operator+=(const Traffic& other) {
    accesses += other.accesses;
    bytes += other.bytes;
    stall_cycles += other.stall_cycles;
    return *this;
  }
  friend bool operator==(const Traffic&, const Traffic&) = default;
};

// By initiator, then by direction.
using TrafficTable = std::array<std::array<Traffic, kDirectionCount>, kInitiatorCount>;

// An object (or "(free)": a region's bytes that nothing was placed on) and all its traffic.
struct ObjectTraffic {
  std::string name;
  std::string owner;   // "core_a", "core_b" or "shared"
  std::string region;  // as the map names it
  Level level = Level::l1;
  Address address = 0;     // of its first byte; of the first free byte for "(free)"
  std::uint32_t size = 0;  // bytes
  TrafficTable traffic{};
};

}  // namespace finback::memory
