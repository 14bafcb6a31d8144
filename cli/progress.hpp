// Watches over a long simulation: a progress bar on a terminal, and Ctrl-C.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace finback::cli {

// Turns Ctrl-C into a wish that interrupted() tells. A second Ctrl-C ends the program at once.
void catch_interrupts();
[[nodiscard]] bool interrupted();

// A bar on stderr when that is a terminal and the work has taken two seconds; wiped at the end.
class ProgressBar {
 public:
  // `total`: steps of the work.
  explicit ProgressBar(std::size_t total);
  ~ProgressBar() { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // `detail` is asked for what stands behind the bar, when it is drawn.
  void show(std::size_t done, const std::function<std::string()>& detail);
  void wipe();
  // Since it was made.
  [[nodiscard]] double seconds() const;

 private:
  std::size_t total_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace finback::cli
