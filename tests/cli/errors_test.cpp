// What people get wrong: one clear line on stderr, the right exit code, and nothing left behind.
#include <algorithm>
#include <gmock/gmock.h>

#include "program.hpp"
#include <scenes/luma.hpp>

namespace finback::cli {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Errors : public ProgramTest {
 protected:
  // Runs `finback run ... --out results` and checks that it fails as bad input does: exit code 2,
  // stdout empty, a message that starts with "finback: ", and no file but those that were there.
  std::string refused(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "run");
    arguments.insert(arguments.end(), {"--out", "results/deep"});
    const std::vector<std::string> before = files();
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(finished.err, StartsWith("finback: "));
    EXPECT_EQ(files(), before) << "something was left behind";
    return finished.err;
  }

  // The same, where the message is a single line.
  std::string refused_in_a_line(const std::vector<std::string>& arguments) const {
    std::string message = refused(arguments);
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    return message;
  }

  void write_picture(const std::string& name, int width, int height) const {
    scenes::write_png(scenes::ByteImage(width, height, 100), folder() / name);
  }
};

TEST_F(Errors, MissingImage) {
  write_picture("right.png", 64, 48);
  EXPECT_THAT(refused_in_a_line({"--left", "absent.png", "--right", "right.png"}),
              HasSubstr("absent.png"));
}

TEST_F(Errors, TextAsImage) {
  write_picture("left.png", 64, 48);
  write("notes.txt", "no picture\n");
  EXPECT_THAT(refused_in_a_line({"--left", "left.png", "--right", "notes.txt"}),
              HasSubstr("notes.txt"));
}

TEST_F(Errors, EmptyFileAsImage) {
  write_picture("left.png", 64, 48);
  write("empty.png", "");
  EXPECT_THAT(refused_in_a_line({"--left", "left.png", "--right", "empty.png"}),
              AllOf(HasSubstr("empty.png"), HasSubstr("empty")));
}

TEST_F(Errors, PairOfDifferentSizes) {
  write_picture("left.png", 64, 48);
  write_picture("right.png", 60, 48);
  EXPECT_THAT(refused_in_a_line({"--left", "left.png", "--right", "right.png"}),
              AllOf(HasSubstr("64x48"), HasSubstr("60x48")));
}

TEST_F(Errors, UnknownScene) {
  EXPECT_THAT(refused_in_a_line({"--scene", "venice"}),
              AllOf(HasSubstr("venice"), HasSubstr("aloe"), HasSubstr("synthetic")));
}

TEST_F(Errors, UnknownFirmware) {
  EXPECT_THAT(refused_in_a_line({"--firmware", "mesvs3"}),
              AllOf(HasSubstr("'mesvs3'"), HasSubstr("mesvs2")));
}

TEST_F(Errors, PlacementThatNamesAnUnknownRegion) {
  write("main.bir", program_text(kReturnsZero));
  write("placement.toml", "[core_a]\ndefault = [\"l1.data.c\"]\n");
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir", "--placement", "placement.toml"}),
              AllOf(HasSubstr("placement.toml"), HasSubstr("l1.data.c")));
}

TEST_F(Errors, PlacementThatNamesAnUnknownObject) {
  write("main.bir", program_text(kReturnsZero));
  write("placement.toml", "[core_a.objects]\n\"absent_buffer\" = \"l2\"\n");
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir", "--placement", "placement.toml"}),
              AllOf(HasSubstr("placement.toml"), HasSubstr("absent_buffer")));
}

TEST_F(Errors, RegionThatOverflows) {
  write("main.bir", program_text(kReturnsZero,
                                 ".bss\n.type _huge_buffer, @object\n_huge_buffer:\n"
                                 "  .space 40000\n.size _huge_buffer, 40000\n"));
  write("placement.toml", "[core_a.objects]\n\"huge_buffer\" = \"l1.data.a\"\n");
  EXPECT_THAT(refused({"--firmware", "main.bir", "--placement", "placement.toml"}),
              AllOf(HasSubstr("l1.data.a"), HasSubstr("huge_buffer"), HasSubstr("40000")));
}

TEST_F(Errors, SyntaxErrorInBir) {
  write("main.bir", program_text("  R0 = = 1;\n  RTS;\n"));
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir"}),
              ContainsRegex("main\\.bir:6:[0-9]+: "));
}

TEST_F(Errors, UnknownKeyInAMachineFile) {
  write("machine.toml", "[memory.l2]\nread_cicles = 12\n");
  EXPECT_THAT(refused_in_a_line({"--machine", "machine.toml"}),
              AllOf(ContainsRegex("machine\\.toml:2:"), HasSubstr("read_cicles"),
                    HasSubstr("read_cycles")));
}

