// What a placement axis moves: the objects, functions and stacks of a firmware by name or pattern.
#pragma once

#include <vector>

#include <runner/run_request.hpp>

namespace finback::explorer {

// What `named` (whose name may be a pattern of `*` and `?`) means in a firmware, in the order of
// the units: all objects of that name, the stack among them, or else all functions. Throws
// InputError at `named.written` when there are none, naming the nearest or whose they are.
struct Movables {
  std::vector<runner::Move> things;  // without regions
  bool functions = false;
};
[[nodiscard]] Movables find_movables(const ir::FirmwareUnits& units, const runner::Move& named);

// Throws InputError at `written` when `owner` has no region of that name, naming the nearest, or
// when it does not hold such things.
void check_region(const memory::MemoryMap& map, ir::Owner owner, const std::string& region,
                  bool functions, const SourcePlace& written);

}  // namespace finback::explorer
