// One run of a firmware on a scene: everything from loaded inputs to the result.
//
// Models nothing of its own: links the image, feeds the host port, runs the machine and gathers
// what its rooms counted into one report::RunResult. Touches no file but those it is told to load.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <isa_sim/core/profile.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/race_report.hpp>
#include <peripheral_model/camera.hpp>
#include <power_model/power_parameters.hpp>
#include <report/run_result.hpp>
#include <runner/port_files.hpp>
#include <scenes/scene.hpp>
#include <scenes/sequence.hpp>

namespace finback::machine {
class Machine;
}

namespace finback::runner {

// A firmware as it was found, with the names and hashes that the result tells.
struct LoadedFirmware {
  ir::Firmware firmware;
  report::Ingredient identity;
  report::Ingredient placement;
};

// `name`: an installed firmware's name, or the path of a folder with a firmware.toml, of such a
// file or of a .bir file. `placement`: a file that replaces the firmware's own. Throws InputError:
// no such firmware (listing the installed ones), and whatever is wrong in its files.
[[nodiscard]] LoadedFirmware find_firmware(const std::string& name,
                                           const std::optional<std::filesystem::path>& placement);

struct RunInputs {
  LoadedFirmware firmware;
  std::unique_ptr<machine::MachineDescription> machine;
  std::shared_ptr<const power::PowerParameters> power = std::make_shared<power::PowerParameters>();
  std::string power_name = "default";
  scenes::Scene scene;
  // What the cameras see over time, of which `scene` is the first pair; none: always `scene`.
  std::shared_ptr<scenes::FrameSequence> sequence;
  std::string sequence_hash;
  std::array<std::vector<peripheral::FrameTrouble>, 2> camera_troubles;  // left, right
  PortRequest ports;
  std::uint32_t frames = 1;
  bool check_races = false;  // slower
  // The run is given up as endless after so many cycles.
  Cycles cycle_limit = kNever;  // of the clock at the start: a limit in real time
};

struct RunObserver {
  // Asked about every millisecond of simulated time; true ends the run.
  std::function<bool(Cycles now, std::uint32_t frames_published)> cancelled;
  // Each line that the firmware prints.
  std::function<void(const std::string& line)> console;
  // What the data caches hid (machine::Machine::stale_reports), when the run has ended, in whatever
  // way.
  std::function<void(const std::vector<std::string>& lines)> stale;
  // The machine before it runs; the image lives as long as the run.
  std::function<void(machine::Machine& machine, const ir::Image& image)> ready;
};

struct RunOutcome {
  bool cancelled = false;  // then the rest is empty
  report::RunResult result;
  std::vector<machine::PublishedMap> maps;
  std::vector<machine::RaceReport> races;  // where RunInputs asked for them
  // What annotations are made from.
  ir::Image image;
  std::array<core::CoreProfile, kCoreCount> profiles;
};

// Throws InputError when the image cannot be linked, GuestFault when the program does what the
// machine cannot, exits with another status than 0, publishes fewer maps than it grabbed frames,
// or does not end by itself.
[[nodiscard]] RunOutcome run_firmware(const RunInputs& inputs, const RunObserver& observer = {});

// The counters that golden traces hold: the registry's, with the cycles of stages and frames
// (traces/README.md).
[[nodiscard]] std::map<std::string, std::uint64_t> trace_counters(const report::RunResult& result);

}  // namespace finback::runner
