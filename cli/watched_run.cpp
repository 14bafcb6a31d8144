#include <algorithm>
#include <fmt/format.h>

#include <cli/progress.hpp>
#include <cli/watched_run.hpp>

namespace finback::cli {

void warn_of_stale_data(const std::vector<std::string>& lines, std::size_t most) {
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i) {
    fmt::print(stderr, "finback: old data: {}\n", lines[i]);
  }
  if (lines.size() > most) {
    fmt::print(stderr, "finback: old data: {} more such lines (--warn-stale N shows N)\n",
               lines.size() - most);
  }
  if (lines.empty()) {
    fmt::print(stderr, "finback: nobody saw old data because of a cache\n");
  }
}

std::optional<runner::RunOutcome> run_watched(const runner::RunInputs& inputs,
                                              std::size_t stale_lines) {
  ProgressBar bar(inputs.frames);
  runner::RunObserver observer;
  const machine::Machine* running = nullptr;
  observer.ready = [&running](machine::Machine& machine, const ir::Image&) { running = &machine; };
  observer.cancelled = [&](Cycles now, std::uint32_t frames_done) {
    bar.show(frames_done, [&] {
      return fmt::format(
          "{}/{} frames, {:.1f} ms simulated", frames_done, inputs.frames,
          static_cast<double>(running->reference_time(now)) / inputs.machine->clock.cclk_mhz / 1e3);
    });
    return interrupted();
  };
  observer.console = [&bar](const std::string& line) {
    bar.wipe();
    fmt::print(stderr, "firmware: {}\n", line);
  };
  if (stale_lines > 0) {
    observer.stale = [&](const std::vector<std::string>& lines) {
      bar.wipe();
      warn_of_stale_data(lines, stale_lines);
    };
  }
  runner::RunOutcome outcome = runner::run_firmware(inputs, observer);
  bar.wipe();
  if (outcome.cancelled || interrupted()) {
    fmt::print(stderr, "finback: interrupted; nothing was written\n");
    return std::nullopt;
  }
  return outcome;
}

}  // namespace finback::cli
