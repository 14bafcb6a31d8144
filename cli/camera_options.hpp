// The options of cameras and of what is at the machine's pins.
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <runner/run_request.hpp>

namespace finback::cli {

// --camera-rate, --distort, --misalign, --drop-frame, --late-frame, in `group`.
void add_camera_options(CLI::App& command, runner::RunRequest& request, const std::string& group);

// --uart, --uart-input, --flags, --flags-input, in `group`.
void add_port_options(CLI::App& command, runner::PortRequest& ports, const std::string& group);

}  // namespace finback::cli
