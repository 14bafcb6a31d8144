#include <fmt/format.h>

#include <report/run_result.hpp>

namespace finback::report {

double RunResult::seconds() const {
  return core_hertz > 0 ? static_cast<double>(cycles) / core_hertz : 0;
}

double frames_per_second(const std::vector<Frame>& frames, double core_hertz) {
  if (frames.empty()) {
    return 0;
  }
  const Cycles from = frames.size() == 1 ? frames.front().grabbed : frames.front().published;
  const Cycles to = frames.back().published;
  const double intervals = frames.size() == 1 ? 1 : static_cast<double>(frames.size() - 1);
  return to > from ? intervals * core_hertz / static_cast<double>(to - from) : 0;
}

std::string verdict(const RunResult& result) {
  std::string failures;
  for (const Target& target : result.targets) {
    if (!target.passed()) {
      failures +=
          fmt::format("{}{} is {:.2f}{}, wanted {} {:g}", failures.empty() ? "" : "; ", target.name,
                      target.value, target.unit.empty() ? "" : " " + target.unit, target.comparison,
                      target.limit);
    }
  }
  return failures.empty() ? "pass" : "fail: " + failures;
}

std::string content_hash(std::string_view content) {
  constexpr std::uint64_t kOffsetBasis = 0xcbf29ce484222325;
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t hash = kOffsetBasis;
  for (const char byte : content) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * kPrime;
  }
  return fmt::format("fnv1a:{:016x}", hash);
}

}  // namespace finback::report
