// A budget held against a result: what holds, what does not, why. What every writer works from.
//
// It holds no date, host path or duration: the same inputs give the same bytes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <budget/check.hpp>
#include <budget/explain.hpp>
#include <report/run_result.hpp>

namespace finback::budget {

// One of the few numbers that stand for the whole.
struct Headline {
  std::string name;
  std::string unit;
  double value = 0;
  std::optional<double> baseline;
};

struct Verdict {
  std::string budget;    // the budgets file as it was named
  std::string baseline;  // "" when there is none
  std::filesystem::path sources;
  std::string run;                   // "firmware mesvs2, scene aloe, 4 frames"
  std::vector<std::string> changed;  // of the inputs: "placement old -> new"
  std::vector<Headline> headlines;
  std::vector<Check> broken;  // worst first
  std::vector<Check> held;    // in the order of the budget
  std::vector<Explanation> why;
  // With a baseline: how many metrics there are, and how many of them differ from it.
  std::size_t metrics = 0;
  std::size_t differing = 0;

  [[nodiscard]] bool passed() const { return broken.empty(); }
};

// Throws InputError when `result` is of another firmware than the budget, or of another firmware,
// scene or number of frames than the baseline: comparing them would mean nothing. `name` is what
// messages call the result.
void require_comparable(const Budget& budget, const report::RunResult& result,
                        const std::string& name, const report::RunResult* baseline);

// The first of these conditions.
void require_firmware(const Budget& budget, const report::RunResult& result,
                      const std::string& name);

// `budget` must outlive the verdict. Throws InputError as require_comparable and check_limits do.
[[nodiscard]] Verdict judge(const Budget& budget, const report::RunResult& result,
                            const std::string& name, const report::RunResult* baseline);

// What changed of the inputs, and of the headlines, from one result to another.
[[nodiscard]] std::vector<std::string> changed_inputs(const report::Provenance& before,
                                                      const report::Provenance& now);
[[nodiscard]] std::vector<Headline> headlines_of(const Metrics& now, const Metrics* baseline);

// "62.014 fps", or "62.1 -> 62.014 fps (-0.1 %)" when there is a baseline that differs.
[[nodiscard]] std::string headline_text(const Headline& headline);

}  // namespace finback::budget
