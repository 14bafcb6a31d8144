// One run with somebody watching: a progress bar, the firmware's lines on stderr, Ctrl-C.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <runner/run_firmware.hpp>

namespace finback::cli {

// What the data caches hid from somebody, on stderr: `most` lines of it.
void warn_of_stale_data(const std::vector<std::string>& lines, std::size_t most);

// Empty when Ctrl-C ended it; a line on stderr has then said so. Throws as run_firmware does.
// `stale_lines`: how many warnings of old data in caches may go to stderr.
[[nodiscard]] std::optional<runner::RunOutcome> run_watched(const runner::RunInputs& inputs,
                                                            std::size_t stale_lines = 0);

}  // namespace finback::cli
