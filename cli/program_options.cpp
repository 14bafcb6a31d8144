#include <algorithm>
#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <span>
#include <string_view>

#include <cli/program_options.hpp>
#include <cli/progress.hpp>

namespace finback::cli {

namespace {

void write_stream(int stream, std::string_view text) {
  std::FILE* out = stream == 2 ? stderr : stdout;
  std::fwrite(text.data(), 1, text.size(), out);
}

}  // namespace

runner::ProgramRequest ProgramOptions::request() const {
  runner::ProgramRequest request;
  request.environment =
      environment == "chip" ? runner::Environment::chip : runner::Environment::user;
  request.memory_megabytes = memory_megabytes;
  request.core_a.assign(files.begin(), files.end());
  request.core_b.assign(core_b.begin(), core_b.end());
  request.include_folders.assign(include_folders.begin(), include_folders.end());
  request.defines = defines;
  request.entry = entry;
  request.machine = machine;
  request.settings = settings;
  request.ports = ports;
  request.note = [](const std::string& message) { fmt::print(stderr, "{}\n", message); };
  return request;
}

runner::ProgramRun ProgramOptions::run() const {
  runner::ProgramRun run;
  run.begin = environment == "chip" ? machine::Begin::reset : machine::Begin::program;
  run.limits.cancelled = [](Cycles) { return interrupted(); };
  run.host.arguments = arguments;
  run.host.arguments.insert(run.host.arguments.begin(), files.front());
  run.host.folder = files_folder;
  run.host.output = write_stream;
  run.host.input = [](std::span<std::uint8_t> bytes) {
    return std::fread(bytes.data(), 1, bytes.size(), stdin);
  };
  return run;
}

CLI::Option* add_program_files(CLI::App& command, ProgramOptions& options) {
  return command.add_option("files", options.files,
                            "Files for core A, linked together: .s or .bir");
}

std::vector<CLI::Option*> add_program_options(CLI::App& command, ProgramOptions& options) {
  return {
      command.add_option("--core-b", options.core_b, "A file for core B; repeatable")
          ->type_name("FILE")
          ->allow_extra_args(false),
      command.add_option("-I", options.include_folders, "A folder to look for included files in")
          ->type_name("DIR")
          ->allow_extra_args(false),
      command
          .add_option("--defsym", options.defines,
                      "A symbol that is a number, for .s files; repeatable")
          ->type_name("NAME=NUMBER")
          ->allow_extra_args(false),
      command.add_option("--entry", options.entry,
                         "The symbol to begin at (default: __start, _start, start, _main, or the "
                         "first instruction)"),
      command
          .add_option("--environment", options.environment,
                      "user: flat memory at 0 without stalls; chip: the machine's own map, from "
                      "reset")
          ->check(CLI::IsMember({"user", "chip"}))
          ->capture_default_str(),
      command.add_option("--memory", options.memory_megabytes, "Flat memory, in MB")
          ->check(CLI::Range(4U, runner::kMostMegabytes))
          ->capture_default_str(),
      command
          .add_option("--files", options.files_folder,
                      "The folder below which the program may open files (default: none)")
          ->type_name("DIR")
          ->check(CLI::ExistingDirectory)};
}

void add_program_machine(CLI::App& command, ProgramOptions& options) {
  command.add_option("--machine", options.machine,
                     "Installed machine, or machine file (TOML), instead of the BF561");
  command
      .add_option("--set", options.settings,
                  "One machine parameter, e.g. memory.l2.read_cycles=9; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
}

std::vector<std::string> take_program_arguments(int& argc, char** argv) {
  constexpr std::array<std::string_view, 2> kCommands = {"exec", "trace"};
  if (argc < 2 || std::ranges::find(kCommands, std::string_view(argv[1])) == kCommands.end()) {
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

}  // namespace finback::cli
