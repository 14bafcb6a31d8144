#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

#include <common/parameter.hpp>
#include <common/pattern.hpp>
#include <isa_sim/ir/layout.hpp>
#include <isa_sim/isa/instruction.hpp>

namespace finback::ir {
namespace {

using memory::MemoryMap;
using memory::Region;

constexpr std::uint32_t kNullGuard = 4096;  // bytes that stay free at address 0
constexpr std::uint32_t kStackAlign = 8;

std::string describe(const Thing& thing) {
  const char* kind = thing.is_stack() ? "the"
                     : thing.piece    ? "section"
                     : thing.function ? "function"
                                      : "object";
  return fmt::format("{} {}", kind, thing.name);
}

std::uint32_t code_size(const Function& function) {
  const auto table = isa::instruction_table();
  std::uint32_t size = 0;
  for (const Packet& packet : function.packets) {
    size += packet_length(packet, table);
  }
  return size;
}

// --- which definitions take part ---

// One owner's definitions in the order of the text, without weak ones that a stronger replaces.
class Collector {
 public:
  Collector(Owner owner, const std::vector<Unit>& units) : owner_(owner) {
    for (const Unit& unit : units) {
      collect(*unit);
    }
  }

  std::vector<Thing> take() {
    std::vector<Thing> kept;
    for (std::size_t i = 0; i < things_.size(); ++i) {
      if (things_[i].binding != Binding::weak || strongest_.at(things_[i].symbol) == i) {
        kept.push_back(std::move(things_[i]));
      }
    }
    return kept;
  }

 private:
  void collect(const Program& unit) {
    for (const Function& function : unit.functions) {
      if (owner_ == Owner::shared) {
        throw InputError(function.written,
                         fmt::format("function {} stands in a shared unit: shared units have "
                                     "objects only, list the unit under each core that calls it",
                                     c_name(function.name)));
      }
      Thing thing;
      thing.function = &function;
      thing.symbol = function.name;
      thing.binding = function.binding;
      thing.align = std::max(function.align, 2u);
      thing.size = code_size(function);
      thing.written = function.written;
      add(unit, std::move(thing));
    }
    for (const Object& object : unit.objects) {
      Thing thing;
      thing.object = &object;
      thing.symbol = object.name;
      thing.binding = object.binding;
      thing.align = object.align;
      thing.size = object.size;
      thing.written = object.written;
      add(unit, std::move(thing));
    }
    for (const Piece& piece : unit.pieces) {
      add_piece(unit, piece);
    }
  }

  void add_piece(const Program& unit, const Piece& piece) {
    if (owner_ == Owner::shared && !piece.packets.empty()) {
      throw InputError(piece.written,
                       fmt::format("{} has instructions, but stands in a shared unit: list the "
                                   "file under each core that runs it",
                                   piece.name));
    }
    Thing thing;
    thing.piece = &piece;
    thing.symbol = piece.name;
    thing.align = std::max(piece.align, piece.code ? 2u : 1u);
    thing.size = piece.size;
    thing.written = piece.written;
    for (const PieceLabel& label : piece.labels) {
      if (label.binding == Binding::global) {
        define(label.name, label.written);
      }
    }
    add(unit, std::move(thing));
  }

  void add(const Program& unit, Thing thing) {
    thing.owner = owner_;
    thing.unit = &unit;
    thing.name = c_name(thing.symbol);
    const std::size_t index = things_.size();
    if (thing.binding != Binding::local) {
      const auto [found, first] = strongest_.emplace(thing.symbol, index);
      if (!first && thing.binding == Binding::global) {
        found->second = index;
      }
    }
    if (thing.binding == Binding::global) {
      define(thing.symbol, thing.written);
    }
    things_.push_back(std::move(thing));
  }

  void define(const std::string& symbol, const SourcePlace& written) {
    const auto [found, first] = defined_.emplace(symbol, written);
    if (!first) {
      throw InputError(written, fmt::format("{} of {} is defined already, at {}", symbol,
                                            owner_name(owner_), found->second.to_string()));
    }
  }

