// Where the functions, objects and stacks of a firmware go: the contents of placement.toml.
//
// Names are C names; rules are tried in the order of the text and the first whose pattern (`*`,
// `?`) matches wins. Says nothing of addresses: the linker finds room. The format: docs/bir.md,
// "Placement".
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/ir/image.hpp>

namespace finback::ir {

// Regions in order of preference: the first with room is taken.
struct RegionList {
  std::vector<std::string> names;
  SourcePlace written;
};

struct PlacementRule {
  std::string pattern;
  bool exact = false;  // `pattern` is a name, not a pattern
  RegionList regions;
};

// What one owner's section says.
struct OwnerPlacement {
  RegionList code;           // functions that no rule names; empty for `shared`
  RegionList defaults;       // objects that no rule names
  std::string stack_region;  // empty for `shared`
  std::uint32_t stack_size = 0;
  SourcePlace stack_written;
  std::vector<PlacementRule> functions;
  std::vector<PlacementRule> objects;
};

struct Placement {
  std::string source;                    // the file, or "(default)"
  std::array<OwnerPlacement, 3> owners;  // by Owner

  [[nodiscard]] OwnerPlacement& of(Owner owner) { return owners[static_cast<std::size_t>(owner)]; }
  [[nodiscard]] const OwnerPlacement& of(Owner owner) const {
    return owners[static_cast<std::size_t>(owner)];
  }

  // Puts one object (or function) elsewhere, before all rules and earlier overrides. Names and
  // regions are checked when the firmware is linked; messages then begin with `written`.
  void override_object(Owner owner, const std::string& name, const std::string& region,
                       const SourcePlace& written = {"(override)"});
  void override_function(Owner owner, const std::string& name, const std::string& region,
                         const SourcePlace& written = {"(override)"});
};

// Code in L1, data in the L1 banks from B, the stack in the scratchpad, the rest in L2, then L3.
[[nodiscard]] Placement default_placement();

// Throws InputError "file:line: what" for text that is no TOML, unknown keys (naming the nearest)
// and values of the wrong kind. What a core's section leaves out is as in default_placement().
[[nodiscard]] Placement parse_placement(std::string_view text, const std::string& file);
[[nodiscard]] Placement load_placement(const std::filesystem::path& path);

// "core_a", "core_b", "shared".
[[nodiscard]] std::string_view owner_name(Owner owner);

}  // namespace finback::ir
