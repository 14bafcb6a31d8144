// What can be put elsewhere in a firmware: its objects, functions and stacks, by name or pattern.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <memory_model/memory_map.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

// An object, a function or a stack ("stack") put into another region.
struct Move {
  ir::Owner owner = ir::Owner::core_a;
  std::string name;  // C name, or a pattern of `*` and `?`
  std::string region;
  SourcePlace written;  // where it was asked for: begins every message about it
};

// "core_b.shd_scores" -> owner and name. Throws InputError at `written` for anything else.
[[nodiscard]] Move parse_movable(std::string_view text, const SourcePlace& written);

// What `named` (whose name may be a pattern of `*` and `?`) means in a firmware, in the order of
// the units: all objects of that name, the stack among them, or else all functions. Throws
// InputError at `named.written` when there are none, naming the nearest or whose they are.
struct Movables {
  std::vector<Move> things;  // without regions
  bool functions = false;
};
[[nodiscard]] Movables find_movables(const ir::FirmwareUnits& units, const Move& named);

// Throws InputError at `written` when `owner` has no region of that name, naming the nearest, or
// when it does not hold such things.
void check_region(const memory::MemoryMap& map, ir::Owner owner, const std::string& region,
                  bool functions, const SourcePlace& written);

// Applies moves in their order, the last wins, and makes the placement's identity tell them. Throws
// InputError for names that the firmware does not have; regions are checked when it is linked.
void apply_moves(LoadedFirmware& firmware, const std::vector<Move>& moves);

}  // namespace finback::runner
