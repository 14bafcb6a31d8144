#include <fmt/format.h>

#include <cli/progress.hpp>
#include <cli/watched_run.hpp>

namespace finback::cli {

std::optional<runner::RunOutcome> run_watched(const runner::RunInputs& inputs) {
  ProgressBar bar(inputs.frames, inputs.machine->clock.cclk_mhz * 1e6);
  runner::RunObserver observer;
  observer.cancelled = [&bar](Cycles now, std::uint32_t frames_done) {
    bar.show(now, frames_done);
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
