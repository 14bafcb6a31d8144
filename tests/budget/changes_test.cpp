// What is found to differ between two results.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "handmade.hpp"
#include <budget/changes.hpp>
#include <budget/line_changes.hpp>

namespace finback::budget {
namespace {

using ::testing::IsEmpty;

const FunctionChange& change_of(const Changes& changes, const std::string& name) {
  return *std::ranges::find(changes.functions, name, &FunctionChange::name);
}

TEST(Changes, OfTheSameAreNone) {
  const report::RunResult result = handmade_result();
  for (const FunctionChange& row : compare(result, result).functions) {
    EXPECT_EQ(row.cycles(), 0);
    EXPECT_EQ(row.idle, 0);
    EXPECT_THAT(row.causes, IsEmpty());
    EXPECT_THAT(row.lines, IsEmpty());
  }
}

TEST(Changes, KeepIdleApart) {
  report::RunResult now = handmade_result();
  slow_down(now, "match", 11, "issue", 500);
  const Changes changes = compare(handmade_result(), now);
  EXPECT_EQ(change_of(changes, "match").cycles(), 500);
  EXPECT_EQ(change_of(changes, "match").causes, (CauseChanges{{"issue", 500}}));
  EXPECT_EQ(change_of(changes, "wait").cycles(), 0);
  EXPECT_EQ(change_of(changes, "wait").idle, 500);
}

TEST(Changes, TellWhatIsNewAndGone) {
  report::RunResult now = handmade_result();
  function(now, "census").name = "census_fast";
  const Changes changes = compare(handmade_result(), now);
  EXPECT_TRUE(change_of(changes, "census_fast").is_new);
  EXPECT_EQ(change_of(changes, "census_fast").cycles(), 9'000);
  EXPECT_TRUE(change_of(changes, "census").is_gone);
  EXPECT_EQ(change_of(changes, "census").cycles(), -9'000);
}

TEST(Changes, TellWhatMoved) {
  report::RunResult now = handmade_result();
  move_scores(now, 12'000);
  const Changes changes = compare(handmade_result(), now);
  ASSERT_EQ(changes.objects.size(), 1U);
  const ObjectChange& scores = changes.objects.front();
  EXPECT_TRUE(scores.moved());
  EXPECT_EQ(scores.level_before, "l1");
  EXPECT_EQ(scores.level_after, "l3");
  EXPECT_EQ(scores.stalls.at("core_b"), 12'000);
}

// A line of source by its number and its cycles.
std::vector<report::Line> source(const std::vector<std::pair<int, Cycles>>& lines) {
  std::vector<report::Line> rows;
  rows.reserve(lines.size());
  for (const auto& [number, cycles] : lines) {
    rows.push_back(line_of("match", "match.c", number, "issue", cycles));
  }
  return rows;
}

std::vector<const report::Line*> pointers(const std::vector<report::Line>& rows) {
  std::vector<const report::Line*> lines;
  lines.reserve(rows.size());
  for (const report::Line& row : rows) {
    lines.push_back(&row);
  }
  return lines;
}

std::vector<std::pair<int, std::int64_t>> line_changes(
    const std::vector<std::pair<int, Cycles>>& before,
    const std::vector<std::pair<int, Cycles>>& after) {
  const std::vector<report::Line> old_rows = source(before);
  const std::vector<report::Line> new_rows = source(after);
  std::vector<std::pair<int, std::int64_t>> changes;
  for (const LineChange& change : compare_lines(pointers(old_rows), pointers(new_rows))) {
    changes.emplace_back(change.line, change.cycles);
  }
  return changes;
}

TEST(Lines, ThatWaitAreTheSame) {
  const std::vector<report::Line> before = source({{10, 100}, {11, 200}, {12, 300}});
  std::vector<report::Line> after = before;
  after[0].causes.emplace_back("l3_read", 100);  // as dear as line 11 was
  const std::vector<LineChange> changes = compare_lines(pointers(before), pointers(after));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].line, 10);
  EXPECT_EQ(changes[0].causes, (CauseChanges{{"l3_read", 100}}));
}

using Pairs = std::vector<std::pair<int, std::int64_t>>;

TEST(Lines, ThatGrewAreTold) {
  EXPECT_EQ(line_changes({{10, 100}, {11, 200}}, {{10, 100}, {11, 260}}), (Pairs{{11, 60}}));
}

TEST(Lines, BelowAnInsertedOneAreTheSame) {
  EXPECT_EQ(
      line_changes({{10, 100}, {11, 200}, {12, 300}}, {{10, 100}, {12, 50}, {13, 200}, {14, 300}}),
      (Pairs{{12, 50}}));
}

TEST(Lines, BelowAGoneOneAreTheSame) {
  EXPECT_EQ(line_changes({{10, 100}, {11, 200}, {12, 300}}, {{10, 100}, {11, 300}}), Pairs{});
}

TEST(Lines, OfEqualCostKeepTheirNumbers) {
  EXPECT_EQ(line_changes({{10, 100}, {12, 100}}, {{10, 100}, {11, 100}, {12, 100}}),
            (Pairs{{11, 100}}));
}

TEST(Lines, OfANewFunctionAreAllNew) {
  EXPECT_EQ(line_changes({}, {{10, 100}, {11, 200}}), (Pairs{{10, 100}, {11, 200}}));
}

}  // namespace
}  // namespace finback::budget
