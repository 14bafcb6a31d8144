// What machine it is: its address map and all its declared parameters.
//
// Read from a machine file (TOML), in which every parameter goes by its dotted name and what is
// left out keeps its default: the BF561 at 600 / 120 MHz. Energy is not here: the power model has
// tables of its own. The format: docs/machine-file.md.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <clock_model/pll_parameters.hpp>
#include <dma_model/dma_parameters.hpp>
#include <isa_sim/core/core_parameters.hpp>
#include <isa_sim/machine/device_parameters.hpp>
#include <memory_model/clock_parameters.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/memory_parameters.hpp>
#include <peripheral_model/camera_parameters.hpp>
#include <peripheral_model/peripheral_parameters.hpp>

namespace finback::machine {

struct MachineDescription {
  std::string name = "bf561";
  memory::MemoryMap map = memory::bf561_map();
  memory::ClockParameters clock;
  clock::PllParameters pll;
  memory::MemoryParameters memory;
  dma::DmaParameters dma;
  DeviceParameters devices;
  peripheral::PeripheralParameters peripherals;
  peripheral::CameraParameters camera;
  core::CoreParameters core;

  // The map without what is cache from reset on: where things can be placed.
  [[nodiscard]] memory::MemoryMap placement_map() const;
  // All parameters, group by group, in the order of their declaration.
  [[nodiscard]] std::vector<ParameterBase*> parameters();
  [[nodiscard]] std::vector<const ParameterBase*> parameters() const;
  // Sets one by its dotted name. Throws InputError for an unknown name (with the nearest known one)
  // and for a value that the parameter refuses.
  void set(std::string_view parameter, double value);
  [[nodiscard]] double get(std::string_view parameter) const;
  // A copy of its own, to vary.
  [[nodiscard]] std::unique_ptr<MachineDescription> clone() const;
};

// Throw InputError "file:line:column: what" for text that is no TOML, unknown keys (naming the
// nearest), wrong types, values out of range, and regions that overlap or make no sense.
[[nodiscard]] std::unique_ptr<MachineDescription> parse_machine(std::string_view text,
                                                                const std::string& file);
[[nodiscard]] std::unique_ptr<MachineDescription> load_machine(const std::filesystem::path& path);

// The page of all parameters, docs/machine-parameters.md: name, unit, default, range, certainty,
// source, meaning.
[[nodiscard]] std::string parameters_as_markdown();

}  // namespace finback::machine
