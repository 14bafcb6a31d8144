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

// `is` and `was` say what differs: "is of the scene aloe", "has 4 frames".
[[noreturn]] void fail_incomparable(const std::string& name, const std::string& is,
                                    const Budget& budget, const std::string& was) {
  throw InputError(fmt::format(
      "{} {}, but the baseline {} {}: they cannot be compared; run the same, or write a new "
      "baseline with --update-baseline",
      name, is, budget.baseline.string(), was));
}

}  // namespace

void require_firmware(const Budget& budget, const report::RunResult& result,
                      const std::string& name) {
  const std::string& is = result.provenance.firmware.name;
  if (!budget.firmware.empty() && is != budget.firmware) {
    throw InputError(fmt::format("{} is of the firmware {}, but {} holds budgets of {}", name, is,
                                 budget.file, budget.firmware));
  }
}

void require_comparable(const Budget& budget, const report::RunResult& result,
                        const std::string& name, const report::RunResult* baseline) {
  require_firmware(budget, result, name);
  if (baseline == nullptr) {
    return;
  }
  require_firmware(budget, *baseline, budget.baseline.string());
  const report::Provenance& now = result.provenance;
  const report::Provenance& then = baseline->provenance;
  const auto require_same = [&](const std::string& what, const std::string& is,
                                const std::string& was) {
    if (is != was) {
      fail_incomparable(name, what + is, budget, what + was);
    }
  };
  require_same("is of the firmware ", now.firmware.name, then.firmware.name);
  require_same("is of the scene ", now.scene.name, then.scene.name);
  if (now.scene.hash != then.scene.hash) {
    fail_incomparable(name, "is of the scene " + now.scene.name, budget,
                      "of other pictures with that name");
  }
  require_same("has ", frames_text(result.frames.size()), frames_text(baseline->frames.size()));
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
      changed.push_back(fmt::format("{} {} has other contents", what, to.name));
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
  if (!headline.baseline || *headline.baseline == headline.value) {
    return fmt::format("{} {}", number_text(headline.value), headline.unit);
  }
  const auto [before, now] = distinct_texts(*headline.baseline, headline.value);
  return fmt::format("{} -> {} {} ({})", before, now, headline.unit,
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
