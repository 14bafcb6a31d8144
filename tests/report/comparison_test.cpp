// Runs side by side: the numbers of two results made by hand, in all forms.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "small_result.hpp"
#include <report/climb_plot.hpp>
#include <report/comparison.hpp>

namespace finback::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Three frames; the second run takes half of the time, and DMA moves its bytes.
std::vector<NamedResult> two_runs() {
  std::vector<NamedResult> runs{{"slow", small_result()}, {"./a,b", small_result()}};
  RunResult& fast = runs[1].result;
  fast.cycles /= 2;
  fast.traffic = {{"l3", "core_a", 0, 600}, {"l3", "mdma1_0", 3'000'000, 0}, {"l3", "host", 7, 7}};
  return runs;
}

const ComparisonRow& row(const std::vector<ComparisonRow>& rows, const std::string& name) {
  const auto found = std::ranges::find(rows, name, &ComparisonRow::name);
  if (found == rows.end()) {
    throw std::runtime_error("no row " + name);
  }
  return *found;
}

TEST(Comparison, CountsByFrame) {
  const std::vector<ComparisonRow> rows = comparison_rows(two_runs());
  EXPECT_THAT(row(rows, "cycles").values, testing::ElementsAre(100e6 / 3, 50e6 / 3));
  EXPECT_THAT(row(rows, "times faster").values, testing::ElementsAre(1, 2));
  EXPECT_THAT(row(rows, "l3_read").values, testing::ElementsAre(20.0 / 3, 20.0 / 3));
  EXPECT_THAT(row(rows, "l3 by cores").values, testing::ElementsAre(1000200, 200));
  EXPECT_THAT(row(rows, "l3 by DMA").values, testing::ElementsAre(0, 1e6));  // not the host's
  EXPECT_THAT(row(rows, "code").values, testing::ElementsAre(90, 90));
  EXPECT_THAT(row(rows, "data in l3").values, testing::ElementsAre(1200, 1200));
  const auto l1 = std::ranges::find(rows, "data in l1", &ComparisonRow::name);
  EXPECT_EQ(l1, rows.end()) << "nothing in L1: no row";
  const auto& energy = row(rows, "energy").values;
  EXPECT_DOUBLE_EQ(energy[0], 2 * energy[1]);
}

TEST(Comparison, SaysTheSameAsTextJsonAndCsv) {
  EXPECT_THAT(comparison_text(two_runs()),
              HasSubstr("A frame                           slow         ./a,b\n"
                        "  cycles                      33333333      16666667\n"
                        "  times faster                    1.00          2.00\n"));
  EXPECT_THAT(comparison_text(two_runs()),
              HasSubstr("  l3 by DMA                          -       1000000\n"));
  const auto json = nlohmann::json::parse(comparison_json(two_runs()));
  EXPECT_EQ(json.at("runs")[1].at("name"), "./a,b");
  EXPECT_EQ(json.at("runs")[1].at("bytes_moved").at("l3_by_dma").dump(), "1000000");
  const std::string csv = comparison_csv(two_runs());
  EXPECT_THAT(csv, testing::StartsWith("section,name,unit,slow,\"./a,b\"\n"));
  EXPECT_THAT(csv, HasSubstr("\nbytes_moved,l3_by_dma,B,0,1000000\n"));
}

TEST(Comparison, ClimbSaysWhatEachBoughtAndWaited) {
  const std::string text = climb_text(two_runs());
  // 20 of 70 cycles awake are no issue.
  EXPECT_THAT(
      text,
      HasSubstr(
          "  1 slow        33333333                               24.00   28.6 %      1000200"));
  EXPECT_THAT(text, HasSubstr("  2 ./a,b       16666667        2.00 x        2.0 x"));
}

TEST(Comparison, PlotHasABarARun) {
  const std::string script = climb_plot(two_runs(), "ladder.svg");
  EXPECT_THAT(script, HasSubstr("set ytics ('slow' 0, './a,b' 1)"));
  EXPECT_THAT(script, HasSubstr("0 33333333 \"33.3 M\"\n1 16666667 \"16.7 M\"\n"));
  EXPECT_THAT(script, HasSubstr("set xrange [10000000:"));
  EXPECT_THAT(script, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace finback::report
