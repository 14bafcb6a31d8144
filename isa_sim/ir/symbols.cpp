#include <fmt/format.h>

#include <common/parameter.hpp>
#include <isa_sim/ir/symbols.hpp>
#include <isa_sim/isa/instruction.hpp>

namespace finback::ir {

Symbols::Symbols(const FirmwareUnits& firmware, std::span<const Thing> things)
    : firmware_(firmware), things_(things) {
  for (const Thing& thing : things_) {
    if (!thing.is_stack()) {
      enter_thing(thing);
    }
  }
  for (const Owner owner : {Owner::core_a, Owner::core_b, Owner::shared}) {
    for (const Unit& unit :
         owner == Owner::shared ? firmware_.shared : firmware_.cores[index_of(owner)].units) {
      for (const Constant& constant : unit->constants) {
        enter({owner, unit.get()}, constant.name, constant.binding, {constant.value, true, true});
      }
    }
  }
}

void Symbols::enter_thing(const Thing& thing) {
  const Scope scope = {thing.owner, thing.unit};
  enter(scope, thing.symbol, thing.binding,
        {thing.address, thing.is_code(), thing.piece != nullptr});
  if (thing.function != nullptr) {
    measure(*thing.function);
    functions_[scope].push_back(&thing);
  }
  if (thing.piece != nullptr) {
    for (const PieceLabel& label : thing.piece->labels) {
      enter(scope, label.name, label.binding,
            {thing.address + label.offset, thing.piece->code, true});
    }
  }
}

void Symbols::enter(const Scope& scope, const std::string& symbol, Binding binding,
                    const Target& target) {
  locals_[scope].emplace(symbol, Definition{target});
  if (binding == Binding::local) {
    return;
  }
  const bool weak = binding == Binding::weak;
  const auto [found, first] =
      globals_[index_of(scope.first)].emplace(symbol, Definition{target, weak});
  if (!first && found->second.weak && !weak) {
    found->second = {target};
  }
}

void Symbols::measure(const Function& function) {
  const auto [found, added] = offsets_.try_emplace(&function);
  if (!added) {
    return;
  }
  std::uint32_t offset = 0;
  for (const Packet& packet : function.packets) {
    found->second.push_back(offset);
    offset += packet_length(packet, isa::instruction_table());
  }
  found->second.push_back(offset);
}

std::optional<Symbols::Target> Symbols::label(const Thing& function,
                                              const std::string& symbol) const {
  const auto found = function.function->labels.find(symbol);
  if (found == function.function->labels.end()) {
    return std::nullopt;
  }
  return Target{function.address + offsets(*function.function)[found->second], true};
}

// Where an address is taken, the labels of the unit's functions are seen, too: tables of jumps, and
// labels as values in what was inlined elsewhere.
Symbols::Target Symbols::resolve(const Reference& reference, const std::string& symbol) const {
  const Thing& from = reference.from;
  if (from.function != nullptr) {
    if (const auto target = label(from, symbol)) {
      return *target;
    }
  }
  const auto unit = locals_.find({from.owner, from.unit});
  for (const Table* table : {unit == locals_.end() ? nullptr : &unit->second,
                             &globals_[index_of(from.owner)], &globals_[index_of(Owner::shared)]}) {
    if (table == nullptr) {
      continue;
    }
    const auto found = table->find(symbol);
    if (found != table->end()) {
      return found->second.target;
    }
  }
  if (reference.takes_address) {
    if (const auto target = label_of_unit(reference, symbol)) {
      return *target;
    }
  }
  undefined(reference, symbol);
}

std::optional<Symbols::Target> Symbols::label_of_unit(const Reference& reference,
                                                      const std::string& symbol) const {
  const auto functions = functions_.find({reference.from.owner, reference.from.unit});
  if (functions == functions_.end()) {
    return std::nullopt;
  }
  std::optional<Target> result;
  for (const Thing* function : functions->second) {
    const auto target = label(*function, symbol);
    if (target && result) {
      throw InputError(reference.place, fmt::format("{} takes the address of label {}, which two "
                                                    "functions of this file have",
                                                    reference.from.name, symbol));
    }
    result = target ? target : result;
  }
  return result;
}

std::optional<Address> Symbols::code(Owner owner, const std::string& symbol) const {
  const auto in = [&symbol](const Table& table) -> std::optional<Address> {
    const auto found = table.find(symbol);
    return found != table.end() && found->second.target.code
               ? std::optional(found->second.target.address)
               : std::nullopt;
  };
  std::optional<Address> address = in(globals_[index_of(owner)]);
  for (const Unit& unit : firmware_.cores[index_of(owner)].units) {
    const auto locals = locals_.find({owner, unit.get()});
    if (!address && locals != locals_.end()) {
      address = in(locals->second);
    }
  }
  return address;
}

void Symbols::undefined(const Reference& reference, const std::string& symbol) const {
  std::vector<std::string> known;
  for (const Thing& thing : things_) {
    const bool seen = thing.owner == reference.from.owner || thing.owner == Owner::shared;
    if (seen && (thing.binding != Binding::local || thing.unit == reference.from.unit)) {
      known.push_back(thing.symbol);
    }
    if (seen && thing.piece != nullptr) {
      for (const PieceLabel& label : thing.piece->labels) {
        if (label.binding != Binding::local || thing.unit == reference.from.unit) {
          known.push_back(label.name);
        }
      }
    }
  }
  const std::string nearest = nearest_name(symbol, known);
  const bool shared = reference.from.owner == Owner::shared;
  throw InputError(reference.place,
                   fmt::format("{} {} refers to {}, which {} defines{}",
                               reference.from.function != nullptr ? "function"
                               : reference.from.object != nullptr ? "object"
                                                                  : "section",
                               reference.from.name, symbol,
                               shared ? "no shared unit"
                                      : fmt::format("no unit of {} and no shared one",
                                                    owner_name(reference.from.owner)),
                               nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
}

}  // namespace finback::ir
