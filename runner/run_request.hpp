// What a person asks to be run, by names: the options of `finback run`. Turns them into loaded
// inputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

struct RunRequest {
  std::string firmware = "mesvs2";  // as find_firmware takes it
  std::string scene = "aloe";
  std::string left;  // both or none: a pair instead of a scene
  std::string right;
  std::string frames_from;           // "moving", a folder or a video instead of a scene
  std::vector<double> distortion;    // k1, k2 of both lenses
  std::vector<double> misalignment;  // of the right camera: degrees, right, down in pixels
  std::vector<std::string> dropped;  // "12", "left:12": frames that a camera does not send
  std::vector<std::string> late;     // "12:5", "right:12:5": frames, and milliseconds
  double camera_rate = 0;            // frames a second; 0: the machine's camera.frame_rate
  PortRequest ports;
  std::uint32_t frames = 4;  // 1 to kMostFrames
  std::string machine;       // as find_machine takes it; "": the BF561
  // Files; "": the firmware's own placement, default power.
  std::string placement;
  std::string power;
  std::vector<std::string> moves;     // "core_b.shd_scores=l3"
  std::vector<std::string> settings;  // "memory.l2.read_cycles=9"
  std::vector<std::string> flash;     // "tables.bin@0x20000000", "tables=mine.bin"
  double max_seconds = 0;             // of simulated time; 0: two a frame
  bool check_races = false;
};
inline constexpr std::uint32_t kMostFrames = 10000;

// The machine that find_machine finds ("": the BF561) with settings such as
// "memory.l2.read_cycles=9". Throws InputError.
[[nodiscard]] std::unique_ptr<machine::MachineDescription> load_machine(
    const std::string& name, const std::vector<std::string>& settings);

// Puts files into flash as --flash names them, "[NAME=]FILE[@ADDRESS]"; the firmware's identity
// tells. Throws InputError.
void apply_flash(LoadedFirmware& loaded, const std::vector<std::string>& files);

// What is linked: the machine and the firmware that `request` names, with its placement, moves and
// flash. Throws InputError.
void load_linked(const RunRequest& request, RunInputs& inputs);

// Loads everything that `request` names. Throws InputError.
[[nodiscard]] RunInputs load_inputs(const RunRequest& request);

}  // namespace finback::runner
