// What the symbols of a firmware stand for, once everything has its place.
//
// Two names are the same only within their scope: labels of a function, symbols of a unit, of a
// core, of what both share, each hiding the next. Knows nothing of instructions.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <isa_sim/ir/layout.hpp>

namespace finback::ir {

[[nodiscard]] inline std::size_t index_of(Owner owner) { return static_cast<std::size_t>(owner); }

class Symbols {
 public:
  struct Target {
    Address address = 0;
    bool code = false;
    bool piece = false;  // of an assembler file: a place some bytes beyond may be branched to
  };
  // Who refers to a symbol.
  struct Reference {
    const Thing& from;
    SourcePlace place;
    bool takes_address = true;  // rather than going there
  };

  // Both must outlive the symbols.
  Symbols(const FirmwareUnits& firmware, std::span<const Thing> things);

  // Throws InputError at `reference` when nothing it sees defines the symbol.
  [[nodiscard]] Target resolve(const Reference& reference, const std::string& symbol) const;
  // Where a core's code of that name is, global or not.
  [[nodiscard]] std::optional<Address> code(Owner owner, const std::string& symbol) const;
  // The offset of each packet of a function, and of its end.
  [[nodiscard]] const std::vector<std::uint32_t>& offsets(const Function& function) const {
    return offsets_.at(&function);
  }

 private:
  struct Definition {
    Target target;
    bool weak = false;
  };
  using Table = std::unordered_map<std::string_view, Definition>;
  using Scope = std::pair<Owner, const Program*>;

  void enter_thing(const Thing& thing);
  void enter(const Scope& scope, const std::string& symbol, Binding binding, const Target& target);
  void measure(const Function& function);
  [[nodiscard]] std::optional<Target> label(const Thing& function, const std::string& symbol) const;
  [[nodiscard]] std::optional<Target> label_of_unit(const Reference& reference,
                                                    const std::string& symbol) const;
  [[noreturn]] void undefined(const Reference& reference, const std::string& symbol) const;

  const FirmwareUnits& firmware_;
  std::span<const Thing> things_;
  std::map<Scope, Table> locals_;
  std::map<Scope, std::vector<const Thing*>> functions_;
  std::array<Table, 3> globals_;
  std::unordered_map<const Function*, std::vector<std::uint32_t>> offsets_;
};

}  // namespace finback::ir
