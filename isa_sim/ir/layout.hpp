// The first half of linking: which definitions take part, and where each goes.
//
// Knows sizes, regions and placement rules; symbols' values are linker.cpp's work.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/ir/placement.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::ir {

// A function, an object, a piece of an assembler file, or a stack of one owner.
struct Thing {
  Owner owner = Owner::shared;
  const Program* unit = nullptr;       // nullptr: a stack
  const Function* function = nullptr;  // one of the three, or a stack
  const Object* object = nullptr;
  const Piece* piece = nullptr;
  std::string symbol;  // as in the text
  std::string name;    // as C spells it
  Binding binding = Binding::local;
  std::uint32_t align = 1;
  std::uint32_t size = 0;
  SourcePlace written;
  const memory::Region* region = nullptr;  // found by lay_out
  Address address = 0;
  [[nodiscard]] bool is_stack() const {
    return function == nullptr && object == nullptr && piece == nullptr;
  }
  // Goes where functions go.
  [[nodiscard]] bool is_code() const {
    return function != nullptr || (piece != nullptr && piece->code);
  }
};

// Everything that is placed, in the order in which it was: named before defaulted, the order of the
// text within. Throws InputError as linker.hpp says.
[[nodiscard]] std::vector<Thing> lay_out(const FirmwareUnits& firmware, const Placement& placement,
                                         const memory::MemoryMap& map);

}  // namespace finback::ir
