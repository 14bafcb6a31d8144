#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>

#include <common/error.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <report/json_writer.hpp>
#include <runner/gather_result.hpp>
#include <runner/run_program.hpp>

namespace finback::runner {

namespace {

using Json = nlohmann::ordered_json;

std::array<isa::ExecutionState, kCoreCount> states_of(const machine::Machine& machine) {
  return {machine.state(CoreId::a), machine.state(CoreId::b)};
}

std::string_view stop_name(machine::Stop reason) {
  switch (reason) {
    case machine::Stop::exited:
      return "exited";
    case machine::Stop::cycle_limit:
      return "cycle_limit";
    case machine::Stop::cancelled:
      return "cancelled";
    case machine::Stop::deadlock:
      return "deadlock";
  }
  return "";
}

}  // namespace

ProgramOutcome run_program(const RunInputs& inputs, ProgramRun run) {
  const ir::FirmwareUnits& units = inputs.firmware.firmware.units;
  const ir::Image image =
      ir::link(units, inputs.firmware.firmware.placement, inputs.machine->placement_map());
  machine::Machine machine(*inputs.machine, image, run.begin);
  machine.host().set_console(
      [output = run.host.output](const std::string& line) { output(1, line + "\n"); });
  machine.serve_programs(std::move(run.host));
  PortFiles ports(inputs.ports, inputs.machine->clock.cclk_mhz);
  ports.attach(machine);
  if (run.ready) {
    run.ready(machine, image);
  }
  const auto tell = [&] {
    if (run.stale) {
      run.stale(machine.stale_reports());
    }
  };
  ProgramOutcome outcome;
  try {
    outcome.stop = run_with_ports(machine, run.limits, ports);
    tell();
  } catch (const GuestFault&) {
    tell();
    if (run.registers) {
      run.registers(states_of(machine));
    }
    throw;
  }
  machine.host().flush_line();
  outcome.states = states_of(machine);
  if (run.registers) {
    run.registers(outcome.states);
  }
  if (outcome.stop.reason == machine::Stop::deadlock) {
    if (!outcome.stop.message.empty()) {
      throw GuestFault(fmt::format("{}: {}", units.path, outcome.stop.message));
    }
    throw GuestFault(
        fmt::format("{}: the program sleeps after {} cycles and nothing is going to wake it: end "
                    "it with HLT, or with the exit call of EXCPT 0",
                    units.path, outcome.stop.time));
  }
  std::array<core::CoreProfile, kCoreCount> profiles;
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    profiles[static_cast<std::size_t>(core)] = machine.profile(core);
    outcome.started[static_cast<std::size_t>(core)] =
        profiles[static_cast<std::size_t>(core)].started;
  }
  outcome.result = gather_result(inputs, image, machine, profiles, outcome.stop.time);
  return outcome;
}

std::vector<std::pair<std::string, std::string>> registers_as_text(
    const isa::ExecutionState& state) {
  std::vector<std::pair<std::string, std::string>> all;
  all.reserve(isa::kRegisterCount);
  for (int reg = 0; reg < isa::A0X; ++reg) {
    all.emplace_back(isa::register_name(static_cast<isa::Register>(reg)),
                     fmt::format("{:08x}", state.reg[static_cast<std::size_t>(reg)]));
  }
  all.emplace_back("ASTAT", fmt::format("{:08x}", state.astat()));
  for (std::size_t i = 0; i < state.accumulator.size(); ++i) {
    constexpr std::uint64_t kAccumulatorBits = 0xff'ffff'ffff;
    const auto bits = static_cast<std::uint64_t>(state.accumulator[i]) & kAccumulatorBits;
    all.emplace_back(fmt::format("A{}", i), fmt::format("{:010x}", bits));
  }
  return all;
}

std::string to_json(const ProgramOutcome& outcome) {
  Json document;
  document["stopped"] = stop_name(outcome.stop.reason);
  document["exit_status"] = outcome.stop.exit_status & 0xff;
  document["message"] = outcome.stop.message;
  Json& cores = document["registers"] = Json::object();
  for (std::size_t core = 0; core < outcome.states.size(); ++core) {
    if (!outcome.started[core]) {
      continue;
    }
    Json& registers = cores[core == 0 ? "core_a" : "core_b"];
    for (const auto& [name, value] : registers_as_text(outcome.states[core])) {
      registers[name] = "0x" + value;
    }
  }
  document["result"] = Json::parse(report::to_json(outcome.result));
  return document.dump(2) + "\n";
}

}  // namespace finback::runner
