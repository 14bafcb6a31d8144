// What is written about a verdict, and that odd names cannot break its form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "handmade.hpp"
#include <budget/numbers.hpp>
#include <budget/writers.hpp>

namespace finback::budget {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class Writers : public ::testing::Test {
 protected:
  Verdict verdict_of(const report::RunResult& now) {
    return judge(budget_, now, "r.json", &baseline_);
  }
  static report::RunResult broken() {
    report::RunResult now = handmade_result();
    move_scores(now, 12'000);
    return now;
  }

 private:
  Budget budget_ = budget_of(
      "frames_per_second = \">= baseline - 1 %\"\nlevel.l3.bytes = \"<= 10\"\n"
      "\"function.core_b.*.exclusive_cycles\" = \"<= baseline\"\n");
  report::RunResult baseline_ = handmade_result();
};

TEST(Numbers, AreGrouped) {
  EXPECT_EQ(number_text(17'885'760), "17,885,760");
  EXPECT_EQ(number_text(-1'000), "-1,000");
  EXPECT_EQ(number_text(999), "999");
  EXPECT_EQ(number_text(62.0137), "62.014");
  EXPECT_EQ(number_text(1'234'567.98), "1,234,568");
  EXPECT_EQ(signed_text(12'345), "+12,345");
  EXPECT_EQ(signed_text(-12'345), "-12,345");
}

TEST(Numbers, TellChanges) {
  EXPECT_EQ(percent_text(100, 169), "+69.0 %");
  EXPECT_EQ(percent_text(100'000, 99'996), "-0.004 %");
  EXPECT_EQ(percent_text(1e9, 1e9 + 1), "<0.001 %");
  EXPECT_EQ(percent_text(145, 223'370), "x 1,540");
  EXPECT_EQ(percent_text(5, 5), "0 %");
  EXPECT_EQ(percent_text(0, 5), "from 0");
}

TEST_F(Writers, TextOfTheSameSaysSo) {
  EXPECT_THAT(to_text(verdict_of(handmade_result()), false),
              AllOf(StartsWith("Budget ci/b.toml: firmware camera, scene aloe, 2 frames, against "
                               "ci/base.json\n"),
                    HasSubstr("No difference from the baseline: all "), Not(HasSubstr("Changed")),
                    EndsWith("\nVerdict: all 4 limits hold\n")));
}

TEST_F(Writers, TextShowsTheBrokenAndWhy) {
  const std::string text = to_text(verdict_of(broken()), false);
  EXPECT_THAT(text, HasSubstr("Changed: placement placement.toml -> placement.toml + 1 moved\n"));
  EXPECT_THAT(text, HasSubstr("function.core_b.match.exclusive_cycles  33,000"));
  EXPECT_THAT(text, HasSubstr("FAIL (baseline - 1 %)"));
  EXPECT_THAT(text, HasSubstr("    scores: l1.data.a -> l3, +12,000 stall cycles\n"));
  EXPECT_THAT(text, HasSubstr("    breaks level.l3.bytes, function.core_b.match.exclusive_cycles, "
                              "frames_per_second\n"));
  EXPECT_THAT(text, HasSubstr("1 limit holds (--all shows them).\n"));
  EXPECT_THAT(text, EndsWith("Verdict: 3 of 4 limits are broken\n"));
  EXPECT_THAT(text, Not(HasSubstr("census.exclusive")));
  EXPECT_THAT(to_text(verdict_of(broken()), true), HasSubstr("census.exclusive"));
}

TEST_F(Writers, TextTellsApartWhatLooksTheSame) {
  Limit limit{"x", parse_demand("<= 20", {}), {}};
  Check check;
  check.limit = &limit;
  check.value = 20.0000001;
  check.bound = 20;
  EXPECT_EQ(row_of(check).value, "20.0000001");
}

TEST_F(Writers, JunitHasACaseALimit) {
  const std::string xml = to_junit(verdict_of(broken()));
  EXPECT_THAT(xml, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites "));
  EXPECT_THAT(xml, HasSubstr("tests=\"4\" failures=\"3\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"budget\" name=\"level.l3.bytes &lt;= 10\">\n"
                             "      <failure type=\"budget\" message=\"level.l3.bytes is 4,000, "
                             "limit &lt;= 10; baseline 0, from 0\">core_b: more"));
  EXPECT_THAT(xml, HasSubstr("name=\"function.core_b.census.exclusive_cycles &lt;= baseline\"/>"));
}

TEST_F(Writers, MarkdownHasATableAndWhy) {
  const std::string text = to_markdown(verdict_of(broken()));
  EXPECT_THAT(text, HasSubstr("3 of 4 limits are broken\n"));
  EXPECT_THAT(text, HasSubstr("| `level.l3.bytes` | 4,000 | \\<= 10 | 0 | from 0 |\n"));
  EXPECT_THAT(text, HasSubstr("\n- core\\_b: more waiting"));
  EXPECT_THAT(text, HasSubstr("\n    - match.c:11 +12,000 cycles"));
  EXPECT_THAT(to_markdown(verdict_of(handmade_result())), Not(HasSubstr("Why")));
}

TEST_F(Writers, GithubPointsAtTheWorstLine) {
  EXPECT_THAT(to_github(verdict_of(broken())),
              StartsWith("::error file=firmware/match.c,line=11,title=level.l3.bytes is 4%2C000%2C "
                         "limit <= 10 (and 2 more)::core_b: more waiting"));
  EXPECT_EQ(to_github(verdict_of(handmade_result())), "");
}

TEST_F(Writers, GithubPointsAtTheLimitOtherwise) {
  report::RunResult now = handmade_result();
  now.traffic[1].read = 50;
  EXPECT_THAT(to_github(verdict_of(now)), StartsWith("::error file=ci/b.toml,line=6,title="));
}

TEST(Escapes, Xml) {
  EXPECT_EQ(xml_escaped("a<b>&\"'\n\x01"), "a&lt;b&gt;&amp;&quot;&apos;&#10;?");
}

TEST(Escapes, Github) {
  EXPECT_EQ(github_message("50 %: a,b\r\nc"), "50 %25: a,b%0D%0Ac");
  EXPECT_EQ(github_property("50 %: a,b\n"), "50 %25%3A a%2Cb%0A");
}

TEST(Escapes, Markdown) {
  EXPECT_EQ(markdown_cell("a|b_c*`<d>\\\ne"), "a\\|b\\_c\\*\\`\\<d\\>\\\\ e");
}

}  // namespace
}  // namespace finback::budget
