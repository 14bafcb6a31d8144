// The subcommands of `finback`. Each adds itself to the command line; what it does is a function
// that main runs once the arguments are read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace finback::cli {

// What the program tells its caller.
enum ExitCode : int {
  kFine = 0,
  kUsage = 1,         // the command line cannot be read
  kBadInput = 2,      // a file or a simulated program is wrong
  kBudgetBroken = 3,  // a target is missed, and the caller asked for that
  kCycleLimit = 124,  // `finback exec`: the program used up its cycles
  kInterrupted = 130,
};

// Threads that one may ask for.
constexpr unsigned kMostJobs = 256;

using Action = std::function<int()>;

// Set `action` when their subcommand is the one that was given.
void add_run_command(CLI::App& app, Action& action);
void add_check_command(CLI::App& app, Action& action);
void add_profile_command(CLI::App& app, Action& action);
void add_annotate_command(CLI::App& app, Action& action);
void add_explore_command(CLI::App& app, Action& action);
void add_link_command(CLI::App& app, Action& action);
void add_machine_command(CLI::App& app, Action& action);
void add_exec_command(CLI::App& app, Action& action, std::vector<std::string> arguments);
void add_trace_command(CLI::App& app, Action& action, std::vector<std::string> arguments);
void add_isa_command(CLI::App& app, Action& action);
void add_lab_command(CLI::App& app, Action& action);
void add_stereo_command(CLI::App& app, Action& action);

}  // namespace finback::cli
