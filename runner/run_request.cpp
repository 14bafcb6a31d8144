#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include <common/file.hpp>
#include <power_model/power_file.hpp>
#include <runner/find_machine.hpp>
#include <runner/load_cameras.hpp>
#include <runner/movables.hpp>
#include <runner/run_request.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

namespace {

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

struct FlashOption {
  std::string name;
  fs::path file;
  std::optional<Address> at;
};

// "[NAME=]FILE[@ADDRESS]": without NAME the file's own, and from the beginning of flash on.
FlashOption parse_flash(const std::string& text) {
  constexpr Address kFlash = 0x20000000;
  FlashOption option;
  const std::size_t equals = text.find('=');
  std::string file = equals == std::string::npos ? text : text.substr(equals + 1);
  if (const std::size_t sign = file.rfind('@'); sign != std::string::npos) {
    const std::string digits = file.substr(sign + 1);
    std::size_t read = 0;
    unsigned long address = 0;
    try {
      address = std::stoul(digits, &read, 0);
    } catch (const std::logic_error&) {
      read = 0;
    }
    if (read == 0 || read != digits.size() || address > 0xFFFFFFFF || address % 4 != 0) {
      throw InputError(
          fmt::format("--flash {}: '{}' is no address, such as 0x20000000; it is a multiple of 4",
                      text, digits));
    }
    option.at = static_cast<Address>(address);
    file.resize(sign);
  }
  if (file.empty() || equals == 0) {
    throw InputError(fmt::format("--flash {}: wants [NAME=]FILE[@ADDRESS]", text));
  }
  option.file = file;
  if (equals != std::string::npos) {
    option.name = text.substr(0, equals);
    return option;
  }
  option.name = option.file.filename().string();
  std::ranges::replace_if(
      option.name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  option.at = option.at.value_or(kFlash);
  return option;
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

}  // namespace

std::unique_ptr<machine::MachineDescription> load_machine(
    const std::string& name, const std::vector<std::string>& settings) {
  auto description = name.empty() ? std::make_unique<machine::MachineDescription>()
                                  : machine::load_machine(find_machine(name));
  for (const std::string& setting : settings) {
    apply_setting(*description, setting);
  }
  return description;
}

void apply_flash(LoadedFirmware& loaded, const std::vector<std::string>& files) {
  for (const std::string& text : files) {
    ir::FirmwareUnits& units = loaded.firmware.units;
    const FlashOption option = parse_flash(text);
    ir::add_flash(units, option.name, option.file, option.at, SourcePlace{"--flash " + text});
    const auto& bytes = std::ranges::find(units.flash, option.name, &ir::FlashFile::name)->bytes;
    loaded.identity.hash = report::content_hash(
        fmt::format("{}\n{} {}\n", loaded.identity.hash, option.name,
                    report::content_hash(std::string(bytes.begin(), bytes.end()))));
  }
}

void load_linked(const RunRequest& request, RunInputs& inputs) {
  inputs.machine = load_machine(request.machine, request.settings);
  inputs.firmware = find_firmware(
      request.firmware,
      request.placement.empty() ? std::nullopt : std::optional<fs::path>(request.placement));
  apply_flash(inputs.firmware, request.flash);
  std::vector<Move> moves;
  for (const std::string& move : request.moves) {
    moves.push_back(parse_move(move));
  }
  apply_moves(inputs.firmware, moves);
}

RunInputs load_inputs(const RunRequest& request) {
  RunInputs inputs;
  load_scene(request, inputs);
  inputs.camera_troubles = camera_troubles(request);
  inputs.ports = request.ports;
  load_linked(request, inputs);
  if (request.camera_rate > 0) {
    inputs.machine->set("camera.frame_rate", request.camera_rate);
  }
  if (!request.power.empty()) {
    auto power = std::make_shared<power::PowerParameters>();
    power::load_power_parameters(request.power, *power);
    inputs.power = power;
    inputs.power_name = fs::path(request.power).filename().string();
  }
  inputs.frames = request.frames;
  inputs.check_races = request.check_races;
  // Two seconds a frame: ten times what the slowest of the camera's firmwares needs.
  const double seconds =
      request.max_seconds > 0 ? request.max_seconds : 2.0 * (request.frames + 1.0);
  inputs.cycle_limit = static_cast<Cycles>(seconds * inputs.machine->clock.cclk_mhz * 1e6);
  return inputs;
}

}  // namespace finback::runner
