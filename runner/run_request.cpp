#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>

#include <common/file.hpp>
#include <common/parameter.hpp>
#include <power_model/power_file.hpp>
#include <runner/run_request.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

namespace {

constexpr std::array<ir::Owner, 3> kOwners = {ir::Owner::core_a, ir::Owner::core_b,
                                              ir::Owner::shared};

// "NAME=VALUE" of an option, at the first equals sign.
std::pair<std::string, std::string> split_assignment(const std::string& option,
                                                     const std::string& text,
                                                     const std::string& form) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw InputError(fmt::format("{} {}: wants {}", option, text, form));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

Move parse_move(const std::string& text) {
  const auto [thing, region] = split_assignment("--place", text, "OWNER.NAME=REGION");
  Move move = parse_movable(thing, SourcePlace{"--place " + text});
  move.region = region;
  return move;
}

void apply_setting(machine::MachineDescription& machine, const std::string& text) {
  const auto [name, value] = split_assignment("--set", text, "PARAMETER=NUMBER");
  std::size_t read = 0;
  double number = 0;
  try {
    number = std::stod(value, &read);
  } catch (const std::logic_error&) {
    read = 0;
  }
  if (read != value.size() || !std::isfinite(number)) {
    throw InputError(fmt::format("--set {}: '{}' is not a number", text, value));
  }
  try {
    machine.set(name, number);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--set {}: {}", text, error.what()));
  }
}

// The C names of what an owner has.
struct Names {
  std::vector<std::string> objects;
  std::vector<std::string> functions;

  [[nodiscard]] static bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
};

Names names_of(const ir::FirmwareUnits& units, ir::Owner owner) {
  const std::vector<ir::Unit>& list = owner == ir::Owner::shared
                                          ? units.shared
                                          : units.cores[static_cast<std::size_t>(owner)].units;
  Names names;
  for (const ir::Unit& unit : list) {
    for (const ir::Object& object : unit->objects) {
      names.objects.push_back(ir::c_name(object.name));
    }
    for (const ir::Function& function : unit->functions) {
      names.functions.push_back(ir::c_name(function.name));
    }
  }
  if (owner != ir::Owner::shared) {
    names.objects.emplace_back(ir::kStackName);
  }
  return names;
}

[[noreturn]] void fail_unknown(const ir::FirmwareUnits& units, const Move& move,
                               const Names& names) {
  for (const ir::Owner other : kOwners) {
    const Names theirs = names_of(units, other);
    if (other != move.owner &&
        (Names::has(theirs.objects, move.name) || Names::has(theirs.functions, move.name))) {
      throw InputError(move.written,
                       fmt::format("{} has no object or function {}, but {} has",
                                   ir::owner_name(move.owner), move.name, ir::owner_name(other)));
    }
  }
  std::vector<std::string> all = names.objects;
  all.insert(all.end(), names.functions.begin(), names.functions.end());
  const std::string near = nearest_name(move.name, all);
  throw InputError(
      move.written,
      fmt::format(
          "{} has no object or function {}{}", ir::owner_name(move.owner), move.name,
          near.empty() ? "; finback profile lists them" : fmt::format(", did you mean {}?", near)));
}

void apply_move(LoadedFirmware& loaded, const Move& move) {
  ir::Placement& placement = loaded.firmware.placement;
  const Names names = names_of(loaded.firmware.units, move.owner);
  if (move.name == ir::kStackName && move.owner != ir::Owner::shared) {
    ir::OwnerPlacement& owner = placement.of(move.owner);
    owner.stack_region = move.region;
    owner.stack_written = move.written;
  } else if (Names::has(names.objects, move.name)) {
    placement.override_object(move.owner, move.name, move.region, move.written);
  } else if (Names::has(names.functions, move.name)) {
    placement.override_function(move.owner, move.name, move.region, move.written);
  } else {
    fail_unknown(loaded.firmware.units, move, names);
  }
}

}  // namespace

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
    apply_move(loaded, move);
    const std::string thing = fmt::format("{}.{}=", ir::owner_name(move.owner), move.name);
    std::erase_if(lines, [&](const std::string& line) { return line.starts_with(thing); });
    lines.push_back(thing + move.region);
  }
  std::sort(lines.begin(), lines.end());
  loaded.placement.name += fmt::format(" + {} moved", lines.size());
  loaded.placement.hash =
      report::content_hash(fmt::format("{}\n{}\n", loaded.placement.hash, fmt::join(lines, "\n")));
}

