#include <fmt/format.h>

#include <budget/writers.hpp>

namespace finback::budget {

namespace {

std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result;
}

std::string title_of(const Verdict& verdict, const Explanation& reason) {
  const CheckRow worst = row_of(verdict.broken[reason.checks.front()]);
  const std::size_t more = reason.checks.size() - 1;
  return fmt::format("{} is {}, limit {}{}", worst.metric, worst.value, worst.limit,
                     more == 0 ? "" : fmt::format(" (and {} more)", more));
}

// Where firmware's source is known, there; else where the limit is written.
SourcePlace place_of(const Verdict& verdict, const Explanation& reason) {
  if (reason.worst.file.empty()) {
    return verdict.broken[reason.checks.front()].limit->written;
  }
  return {(verdict.sources / reason.worst.file).lexically_normal().string(), reason.worst.line, 0};
}

}  // namespace

std::string github_message(std::string_view text) { return escaped(text, "%\r\n"); }

std::string github_property(std::string_view text) { return escaped(text, "%\r\n:,"); }

std::string to_github(const Verdict& verdict) {
  std::string text;
  for (const Explanation& reason : verdict.why) {
    std::string message = reason.headline;
    for (const std::string& detail : reason.details) {
      message += "\n" + detail;
    }
    const SourcePlace place = place_of(verdict, reason);
    text += fmt::format("::error file={},line={},title={}::{}\n", github_property(place.file),
                        place.line, github_property(title_of(verdict, reason)),
                        github_message(message));
  }
  return text;
}

}  // namespace finback::budget
