// The options that say what is run: common to every command that runs a firmware.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <runner/run_request.hpp>

namespace finback::cli {

// Those of what is linked: firmware, machine, placement and flash.
void add_link_options(CLI::App& command, runner::RunRequest& request);

// Adds all of them to `command`; they are read into `request`, which must live as long as the
// command.
void add_run_options(CLI::App& command, runner::RunRequest& request);

// `base` with the options that were given to `command` and so are in `given`. A scene replaces a
// pair and a pair a scene; --place and --set come after those of `base`.
[[nodiscard]] runner::RunRequest with_given_options(const CLI::App& command,
                                                    const runner::RunRequest& given,
                                                    runner::RunRequest base);

// Says that with `option` no firmware is run: none of them but `still` may be given with it.
void exclude_run_options(CLI::App& command, CLI::Option& option,
                         const std::vector<std::string>& still = {});

}  // namespace finback::cli
