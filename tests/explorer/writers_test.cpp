// What tables, comma-separated values and plots say.
#include <gmock/gmock.h>

#include <common/csv.hpp>
#include <common/error.hpp>
#include <explorer/csv_writer.hpp>
#include <explorer/plot.hpp>
#include <explorer/table_writer.hpp>

namespace finback::explorer {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// A space of one placement with three regions, and what three points of it did.
class Writers : public ::testing::Test {
 protected:
  Writers() {
    space_.file = "deep/space.toml";
    space_.firmwares.resize(1);
    space_.firmware_names = {"mesvs2"};
    Axis axis;
    axis.kind = AxisKind::placement;
    axis.name = "core_b.table";
    axis.things = {{{ir::Owner::core_b, "table", "", {}}}};
    for (const char* region : {"l1.data.a", "l2", "l3"}) {
      Choice choice;
      choice.text = region;
      choice.region = region;
      axis.choices.push_back(choice);
    }
    space_.axes.push_back(axis);
    space_.goal = {{"frames_per_second", true, 20, {}}};
    candidates_.resize(3);
    for (std::uint32_t i = 0; i < 3; ++i) {
      candidates_[i].point = {i};
      Row row;
      row.number = i + 1;
      row.candidate = &candidates_[i];
      findings_.rows.push_back(row);
    }
    set(0, 30.125, 2);
    set(1, 20.5, 1.5);
    findings_.rows[2].state = State::misfit;
    findings_.rows[2].reason = "l3 overflows: \"table\", 9 bytes";
    findings_.front = {1, 0};
    findings_.best = 1;
  }

  void set(std::size_t row, double rate, double watts) {
    findings_.rows[row].on_front = true;
    findings_.rows[row].values = {{"frames_per_second", rate},
                                  {"power_watts", watts},
                                  {"energy_per_frame_joules", watts / rate},
                                  {"latency_seconds", 0.1}};
  }

  Space space_;
  std::vector<Candidate> candidates_;
  Findings findings_;
};

TEST_F(Writers, QuoteFieldsThatNeedIt) {
  EXPECT_EQ(csv_field("plain text"), "plain text");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST_F(Writers, KeepAllPointsInFullPrecision) {
  const std::string csv = to_csv(space_, findings_);
  EXPECT_THAT(csv, HasSubstr("point,state,front,core_b.table,frames_per_second,power_watts,"
                             "energy_per_frame_joules,latency_seconds,reason,command\n"));
  EXPECT_THAT(csv, HasSubstr("\n1,done,1,l1.data.a,30.125,2,0.06639004149377593,0.1,,finback run "
                             "--scene aloe --frames 4 --place core_b.table=l1.data.a\n"));
  EXPECT_THAT(csv, HasSubstr("\n3,does not fit,0,l3,,,,,\"l3 overflows: \"\"table\"\", 9 bytes\","
                             "finback run "));
}

TEST_F(Writers, ShowTheFrontFirstAndTheGoal) {
  const std::string table = to_table(space_, findings_, {});
  EXPECT_THAT(table, HasSubstr("  point     table        fps  watts  mJ/frame  latency ms\n"
                               "      2  *  l2         20.50  1.500     73.17      100.00\n"
                               "      1  *  l1.data.a  30.12  2.000     66.39      100.00\n"
                               "      3     l3         does not fit [1]\n"));
  EXPECT_THAT(table, HasSubstr("  [1] does not fit, 1 point: l3 overflows"));
  EXPECT_THAT(table,
              HasSubstr("Front (*): 2 of 2 points, from the thriftiest to the fastest: 2 1"));
  EXPECT_THAT(table, HasSubstr("Goal frames_per_second >= 20, with the least watts:\n  point 2:"));
  EXPECT_THAT(table, HasSubstr("--place core_b.table=l2\n"));
}

TEST_F(Writers, SortAndLimit) {
  TableOptions options;
  options.sort = "fps";
  options.descending = true;
  options.limit = 1;
  const std::string table = to_table(space_, findings_, options);
  EXPECT_THAT(table, AllOf(HasSubstr("\n      1  *  l1.data.a"), HasSubstr("... and 2 more"),
                           Not(HasSubstr("\n      2  *"))));
  options = {};
  options.sort = "core_b.table";
  EXPECT_LT(to_table(space_, findings_, options).find("      1  *"),
            to_table(space_, findings_, options).find("      2  *"));
}

TEST_F(Writers, TellThatNoPointMakesTheGoal) {
  space_.goal[0].limit = 40;
  findings_.best.reset();
  EXPECT_THAT(to_table(space_, findings_, {}),
              HasSubstr("Goal frames_per_second >= 40: no point makes it; the nearest is point 1 "
                        "with 30.125\n"));
}

TEST_F(Writers, NameTheColumnsOfWideTablesByLetters) {
  space_.columns = {{"a.metric.with.a.name.that.fills.half.of.a.usual.line.and.still.goes.on", {}}};
  EXPECT_THAT(to_table(space_, findings_, {}),
              AllOf(HasSubstr("Columns\n  a  core_b.table\n  b  a.metric.with"),
                    HasSubstr("  point     a            fps  watts  mJ/frame  latency ms  b\n")));
}

TEST_F(Writers, GroupWhatDoesNotFitByItsReason) {
  candidates_[0].misfit = "s.toml:3:4: l2 overflows: of 100 bytes 60 are taken";
  candidates_[2].misfit = "s.toml:3:4: l2 overflows: of 100 bytes 80 are taken";
  EXPECT_EQ(misfits_text(candidates_),
            "Does not fit, 2 points (1 3): s.toml:3:4: l2 overflows: of 100 bytes 60 are taken\n");
}

TEST_F(Writers, DrawTheFrontTheGoalAndTheBest) {
  const std::string script = plot_script(space_, findings_, "it's.svg");
  EXPECT_THAT(script, AllOf(HasSubstr("set output 'it''s.svg'"),
                            HasSubstr("$front << EOD\n20.5 1.5 \"2\"\n30.125 2 \"1\"\nEOD\n"),
                            HasSubstr("$best << EOD\n20.5 1.5"), HasSubstr("'goal: >= 20 fps'"),
                            HasSubstr("'space: 2 points'")));
}

TEST_F(Writers, RefusePlotsOfOtherKinds) {
  EXPECT_THROW(check_plot("points.jpg"), InputError);
  EXPECT_NO_THROW(check_plot("points.svg"));
}

TEST_F(Writers, KnowTheNearestMetric) {
  try {
    check_metrics({{"power_wats", {"space.toml", 3, 1}}}, {"frames_per_second", "power_watts"});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "space.toml:3:1: no point has a metric power_wats, did you mean power_watts?");
  }
}

}  // namespace
}  // namespace finback::explorer
