// Limits against metrics: what is matched, what contradicts, what is worst, what compares.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "handmade.hpp"
#include <budget/check.hpp>
#include <budget/verdict.hpp>
#include <common/toml_reader.hpp>

namespace finback::budget {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Metrics kNow = {
    {"fps", {15, "fps"}},     {"watts", {2.5, "W"}},     {"f.a.cycles", {110, "cycles"}},
    {"f.b.cycles", {90, ""}}, {"f.new.cycles", {7, ""}}, {"g", {5, ""}}};
const Metrics kThen = {
    {"fps", {20, "fps"}},     {"watts", {2, "W"}}, {"f.a.cycles", {100, "cycles"}},
    {"f.b.cycles", {90, ""}}, {"g", {5, ""}},      {"f.old.cycles", {1, ""}}};

template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string refused(const std::string& limits) {
  return refusal([&] { static_cast<void>(check_limits(budget_of(limits), kNow, &kThen)); });
}

std::vector<std::string> metrics_of(const std::vector<Check>& checks) {
  std::vector<std::string> names;
  names.reserve(checks.size());
  for (const Check& check : checks) {
    names.push_back((check.holds ? "" : "!") + check.metric);
  }
  return names;
}

TEST(Limits, AreReadFromTablesOfTables) {
  const Budget budget = budget_of(
      "a.b.c = \"<= 1\"\n\"a.b.d\" = [\"<= 2\", \">= baseline\"]\n"
      "[limits.a.\"x.y\"]\nz = \"== 3\"\n");
  std::vector<std::string> texts;
  texts.reserve(budget.limits.size());
  for (const Limit& limit : budget.limits) {
    texts.push_back(limit.text());
  }
  EXPECT_THAT(texts, ElementsAre("a.b.c <= 1", "a.b.d <= 2", "a.b.d >= baseline", "a.x.y.z == 3"));
  EXPECT_EQ(budget.limits[2].written.line, 6);
  EXPECT_EQ(budget.baseline, "ci/base.json");
}

TEST(Limits, WantAComparison) {
  EXPECT_THAT(refusal([] { static_cast<void>(budget_of("fps = 20\n")); }),
              AllOf(HasSubstr("ci/b.toml:5:"), HasSubstr("\"<= 20\" or \">= 20\"")));
  EXPECT_THAT(refusal([] { static_cast<void>(budget_of("fps = [\">= 20\", 3]\n")); }),
              HasSubstr("ci/b.toml:5:"));
  EXPECT_THAT(refusal([] { static_cast<void>(budget_of("fps = [\">= 20\", \"< 3\"]\n")); }),
              HasSubstr("ci/b.toml:5:17: '< 3' is no comparison"));
}

TEST(Limits, OnTheBaselineWantOne) {
  const TomlReader reader("[limits]\nfps = \">= baseline - 5\"\n", "b.toml");
  EXPECT_THAT(
      refusal([&] { static_cast<void>(read_budget(reader)); }),
      AllOf(HasSubstr("b.toml:2:7"), HasSubstr("fps >= baseline - 5"), HasSubstr("baseline = ")));
}

TEST(Limits, OfUnknownKeysNameTheNearest) {
  const TomlReader reader("limit = 5\n", "b.toml");
  EXPECT_THAT(refusal([&] { static_cast<void>(read_budget(reader)); }),
              AllOf(HasSubstr("b.toml:1:"), HasSubstr("did you mean 'limits'?")));
}

TEST(Checks, MatchPatternsAndRankTheWorstFirst) {
  const Budget budget = budget_of(
      "g = \"== 5\"\nfps = \">= 20\"\nwatts = \"<= 2\"\n\"f.*.cycles\" = \"<= baseline\"\n");
  const std::vector<Check> checks = check_limits(budget, kNow, &kThen);
  EXPECT_THAT(metrics_of(checks),
              ElementsAre("!f.new.cycles", "!fps", "!watts", "!f.a.cycles", "g", "f.b.cycles"));
  EXPECT_TRUE(checks[0].is_new);
  EXPECT_TRUE(std::isinf(checks[0].excess));
  EXPECT_EQ(checks[1].excess, 0.25);
  EXPECT_EQ(checks[3].bound, 100);
  EXPECT_EQ(checks[3].baseline, 100);
}

TEST(Checks, OfNoMetricNameTheNearest) {
  EXPECT_THAT(refused("f.a.cicles = \"<= 5\"\n"),
              AllOf(HasSubstr("ci/b.toml:5:"), HasSubstr("did you mean 'f.a.cycles'?")));
  EXPECT_THAT(refused("\"zzz.*.qqqqqqqqqq\" = \"<= 5\"\n"),
              AllOf(HasSubstr("no metric matches"), HasSubstr("--list")));
  EXPECT_THAT(refused("f.old.cycles = \"<= 5\"\n"), HasSubstr("the baseline has it"));
}

TEST(Checks, RefuseContradictions) {
  EXPECT_THAT(refused("fps = [\">= 20\", \"<= 10\"]\n"),
              AllOf(HasSubstr("ci/b.toml:5:17: 'fps <= 10' contradicts 'fps >= 20' of line 5"),
                    HasSubstr("fps cannot meet both")));
  // Two entries, one of them a pattern.
  EXPECT_THAT(refused("\"f.*.cycles\" = \"<= 10\"\nf.a.cycles = \"== 11\"\n"),
              AllOf(HasSubstr("ci/b.toml:6:"), HasSubstr("f.*.cycles <= 10"), HasSubstr("line 5")));
  // Known only with the baseline's value.
  EXPECT_THAT(refused("fps = [\">= 21\", \"<= baseline\"]\n"),
              HasSubstr("'fps <= baseline' (20) contradicts 'fps >= 21'"));
  EXPECT_THAT(refused("fps = [\"== 20\", \"<= baseline\", \">= 20\"]\n"), "nothing was refused");
}

TEST(Checks, KnowContradictionsBeforeTheRun) {
  const auto early = [](const std::string& limits, const Metrics* baseline) {
    return refusal([&] { require_consistent(budget_of(limits), baseline); });
  };
  EXPECT_THAT(early("x = [\">= 20\", \"<= 10\"]\n", nullptr), HasSubstr("x cannot meet both"));
  EXPECT_THAT(early("\"f.?.cycles\" = \">= 101\"\nf.a.cycles = \"<= baseline\"\n", &kThen),
              HasSubstr("f.a.cycles cannot meet both"));
  EXPECT_EQ(early("x = [\">= 20\", \"<= baseline\"]\n", nullptr), "nothing was refused");
}

TEST(Checks, OfWhatIsNewContradictNothing) {
  const Budget budget = budget_of("\"f.*.cycles\" = \"<= baseline\"\nf.new.cycles = \">= 5\"\n");
  EXPECT_THAT(metrics_of(check_limits(budget, kNow, &kThen)),
              ElementsAre("!f.new.cycles", "!f.a.cycles", "f.b.cycles", "f.new.cycles"));
}

TEST(Comparison, WantsTheSameRun) {
  const Budget budget = budget_of("cycles = \"<= baseline\"\n");
  const report::RunResult baseline = handmade_result();
  const auto refused_after = [&](auto change) {
    report::RunResult now = handmade_result();
    change(now);
    return refusal([&] { static_cast<void>(judge(budget, now, "r.json", &baseline)); });
  };
  EXPECT_EQ(refused_after([](auto&) {}), "nothing was refused");
  EXPECT_THAT(refused_after([](auto& now) { now.provenance.firmware.name = "main"; }),
              "r.json is of the firmware main, but ci/b.toml holds budgets of camera");
  EXPECT_THAT(refused_after([](auto& now) { now.provenance.scene.name = "synthetic"; }),
              HasSubstr("r.json is of the scene synthetic, but the baseline ci/base.json is of the "
                        "scene aloe"));
  EXPECT_THAT(refused_after([](auto& now) { now.provenance.scene.hash = "t"; }),
              HasSubstr("of other pictures"));
  EXPECT_THAT(refused_after([](auto& now) { now.frames.pop_back(); }),
              HasSubstr("r.json has 1 frame, but the baseline ci/base.json has 2 frames"));
}

TEST(Comparison, OfTheSameFindsNoDifference) {
  const Budget budget = budget_of("\"*cycles\" = \"<= baseline\"\n");
  const report::RunResult result = handmade_result();
  const Verdict verdict = judge(budget, result, "r.json", &result);
  EXPECT_TRUE(verdict.passed());
  EXPECT_EQ(verdict.differing, 0U);
  EXPECT_GT(verdict.metrics, 10U);
  EXPECT_TRUE(verdict.why.empty());
  EXPECT_TRUE(verdict.changed.empty());
}

}  // namespace
}  // namespace finback::budget
