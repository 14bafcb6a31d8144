// A firmware: the BIR units of each core and of what both share, and the placement that goes with
// them.
//
// A core's units are linked into that core alone (it gets its own copy of their functions and
// objects); shared units hold objects only. The manifest firmware.toml: docs/bir.md, "Firmware".
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <isa_sim/ir/image.hpp>
#include <isa_sim/ir/placement.hpp>
#include <isa_sim/ir/program.hpp>

namespace finback::ir {

// A unit may belong to both cores; its program is then read once.
using Unit = std::shared_ptr<const Program>;

struct CoreUnits {
  bool present = false;  // false: the core never starts
  std::vector<Unit> units;
  std::string entry = "_start";  // a symbol as in the text
};

// A stage of the firmware's work, for reports: a function with all that it calls.
struct Stage {
  std::string name;
  Owner core = Owner::core_a;
  std::string function;  // C name
};

// What a file's bytes become before the program runs: a shared object that is loaded from it, in
// flash unless placement says otherwise.
struct FlashFile {
  std::string name;            // C name of the object
  std::filesystem::path path;  // the file
  std::optional<Address> at;   // where it stands; none: where there is room
  std::vector<std::uint8_t> bytes;
  SourcePlace written;
};

struct FirmwareUnits {
  std::string name;
  std::string path;  // firmware.toml, or the bare file
  std::array<CoreUnits, kCoreCount> cores;
  std::vector<Unit> shared;
  std::vector<std::string> flags;  // C names of shared objects by which the cores synchronise
  std::vector<Stage> stages;       // in the order of the manifest
  std::vector<FlashFile> flash;    // each a unit of `shared`, too
};

struct Firmware {
  FirmwareUnits units;
  Placement placement;
};

// Reads a manifest, its units (verified) and its placement; or a bare `.bir` or `.s` file as a
// firmware of core A with the default placement, entered at `_start` or, where there is none, at a
// start-up of our own that calls `_main`, writes its result to the host port's EXIT register and
// idles. Throws InputError naming file and line.
[[nodiscard]] Firmware load_firmware(const std::filesystem::path& path);

// The same for one program in memory.
[[nodiscard]] Firmware bare_firmware(Program program);

// Reads a file into flash; one of the same name is replaced. Throws InputError for a file that is
// empty or cannot be read. `at`: none where it goes wherever there is room.
void add_flash(FirmwareUnits& units, const std::string& name, const std::filesystem::path& path,
               std::optional<Address> at, const SourcePlace& written);

// The start-up of bare programs, as BIR text.
[[nodiscard]] std::string_view bare_start_text();

}  // namespace finback::ir
