// `finback exec`: any program on a bare machine.
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cli/camera_options.hpp>
#include <cli/commands.hpp>
#include <cli/program_options.hpp>
#include <cli/progress.hpp>
#include <cli/watched_run.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <report/sections.hpp>
#include <runner/run_program.hpp>

namespace finback::cli {

namespace {

constexpr const char* kExecExamples =
    "Examples:\n"
    "  finback exec prog.s\n"
    "  finback exec -I include --defsym DEBUG=1 start.s prog.s -- an argument\n"
    "  finback exec --environment chip --dump-registers boot.s\n"
    "The exit code is the program's. More: docs/finback-exec.md, docs/assembler.md";

struct ExecOptions {
  ProgramOptions program;
  std::string json;
  std::uint64_t max_cycles = 0;
  bool dump_registers = false;
  bool summary = false;
  std::size_t stale_lines = 0;
};

void print_registers(const isa::ExecutionState& state) {
  constexpr std::size_t kColumns = 4;
  const auto registers = runner::registers_as_text(state);
  for (std::size_t i = 0; i < registers.size(); ++i) {
    const bool last = i % kColumns == kColumns - 1 || i + 1 == registers.size();
    const auto& [name, value] = registers[i];
    fmt::print("{:<8}{:<{}}", name, last ? value + "\n" : value, last ? 0 : 12);
  }
}

// Where the cycles went, on stderr, so that the program's own output stays what it is.
void print_summary(const report::RunResult& result) {
  for (const report::Core& core : result.cores) {
    if (!core.started) {
      continue;
    }
    fmt::print(stderr, "{}: {} cycles, {} instructions in {} packets\n", core.name, core.cycles,
               core.instructions, core.packets);
    for (const auto& [cause, cycles] : core.causes) {
      if (cycles > 0) {
        fmt::print(stderr, "  {:>12}  {}\n", cycles, cause);
      }
    }
  }
  report::Page page;
  report::write_clocks(page, result);
  fmt::print(stderr, "{}", page.take());
}

int run(const ExecOptions& options) {
  catch_interrupts();
  const runner::RunInputs inputs = runner::load_program(options.program.request());
  runner::ProgramRun run = options.program.run();
  run.limits.cycles = options.max_cycles == 0 ? kNever : options.max_cycles;
  if (options.dump_registers) {
    run.registers = [](const auto& states) {
      std::fflush(stdout);
      print_registers(states[0]);
    };
  }
  if (options.stale_lines > 0) {
    run.stale = [&options](const std::vector<std::string>& lines) {
      std::fflush(stdout);
      warn_of_stale_data(lines, options.stale_lines);
    };
  }
  const runner::ProgramOutcome outcome = runner::run_program(inputs, std::move(run));
  std::fflush(stdout);
  if (options.summary) {
    print_summary(outcome.result);
  }
  if (!options.json.empty() && outcome.stop.reason != machine::Stop::cancelled) {
    if (options.json == "-") {
      fmt::print("{}", runner::to_json(outcome));
    } else {
      write_file_whole(options.json, runner::to_json(outcome));
    }
  }
  switch (outcome.stop.reason) {
    case machine::Stop::cycle_limit:
      fmt::print(stderr, "finback: the program has not ended after {} cycles (--max-cycles)\n",
                 outcome.stop.time);
      return kCycleLimit;
    case machine::Stop::cancelled:
      fmt::print(stderr, "finback: interrupted after {} cycles\n", outcome.stop.time);
      return kInterrupted;
    default:
      if (!outcome.stop.message.empty()) {
        fmt::print(stderr, "finback: {}\n", outcome.stop.message);
      }
      return static_cast<int>(outcome.stop.exit_status & 0xff);
  }
}

}  // namespace

void add_exec_command(CLI::App& app, Action& action, std::vector<std::string> arguments) {
  auto options = std::make_shared<ExecOptions>();
  options->program.arguments = std::move(arguments);
  CLI::App* command =
      app.add_subcommand("exec", "Run a program of assembler or BIR files on a bare machine");
  command->footer(kExecExamples);
  add_program_files(*command, options->program)->required();
  add_program_options(*command, options->program);
  add_program_machine(*command, options->program);
  add_port_options(*command, options->program.ports, "What is at the pins");
  command->add_option("--max-cycles", options->max_cycles, "End the program after so many cycles")
      ->check(CLI::PositiveNumber);
  command->add_flag("--dump-registers", options->dump_registers, "Print the registers at the end");
  command->add_flag("--summary", options->summary, "Say on stderr where the cycles went");
  command
      ->add_option("--warn-stale", options->stale_lines,
                   "Say on stderr who saw old data because of a cache: at most N lines")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--json", options->json, "Write registers and all that was counted; -: print it")
      ->type_name("FILE");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace finback::cli
