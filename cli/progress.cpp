#include <algorithm>
#include <csignal>
#include <fmt/format.h>
#include <unistd.h>

#include <cli/progress.hpp>

namespace finback::cli {

namespace {

constexpr auto kQuietTime = std::chrono::seconds(2);
constexpr auto kRedrawTime = std::chrono::milliseconds(100);
constexpr std::size_t kBarWidth = 30;

volatile std::sig_atomic_t interrupt_seen = 0;

extern "C" void on_interrupt(int) { interrupt_seen = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

bool interrupted() { return interrupt_seen != 0; }

ProgressBar::ProgressBar(std::uint32_t frames, double core_hertz)
    : frames_(std::max<std::uint32_t>(1, frames)),
      core_hertz_(core_hertz),
      terminal_(::isatty(STDERR_FILENO) == 1),
      begun_(std::chrono::steady_clock::now()),
      drawn_(begun_) {}

void ProgressBar::show(Cycles now, std::uint32_t frames_done) {
  const auto time = std::chrono::steady_clock::now();
  if (!terminal_ || time - begun_ < kQuietTime || time - drawn_ < kRedrawTime) {
    return;
  }
  drawn_ = time;
  shown_ = true;
  const std::size_t filled = kBarWidth * std::min(frames_done, frames_) / frames_;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{} frames, {:.1f} ms simulated ", "", filled, "",
             kBarWidth - filled, frames_done, frames_,
             static_cast<double>(now) / core_hertz_ * 1e3);
  std::fflush(stderr);
}

void ProgressBar::wipe() {
  if (shown_) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    shown_ = false;
  }
}

}  // namespace finback::cli