  Owner owner_;
  std::vector<Thing> things_;
  std::map<std::string, std::size_t> strongest_;  // global symbol -> index of its definition
  std::map<std::string, SourcePlace> defined_;    // global, not weak
};

// --- where they go ---

class Layout {
 public:
  Layout(const FirmwareUnits& firmware, const Placement& placement, const MemoryMap& map)
      : firmware_(firmware), placement_(placement), map_(map) {
    for (const Owner owner : kOwners) {
      fit_to_machine(owner);
    }
  }

  std::vector<Thing> run() {
    for (const Owner owner : kOwners) {
      if (present(owner)) {
        check_machine(owner);
        check_lists(owner);
        things_[index_of(owner)] = Collector(owner, units_of(owner)).take();
        check_patterns(owner);
      }
    }
    place_fixed();
    for (const Owner owner : kOwners) {
      if (present(owner)) {
        place_stack(owner);
        place_all(owner, true);
      }
    }
    for (const Owner owner : kOwners) {
      if (present(owner)) {
        place_all(owner, false);
      }
    }
    return std::move(placed_);
  }

 private:
  static constexpr std::array kOwners = {Owner::core_a, Owner::core_b, Owner::shared};

  static std::size_t index_of(Owner owner) { return static_cast<std::size_t>(owner); }
  static int core_of(Owner owner) { return owner == Owner::shared ? -1 : static_cast<int>(owner); }
  [[nodiscard]] bool present(Owner owner) const {
    return owner == Owner::shared || firmware_.cores[index_of(owner)].present;
  }
  [[nodiscard]] const std::vector<Unit>& units_of(Owner owner) const {
    return owner == Owner::shared ? firmware_.shared : firmware_.cores[index_of(owner)].units;
  }

  // --- checks of the placement ---

  void check_machine(Owner owner) const {
    const int core = core_of(owner);
    if (core >= 0 && std::ranges::find(map_.regions, core, &Region::core) == map_.regions.end()) {
      throw InputError(fmt::format(
          "{} has code for {}, which this machine does not have: no region of its map is {}'s",
          firmware_.path, owner_name(owner), owner_name(owner)));
    }
  }

  // A list names regions in order of preference: those of the BF561 that this machine lacks are
  // left out, as long as another one stays.
  void fit_to_machine(Owner owner) {
    static const MemoryMap bf561 = memory::bf561_map();
    const int core = core_of(owner);
    const auto absent = [&](const std::string& name) {
      return map_.find(core, name) == nullptr && bf561.find(core, name) != nullptr;
    };
    const auto fit = [&](RegionList& list) {
      if (!std::ranges::all_of(list.names, absent)) {
        std::erase_if(list.names, absent);
      }
    };
    OwnerPlacement& own = placement_.of(owner);
    fit(own.code);
    fit(own.defaults);
    for (std::vector<PlacementRule>* rules : {&own.functions, &own.objects}) {
      for (PlacementRule& rule : *rules) {
        fit(rule.regions);
      }
    }
  }

  const Region& region(Owner owner, const std::string& name, const SourcePlace& written,
                       bool code) const {
    const Region* found = map_.find(core_of(owner), name);
    if (found == nullptr || (owner == Owner::shared && found->core >= 0)) {
      const std::vector<std::string> known = map_.names(core_of(owner));
      const std::string nearest = nearest_name(name, known);
      throw InputError(
          written, fmt::format("{} has no region {}; {}", owner_name(owner), name,
                               nearest.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                                               : fmt::format("did you mean {}?", nearest)));
    }
    if (!(code ? found->code : found->data)) {
      throw InputError(
          written, fmt::format("region {} holds {}, not {}", name, code ? "data" : "instructions",
                               code ? "functions" : "objects"));
    }
    return *found;
  }

  void check_list(Owner owner, const RegionList& list, bool code) const {
    for (const std::string& name : list.names) {
      (void)region(owner, name, list.written, code);
    }
  }

  void check_lists(Owner owner) const {
    const OwnerPlacement& own = placement_.of(owner);
    check_list(owner, own.code, true);
    check_list(owner, own.defaults, false);
    for (const PlacementRule& rule : own.functions) {
      check_list(owner, rule.regions, true);
    }
    for (const PlacementRule& rule : own.objects) {
      check_list(owner, rule.regions, false);
    }
  }

  static bool matches(const PlacementRule& rule, const std::string& name) {
    return rule.exact ? rule.pattern == name : matches_pattern(rule.pattern, name);
  }