TEST_F(Errors, OutputFolderThatIsAFile) {
  write("main.bir", program_text(kReturnsZero));
  write("taken", "");
  const Finished finished = finback({"run", "--firmware", "main.bir", "--out", "taken"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err, AllOf(StartsWith("finback: "), HasSubstr("taken")));
  EXPECT_EQ(files(), (std::vector<std::string>{"main.bir", "taken"}));
}

TEST_F(Errors, OutputFolderThatCannotBeMade) {
  write("main.bir", program_text(kReturnsZero));
  write("taken", "");
  const Finished finished = finback({"run", "--firmware", "main.bir", "--out", "taken/below"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err, AllOf(StartsWith("finback: "), HasSubstr("taken/below")));
  EXPECT_EQ(files(), (std::vector<std::string>{"main.bir", "taken"}));
}

TEST_F(Errors, GuestThatFaults) {
  write("main.bir", program_text("  P0.L = 2;\n  P0.H = 0xFEB0;\n  R0 = [P0];\n  RTS;\n"));
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir"}),
              AllOf(HasSubstr("core_a"), HasSubstr("main"), HasSubstr("feb00002")));
}

TEST_F(Errors, GuestThatFails) {
  write("main.bir", program_text("  R0 = 3 (X);\n  RTS;\n"));
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir"}), HasSubstr("status 3"));
}

TEST_F(Errors, GuestThatNeverEnds) {
  write("main.bir", program_text(kNeverEnds));
  EXPECT_THAT(refused_in_a_line({"--firmware", "main.bir", "--max-seconds", "0.001"}),
              AllOf(HasSubstr("does not end"), HasSubstr("--max-seconds")));
}

TEST_F(Errors, OfUsage) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{},
        {"walk"},
        {"run", "--frames", "0"},
        {"run", "--frames", "many"},
        {"run", "--left", "left.png"},
        {"run", "--colour"},
        {"run", "--scene", "aloe", "--left", "a.png", "--right", "b.png"}}) {
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    EXPECT_THAT(finished.err, StartsWith("finback: "));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Errors, InterruptLeavesNothing) {
  write("main.bir", program_text(kNeverEnds));
  constexpr int kWhileItRuns = 700;
  const Finished finished =
      finback({"run", "--firmware", "main.bir", "--max-seconds", "100000", "--out", "results"},
              kWhileItRuns);
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err, "finback: interrupted; nothing was written\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"main.bir"}));
}

TEST_F(Errors, WrongMovesAndSettingsAreOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--place", "core_b.shd_score=l3"}, "did you mean shd_scores?"},
      {{"--place", "core_a.shd_scores=l3"}, "but core_b has"},
      {{"--place", "core_b.shd_scores=l9"}, "core_b has no region l9; did you mean l3?"},
      {{"--place", "shd_scores=l3"}, "names no owner"},
      {{"--place", "core_b.shd_scores"}, "wants OWNER.NAME=REGION"},
      {{"--set", "memory.l2.read_cycle=9"}, "did you mean memory.l2.read_cycles"},
      {{"--set", "memory.l2.read_cycles=fast"}, "'fast' is not a number"},
      {{"--set", "memory.l2.read_cycles=-1"}, "memory.l2.read_cycles"}};
  for (const auto& [options, message] : cases) {
    std::vector<std::string> arguments = {"run", "--frames", "1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 2) << options[1];
    EXPECT_THAT(finished.err, HasSubstr(message));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Errors, UnknownCommandNamesTheNearest) {
  const Finished near = finback({"runn", "--frames", "1"});
  EXPECT_EQ(near.exit_code, 1);
  EXPECT_THAT(near.err, HasSubstr("there is no command 'runn', did you mean 'run'?"));
  const Finished far = finback({"xyzzyplugh"});
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_THAT(far.err, HasSubstr("there is no command 'xyzzyplugh', but run, "));
}

TEST_F(Errors, UnknownOptionNamesTheNearest) {
  const Finished near = finback({"run", "--frame", "1"});
  EXPECT_EQ(near.exit_code, 1);
  EXPECT_THAT(near.err, HasSubstr("run has no option --frame, did you mean --frames?"));
  // ... also where the right one is required.
  const Finished required = finback({"stereo", "match", "--left", "a", "--rigth=b"});
  EXPECT_EQ(required.exit_code, 1);
  EXPECT_THAT(required.err, HasSubstr("stereo match has no option --rigth, did you mean --right?"));
  EXPECT_THAT(finback({"--xyzzyplugh"}).err, HasSubstr("finback has no option --xyzzyplugh ("));
}

TEST_F(Errors, MissedTargetWithCheckIsThree) {
  const std::vector<std::string> run = {"run",
                                        "--scene",
                                        "synthetic",
                                        "--frames",
                                        "2",
                                        "--place",
                                        "core_b.shd_scores=l3",
                                        "--place",
                                        "core_b.shd_*_best=l3",
                                        "--out",
                                        "results"};
  EXPECT_EQ(finback(run).exit_code, 0);
  std::vector<std::string> checked = run;
  checked.emplace_back("--check");
  EXPECT_EQ(finback(checked).exit_code, 3);
}

}  // namespace
}  // namespace finback::cli
