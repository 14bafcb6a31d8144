// What a person asks to be run, by names: the options of `finback run` and the [run] table of other
// files. Turns them into loaded inputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <common/toml_reader.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

struct RunRequest {
  std::string firmware = "mesvs2";  // as find_firmware takes it
  std::string scene = "aloe";
  std::string left;  // both or none: a pair instead of a scene
  std::string right;
  std::uint32_t frames = 4;  // 1 to kMostFrames
  std::string machine;       // files; "": the BF561, the firmware's own placement, default power
  std::string placement;
  std::string power;
  std::vector<std::string> moves;     // "core_b.shd_scores=l3"
  std::vector<std::string> settings;  // "memory.l2.read_cycles=9"
  double max_seconds = 0;             // of simulated time; 0: two a frame
};
inline constexpr std::uint32_t kMostFrames = 10000;

// The machine of a file ("": the BF561) with settings such as "memory.l2.read_cycles=9". Throws
// InputError.
[[nodiscard]] std::unique_ptr<machine::MachineDescription> load_machine(
    const std::string& file, const std::vector<std::string>& settings);

// Loads everything that `request` names. Throws InputError.
[[nodiscard]] RunInputs load_inputs(const RunRequest& request);

// A firmware that a file in `folder` names, as find_firmware takes it: what looks like a path is
// one, relative to the folder.
[[nodiscard]] std::string firmware_named_in(const std::filesystem::path& folder,
                                            const std::string& name);

// Reads the keys of a [run] table, which are the options of `finback run`: firmware, scene, left,
// right, frames, machine, placement, power, place, set, max_seconds. Paths are relative to the
// file. Throws InputError naming the line.
[[nodiscard]] RunRequest read_run_request(const TomlReader& reader, const toml::table& table);

}  // namespace finback::runner
