// What is wrong in a budgets file or beside it: one line, the right exit code, nothing written.
#include <algorithm>
#include <gmock/gmock.h>

#include "../cli/program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr const char* kRun = "[run]\nscene = \"synthetic\"\nframes = 1\n";

class CheckErrors : public ProgramTest {
 protected:
  std::string refused(const std::string& budgets, const std::vector<std::string>& more = {}) const {
    write("b.toml", budgets);
    std::vector<std::string> arguments = {"check", "b.toml", "--junit", "j.xml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::vector<std::string> before = files();
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(finished.err, StartsWith("finback: "));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_EQ(files(), before) << "something was left behind";
    return finished.err;
  }

  // base.json: of a bare program, which has no frames.
  void make_bare_baseline() const {
    write("main.bir", program_text(kReturnsZero));
    ASSERT_EQ(
        finback({"run", "--firmware", "main.bir", "--scene", "synthetic", "--out", "o"}).exit_code,
        0);
    write("base.json", read_text_file(folder() / "o" / "result.json"));
  }
};

TEST_F(CheckErrors, InTheFile) {
  const std::string run = kRun;
  EXPECT_THAT(refused("[limits\n"), HasSubstr("b.toml:1:"));
  EXPECT_THAT(refused(run + "[limits]\ncycles = \"< 5\"\n"),
              AllOf(HasSubstr("b.toml:5:10"), HasSubstr("write \"<= 20\"")));
  EXPECT_THAT(refused(run + "[limits]\ncycles = 5\n"), HasSubstr("b.toml:5:10"));
  EXPECT_THAT(refused(run + "[limits]\ncycels = \"<= 5\"\n"),
              AllOf(HasSubstr("b.toml:5:10"), HasSubstr("did you mean 'cycles'?")));
  EXPECT_THAT(refused(run + "[limits]\ncycles = [\">= 5\", \"<= 4\"]\n"),
              AllOf(HasSubstr("b.toml:5:"), HasSubstr("contradicts 'cycles >= 5' of line 5")));
  EXPECT_THAT(refused(run + "[limits]\ncycles = \"<= baseline\"\n"), HasSubstr("b.toml:5:10"));
  EXPECT_THAT(refused(run + "[limit]\ncycles = \"<= 5\"\n"),
              AllOf(HasSubstr("b.toml:4:"), HasSubstr("did you mean 'limits'?")));
  EXPECT_THAT(refused("[run]\nframe = 1\n[limits]\ncycles = \"<= 5\"\n"),
              AllOf(HasSubstr("b.toml:2:"), HasSubstr("did you mean 'frames'?")));
  EXPECT_THAT(refused(run), AllOf(HasSubstr("b.toml"), HasSubstr("[limits]")));
}

TEST_F(CheckErrors, OfTheBaseline) {
  const std::string budgets =
      std::string("baseline = \"base.json\"\n") + kRun + "[limits]\ncycles = \"<= baseline\"\n";
  EXPECT_THAT(refused(budgets), AllOf(HasSubstr("base.json"), HasSubstr("--update-baseline")));
  write("base.json", "{\"schema_version\": 1,");
  EXPECT_THAT(refused(budgets), HasSubstr("base.json"));
  write("base.json", "{\"schema_version\": 99}");
  EXPECT_THAT(refused(budgets), AllOf(HasSubstr("base.json"), HasSubstr("99")));
}

TEST_F(CheckErrors, OfAnotherFirmware) {
  make_bare_baseline();
  const std::string limits = "[limits]\ncycles = \"<= 1_000_000_000\"\n";
  EXPECT_THAT(refused("firmware = \"mesvs2\"\n" + limits, {"--result", "o/result.json"}),
              AllOf(HasSubstr("o/result.json is of the firmware main"),
                    HasSubstr("b.toml holds budgets of mesvs2")));
  EXPECT_THAT(refused("baseline = \"base.json\"\n" + (kRun + limits)),
              AllOf(HasSubstr("this run is of the firmware mesvs2"),
                    HasSubstr("the baseline base.json is of the firmware main")));
}

TEST_F(CheckErrors, OfAnotherSceneOrNumberOfFrames) {
  const std::string budgets =
      std::string("baseline = \"base.json\"\n") + kRun + "[limits]\ncycles = \"<= baseline\"\n";
  write("b.toml", budgets);
  ASSERT_EQ(finback({"check", "b.toml", "--update-baseline"}).exit_code, 0);
  EXPECT_THAT(refused(budgets, {"--frames", "2"}),
              HasSubstr("this run has 2 frames, but the baseline base.json has 1 frame"));
  EXPECT_THAT(refused(budgets, {"--scene", "aloe"}), HasSubstr("is of the scene aloe, but"));
}

TEST_F(CheckErrors, OfAResultThatIsNotThere) {
  const std::string budgets = "[limits]\ncycles = \"<= 5\"\n";
  EXPECT_THAT(refused(budgets, {"--result", "absent.json"}), HasSubstr("absent.json"));
  write("taken", "");
  write("main.bir", program_text(kReturnsZero));
  const Finished finished =
      finback({"check", "b.toml", "--firmware", "main.bir", "--markdown", "taken/m.md"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err, HasSubstr("taken/m.md"));
  EXPECT_THAT(finished.out, HasSubstr("Verdict: 1 of 1 limits is broken"));
}

TEST_F(CheckErrors, OfUpdating) {
  write("b.toml", "[limits]\ncycles = \"<= 5\"\n");
  const Finished without = finback({"check", "b.toml", "--update-baseline"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.err, HasSubstr("add baseline = "));

  // A limit on nothing is found before anything is written.
  write("main.bir", program_text(kReturnsZero));
  write("b.toml", "baseline = \"base.json\"\n[limits]\nnothing = \"<= baseline\"\n");
  EXPECT_EQ(finback({"check", "b.toml", "--firmware", "main.bir", "--update-baseline"}).exit_code,
            2);
  EXPECT_EQ(files(), (std::vector<std::string>{"b.toml", "main.bir"}));
}

TEST_F(CheckErrors, OfUsage) {
  write("b.toml", "[limits]\ncycles = \"<= 5\"\n");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"check"},
        {"check", "b.toml", "--result", "r.json", "--frames", "2"},
        {"check", "b.toml", "--update-baseline", "--github"},
        {"check", "b.toml", "--list", "--update-baseline"}}) {
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
}

TEST_F(CheckErrors, InterruptLeavesNothing) {
  write("main.bir", program_text(kNeverEnds));
  write("b.toml", "baseline = \"base.json\"\n[run]\nfirmware = \"main.bir\"\nmax_seconds = 1e5\n");
  constexpr int kWhileItRuns = 700;
  const Finished finished = finback({"check", "b.toml", "--update-baseline"}, kWhileItRuns);
  EXPECT_EQ(finished.exit_code, 130) << finished.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"b.toml", "main.bir"}));
}

}  // namespace
}  // namespace finback::cli
