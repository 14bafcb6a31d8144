// Small programs of instructions on a whole machine, for tests of its devices.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/isa/operation.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback::machine {

constexpr Address kPllCtl = 0xFFC00000, kPllDiv = 0xFFC00004, kVrCtl = 0xFFC00008;

// Stores of a value to a device register.
inline std::string store(Address address, std::uint32_t value, int bytes = 4) {
  return fmt::format("P0.L = {:#x}; P0.H = {:#x}; R0.L = {:#x}; R0.H = {:#x};\n{} = R0; SSYNC;\n",
                     address & 0xFFFF, address >> 16, value & 0xFFFF, value >> 16,
                     bytes == 4 ? "[P0]" : "W[P0]");
}

inline std::string function(const char* name, const std::string& body) {
  return fmt::format(".type {0}, @function\n{0}:\n{1}\n.size {0}, .-{0}\n", name, body);
}

class GuestProgramTest : public testing::Test {
 protected:
  Machine& load(const std::string& body, const std::string& more = "") {
    ir::Program units =
        ir::parse(".bir 1\n.text\n.global _start\n" + function("_start", body) + more, "test.bir");
    ir::verify(units);
    const ir::Firmware firmware = ir::bare_firmware(std::move(units));
    image_ = ir::link(firmware.units, firmware.placement, description_.map);
    machine_ = std::make_unique<Machine>(description_, image_);
    return *machine_;
  }
  StopInfo run() { return machine_->run({.cycles = 1'000'000, .cancelled = {}}); }

  MachineDescription description_;
  ir::Image image_;
  std::unique_ptr<Machine> machine_;
};

}  // namespace finback::machine
