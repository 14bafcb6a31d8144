// `finback check` on the shipped firmware: what passes, what breaks it, what it says then.
#include <gmock/gmock.h>

#include "../cli/program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kBudgets =
    "firmware = \"mesvs2\"\n"
    "baseline = \"base.json\"\n"
    "sources = \"firmware\"\n"
    "[run]\n"
    "scene = \"synthetic\"\n"
    "frames = 1\n"
    "[limits]\n"
    "frames_per_second = [\">= 20\", \">= baseline\"]\n"
    "power_watts = \"<= 2.3\"\n"
    "level.l3.bytes = \"<= baseline + 1 %\"\n"
    "[limits.function.\"core_?\"]\n"
    "\"*_row.exclusive_cycles\" = \"<= baseline + 0.1 %\"\n";  // a fetch here or there

class CheckCommand : public ProgramTest {
 protected:
  CheckCommand() {
    write("b.toml", kBudgets);
    EXPECT_EQ(check({"--update-baseline"}).exit_code, 0);
  }

  [[nodiscard]] Finished check(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"check", "b.toml"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return finback(all);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_text_file(folder() / name);
  }

  // A copy of the shipped firmware, in which `instructions` begin the loop over a row's pixels.
  void copy_firmware(const std::string& instructions) const {
    fs::copy(fs::path(FINBACK_BUILD_DIR) / "share/finback/firmware/mesvs2", folder() / "changed");
    const std::string unit = text("changed/census.bir");
    const std::string setup = "LSETUP (";
    const std::size_t label = unit.find(setup) + setup.size();
    const std::string top = "\n" + unit.substr(label, unit.find(',', label) - label) + ":\n";
    const std::size_t found = unit.find(top);
    ASSERT_NE(found, std::string::npos);
    const std::size_t begin = found + top.size();
    write("changed/census.bir", unit.substr(0, begin) + instructions + unit.substr(begin));
  }
};

TEST_F(CheckCommand, FindsNoDifferenceInTheSame) {
  const Finished same = check({});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.err, IsEmpty());
  EXPECT_THAT(same.out,
              AllOf(StartsWith("Budget b.toml: firmware mesvs2, scene synthetic, 1 frame"),
                    HasSubstr("No difference from the baseline: all "), Not(HasSubstr("FAIL")),
                    HasSubstr("limits hold\n")));
}

TEST_F(CheckCommand, NamesTheBufferThatMovedAndWhoWaitsForIt) {
  const Finished moved = check({"--place", "core_b.shd_scores=l3", "--junit", "out/j.xml",
                                "--markdown", "out/m.md", "--github"});
  EXPECT_EQ(moved.exit_code, 3) << moved.err;
  EXPECT_THAT(moved.out,
              HasSubstr("Changed: placement placement.toml -> placement.toml + 1 moved"));
  EXPECT_THAT(moved.out, ContainsRegex("function.core_b.shd_update_row.exclusive_cycles .* FAIL"));
  EXPECT_THAT(moved.out,
              ContainsRegex("core_b: more waiting for data in L3 .*, \\+[0-9,]+ cycles"));
  EXPECT_THAT(moved.out, ContainsRegex("shd_update_row \\+[0-9,]+ cycles .*: l3_read"));
  EXPECT_THAT(moved.out, ContainsRegex("shd_passes.bir:[0-9]+ \\+[0-9,]+ cycles: l3_read"));
  EXPECT_THAT(moved.out, ContainsRegex("shd_scores: l1.data.a -> l3, \\+[0-9,]+ stall cycles"));
  EXPECT_THAT(moved.out,
              ContainsRegex("::error file=firmware/.*shd_passes.bir,line=[0-9]+,title="));
  EXPECT_THAT(text("out/j.xml"), AllOf(HasSubstr("<failure"), HasSubstr("shd_scores: l1.data.a")));
  EXPECT_THAT(text("out/m.md"), AllOf(HasSubstr("**Why**"), HasSubstr("shd\\_scores: l1.data.a")));
}

