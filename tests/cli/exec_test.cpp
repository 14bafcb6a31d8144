// finback exec, as a user runs it.
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "page_examples.hpp"
#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Exec : public ProgramTest {};

// Ends with the status in R0.
constexpr const char* kExit =
    "exit:\n  P1.L = arguments; P1.H = arguments;\n  [P1] = R0;\n  R0 = P1;\n  P0 = 1 (X);\n"
    "  EXCPT 0;\n.data\n.align 4\narguments: .space 16\n";

TEST_F(Exec, ItsPagesExamplesRun) { check_page_examples("finback-exec.md", folder().string()); }

TEST_F(Exec, ThePageOfTheAssemblerRuns) { check_page_examples("assembler.md", folder().string()); }

TEST_F(Exec, TheProgramsStatusIsTheCommands) {
  const std::string file =
      write("seven.s", std::string("_start: R0 = 7 (X); JUMP exit;\n") + kExit);
  const Finished finished = finback({"exec", file});
  EXPECT_EQ(finished.exit_code, 7);
  EXPECT_EQ(finished.out + finished.err, "");
  EXPECT_EQ(finback({"exec", write("halt.s", "HLT;")}).exit_code, 0);
  EXPECT_EQ(finback({"exec", write("abort.s", "ABORT;")}).exit_code, 1);
}

