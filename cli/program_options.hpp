// The options of commands that run programs of assembler and BIR files.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <runner/program_request.hpp>
#include <runner/run_program.hpp>

namespace finback::cli {

struct ProgramOptions {
  std::vector<std::string> files;
  std::vector<std::string> core_b;
  std::vector<std::string> include_folders;
  std::vector<std::string> defines;
  std::vector<std::string> arguments;  // of the program
  std::vector<std::string> settings;
  std::string machine;
  std::string files_folder;  // that the program may open files in; "": none
  std::string entry;
  std::string environment = "user";
  std::uint32_t memory_megabytes = 64;
  runner::PortRequest ports;

  [[nodiscard]] runner::ProgramRequest request() const;
  // With the program's input and output, ended by Ctrl-C.
  [[nodiscard]] runner::ProgramRun run() const;
};

// The files themselves.
CLI::Option* add_program_files(CLI::App& command, ProgramOptions& options);
// How they are read and where they run; returns what was added.
std::vector<CLI::Option*> add_program_options(CLI::App& command, ProgramOptions& options);
// --machine and --set, for a command that does not have them otherwise.
void add_program_machine(CLI::App& command, ProgramOptions& options);

// Takes what stands behind `--` off the command line: the program's arguments.
[[nodiscard]] std::vector<std::string> take_program_arguments(int& argc, char** argv);

}  // namespace finback::cli
