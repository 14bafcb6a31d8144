// The address map: which regions of memory a chip and its board have, where, how large, and whose.
//
// Models the BF561's map of both cores (hardware.md 2.1; machine files may change bases and sizes).
// Does not model cached or mirrored aliases. Devices (MMRs, 0xFFC00000 up) are not memory and not
// in the map.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <common/units.hpp>

namespace finback::memory {

enum class Level : std::uint8_t { l1, l2, l3 };
inline constexpr int kLevelCount = 3;
inline constexpr std::array<std::string_view, kLevelCount> kLevelNames = {"l1", "l2", "l3"};

// Everything that moves bytes; counters carry these names. A channel's descriptors count as its
// data. PPI0 and PPI1 go by their names; `dma1` and `dma2` are the other peripherals of the two
// controllers. A stream of memory DMA counts what its source reads and its destination writes.
enum class Initiator : std::uint8_t {
  core_a,
  core_b,
  ppi0,
  ppi1,
  dma1,
  dma2,
  mdma1_0,
  mdma1_1,
  mdma2_0,
  mdma2_1,
  imdma_0,
  imdma_1,
  host
};
inline constexpr int kInitiatorCount = 13;
inline constexpr std::array<std::string_view, kInitiatorCount> kInitiatorNames = {
    "core_a",  "core_b",  "ppi0",    "ppi1",    "dma1",    "dma2", "mdma1_0",
    "mdma1_1", "mdma2_0", "mdma2_1", "imdma_0", "imdma_1", "host"};

struct Region {
  std::string
      name;  // as one core's program and its placement say: "l1.data.a", "l1.code", "l2", "l3"
  Address base = 0;
  std::uint32_t size = 0;
  Level level = Level::l1;
  int core = -1;                  // whose L1 it is: 0 or 1; -1: shared by both
  bool code = false;              // instructions may be placed here
  bool data = false;              // objects and stacks may be placed here
  bool dma_reachable = true;      // scratchpad is not
  bool read_only = false;         // stores and DMA cannot change it: flash
  std::uint32_t cache_bytes = 0;  // its last bytes, which can be a cache instead; L1 only
  // The first byte that can be cache.
  [[nodiscard]] Address cache_base() const { return base + (size - cache_bytes); }
  [[nodiscard]] bool contains(Address address, std::uint32_t bytes = 1) const {
    return address - base < size && bytes <= size - (address - base);
  }
};

struct MemoryMap {
  std::vector<Region> regions;  // ordered by base, not overlapping

  // The region that holds `address`, or nullptr.
  [[nodiscard]] const Region* find(Address address) const;
  // The region that `core` (0 or 1) calls `name`: its own L1 region or a shared one; nullptr when
  // there is none.
  [[nodiscard]] const Region* find(int core, std::string_view name) const;
  // The names that `core` knows, for error messages; core -1: the shared ones.
  [[nodiscard]] std::vector<std::string> names(int core) const;
};

// The four banks of asynchronous memory, 64 MB each from 0x20000000 on, which share the external
// bus with the SDRAM: regions of L3 there are asynchronous.
inline constexpr int kAsyncBanks = 4;
[[nodiscard]] constexpr bool is_asynchronous(Address address) { return address >> 28U == 2; }
[[nodiscard]] constexpr int async_bank(Address address) {
  return static_cast<int>(address >> 26U & 3U);
}

// The BF561 on the MESVS board, with 64 MB of SDRAM and 8 MB of flash (hardware.md 2.1). The two 16
// KB halves of L1 instruction memory do not touch: they are "l1.code" and "l1.code.cache". The
// halves of a data bank do: "l1.data.a" (32 KB, 0xFF800000) is one region, since its SRAM half and
// its SRAM/cache half are neighbours.
[[nodiscard]] MemoryMap bf561_map();

}  // namespace finback::memory
