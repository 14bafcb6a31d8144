#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <common/parameter.hpp>
#include <common/pattern.hpp>
#include <runner/movables.hpp>

namespace finback::runner {

namespace {

constexpr std::array<ir::Owner, 3> kOwners = {ir::Owner::core_a, ir::Owner::core_b,
                                              ir::Owner::shared};

struct Names {
  std::vector<std::string> objects;
  std::vector<std::string> functions;
};

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) {
    names.push_back(name);
  }
}

Names names_of(const ir::FirmwareUnits& units, ir::Owner owner) {
  const bool shared = owner == ir::Owner::shared;
  const auto core = static_cast<std::size_t>(owner);
  Names names;
  for (const ir::Unit& unit : shared ? units.shared : units.cores[core].units) {
    for (const ir::Object& object : unit->objects) {
      add_once(names.objects, ir::c_name(object.name));
    }
    for (const ir::Function& function : unit->functions) {
      add_once(names.functions, ir::c_name(function.name));
    }
    for (const ir::Piece& piece : unit->pieces) {
      add_once(piece.code ? names.functions : names.objects, ir::c_name(piece.name));
    }
  }
  if (!shared && units.cores[core].present) {
    names.objects.emplace_back(ir::kStackName);
  }
  return names;
}

std::vector<std::string> matching(const std::vector<std::string>& names,
                                  const std::string& pattern) {
  std::vector<std::string> found;
  std::ranges::copy_if(names, std::back_inserter(found),
                       [&](const std::string& name) { return matches_pattern(pattern, name); });
  return found;
}

[[noreturn]] void fail_unknown(const ir::FirmwareUnits& units, const Move& named, Names names) {
  std::string hint;
  for (const ir::Owner other : kOwners) {
    const Names theirs = names_of(units, other);
    if (!matching(theirs.objects, named.name).empty() ||
        !matching(theirs.functions, named.name).empty()) {
      hint = fmt::format(", but {} has", ir::owner_name(other));
    }
  }
  if (hint.empty()) {
    names.objects.insert(names.objects.end(), names.functions.begin(), names.functions.end());
    const std::string near = nearest_name(named.name, names.objects);
    hint = near.empty() ? "" : fmt::format(", did you mean {}?", near);
  }
  throw InputError(named.written,
                   fmt::format("{} of firmware {} has no object or function {}{}",
                               ir::owner_name(named.owner), units.name, named.name, hint));
}

// One thing that is there.
void apply(ir::Placement& placement, const Move& move, bool function) {
  if (move.name == ir::kStackName && move.owner != ir::Owner::shared) {
    placement.of(move.owner).stack_region = move.region;
    placement.of(move.owner).stack_written = move.written;
  } else if (function) {
    placement.override_function(move.owner, move.name, move.region, move.written);
  } else {
    placement.override_object(move.owner, move.name, move.region, move.written);
  }
}

}  // namespace

Movables find_movables(const ir::FirmwareUnits& units, const Move& named) {
  const Names names = names_of(units, named.owner);
  Movables movables;
  std::vector<std::string> found = matching(names.objects, named.name);
  if (found.empty()) {
    found = matching(names.functions, named.name);
    movables.functions = true;
  }
  if (found.empty()) {
    fail_unknown(units, named, names);
  }
  for (const std::string& name : found) {
    movables.things.push_back({named.owner, name, "", named.written});
  }
  return movables;
}

void check_region(const memory::MemoryMap& map, ir::Owner owner, const std::string& region,
                  bool functions, const SourcePlace& written) {
  const int core = owner == ir::Owner::shared ? -1 : static_cast<int>(owner);
  const std::vector<std::string> known = map.names(core);
  if (std::ranges::find(known, region) == known.end()) {
    const std::string near = nearest_name(region, known);
    throw InputError(written,
                     fmt::format("{} has no region {}; {}", ir::owner_name(owner), region,
                                 near.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                                              : fmt::format("did you mean {}?", near)));
  }
  const memory::Region* found = map.find(core, region);
  if (!(functions ? found->code : found->data)) {
    throw InputError(
        written, fmt::format("region {} holds {}, not {}", region, functions ? "data" : "functions",
                             functions ? "functions" : "data"));
  }
}

Move parse_movable(std::string_view text, const SourcePlace& written) {
  const std::size_t dot = text.find('.');
  for (const ir::Owner owner : kOwners) {
    if (dot != std::string_view::npos && dot + 1 < text.size() &&
        text.substr(0, dot) == ir::owner_name(owner)) {
      return {owner, std::string(text.substr(dot + 1)), "", written};
    }
  }
  throw InputError(
      written,
      fmt::format("'{}' names no owner: write core_a.NAME, core_b.NAME or shared.NAME", text));
}

void apply_moves(LoadedFirmware& loaded, const std::vector<Move>& moves) {
  if (moves.empty()) {
    return;
  }
  std::vector<std::string> lines;
  for (const Move& move : moves) {
    const Movables movables = find_movables(loaded.firmware.units, move);
    for (Move thing : movables.things) {
      thing.region = move.region;
      apply(loaded.firmware.placement, thing, movables.functions);
      const std::string name = fmt::format("{}.{}=", ir::owner_name(thing.owner), thing.name);
      std::erase_if(lines, [&](const std::string& line) { return line.starts_with(name); });
      lines.push_back(name + thing.region);
    }
  }
  std::sort(lines.begin(), lines.end());
  loaded.placement.name += fmt::format(" + {} moved", lines.size());
  loaded.placement.hash =
      report::content_hash(fmt::format("{}\n{}\n", loaded.placement.hash, fmt::join(lines, "\n")));
}

}  // namespace finback::runner
