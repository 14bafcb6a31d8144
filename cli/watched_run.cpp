#include <fmt/format.h>

#include <cli/progress.hpp>
#include <cli/watched_run.hpp>

namespace finback::cli {

std::optional<runner::RunOutcome> run_watched(const runner::RunInputs& inputs) {
  ProgressBar bar(inputs.frames);
  runner::RunObserver observer;
  observer.cancelled = [&](Cycles now, std::uint32_t frames_done) {
    bar.show(frames_done, [&] {
      return fmt::format("{}/{} frames, {:.1f} ms simulated", frames_done, inputs.frames,
                         static_cast<double>(now) / inputs.machine->clock.cclk_mhz / 1e3);
    });
    return interrupted();
  };
  observer.console = [&bar](const std::string& line) {
    bar.wipe();
    fmt::print(stderr, "firmware: {}\n", line);
  };
  runner::RunOutcome outcome = runner::run_firmware(inputs, observer);
  bar.wipe();
  if (outcome.cancelled || interrupted()) {
    fmt::print(stderr, "finback: interrupted; nothing was written\n");
    return std::nullopt;
  }
  return outcome;
}

}  // namespace finback::cli
