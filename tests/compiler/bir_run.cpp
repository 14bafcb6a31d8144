// Links BIR files into a bare program of core A, runs it, prints what it prints, and then its exit
// status and cycles. The tests' way to execute what finback-cc writes.
#include <exception>
#include <fmt/core.h>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace {

using namespace finback;

constexpr Cycles kCycleLimit = 400'000'000;
constexpr std::uint32_t kStackSize = 96 * 1024;

ir::Firmware link_together(int count, char** files) {
  ir::Firmware firmware = ir::bare_firmware(ir::load_program(files[0]));
  for (int i = 1; i < count; ++i) {
    firmware.units.cores[0].units.push_back(
        std::make_shared<const ir::Program>(ir::load_program(files[i])));
  }
  // Some of the programs have frames that the scratchpad does not hold.
  firmware.placement.of(ir::Owner::core_a).stack_region = "l2";
  firmware.placement.of(ir::Owner::core_a).stack_size = kStackSize;
  return firmware;
}

int run(int count, char** files) {
  const ir::Firmware firmware = link_together(count, files);
  const machine::MachineDescription description;
  const ir::Image image = ir::link(firmware.units, firmware.placement, description.map);
  machine::Machine machine(description, image);
  machine.host().set_console([](const std::string& line) { fmt::print("{}\n", line); });
  const machine::StopInfo stop = machine.run({.cycles = kCycleLimit, .cancelled = {}});
  if (stop.reason != machine::Stop::exited) {
    fmt::print(stderr, "the program did not end within {} cycles\n", kCycleLimit);
    return 3;
  }
  fmt::print(stderr, "status {} cycles {}\n", stop.exit_status, stop.time);
  return static_cast<int>(stop.exit_status & 0x7f);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bir_run file.bir...\n");
    return 1;
  }
  try {
    return run(argc - 1, argv + 1);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