TEST_F(CheckCommand, NamesTheLoopThatGotSlowerUntilThatIsTheBaseline) {
  copy_firmware("  NOP;\n  NOP;\n");
  const Finished slowed = check({"--firmware", "changed", "--github"});
  EXPECT_EQ(slowed.exit_code, 3) << slowed.err;
  EXPECT_THAT(slowed.out, ContainsRegex("function.core_a.census_row.exclusive_cycles .* FAIL"));
  EXPECT_THAT(slowed.out, ContainsRegex("core_a: more work \\(issue\\), \\+[0-9,]+ cycles"));
  EXPECT_THAT(slowed.out, ContainsRegex("census_row \\+[0-9,]+ cycles .*: issue \\+[0-9,]+\n"));
  EXPECT_THAT(slowed.out, ContainsRegex("::error file=firmware/mesvs2/census.c,line="));
  EXPECT_THAT(slowed.out, Not(HasSubstr("idle")));

  const Finished updated = check({"--firmware", "changed", "--update-baseline"});
  EXPECT_EQ(updated.exit_code, 0) << updated.err;
  EXPECT_THAT(updated.out, ContainsRegex("cycles +[0-9,]+ -> [0-9,]+ cycles \\(\\+"));
  EXPECT_EQ(check({"--firmware", "changed"}).exit_code, 0);
  const Finished faster = check({});
  EXPECT_EQ(faster.exit_code, 0) << "what got faster breaks no limit\n" << faster.out;
}

// The firmware where it was built, and a copy of it elsewhere.
TEST_F(CheckCommand, KnowsAFirmwareInAnotherFolder) {
  copy_firmware("");
  const Finished same = check({"--firmware", "changed"});
  EXPECT_THAT(same.out, HasSubstr("No difference from the baseline"));
}

TEST_F(CheckCommand, SaysWhenAnAbsoluteLimitStaysBroken) {
  write("b.toml",
        "baseline = \"base.json\"\n[run]\nscene = \"synthetic\"\nframes = 1\n"
        "[limits]\nframes_per_second = [\">= 5_000\", \">= baseline\"]\n");
  const Finished updated = check({"--update-baseline"});
  EXPECT_EQ(updated.exit_code, 0) << updated.err;
  EXPECT_THAT(updated.out, HasSubstr("no change\n"));
  EXPECT_THAT(updated.out, HasSubstr("Still broken: frames_per_second is "));
}

TEST_F(CheckCommand, SaysTheSameTwice) {
  const std::vector<std::string> arguments = {"--place", "core_b.shd_scores=l2", "--junit",
                                              "j.xml"};
  const Finished first = check(arguments);
  const std::string junit = text("j.xml");
  EXPECT_EQ(check(arguments).out, first.out);
  EXPECT_EQ(text("j.xml"), junit);
  EXPECT_THAT(first.out, Not(HasSubstr(folder().string())));
  EXPECT_THAT(text("base.json"), Not(HasSubstr(FINBACK_BUILD_DIR)));
}

TEST_F(CheckCommand, JudgesAnEarlierResult) {
  ASSERT_EQ(finback({"run", "--scene", "synthetic", "--frames", "1", "--out", "o"}).exit_code, 0);
  const Finished judged = check({"--result", "o/result.json"});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("No difference from the baseline"));
}

TEST_F(CheckCommand, ListsMetrics) {
  const Finished all = check({"--list"});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_THAT(all.out, AllOf(ContainsRegex("\nframes_per_second +[0-9.]+ fps\n"),
                             ContainsRegex("\nlevel.l3.bytes +[0-9,]+ bytes\n")));
  const Finished some = check({"--list", "core_?.stack.*"});
  EXPECT_THAT(some.out, AllOf(StartsWith("core_a.stack.size_bytes  4,096 bytes\n"),
                              Not(HasSubstr("frames"))));
  const Finished before = finback({"check", "--list", "b.toml"});
  EXPECT_EQ(before.out, all.out);
}

}  // namespace
}  // namespace finback::cli
