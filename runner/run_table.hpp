// The [run] table of files that say what is run: spaces and budgets.
#pragma once

#include <filesystem>
#include <string>

#include <common/toml_reader.hpp>
#include <runner/run_request.hpp>

namespace finback::runner {

// A firmware or machine that a file in `folder` names, as find_firmware and find_machine take it:
// what looks like a path is one, relative to the folder.
[[nodiscard]] std::string named_in(const std::filesystem::path& folder, const std::string& name);

// Reads the keys of a [run] table, which are the options of `finback run`: firmware, scene, left,
// right, frames, machine, placement, power, place, set, max_seconds, flash, and the cameras'
// frames_from, camera_rate, distort, misalign, drop_frame, late_frame. Paths are relative to the
// file. Throws InputError naming the line.
[[nodiscard]] RunRequest read_run_request(const TomlReader& reader, const toml::table& table);

}  // namespace finback::runner
