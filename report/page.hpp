// What the text writers share: a page of lines, numbers as people read them, colour.
#pragma once

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <report/run_result.hpp>

namespace finback::report {

// Appends lines to a text, without blanks at their ends.
class Page {
 public:
  template <class... Values>
  void line(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
    while (!text_.empty() && text_.back() == ' ') {
      text_.pop_back();
    }
    text_ += '\n';
  }
  void title(std::string_view heading) { line("\n{}", heading); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

// Colour by escape sequences, or none.
struct Style {
  bool colour = false;

  [[nodiscard]] std::string dim(std::string_view text) const { return wrap(text, "2"); }
  [[nodiscard]] std::string bold(std::string_view text) const { return wrap(text, "1"); }
  // Red from a tenth of the whole, yellow from a hundredth.
  [[nodiscard]] std::string heat(std::string_view text, double percent) const {
    return percent >= 10 ? wrap(text, "31;1") : percent >= 1 ? wrap(text, "33") : std::string(text);
  }

 private:
  [[nodiscard]] std::string wrap(std::string_view text, std::string_view code) const {
    return colour ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
  }
};

[[nodiscard]] inline double percent(double part, double whole) {
  return whole > 0 ? 100 * part / whole : 0;
}
[[nodiscard]] inline double percent(Cycles part, Cycles whole) {
  return percent(static_cast<double>(part), static_cast<double>(whole));
}

[[nodiscard]] inline double per_frame(std::uint64_t count, const RunResult& result) {
  return static_cast<double>(count) /
         static_cast<double>(std::max<std::size_t>(1, result.frames.size()));
}

// "1.23 MB", "12.3 kB" or "123 B", by thousands; "-" for none.
[[nodiscard]] inline std::string bytes_text(double bytes) {
  if (bytes >= 1e6) {
    return fmt::format("{:.2f} MB", bytes / 1e6);
  }
  return bytes >= 1e3 ? fmt::format("{:.1f} kB", bytes / 1e3)
         : bytes > 0  ? fmt::format("{:.0f} B", bytes)
                      : "-";
}

// Cycles that were not slept through: what somebody might save.
[[nodiscard]] inline Cycles awake(Cycles cycles, const CyclesByCause& causes) {
  for (const auto& [cause, count] : causes) {
    cycles -= cause == "idle" ? count : 0;
  }
  return cycles;
}

// The largest causes of waiting, at most two, as "l3_read 82 %, hazard_ex1 3 %" of all `cycles`;
// those below a hundredth are left out.
[[nodiscard]] inline std::string largest_stalls(const CyclesByCause& causes, Cycles cycles) {
  constexpr std::size_t kShown = 2;
  CyclesByCause waits;
  for (const auto& cause : causes) {
    if (cause.first != "issue" && 100 * cause.second >= std::max<Cycles>(1, cycles)) {
      waits.push_back(cause);
    }
  }
  std::ranges::stable_sort(waits, std::greater<>(), [](const auto& cause) { return cause.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, waits.size()); ++i) {
    text += fmt::format("{}{} {:.0f} %", i > 0 ? ", " : "", waits[i].first,
                        percent(waits[i].second, cycles));
  }
  return text;
}

}  // namespace finback::report
