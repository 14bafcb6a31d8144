#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

#include <common/error.hpp>
#include <explorer/candidate.hpp>
#include <explorer/source_hash.hpp>
#include <isa_sim/ir/linker.hpp>
#include <report/run_result.hpp>
#include <runner/identity.hpp>

namespace finback::explorer {

namespace {

std::size_t firmware_of(const Space& space, const Point& point) {
  for (std::size_t i = 0; i < space.axes.size(); ++i) {
    if (space.axes[i].kind == AxisKind::firmware) {
      return space.axes[i].choices[point[i]].firmware;
    }
  }
  return 0;
}

std::vector<runner::Move> moves_of(const Space& space, const Point& point) {
  const std::size_t firmware = firmware_of(space, point);
  std::vector<runner::Move> moves;
  for (std::size_t i = 0; i < space.axes.size(); ++i) {
    const Axis& axis = space.axes[i];
    if (axis.kind != AxisKind::placement) {
      continue;
    }
    for (runner::Move move : axis.things[firmware]) {
      move.region = axis.choices[point[i]].region;
      move.written = axis.choices[point[i]].written;
      moves.push_back(std::move(move));
    }
  }
  return moves;
}

std::vector<Setting> settings_of(const Space& space, const Point& point) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < space.axes.size(); ++i) {
    const std::vector<Setting>& more = space.axes[i].choices[point[i]].settings;
    settings.insert(settings.end(), more.begin(), more.end());
  }
  return settings;
}

runner::LoadedFirmware placed_firmware(const Space& space, const Point& point) {
  runner::LoadedFirmware firmware = space.firmwares[firmware_of(space, point)];
  runner::apply_moves(firmware, moves_of(space, point));
  return firmware;
}

std::unique_ptr<machine::MachineDescription> machine_of(const Space& space, const Point& point) {
  auto machine = space.base.machine->clone();
  for (const Setting& setting : settings_of(space, point)) {
    machine->set(setting.parameter, setting.value);
  }
  return machine;
}

// The limit is a time, the same at every clock.
Cycles cycle_limit_of(const Space& space, const machine::MachineDescription& machine) {
  return static_cast<Cycles>(
      std::round(static_cast<double>(space.base.cycle_limit) *
                 (machine.clock.cclk_mhz / space.base.machine->clock.cclk_mhz)));
}

// --- identities ---

// The image with all that a run can see: code and data at their addresses, and their names.
std::string image_hash(const ir::Image& image) {
  std::string text;
  auto out = std::back_inserter(text);
  for (const ir::CoreImage& core : image.cores) {
    fmt::format_to(out, "core {} {} {}\n", core.present, core.entry, core.stack_top);
    for (const ir::PlacedFunction& function : core.functions) {
      fmt::format_to(out, "{} {} {} {}\n", function.name, function.region, function.address,
                     function.size);
    }
    for (const ir::PlacedPacket& packet : core.packets) {
      fmt::format_to(out, "{} {} {}", packet.address, packet.length, packet.count);
      for (std::size_t slot = 0; slot < packet.count; ++slot) {
        fmt::format_to(out, " {}", packet.slots[slot].instruction);
        for (const std::int32_t operand : packet.slots[slot].operand) {
          fmt::format_to(out, ",{}", operand);
        }
      }
      text += '\n';
    }
  }
  for (const ir::PlacedObject& object : image.objects) {
    fmt::format_to(out, "{} {} {} {} {} ", object.name, static_cast<int>(object.owner),
                   object.region, object.address, object.size);
    text.append(object.initial.begin(), object.initial.end());
    text += '\n';
  }
  return report::content_hash(text);
}

std::string key_of(const Identity& identity) {
  return report::content_hash(fmt::format(
      "{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n", identity.tool_version, identity.firmware,
      identity.firmware_hash, identity.image_hash, identity.machine_hash, identity.power_hash,
      identity.scene, identity.scene_hash, identity.frames, identity.cycle_limit));
}

// A layout, linked once for all points that share it.
struct Layout {
  std::string misfit;
  std::string image_hash;
};

Layout link_layout(const Space& space, const Point& point) {
  const runner::LoadedFirmware firmware = placed_firmware(space, point);
  try {
    return {"", image_hash(ir::link(firmware.firmware.units, firmware.firmware.placement,
                                    space.base.machine->placement_map()))};
  } catch (const InputError& error) {
    const std::string text = error.what();
    return {without_folders(space, text.substr(0, text.find('\n'))), ""};
  }
}

