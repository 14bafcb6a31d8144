#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

#include <common/error.hpp>
#include <common/file.hpp>
#include <common/parameter.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "firmware.toml";

std::vector<std::string> installed_firmwares(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (fs::exists(entry.path() / kManifest)) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The manifest or BIR file that `name` means.
fs::path firmware_file(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) {
    return fs::path(name) / kManifest;
  }
  const std::string extension = fs::path(name).extension().string();
  const fs::path folder = share_folder() / "firmware";
  fs::path installed = folder / name / kManifest;
  // "labs/modular" is an installed one unless there is something of this name here.
  if (name.find('/') != std::string::npos && fs::path(name).is_relative() &&
      !fs::exists(name, error) && fs::exists(installed, error)) {
    return installed;
  }
  if (extension == ".toml" || extension == ".bir" || assembler::is_assembler_file(name) ||
      name.find('/') != std::string::npos) {
    return name;
  }
  if (!fs::exists(installed, error)) {
    const std::vector<std::string> known = installed_firmwares(folder);
    const std::string near = nearest_name(name, known);
    throw InputError(
        fmt::format("firmware '{}' is not installed{}; known: {}; or give the path of "
                    "a folder, a firmware.toml or a .bir file",
                    name, near.empty() ? "" : fmt::format(", did you mean '{}'", near),
                    fmt::join(known, ", ")));
  }
  return installed;
}

// Identifies a firmware by all BIR, assembler and TOML files of its folder, in the order of their
// names, and by what it puts into flash.
std::string firmware_hash(const fs::path& file, const std::vector<ir::FlashFile>& flash) {
  if (file.filename() != kManifest) {
    return report::content_hash(read_text_file(file));
  }
  std::vector<fs::path> parts;
  for (const auto& entry : fs::directory_iterator(fs::absolute(file).parent_path())) {
    const std::string extension = entry.path().extension().string();
    const bool part = extension == ".bir" || extension == ".toml" || extension == ".inc" ||
                      assembler::is_assembler_file(entry.path());
    if (entry.is_regular_file() && part) {
      parts.push_back(entry.path());
    }
  }
  std::sort(parts.begin(), parts.end());
  std::string all;
  for (const fs::path& part : parts) {
    all += part.filename().string() + '\n' + read_text_file(part);
  }
  for (const ir::FlashFile& part : flash) {
    all += part.name + '\n' + std::string(part.bytes.begin(), part.bytes.end());
  }
  return report::content_hash(all);
}

report::Ingredient placement_identity(const ir::Placement& placement) {
  std::error_code error;
  if (!fs::is_regular_file(placement.source, error)) {
    return {"default", report::content_hash("")};
  }
  return {fs::path(placement.source).filename().string(),
          report::content_hash(read_text_file(placement.source))};
}

}  // namespace

LoadedFirmware find_firmware(const std::string& name, const std::optional<fs::path>& placement) {
  const fs::path file = firmware_file(name);
  LoadedFirmware loaded;
  loaded.firmware = ir::load_firmware(file);
  if (placement) {
    loaded.firmware.placement = ir::load_placement(*placement);
  }
  loaded.identity = {loaded.firmware.units.name, firmware_hash(file, loaded.firmware.units.flash)};
  loaded.placement = placement_identity(loaded.firmware.placement);
  return loaded;
}

}  // namespace finback::runner
