// `finback exec`: any program on a bare machine.
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <common/error.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/isa/operation.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/program_host.hpp>
#include <runner/program_request.hpp>

namespace finback::cli {

namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  finback exec prog.s\n"
    "  finback exec -I include --defsym DEBUG=1 start.s prog.s --dump-registers\n"
    "  finback exec --environment chip boot.s\n"
    "More: docs/finback-exec.md, docs/assembler.md";

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> core_b;
  std::vector<std::string> include_folders;
  std::vector<std::string> arguments;  // of the program
  std::string files_folder;            // that the program may open files in; "": none
  runner::ProgramRequest request;
  std::string environment = "user";
  std::uint64_t max_cycles = 0;
  bool dump_registers = false;
};

void print_registers(const isa::ExecutionState& state) {
  constexpr int kColumns = 4;
  int column = 0;
  const auto print = [&](std::string_view name, const std::string& value) {
    fmt::print("{:<8} {}{}", name, value, ++column % kColumns == 0 ? "\n" : "   ");
  };
  for (int reg = 0; reg < isa::A0X; ++reg) {
    print(isa::register_name(static_cast<isa::Register>(reg)),
          fmt::format("{:08x}", state.reg[static_cast<std::size_t>(reg)]));
  }
  print("ASTAT", fmt::format("{:08x}", state.astat()));
  for (std::size_t i = 0; i < state.accumulator.size(); ++i) {
    print(fmt::format("A{}", i),
          fmt::format("{:010x}", static_cast<std::uint64_t>(state.accumulator[i]) & 0xffffffffff));
  }
  fmt::print("{}", column % kColumns == 0 ? "" : "\n");
}

// argv of the program: the first file's name, then --argument's.
std::vector<std::string> program_arguments(const Options& options) {
  std::vector<std::string> arguments = options.arguments;
  arguments.insert(arguments.begin(), options.files.front());
  return arguments;
}

void write_stream(int stream, std::string_view text) {
  std::FILE* out = stream == 2 ? stderr : stdout;
  std::fwrite(text.data(), 1, text.size(), out);
}

int run(const Options& options) {
  catch_interrupts();
  runner::ProgramRequest request = options.request;
  request.environment =
      options.environment == "chip" ? runner::Environment::chip : runner::Environment::user;
  request.core_a.assign(options.files.begin(), options.files.end());
  request.core_b.assign(options.core_b.begin(), options.core_b.end());
  request.include_folders.assign(options.include_folders.begin(), options.include_folders.end());
  request.note = [](const std::string& message) { fmt::print(stderr, "{}\n", message); };
  const runner::LoadedProgram program = runner::load_program(request);
  const ir::Image image =
      ir::link(program.firmware.units, program.firmware.placement, program.machine->map);
  machine::Machine machine(
      *program.machine, image,
      options.environment == "chip" ? machine::Begin::reset : machine::Begin::program);
  machine.host().set_console([](const std::string& line) { fmt::print("{}\n", line); });
  machine.serve_programs({.arguments = program_arguments(options),
                          .folder = options.files_folder,
                          .output = write_stream,
                          .input = [](std::span<std::uint8_t> bytes) {
                            return std::fread(bytes.data(), 1, bytes.size(), stdin);
                          }});

  machine::RunLimits limits;
  limits.cycles = options.max_cycles == 0 ? kNever : options.max_cycles;
  limits.cancelled = [](Cycles) { return interrupted(); };
  const machine::StopInfo stop = machine.run(limits);
  machine.host().flush_line();
  if (options.dump_registers) {
    print_registers(machine.state(CoreId::a));
  }
  std::fflush(stdout);
  switch (stop.reason) {
    case machine::Stop::exited:
      if (!stop.message.empty()) {
        fmt::print(stderr, "finback: {}\n", stop.message);
      }
      if (!stop.message.empty()) {
        fmt::print(stderr, "finback: {}\n", stop.message);
      }
      return static_cast<int>(stop.exit_status & 0xff);
    case machine::Stop::cycle_limit:
      fmt::print(stderr, "finback: the program has not ended after {} cycles (--max-cycles)\n",
                 stop.time);
      return kCycleLimit;
    case machine::Stop::cancelled:
      fmt::print(stderr, "finback: interrupted\n");
      return kInterrupted;
    case machine::Stop::deadlock:
      throw GuestFault(fmt::format("{} sleeps after {} cycles and nothing is going to wake it",
                                   program.firmware.units.name, stop.time));
  }
  return kFine;
}

}  // namespace

void add_exec_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("exec", "Run a program of assembler or BIR files on a bare machine");
  command->footer(kExamples);
  command->add_option("files", options->files, "Files for core A: .s or .bir")->required();
  command->add_option("--core-b", options->core_b, "A file for core B; repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command
      ->add_option("--environment", options->environment,
                   "user: flat memory at 0, no stalls; chip: the machine's own map")
      ->check(CLI::IsMember({"user", "chip"}))
      ->capture_default_str();
  command->add_option("--memory", options->request.memory_megabytes, "Flat memory, in MB")
      ->check(CLI::Range(4U, runner::kMostMegabytes))
      ->capture_default_str();
  command->add_option("-I", options->include_folders, "A folder to look for included files")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command->add_option("--defsym", options->request.defines, "A symbol for .s files; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  command->add_option("--entry", options->request.entry, "The symbol to begin at");
  command
      ->add_option("--files", options->files_folder,
                   "The folder below which the program may open files (default: none)")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  command->add_option("--argument", options->arguments, "An argument of the program; repeatable")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  command->add_option("--max-cycles", options->max_cycles, "End the program after so many cycles")
      ->check(CLI::PositiveNumber);
  command->add_flag("--dump-registers", options->dump_registers, "Print the registers at the end");
  command->add_option("--machine", options->request.machine, "Machine file instead of the BF561");
  command->add_option("--set", options->request.settings, "One machine parameter; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace finback::cli