// The choices that decide a layout.
Point layout_part(const Space& space, const Point& point) {
  Point part;
  for (std::size_t i = 0; i < space.axes.size(); ++i) {
    const AxisKind kind = space.axes[i].kind;
    if (kind == AxisKind::firmware || kind == AxisKind::placement) {
      part.push_back(point[i]);
    }
  }
  return part;
}

// --- the command ---

// A word of a command line, between quotes when the shell would read more into it.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace

runner::RunInputs inputs_of(const Space& space, const Point& point) {
  runner::RunInputs inputs;
  inputs.firmware = placed_firmware(space, point);
  inputs.machine = machine_of(space, point);
  inputs.power = space.base.power;
  inputs.power_name = space.base.power_name;
  inputs.scene = space.base.scene;
  inputs.camera_troubles = space.base.camera_troubles;
  inputs.frames = space.base.frames;
  inputs.cycle_limit = cycle_limit_of(space, *inputs.machine);
  return inputs;
}

std::vector<Candidate> prepare(const Space& space, const std::vector<Point>& points,
                               const std::function<bool()>& cancelled) {
  if (space.base.sequence) {
    throw InputError(
        "explore tries its points side by side on one pair of pictures: frames_from, distort and "
        "misalign are for finback run and finback check");
  }
  Identity common;
  common.tool_version = fmt::format("{}+{}", FINBACK_VERSION, kSourceHash);
  common.power_hash = runner::power_hash(*space.base.power);
  common.scene = space.base.scene.name;
  common.scene_hash = runner::view_hash(space.base.scene, space.base.camera_troubles);
  common.frames = space.base.frames;
  std::map<Point, Layout> layouts;
  std::vector<Candidate> candidates;
  candidates.reserve(points.size());
  for (const Point& point : points) {
    if (cancelled && cancelled()) {
      break;
    }
    const auto [layout, is_new] = layouts.try_emplace(layout_part(space, point));
    if (is_new) {
      layout->second = link_layout(space, point);
    }
    Candidate candidate{point, layout->second.misfit, {}};
    if (candidate.misfit.empty()) {
      const auto machine = machine_of(space, point);
      const runner::LoadedFirmware& firmware = space.firmwares[firmware_of(space, point)];
      candidate.identity = common;
      candidate.identity.firmware = firmware.identity.name;
      candidate.identity.firmware_hash = firmware.identity.hash;
      candidate.identity.image_hash = layout->second.image_hash;
      candidate.identity.machine_hash = runner::machine_hash(*machine);
      candidate.identity.cycle_limit = cycle_limit_of(space, *machine);
      candidate.identity.key = key_of(candidate.identity);
    }
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

std::string without_folders(const Space& space, std::string text) {
  std::vector<std::filesystem::path> files = {space.file};
  for (const runner::LoadedFirmware& firmware : space.firmwares) {
    files.emplace_back(firmware.firmware.units.path);
    files.emplace_back(firmware.firmware.placement.source);
  }
  for (const std::filesystem::path& file : files) {
    const std::string folder = file.parent_path().string() + "/";
    for (std::size_t at = text.find(folder); folder.size() > 1 && at != std::string::npos;
         at = text.find(folder)) {
      text.erase(at, folder.size());
    }
  }
  return text;
}

std::string run_command(const Space& space, const Point& point) {
  const runner::RunRequest& request = space.request;
  const runner::RunRequest usual;
  std::string command = "finback run";
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) {
      command += fmt::format(" {} {}", option, shell_word(value));
    }
  };
  add("--left", request.left);
  add("--right", request.right);
  add("--scene", request.left.empty() ? request.scene : "");
  add("--frames", std::to_string(request.frames));
  const std::string& firmware = space.firmware_names[firmware_of(space, point)];
  add("--firmware", firmware == usual.firmware ? "" : firmware);
  add("--machine", request.machine);
  add("--placement", request.placement);
  add("--power", request.power);
  add("--max-seconds", request.max_seconds > 0 ? number_text(request.max_seconds) : "");
  for (const std::string& move : request.moves) {
    add("--place", move);
  }
  for (const std::string& setting : request.settings) {
    add("--set", setting);
  }
  for (const runner::Move& move : moves_of(space, point)) {
    add("--place", fmt::format("{}.{}={}", ir::owner_name(move.owner), move.name, move.region));
  }
  for (const Setting& setting : settings_of(space, point)) {
    add("--set", setting.parameter + "=" + number_text(setting.value));
  }
  return command;
}

}  // namespace finback::explorer
