// One run with somebody watching: a progress bar, the firmware's lines on stderr, Ctrl-C.
#pragma once

#include <optional>

#include <runner/run_firmware.hpp>

namespace finback::cli {

// Empty when Ctrl-C ended it; a line on stderr has then said so. Throws as run_firmware does.
[[nodiscard]] std::optional<runner::RunOutcome> run_watched(const runner::RunInputs& inputs);

}  // namespace finback::cli
