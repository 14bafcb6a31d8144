// The comparisons of a limit: every form, and what is none.
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <budget/demand.hpp>
#include <common/pattern.hpp>

namespace finback::budget {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Demand parsed(std::string_view text) { return parse_demand(text, {"b.toml", 3, 5}); }

TEST(Demand, ReadsNumbers) {
  EXPECT_EQ(parsed("<= 4_500_000").bound(0), 4'500'000);
  EXPECT_EQ(parsed(">=20").bound(0), 20);
  EXPECT_EQ(parsed("  ==  -2.5e1 ").bound(0), -25);
  EXPECT_EQ(parsed("<= 2.3").relation, Relation::at_most);
  EXPECT_EQ(parsed(">= 2.3").relation, Relation::at_least);
  EXPECT_EQ(parsed("== 2.3").relation, Relation::equal);
}

TEST(Demand, ReadsTheBaseline) {
  EXPECT_EQ(parsed("<= baseline").bound(200), 200);
  EXPECT_EQ(parsed("<= baseline + 64").bound(200), 264);
  EXPECT_EQ(parsed(">=baseline-1_000").bound(3000), 2000);
  EXPECT_EQ(parsed("<= baseline + 1 %").bound(200), 202);
  EXPECT_EQ(parsed(">= baseline - 2.5%").bound(200), 195);
  EXPECT_FALSE(parsed("<= 5").relative);
  EXPECT_TRUE(parsed("<= baseline").relative);
}

TEST(Demand, TellsWhereItsBoundIsFrom) {
  for (const char* text : {"baseline", "baseline + 64", "baseline - 64", "baseline + 0.5 %"}) {
    EXPECT_EQ(parsed(std::string("<= ") + text).origin_text(), text);
  }
  EXPECT_EQ(parsed("<= 5").origin_text(), "");
}

TEST(Demand, RefusesWhatIsNoComparison) {
  for (const char* text : {"",
                           "20",
                           "< 20",
                           "=> 20",
                           "= 20",
                           "<=",
                           "<= twenty",
                           "<= 20 fps",
                           "<= 1__0",
                           "<= _1",
                           "<= 1_",
                           "<= inf",
                           "<= nan",
                           "<= 1e999",
                           "<= baselin",
                           "<= baseline 5",
                           "<= baseline +",
                           "<= baseline + -5",
                           "<= baseline * 2",
                           "<= 5 %",
                           "<= baseline + 5 % more"}) {
    try {
      static_cast<void>(parsed(text));
      ADD_FAILURE() << "'" << text << "' was read";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("b.toml:3:5"), HasSubstr("\"<= baseline + 1 %\"")));
    }
  }
}

TEST(Demand, HoldsOnItsBound) {
  EXPECT_TRUE(parsed("<= 20").holds(20, 20));
  EXPECT_FALSE(parsed("<= 20").holds(20.0001, 20));
  EXPECT_TRUE(parsed(">= 20").holds(20, 20));
  EXPECT_FALSE(parsed(">= 20").holds(19.9999, 20));
  EXPECT_TRUE(parsed("== 20").holds(20, 20));
  EXPECT_FALSE(parsed("== 20").holds(21, 20));
}

TEST(Demand, MeasuresItsExcess) {
  EXPECT_EQ(parsed("<= 20").excess(30, 20), 0.5);
  EXPECT_EQ(parsed(">= 20").excess(5, 20), 0.75);
  EXPECT_EQ(parsed("== 20").excess(10, 20), 0.5);
  EXPECT_EQ(parsed("<= 20").excess(10, 20), 0);
  EXPECT_TRUE(std::isinf(parsed("<= 0").excess(1, 0)));
}

TEST(Pattern, Matches) {
  EXPECT_TRUE(matches_pattern("function.core_b.*.calls", "function.core_b.census_row.calls"));
  EXPECT_TRUE(matches_pattern("memory.*.free_bytes", "memory.core_b.l1.data.a.free_bytes"));
  EXPECT_TRUE(matches_pattern("core_?.cycles", "core_a.cycles"));
  EXPECT_TRUE(matches_pattern("*", ""));
  EXPECT_TRUE(matches_pattern("a*b*c", "a_b_b_c"));
  EXPECT_FALSE(matches_pattern("core_?.cycles", "core_.cycles"));
  EXPECT_FALSE(matches_pattern("function.*.calls", "function.core_b.main.calls_per_frame"));
  EXPECT_FALSE(matches_pattern("cycles", "cycles_per_frame"));
  EXPECT_FALSE(matches_pattern("a*b", "a_b_c"));
}

}  // namespace
}  // namespace finback::budget
