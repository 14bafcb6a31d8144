// Firmware + placement + address map -> image: every function and object gets its address, every
// symbol its value.
//
// Placed in the order of the text: first the stacks and what rules name, then what goes by default;
// first region with room, lowest free address. No sorting by size or alignment, so that a layout
// can be read and foretold. Address 0 is never given to anything (the first 4 KB of a region at 0
// stay free). Does not build page tables or overlays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/ir/placement.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::ir {

// Throws InputError: unknown regions; patterns that match nothing; regions that overflow (first
// line says which, the lines after it who is in it); undefined and doubly defined symbols; branches
// and loops out of range.
[[nodiscard]] Image link(const FirmwareUnits& firmware, const Placement& placement,
                         const memory::MemoryMap& map);

// How full a region is.
struct RegionUse {
  std::string region;  // "l1.data.a"
  int core = -1;       // whose L1; -1: shared
  std::uint32_t size = 0;
  std::uint32_t used = 0;  // bytes of functions, objects and stacks, without gaps of alignment
  std::uint32_t end = 0;   // bytes from the base to the end of the last thing
};

// One entry a region of the map, in its order.
[[nodiscard]] std::vector<RegionUse> link_report(const Image& image, const memory::MemoryMap& map);

}  // namespace finback::ir