  void check_patterns(Owner owner) const {
    const OwnerPlacement& own = placement_.of(owner);
    check_patterns(owner, own.functions, true);
    check_patterns(owner, own.objects, false);
  }

  void check_patterns(Owner owner, const std::vector<PlacementRule>& rules, bool functions) const {
    std::vector<std::string> names;
    for (const Thing& thing : things_[index_of(owner)]) {
      if (thing.is_code() == functions) {
        names.push_back(thing.name);
      }
    }
    for (const PlacementRule& rule : rules) {
      if (std::ranges::none_of(names, [&](const auto& name) { return matches(rule, name); })) {
        const std::string nearest = nearest_name(rule.pattern, names);
        throw InputError(rule.regions.written,
                         fmt::format("{} has no {} {}{}", owner_name(owner),
                                     functions ? "function" : "object", rule.pattern,
                                     nearest.empty() ? elsewhere(owner, rule, functions)
                                                     : fmt::format(", did you mean {}?", nearest)));
      }
    }
  }

  // Whether another owner has what a rule looks for.
  [[nodiscard]] std::string elsewhere(Owner owner, const PlacementRule& rule,
                                      bool functions) const {
    for (const Owner other : kOwners) {
      if (other == owner || !present(other)) {
        continue;
      }
      for (const Thing& thing : Collector(other, units_of(other)).take()) {
        if (thing.is_code() == functions && matches(rule, thing.name)) {
          return fmt::format(", but {} has: move the line to [{}.{}]", owner_name(other),
                             owner_name(other), functions ? "functions" : "objects");
        }
      }
    }
    return "";
  }

  // --- finding room ---

  // The regions that rules name for a thing, or nothing when it goes by default.
  [[nodiscard]] const RegionList* named(const Thing& thing) const {
    const PlacementRule* rule = rule_for(thing);
    return rule == nullptr ? nullptr : &rule->regions;
  }

  [[nodiscard]] const PlacementRule* rule_for(const Thing& thing) const {
    const OwnerPlacement& own = placement_.of(thing.owner);
    const auto& rules = thing.is_code() ? own.functions : own.objects;
    const auto found = std::ranges::find_if(
        rules, [&](const PlacementRule& rule) { return matches(rule, thing.name); });
    return found == rules.end() ? nullptr : &*found;
  }

  // Of a thing that comes out of a file, or nullptr.
  [[nodiscard]] const FlashFile* file_of(const Thing& thing) const {
    const auto found = std::ranges::find(firmware_.flash, thing.name, &FlashFile::name);
    return thing.owner != Owner::shared || found == firmware_.flash.end() ? nullptr : &*found;
  }

  // Files that say where they stand, lowest first; whatever else goes there comes behind them.
  void place_fixed() {
    std::vector<Thing> fixed;
    for (const Thing& thing : things_[index_of(Owner::shared)]) {
      const FlashFile* file = file_of(thing);
      if (file != nullptr && file->at) {
        fixed.push_back(thing);
        fixed.back().address = *file->at;
      }
    }
    std::ranges::stable_sort(fixed, {}, &Thing::address);
    for (Thing& thing : fixed) {
      const Region* found = map_.find(thing.address);
      if (found == nullptr || !found->data || found->core >= 0 ||
          !found->contains(thing.address, thing.size)) {
        throw InputError(
            thing.written,
            fmt::format("{}: {} bytes at {:#010x} do not lie in one region of shared memory",
                        file_of(thing)->path.filename().string(), thing.size, thing.address));
      }
      const std::uint32_t offset = thing.address - found->base;
      if (used_.contains(found->base) && offset < used(*found)) {
        throw InputError(thing.written, fmt::format("{} at {:#010x} overlaps {}", thing.name,
                                                    thing.address, placed_.back().name));
      }
      const PlacementRule* rule = rule_for(thing);
      if (rule != nullptr && (rule->exact || rule->pattern == thing.name)) {
        throw InputError(rule->regions.written,
                         fmt::format("{} stands at {:#010x}, which {} says: no placement moves it",
                                     thing.name, thing.address, thing.written.to_string()));
      }
      used(*found) = offset + thing.size;
      thing.region = found;
      placed_.push_back(std::move(thing));
    }
  }