RunInputs load_inputs(const RunRequest& request) {
  RunInputs inputs;
  inputs.scene = request.left.empty() ? scenes::load_scene(request.scene, share_folder() / "scenes")
                                      : scenes::load_scene_pair(request.left, request.right);
  inputs.machine = request.machine.empty() ? std::make_unique<machine::MachineDescription>()
                                           : machine::load_machine(request.machine);
  for (const std::string& setting : request.settings) {
    apply_setting(*inputs.machine, setting);
  }
  inputs.firmware = find_firmware(
      request.firmware,
      request.placement.empty() ? std::nullopt : std::optional<fs::path>(request.placement));
  std::vector<Move> moves;
  for (const std::string& move : request.moves) {
    moves.push_back(parse_move(move));
  }
  apply_moves(inputs.firmware, moves);
  if (!request.power.empty()) {
    auto power = std::make_shared<power::PowerParameters>();
    power::load_power_parameters(request.power, *power);
    inputs.power = power;
    inputs.power_name = fs::path(request.power).filename().string();
  }
  inputs.frames = request.frames;
  // Two seconds a frame: ten times what the slowest of the camera's firmwares needs.
  const double seconds =
      request.max_seconds > 0 ? request.max_seconds : 2.0 * (request.frames + 1.0);
  inputs.cycle_limit = static_cast<Cycles>(seconds * inputs.machine->clock.cclk_mhz * 1e6);
  return inputs;
}

RunRequest read_run_request(const TomlReader& reader, const toml::table& table) {
  reader.check_keys(table, "[run]",
                    {"firmware", "scene", "left", "right", "frames", "machine", "placement",
                     "power", "place", "set", "max_seconds"});
  const fs::path folder = fs::path(reader.file()).parent_path();
  const auto path = [&](std::string_view key) {
    const std::string text = reader.string(table, key);
    return text.empty() ? text : (folder / text).string();
  };
  RunRequest request;
  // Firmwares and scenes have names; what looks like a path is one.
  if (const std::string name = reader.string(table, "firmware"); !name.empty()) {
    const bool is_path = name.find('/') != std::string::npos || name.find('.') != std::string::npos;
    request.firmware = is_path ? (folder / name).string() : name;
  }
  if (const std::string name = reader.string(table, "scene"); !name.empty()) {
    request.scene = name;
  }
  request.left = path("left");
  request.right = path("right");
  if (request.left.empty() != request.right.empty()) {
    reader.fail(table, "[run] has one of left and right: a pair needs both");
  }
  request.machine = path("machine");
  request.placement = path("placement");
  request.power = path("power");
  if (const toml::node* node = table.get("place")) {
    request.moves = reader.strings(*node, "place");
  }
  if (const toml::node* node = table.get("set")) {
    request.settings = reader.strings(*node, "set");
  }
  if (const toml::node* node = table.get("frames")) {
    const auto frames = node->value_exact<std::int64_t>();
    if (!frames || *frames < 1 || *frames > kMostFrames) {
      reader.fail(*node, fmt::format("frames wants a whole number from 1 to {}", kMostFrames));
    }
    request.frames = static_cast<std::uint32_t>(*frames);
  }
  if (const toml::node* node = table.get("max_seconds")) {
    const auto seconds = node->value<double>();
    if (!seconds || !(*seconds > 0)) {
      reader.fail(*node, "max_seconds wants a number above 0");
    }
    request.max_seconds = *seconds;
  }
  return request;
}

}  // namespace finback::runner
