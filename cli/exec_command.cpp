// `finback exec`: any program on a bare machine.
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <runner/program_request.hpp>
#include <runner/run_program.hpp>

namespace finback::cli {

namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  finback exec prog.s\n"
    "  finback exec -I include --defsym DEBUG=1 start.s prog.s -- an argument\n"
    "  finback exec --environment chip --dump-registers boot.s\n"
    "The exit code is the program's. More: docs/finback-exec.md, docs/assembler.md";

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> core_b;
  std::vector<std::string> include_folders;
  std::vector<std::string> arguments;  // of the program
  std::string files_folder;            // that the program may open files in; "": none
  std::string json;
  runner::ProgramRequest request;
  std::string environment = "user";
  std::uint64_t max_cycles = 0;
  bool dump_registers = false;
  bool summary = false;
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
}

void write_stream(int stream, std::string_view text) {
  std::FILE* out = stream == 2 ? stderr : stdout;
  std::fwrite(text.data(), 1, text.size(), out);
}

runner::ProgramRequest request_of(const Options& options) {
  runner::ProgramRequest request = options.request;
  request.environment =
      options.environment == "chip" ? runner::Environment::chip : runner::Environment::user;
  request.core_a.assign(options.files.begin(), options.files.end());
  request.core_b.assign(options.core_b.begin(), options.core_b.end());
  request.include_folders.assign(options.include_folders.begin(), options.include_folders.end());
  request.note = [](const std::string& message) { fmt::print(stderr, "{}\n", message); };
  return request;
}

runner::ProgramRun run_of(const Options& options) {
  runner::ProgramRun run;
  run.begin = options.environment == "chip" ? machine::Begin::reset : machine::Begin::program;
  run.limits.cycles = options.max_cycles == 0 ? kNever : options.max_cycles;
  run.limits.cancelled = [](Cycles) { return interrupted(); };
  run.host.arguments = options.arguments;
  run.host.arguments.insert(run.host.arguments.begin(), options.files.front());
  run.host.folder = options.files_folder;
  run.host.output = write_stream;
  run.host.input = [](std::span<std::uint8_t> bytes) {
    return std::fread(bytes.data(), 1, bytes.size(), stdin);
  };
  if (options.dump_registers) {
    run.registers = [](const auto& states) {
      std::fflush(stdout);
      print_registers(states[0]);
    };
  }
  return run;
}

int run(const Options& options) {
  catch_interrupts();
  const runner::RunInputs inputs = runner::load_program(request_of(options));
  const runner::ProgramOutcome outcome = runner::run_program(inputs, run_of(options));
  std::fflush(stdout);
  if (options.summary) {
    print_summary(outcome.result);
  }
  if (!options.json.empty() && outcome.stop.reason != machine::Stop::cancelled) {
    write_file_whole(options.json, runner::to_json(outcome));
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

void add_what_is_run(CLI::App& command, Options& options) {
  command.add_option("files", options.files, "Files for core A, linked together: .s or .bir")
      ->required();
  command.add_option("--core-b", options.core_b, "A file for core B; repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command.add_option("-I", options.include_folders, "A folder to look for included files in")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command
      .add_option("--defsym", options.request.defines,
                  "A symbol that is a number, for .s files; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  command.add_option("--entry", options.request.entry,
                     "The symbol to begin at (default: __start, _start, start, _main, or the "
                     "first instruction)");
}

void add_machine(CLI::App& command, Options& options) {
  command
      .add_option("--environment", options.environment,
                  "user: flat memory at 0 without stalls; chip: the machine's own map, from reset")
      ->check(CLI::IsMember({"user", "chip"}))
      ->capture_default_str();
  command.add_option("--memory", options.request.memory_megabytes, "Flat memory, in MB")
      ->check(CLI::Range(4U, runner::kMostMegabytes))
      ->capture_default_str();
  command.add_option("--machine", options.request.machine,
                     "Machine file (TOML) instead of the BF561");
  command
      .add_option("--set", options.request.settings,
                  "One machine parameter, e.g. memory.l2.read_cycles=9; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  command
      .add_option("--files", options.files_folder,
                  "The folder below which the program may open files (default: none)")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  command.add_option("--max-cycles", options.max_cycles, "End the program after so many cycles")
      ->check(CLI::PositiveNumber);
}

}  // namespace

std::vector<std::string> take_program_arguments(int& argc, char** argv) {
  if (argc < 2 || std::string_view(argv[1]) != "exec") {
    return {};
  }
  const std::span<char*> all(argv, static_cast<std::size_t>(argc));
  const auto mark =
      std::ranges::find_if(all, [](const char* word) { return std::string_view(word) == "--"; });
  if (mark == all.end()) {
    return {};
  }
  argc = static_cast<int>(mark - all.begin());
  return {mark + 1, all.end()};
}

void add_exec_command(CLI::App& app, Action& action, std::vector<std::string> arguments) {
  auto options = std::make_shared<Options>();
  options->arguments = std::move(arguments);
  CLI::App* command =
      app.add_subcommand("exec", "Run a program of assembler or BIR files on a bare machine");
  command->footer(kExamples);
  add_what_is_run(*command, *options);
  add_machine(*command, *options);
  command->add_flag("--dump-registers", options->dump_registers, "Print the registers at the end");
  command->add_flag("--summary", options->summary, "Say on stderr where the cycles went");
  command->add_option("--json", options->json, "Write registers and all that was counted")
      ->type_name("FILE");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace finback::cli
