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

ProgressBar::ProgressBar(std::size_t total)
    : total_(std::max<std::size_t>(1, total)),
      terminal_(::isatty(STDERR_FILENO) == 1),
      begun_(std::chrono::steady_clock::now()),
      drawn_(begun_) {}

void ProgressBar::show(std::size_t done, const std::function<std::string()>& detail) {
  const auto time = std::chrono::steady_clock::now();
  if (!terminal_ || time - begun_ < kQuietTime || time - drawn_ < kRedrawTime) {
    return;
  }
  drawn_ = time;
  shown_ = true;
  const std::size_t filled = kBarWidth * std::min(done, total_) / total_;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}\033[K", "", filled, "", kBarWidth - filled, detail());
  std::fflush(stderr);
}

double ProgressBar::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

void ProgressBar::wipe() {
  if (shown_) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    shown_ = false;
  }
}

}  // namespace finback::cli
