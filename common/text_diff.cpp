#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <sstream>
#include <vector>

#include <common/text_diff.hpp>

namespace finback {

namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

// A line of the diff: ' ' in both, '-' in the first text alone, '+' in the second alone; with the
// numbers of lines of either text before it.
struct Step {
  char mark = ' ';
  const std::string* line = nullptr;
  std::size_t before = 0;
  std::size_t after = 0;
};

// The longest common subsequence of the lines' ends from (i, j) on.
class Common {
 public:
  Common(const Lines& a, const Lines& b)
      : width_(b.size() + 1), length_((a.size() + 1) * (b.size() + 1)) {
    for (std::size_t i = a.size(); i-- > 0;) {
      for (std::size_t j = b.size(); j-- > 0;) {
        length_[i * width_ + j] =
            a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
      }
    }
  }
  [[nodiscard]] std::uint32_t at(std::size_t i, std::size_t j) const {
    return length_[i * width_ + j];
  }

 private:
  std::size_t width_;
  std::vector<std::uint32_t> length_;
};

std::vector<Step> steps_between(const Lines& a, const Lines& b) {
  const Common common(a, b);
  std::vector<Step> steps;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      steps.push_back({' ', &a[i], i, j});
      ++i;
      ++j;
    } else if (j == b.size() || (i < a.size() && common.at(i + 1, j) >= common.at(i, j + 1))) {
      steps.push_back({'-', &a[i], i, j});
      ++i;
    } else {
      steps.push_back({'+', &b[j], i, j});
      ++j;
    }
  }
  return steps;
}

// "12,3": lines from the 12th on; of none, the line before them.
std::string range_text(std::size_t first, std::size_t count) {
  return fmt::format("{},{}", count == 0 ? first : first + 1, count);
}

std::string hunk_text(const std::vector<Step>& steps, std::size_t from, std::size_t to) {
  std::string body;
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t k = from; k < to; ++k) {
    before += steps[k].mark != '+' ? 1 : 0;
    after += steps[k].mark != '-' ? 1 : 0;
    body += steps[k].mark + *steps[k].line + '\n';
  }
  return fmt::format("@@ -{} +{} @@\n{}", range_text(steps[from].before, before),
                     range_text(steps[from].after, after), body);
}

}  // namespace

std::string unified_diff(const NamedText& before, const NamedText& after) {
  const Lines a = lines_of(before.text);
  const Lines b = lines_of(after.text);
  const std::vector<Step> steps = steps_between(a, b);
  std::string text;
  std::size_t from = 0;  // of the hunk at hand
  std::size_t to = 0;    // behind it; 0: none
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].mark == ' ') {
      continue;
    }
    const std::size_t begin = k - std::min(k, kContext);
    if (to > 0 && begin > to) {
      text += hunk_text(steps, from, to);
      to = 0;
    }
    from = to == 0 ? begin : from;
    to = std::min(k + 1 + kContext, steps.size());
  }
  if (to == 0) {
    return "";
  }
  const auto name = [](const NamedText& side) {
    return side.name.empty() ? std::string("/dev/null") : side.name;
  };
  return fmt::format("--- {}\n+++ {}\n{}{}", name(before), name(after), text,
                     hunk_text(steps, from, to));
}

}  // namespace finback
