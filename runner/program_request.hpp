// Programs on a bare machine: what `finback exec` is asked for, turned into units, a placement and
// a machine.
//
// Two environments: `chip`, the machine as its file says; `user`, flat memory at address 0 without
// a stall, for programs that expect to be a process of an operating system.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <runner/run_firmware.hpp>

namespace finback::runner {

enum class Environment : std::uint8_t { chip, user };

struct ProgramRequest {
  std::vector<std::filesystem::path> core_a;  // `.s` and `.bir` files, linked together
  std::vector<std::filesystem::path> core_b;
  Environment environment = Environment::user;
  std::uint32_t memory_megabytes = 64;  // of `user`: 1 to kMostMegabytes
  std::vector<std::filesystem::path> include_folders;
  std::vector<std::string> defines;   // "NAME=VALUE", for `.s` files
  std::string entry;                  // a symbol; "": found
  std::string machine;                // file; "": the BF561
  std::vector<std::string> settings;  // "memory.l2.read_cycles=9"
  PortRequest ports;
  // Gets what .print and .warning say; may be empty.
  std::function<void(const std::string& message)> note;
};
inline constexpr std::uint32_t kMostMegabytes = 2048;

// Loads, checks and arranges everything; linking is left to do. There is no scene. Throws
// InputError.
[[nodiscard]] RunInputs load_program(const ProgramRequest& request);

}  // namespace finback::runner
