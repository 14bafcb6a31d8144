// The options that say what is run: common to every command that runs a firmware.
#pragma once

#include <runner/run_request.hpp>

#include <CLI/CLI.hpp>

namespace finback::cli {

// Adds them to `command`; they are read into `request`, which must live as long as the command.
void add_run_options(CLI::App& command, runner::RunRequest& request);

}  // namespace finback::cli