  void place_stack(Owner owner) {
    const OwnerPlacement& own = placement_.of(owner);
    if (owner == Owner::shared) {
      return;
    }
    Thing stack;
    stack.owner = owner;
    stack.symbol = stack.name = kStackName;
    stack.align = kStackAlign;
    stack.size = own.stack_size;
    place(std::move(stack), {{own.stack_region}, own.stack_written}, true);
  }

  // Functions first, then objects, each in the order of the text.
  void place_all(Owner owner, bool by_name) {
    const OwnerPlacement& own = placement_.of(owner);
    for (const bool functions : {true, false}) {
      for (const Thing& thing : things_[index_of(owner)]) {
        const RegionList* rule = named(thing);
        const FlashFile* file = file_of(thing);
        if (thing.is_code() != functions || (rule != nullptr) != by_name ||
            (file != nullptr && file->at)) {
          continue;
        }
        if (file != nullptr && !by_name) {
          place(thing, {{"flash"}, file->written}, true);
        } else {
          place(thing, by_name ? *rule : (functions ? own.code : own.defaults), by_name);
        }
      }
    }
  }

  std::uint32_t& used(const Region& region) {
    return used_.try_emplace(region.base, region.base == 0 ? kNullGuard : 0).first->second;
  }

  // The offset at which a thing fits into a region.
  std::optional<std::uint32_t> room(const Region& region, const Thing& thing) {
    const std::uint64_t align = thing.align;
    const std::uint64_t address =
        (std::uint64_t{region.base} + used(region) + align - 1) / align * align;
    const std::uint64_t offset = address - region.base;
    if (offset + thing.size > region.size) {
      return std::nullopt;
    }
    return static_cast<std::uint32_t>(offset);
  }

  void place(Thing thing, const RegionList& list, bool by_name) {
    for (const std::string& name : list.names) {
      const Region& found = region(thing.owner, name, list.written, thing.is_code());
      if (const auto offset = room(found, thing)) {
        used(found) = *offset + thing.size;
        thing.region = &found;
        thing.address = found.base + *offset;
        placed_.push_back(std::move(thing));
        return;
      }
    }
    overflow(thing, list, by_name);
  }

  [[noreturn]] void overflow(const Thing& thing, const RegionList& list, bool by_name) {
    std::string message;
    if (list.names.size() == 1) {
      const Region& full = region(thing.owner, list.names[0], list.written, thing.is_code());
      message = fmt::format(
          "{} overflows: {} of {} has {} bytes (alignment {}), but of {} bytes {} are taken",
          full.name, describe(thing), owner_name(thing.owner), thing.size, thing.align, full.size,
          used(full));
    } else {
      message =
          fmt::format("no room for {} of {}, {} bytes (alignment {}), in any of {}{}",
                      describe(thing), owner_name(thing.owner), thing.size, thing.align,
                      fmt::join(list.names, ", "), by_name ? "" : ", where it goes by default");
    }
    for (const std::string& name : list.names) {
      message += residents(region(thing.owner, name, list.written, thing.is_code()));
    }
    throw InputError(list.written, message);
  }

  // Who is in a region, largest first, one line each.
  std::string residents(const Region& full) {
    std::vector<const Thing*> inside;
    for (const Thing& thing : placed_) {
      if (thing.region == &full) {
        inside.push_back(&thing);
      }
    }
    std::ranges::stable_sort(inside, std::ranges::greater{}, &Thing::size);
    std::string text =
        fmt::format("\n  in {} ({} of {} bytes taken):", full.name, used(full), full.size);
    for (const Thing* thing : inside) {
      text +=
          fmt::format("\n    {:>9}  {} ({})", thing->size, thing->name, owner_name(thing->owner));
    }
    return text;
  }

  const FirmwareUnits& firmware_;
  Placement placement_;
  const MemoryMap& map_;
  std::array<std::vector<Thing>, 3> things_;  // by owner, in the order of the text
  std::map<Address, std::uint32_t> used_;     // by a region's base: bytes taken, with gaps
  std::vector<Thing> placed_;
};

}  // namespace

std::vector<Thing> lay_out(const FirmwareUnits& firmware, const Placement& placement,
                           const MemoryMap& map) {
  return Layout(firmware, placement, map).run();
}

}  // namespace finback::ir
