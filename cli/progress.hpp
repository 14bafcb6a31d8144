// Watches over a long simulation: a progress bar on a terminal, and Ctrl-C.
#pragma once

#include <chrono>
#include <cstdint>

#include <common/units.hpp>

namespace finback::cli {

// Turns Ctrl-C into a wish that interrupted() tells. A second Ctrl-C ends the program at once.
void catch_interrupts();
[[nodiscard]] bool interrupted();

// A bar on stderr when that is a terminal and the work has taken two seconds; wiped at the end.
class ProgressBar {
 public:
  ProgressBar(std::uint32_t frames, double core_hertz);
  ~ProgressBar() { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(Cycles now, std::uint32_t frames_done);
  void wipe();

 private:
  std::uint32_t frames_;
  double core_hertz_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace finback::cli