TEST_F(Exec, SeveralFilesAreOneProgram) {
  write("first.s", ".text\n.global _start\n_start: CALL second; JUMP exit;\n.global exit\n" +
                       std::string(kExit));
  write("second.s", ".global second\nsecond: R0 = VALUE + 1 (X); RTS;\n");
  EXPECT_EQ(finback({"exec", "first.s", "second.s", "--defsym", "VALUE=0x20"}).exit_code, 33);
  const Finished alone = finback({"exec", "first.s"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("first.s:3:9: section first.text refers to second, which no "
                                   "unit of core_a and no shared one defines"));
}

TEST_F(Exec, BirAndAssemblerGoTogether) {
  write("main.bir", program_text("  [--SP] = RETS;\n  CALL _four;\n  RETS = [SP++];\n  RTS;\n"));
  write("four.s", ".global _four\n_four: R0 = 4; RTS;\n");
  const Finished finished = finback({"exec", "main.bir", "four.s"});
  EXPECT_EQ(finished.exit_code, 4) << finished.err;
}

TEST_F(Exec, FilesAreIncludedFromGivenFolders) {
  std::filesystem::create_directory(folder() / "inc");
  write("inc/common.inc", ".macro finish\nHLT;\n.endm\n");
  write("a.s", ".include \"common.inc\"\n finish\n");
  EXPECT_EQ(finback({"exec", "-I", "inc", "a.s"}).exit_code, 0);
  const Finished finished = finback({"exec", "a.s"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err,
              HasSubstr("a.s:1:11: common.inc is neither beside a.s nor in a folder given by -I"));
}

TEST_F(Exec, AnEndlessProgramIsEnded) {
  write("ever.s", "1: JUMP 1b;");
  const Finished finished = finback({"exec", "ever.s", "--max-cycles", "1000"});
  EXPECT_EQ(finished.exit_code, 124);
  EXPECT_EQ(finished.err, "finback: the program has not ended after 1000 cycles (--max-cycles)\n");
}

TEST_F(Exec, CtrlCEndsIt) {
  write("ever.s", "1: JUMP 1b;");
  EXPECT_EQ(finback({"exec", "ever.s"}, 300).exit_code, 130);
}

TEST_F(Exec, AProgramThatOnlySleepsIsAnError) {
  write("sleep.s", "1: IDLE; JUMP 1b;");
  const Finished finished = finback({"exec", "sleep.s"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err, HasSubstr("nothing is going to wake it"));
}

TEST_F(Exec, RegistersAreShownEvenAfterAFault) {
  write("fault.s", "R3 = 9; P0 = 1 (X); R0 = [P0];");
  const Finished finished = finback({"exec", "fault.s", "--dump-registers"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.out, HasSubstr("R3      00000009"));
  EXPECT_THAT(finished.err, HasSubstr("fault.s:1"));
}

TEST_F(Exec, JsonHoldsRegistersAndWhatWasCounted) {
  write("a.s", "_start: R5.L = 0x1234; R5.H = 0xABCD; HLT;");
  ASSERT_EQ(finback({"exec", "a.s", "--json", "a.json"}).exit_code, 0);
  const json a = json::parse(read_text_file(folder() / "a.json"));
  EXPECT_EQ(a["stopped"], "exited");
  EXPECT_EQ(a["registers"]["core_a"]["R5"], "0xabcd1234");
  EXPECT_FALSE(a["registers"].contains("core_b"));
  EXPECT_EQ(a["result"]["functions"][0]["name"], "start");
  EXPECT_EQ(a["result"]["cores"]["core_a"]["packets"], 3);
}

// A load takes one cycle in flat memory; in the chip's L2 it takes longer.
TEST_F(Exec, TheEnvironmentDecidesWhereThingsLie) {
  write("a.s", "_start: P0.L = x; P0.H = x; R0 = [P0]; HLT;\n.data\nx: .long 5\n");
  const auto registers = [&](const char* environment) {
    EXPECT_EQ(finback({"exec", "a.s", "--environment", environment, "--json", "a.json"}).exit_code,
              0);
    return json::parse(read_text_file(folder() / "a.json"))["registers"]["core_a"];
  };
  const json user = registers("user");
  EXPECT_EQ(user["R0"], "0x00000005");
  EXPECT_EQ(user["SP"], "0x04000000");
  const json chip = registers("chip");
  EXPECT_EQ(chip["R0"], "0x00000005");
  EXPECT_THAT(chip["P0"].get<std::string>(), StartsWith("0xff9"));
}

// A core reads a word of SDRAM before and behind memory DMA that changes it.
TEST_F(Exec, WarnsOfOldData) {
  write("stale.s", R"(__start:
        P0.L = 0; P0.H = 0x10; R1 = [P0];
        P4.L = 0x1F00; P4.H = 0xFFC0; P3.L = 0x1F40; P3.H = 0xFFC0;
        R0.L = 0; R0.H = 0xFEB0; [P3 + 4] = R0; [P4 + 4] = P0;
        R0 = 1 (X); W[P3 + 0x10] = R0; W[P4 + 0x10] = R0;
        R0 = 4 (X); W[P3 + 0x14] = R0; W[P4 + 0x14] = R0;
        R0 = 9 (X); W[P3 + 8] = R0; R0 = 11 (X); W[P4 + 8] = R0;
wait:   R0 = W[P4 + 0x28] (Z); CC = BITTST(R0, 0); IF !CC JUMP wait;
        R1 = [P0];
        HLT;
)");
  Finished finished =
      finback({"exec", "--environment", "chip", "--set", "memory.cache.data_banks=1", "--set",
               "memory.cache.l3_policy=1", "--warn-stale", "3", "stale.s"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.err, StartsWith("finback: old data: free memory of l3 at 0x00100000: core_a "
                                       "in wait (0xffa00042, stale.s:9) read an old copy"));
  finished = finback({"exec", "--environment", "chip", "--warn-stale", "3", "stale.s"});
  EXPECT_EQ(finished.err, "finback: nobody saw old data because of a cache\n");
}

TEST_F(Exec, MessagesOfTheAssemblerGoToStderr) {
  write("a.s", ".print \"hello\"\n.warning \"careful\"\nHLT;\n.byte 300\n");
  const Finished finished = finback({"exec", "a.s"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err,
            "hello\na.s:2:1: warning: careful\n"
            "a.s:4:7: warning: 0x12c does not fit into 1 byte: 0x2c is taken\n");
}

TEST_F(Exec, BadCommandLinesAreUsage) {
  EXPECT_EQ(finback({"exec"}).exit_code, 1);
  EXPECT_EQ(finback({"exec", "a.s", "--environment", "moon"}).exit_code, 1);
  EXPECT_EQ(finback({"exec", "nowhere.s"}).exit_code, 2);
  write("a.s", "HLT;");
  EXPECT_EQ(finback({"exec", "a.s", "--defsym", "A=x"}).exit_code, 2);
  EXPECT_EQ(finback({"exec", "a.s", "--core-b", "a.s"}).exit_code, 2);
  EXPECT_EQ(finback({"exec", "a.s", "--", "--not-an-option"}).exit_code, 0);
}

// Assembler files in a firmware: functions and objects keep their names in profile and annotation.
TEST_F(Exec, AFirmwareMayHaveAssemblerUnits) {
  std::filesystem::create_directory(folder() / "fw");
  write("fw/firmware.toml", "name = \"mixed\"\n[core_a]\nunits = [\"start.s\", \"work.bir\"]\n");
  write("fw/start.s",
        ".global _start\n_start: CALL _main;\n P0.L = 0xF020; P0.H = 0xFFC0; [P0] = R0;\n"
        "sleep: IDLE; JUMP sleep;\n.data\n_table: .long sleep\n");
  write("fw/work.bir", program_text(kReturnsZero));
  const Finished annotated =
      finback({"annotate", "start", "--firmware", "fw", "--scene", "synthetic", "--frames", "1",
               "--place", "core_a.start.data=l2", "--color", "never"});
  EXPECT_EQ(annotated.exit_code, 0) << annotated.err;
  EXPECT_THAT(annotated.out, HasSubstr("CALL _main;"));
}

}  // namespace
}  // namespace finback::cli
