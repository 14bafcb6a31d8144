// A calibration as a TOML file.
//
// Models: StereoCalibration to the last bit, both ways; one place for each number. Does not model:
// OpenCV's YAML files. docs/finback-stereo.md shows the file.
#pragma once

#include <filesystem>
#include <string>

#include <stereo_reference/rectification.hpp>

namespace finback::stereo_reference {

[[nodiscard]] std::string calibration_text(const StereoCalibration& calibration);

// `file` is what messages call it. Throws InputError "file:line:column: ..." for text that is no
// TOML, keys that are missing, unknown or of the wrong kind, numbers that are none, and cameras
// that cannot be (rectify's check).
[[nodiscard]] StereoCalibration parse_calibration(const std::string& text, const std::string& file);
[[nodiscard]] StereoCalibration load_calibration(const std::filesystem::path& path);

}  // namespace finback::stereo_reference
