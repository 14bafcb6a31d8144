// One run of a program on a bare machine, and what it found out.
#pragma once

#include <array>
#include <functional>

#include <isa_sim/isa/operation.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/program_host.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

struct ProgramRun {
  machine::Begin begin = machine::Begin::program;
  machine::RunLimits limits;
  machine::ProgramHostOptions host;  // arguments, files, input and output
  // The machine before it runs; the image lives as long as the run. May be empty.
  std::function<void(machine::Machine& machine, const ir::Image& image)> ready;
  // As RunObserver's: who saw old data because of a data cache. May be empty.
  std::function<void(const std::vector<std::string>& lines)> stale;
  // Gets the registers of both cores when the program has ended, in whatever way; may be empty.
  std::function<void(const std::array<isa::ExecutionState, kCoreCount>& states)> registers;
};

struct ProgramOutcome {
  machine::StopInfo stop;
  std::array<bool, kCoreCount> started{};
  std::array<isa::ExecutionState, kCoreCount> states;
  report::RunResult result;  // without frames
};

// Throws InputError when the program cannot be linked, GuestFault when it does what the machine
// cannot, or sleeps with nothing to wake it.
[[nodiscard]] ProgramOutcome run_program(const RunInputs& inputs, ProgramRun run);

// The outcome as JSON: how it ended, the registers, and the result as finback run writes it.
[[nodiscard]] std::string to_json(const ProgramOutcome& outcome);

// The registers' names and values, as hexadecimal numbers, in their order; the accumulators last.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> registers_as_text(
    const isa::ExecutionState& state);

}  // namespace finback::runner
