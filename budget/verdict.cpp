#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <budget/numbers.hpp>
#include <budget/verdict.hpp>

namespace finback::budget {

namespace {

constexpr std::array<const char*, 3> kHeadlines = {"frames_per_second", "power_watts", "cycles"};

std::string frames_text(std::size_t frames) {
  return fmt::format("{} frame{}", frames, frames == 1 ? "" : "s");
}

[[noreturn]] void fail_incomparable(const std::string& name, const std::string& what,
                                    const std::string& is, const Budget& budget,
                                    const std::string& was) {
  throw InputError(
      SourcePlace{name},
      fmt::format("{} {}, but the baseline {} {} {}: they cannot be compared; run the same, or "
                  "write a new baseline with --update-baseline",
                  what, is, budget.baseline.string(), what == "has" ? "has" : "is of", was));
}

void require_same_firmware(const Budget& budget, const std::string& is, const std::string& name) {
  if (!budget.firmware.empty() && is != budget.firmware) {
    throw InputError(SourcePlace{name},
                     fmt::format("a result of the firmware {}, but {} holds budgets of {}", is,
                                 budget.file, budget.firmware));
  }
}

}  // namespace

void require_comparable(const Budget& budget, const report::RunResult& result,
                        const std::string& name, const report::RunResult* baseline) {
  const report::Provenance& now = result.provenance;
  require_same_firmware(budget, now.firmware.name, name);
  if (baseline == nullptr) {
    return;
  }
  const report::Provenance& then = baseline->provenance;
  require_same_firmware(budget, then.firmware.name, budget.baseline.string());
  if (now.firmware.name != then.firmware.name) {
    fail_incomparable(name, "of the firmware", now.firmware.name, budget, then.firmware.name);
  }
  if (now.scene.name != then.scene.name) {
    fail_incomparable(name, "of the scene", now.scene.name, budget, then.scene.name);
  }
  if (now.scene.hash != then.scene.hash) {
    fail_incomparable(name, "of the scene", now.scene.name, budget, "other pictures of that name");
  }
  if (result.frames.size() != baseline->frames.size()) {
    fail_incomparable(name, "has", frames_text(result.frames.size()), budget,
                      frames_text(baseline->frames.size()));
  }
}

std::vector<std::string> changed_inputs(const report::Provenance& before,
                                        const report::Provenance& now) {
  std::vector<std::string> changed;
  if (before.tool_version != now.tool_version) {
    changed.push_back(fmt::format("Finback {} -> {}", before.tool_version, now.tool_version));
  }
  const auto add = [&](const char* what, const report::Ingredient& from,
                       const report::Ingredient& to) {
    if (from.name != to.name) {
      changed.push_back(fmt::format("{} {} -> {}", what, from.name, to.name));
    } else if (from.hash != to.hash) {
      changed.push_back(fmt::format("{} {}", what, to.name));
    }
  };
  add("firmware", before.firmware, now.firmware);
  add("placement", before.placement, now.placement);
  add("machine", before.machine, now.machine);
  add("power model", before.power, now.power);
  return changed;
}

std::vector<Headline> headlines_of(const Metrics& now, const Metrics* baseline) {
  std::vector<Headline> headlines;
  for (const char* name : kHeadlines) {
    const auto value = now.find(name);
    if (value == now.end()) {
      continue;
    }
    Headline headline{name, value->second.unit, value->second.value, std::nullopt};
    if (baseline != nullptr && baseline->contains(name)) {
      headline.baseline = baseline->at(name).value;
    }
    headlines.push_back(std::move(headline));
  }
  return headlines;
}

std::string headline_text(const Headline& headline) {
  const std::string value = fmt::format("{} {}", number_text(headline.value), headline.unit);
  if (!headline.baseline || *headline.baseline == headline.value) {
    return value;
  }
  return fmt::format("{} ({} before, {})", value, number_text(*headline.baseline),
                     percent_text(*headline.baseline, headline.value));
}

Verdict judge(const Budget& budget, const report::RunResult& result, const std::string& name,
              const report::RunResult* baseline) {
  require_comparable(budget, result, name, baseline);
  const Metrics now = report::metrics_of(result);
  const Metrics then = baseline == nullptr ? Metrics() : report::metrics_of(*baseline);
  const Metrics* reference = baseline == nullptr ? nullptr : &then;
  Verdict verdict;
  verdict.budget = budget.file;
  verdict.sources = budget.sources;
  verdict.run = fmt::format("firmware {}, scene {}, {}", result.provenance.firmware.name,
                            result.provenance.scene.name, frames_text(result.frames.size()));
  for (Check& check : check_limits(budget, now, reference)) {
    (check.holds ? verdict.held : verdict.broken).push_back(std::move(check));
  }
  verdict.headlines = headlines_of(now, reference);
  verdict.why = explain(verdict.broken, result, baseline);
  verdict.metrics = now.size();
  if (baseline != nullptr) {
    verdict.baseline = budget.baseline.string();
    verdict.changed = changed_inputs(baseline->provenance, result.provenance);
    for (const auto& [metric, value] : now) {
      const auto found = then.find(metric);
      verdict.differing += found == then.end() || found->second.value != value.value ? 1U : 0U;
    }
    verdict.differing += static_cast<std::size_t>(std::ranges::count_if(
        then, [&](const auto& metric) { return !now.contains(metric.first); }));
  }
  return verdict;
}

}  // namespace finback::budget
