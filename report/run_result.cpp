#include <fmt/format.h>

#include <report/run_result.hpp>

namespace finback::report {

double RunResult::hertz(Cycles from, Cycles to) const {
  return clocks.changed() ? clocks.mean_hertz(from, to) : core_hertz;
}

double RunResult::seconds(Cycles from, Cycles to) const {
  const double mean = hertz(from, to);
  return mean > 0 ? static_cast<double>(to - from) / mean : 0;
}

Stretch steady_state(const std::vector<Frame>& frames) {
  if (frames.empty()) {
    return {};
  }
  return {frames.size() == 1 ? frames.front().grabbed : frames.front().published,
          frames.back().published};
}

double frames_per_second(const std::vector<Frame>& frames, double core_hertz) {
  const auto [from, to] = steady_state(frames);
  const double intervals = frames.size() == 1 ? 1 : static_cast<double>(frames.size()) - 1;
  return to > from ? intervals * core_hertz / static_cast<double>(to - from) : 0;
}

double frames_per_second(const RunResult& result) {
  const auto [from, to] = steady_state(result.frames);
  return frames_per_second(result.frames, result.hertz(from, to));
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
