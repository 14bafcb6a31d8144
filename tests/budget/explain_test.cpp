// The reasons that are given, on results made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "handmade.hpp"
#include <budget/explain.hpp>
#include <budget/subject.hpp>
#include <budget/verdict.hpp>

namespace finback::budget {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Why : public ::testing::Test {
 protected:
  // The reasons for what `limits` find broken.
  const std::vector<Explanation>& of(const std::string& limits, bool with_baseline = true) {
    budget_ = budget_of(limits);
    verdict_ = judge(budget_, now, "r.json", with_baseline ? &baseline : nullptr);
    return verdict_.why;
  }

  const report::RunResult baseline = handmade_result();
  report::RunResult now = handmade_result();

 private:
  Budget budget_;
  Verdict verdict_;
};

TEST_F(Why, AMovedObjectExplainsAllThatItBreaks) {
  move_scores(now, 12'000);
  const auto& why =
      of("frames_per_second = \">= baseline\"\ncycles = \"<= baseline\"\n"
         "function.core_b.match.exclusive_cycles = \"<= baseline\"\n"
         "stage.core_b.matching_scores.cycles = \"<= baseline\"\n"
         "core_b.stall.l3_read.cycles = \"<= baseline\"\nlevel.l3.bytes = \"<= baseline\"\n"
         "object.core_b.scores.stall_cycles = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].checks.size(), 7U);
  EXPECT_EQ(why[0].headline,
            "core_b: more waiting for data in L3 (l3_read, l3_write), +12,000 cycles");
  EXPECT_THAT(why[0].details, ElementsAre("match +12,000 cycles (+60.0 %): l3_read +12,000",
                                          "  match.c:11 +12,000 cycles: l3_read +12,000",
                                          "scores: l1.data.a -> l3, +12,000 stall cycles"));
  EXPECT_EQ(why[0].worst.file, "match.c");
  EXPECT_EQ(why[0].worst.line, 11);
}

TEST_F(Why, ASlowedLoopIsMoreWork) {
  slow_down(now, "census", 5, "issue", 900);
  const auto& why = of("frames_per_second = \">= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: more work (issue), +900 cycles");
  EXPECT_THAT(why[0].details, ElementsAre("census +900 cycles (+10.0 %): issue +900",
                                          "  census.c:5 +900 cycles: issue +900"));
}

TEST_F(Why, MoreCallsAreTold) {
  slow_down(now, "match", 10, "issue", 2'000);
  function(now, "match").calls = 530;
  const auto& why = of("function.core_b.match.calls = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_THAT(why[0].details.front(), HasSubstr("; calls 480 -> 530"));
}

// What the other core waits is no reason: that it waits has one.
TEST_F(Why, AWaitingCoreIsExplainedByTheOther) {
  slow_down(now, "match", 11, "sub_bank", 700);
  const auto& why = of(
      "function.core_a.wait.exclusive_cycles = \"<= baseline\"\ncore_a.cycles = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: more meeting in one L1 sub-bank (sub_bank), +700 cycles");
  EXPECT_EQ(why[0].checks.size(), 2U);
}

TEST_F(Why, AFewCyclesOfItsOwnDoNotExplainAWaitingCore) {
  slow_down(now, "match", 11, "l3_read", 5'000);
  function(now, "wait").causes.front().second += 10;
  function(now, "wait").inclusive += 10;
  function(now, "wait").exclusive += 10;
  const auto& why =
      of("core_a.cycles = \"<= baseline\"\n"
         "function.core_a.wait.inclusive_cycles = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_THAT(why[0].headline, StartsWith("core_b: more waiting for data in L3"));
}

TEST_F(Why, IdleIsNamedWhenNothingElseGrew) {
  slow_down(now, "match", 11, "idle", 700);
  const auto& why = of("cycles = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_THAT(why[0].headline, HasSubstr("time asleep (idle)"));
}

TEST_F(Why, TwoCausesAreTwoReasons) {
  slow_down(now, "match", 11, "l3_read", 3'000);
  slow_down(now, "census", 5, "issue", 900);
  const auto& why =
      of("\"function.core_b.*.exclusive_cycles\" = \"<= baseline\"\n"
         "\"function.core_?.*.exclusive_cycles\" = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 2U);
  EXPECT_THAT(why[0].headline, HasSubstr("L3"));
  EXPECT_THAT(why[0].details.front(), StartsWith("match "));
  EXPECT_THAT(why[1].headline, HasSubstr("issue"));
  EXPECT_THAT(why[1].details.front(), StartsWith("census "));
}

TEST_F(Why, AFunctionThatIsNewOrGoneIsTold) {
  function(now, "census").name = "census_slow";
  for (report::Line& row : now.lines) {
    row.function = row.function == "census" ? "census_slow" : row.function;
  }
  slow_down(now, "census_slow", 5, "issue", 100);
  const auto& why = of("\"function.core_b.*.exclusive_cycles\" = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_THAT(why[0].details, ElementsAre("census_slow +9,100 cycles (new): issue +9,100",
                                          "  census.c:5 +9,100 cycles: issue +9,100",
                                          "gone: census -9,000 cycles"));
}

TEST_F(Why, LessWorkIsTold) {
  function(now, "census").exclusive = 8'000;
  function(now, "census").causes = {{"issue", 8'000}};
  const auto& why = of("function.core_b.census.exclusive_cycles = \"== baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: less work (issue), -1,000 cycles");
}

TEST_F(Why, OfAnUnchangedValueIsWhatCostsMost) {
  const auto& why = of("frames_per_second = \">= 1_000_000\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: no worse than the baseline; what costs most now");
  EXPECT_THAT(why[0].details.front(), "match 20,000 cycles: issue 20,000");
}

TEST_F(Why, OfABetterValueThatIsNotEnoughIsWhatCostsMost) {
  function(now, "census").exclusive = 8'000;
  function(now, "census").causes = {{"issue", 8'000}};
  const auto& why = of("function.core_b.census.exclusive_cycles = \"<= 5_000\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: no worse than the baseline; what costs most now");
}

TEST_F(Why, WithoutABaselineIsWhatCostsMost) {
  const auto& why = of("function.core_b.census.exclusive_cycles = \"<= 5\"\n", false);
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b: what costs most now");
  EXPECT_THAT(why[0].details, ::testing::Contains("census 9,000 cycles: issue 9,000"));
  EXPECT_EQ(why[0].worst.file, "match.c");
}

TEST_F(Why, MemoryIsExplainedByItsObjects) {
  now.objects.front().size = 1'000;
  now.regions.front().used = 1'000;
  const auto& why = of("memory.core_b.l1.data.a.used_bytes = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "core_b l1.data.a: +200 bytes");
  EXPECT_THAT(why[0].details, ElementsAre("scores (l1.data.a), +200 bytes"));
}

TEST_F(Why, CodeAndStacksAreExplainedByFunctions) {
  function(now, "match").code_bytes = 240;
  now.cores[1].code_bytes = 40;
  now.cores[1].stack_used_bytes = 16;
  const auto& why =
      of("core_b.code.bytes = \"<= baseline\"\ncore_b.stack.used_bytes = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 2U);
  EXPECT_EQ(why[0].headline, "core_b code: +40 bytes");
  EXPECT_EQ(why[1].headline, "core_b stack: +16 bytes at its deepest");
  for (const Explanation& reason : why) {
    EXPECT_THAT(reason.details, ElementsAre("match +40 bytes of code"));
  }
}

TEST_F(Why, PowerIsExplainedByItsComponents) {
  now.power.watts = 2.25;
  now.power.components[1].watts = 0.75;
  const auto& why = of("power_watts = \"<= baseline\"\n");
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why[0].headline, "power: +0.2500 W");
  EXPECT_THAT(why[0].details, ElementsAre("sdram +0.2500 W"));
}

TEST_F(Why, NothingBrokenHasNone) { EXPECT_THAT(of("cycles = \"<= baseline\"\n"), IsEmpty()); }

TEST(Subject, IsReadFromTheName) {
  const auto kind = [](const char* metric) { return subject_of(metric).kind; };
  EXPECT_EQ(kind("frames_per_second"), SubjectKind::camera);
  EXPECT_EQ(kind("core_megahertz"), SubjectKind::camera);
  EXPECT_EQ(kind("core_b.cycles"), SubjectKind::core);
  EXPECT_EQ(kind("core_b.stack.used_bytes"), SubjectKind::stack);
  EXPECT_EQ(kind("power.core_b_dynamic.watts"), SubjectKind::power);
  EXPECT_EQ(kind("memory.sdram.row_hit.accesses"), SubjectKind::level);
  const Subject function = subject_of("function.core_b.odd.name.inclusive_cycles_per_frame");
  EXPECT_EQ(function.kind, SubjectKind::callees);
  EXPECT_EQ(function.owner, "core_b");
  EXPECT_EQ(function.name, "odd.name");
  const Subject stall = subject_of("traffic.l3.core_b.read.stall.cycles");
  EXPECT_EQ(stall.kind, SubjectKind::cause);
  EXPECT_EQ(stall.owner, "core_b");
  EXPECT_EQ(stall.name, "l3_read");
  const Subject region = subject_of("memory.core_b.l1.data.a.free_bytes");
  EXPECT_EQ(region.kind, SubjectKind::region);
  EXPECT_EQ(region.name, "l1.data.a");
}

}  // namespace
}  // namespace finback::budget
