// Pairs that change, lenses, and what is at the pins, as a user asks for them.
#include <gmock/gmock.h>

#include "page_examples.hpp"
#include "program.hpp"
#include <common/file.hpp>
#include <scenes/luma.hpp>
#include <scenes/sequence.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;

class Cameras : public ProgramTest {
 protected:
  // A firmware that publishes each left view that it grabs.
  std::string views() {
    return write("views.bir",
                 program_text("  P0.L = 0xF000; P0.H = 0xFFC0;\n"
                              "  R0.L = _left; R0.H = _left; [P0 + 4] = R0; [P0 + 16] = R0;\n"
                              "  R0.L = _right; R0.H = _right; [P0 + 8] = R0;\n"
                              "  R0.L = 640; R0.H = 480; [P0 + 20] = R0;\n"
                              ".Lnext:\n  R0 = 1; [P0 + 12] = R0; R0 = [P0 + 36]; [P0 + 24] = R0;\n"
                              "  R0 = [P0]; CC = R0 == 0; IF !CC JUMP .Lnext;\n  R0 = 0;\n  RTS;\n",
                              ".data\n.align 4\n.type _left, @object\n_left: .space 307200\n"
                              ".size _left, 307200\n.type _right, @object\n_right: .space 307200\n"
                              ".size _right, 307200\n"));
  }
  std::string map(const std::string& out, int frame) {
    return read_text_file(folder() / out / ("disparity_000" + std::to_string(frame) + ".png"));
  }
  // Runs it and returns the message, "" when all went well.
  std::string run(const std::string& out, std::vector<std::string> options) {
    std::vector<std::string> arguments = {"run", "--firmware", views(), "--frames",
                                          "3",   "--out",      out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return finback(arguments).err;
  }
};

TEST_F(Cameras, PairsChangeOnlyWhereTheyAreAskedTo) {
  EXPECT_EQ(run("still", {"--scene", "synthetic"}), "");
  EXPECT_EQ(map("still", 0), map("still", 1));
  EXPECT_EQ(run("moving", {"--frames-from", "moving"}), "");
  EXPECT_EQ(map("moving", 0), map("still", 0));
  EXPECT_NE(map("moving", 1), map("moving", 0));
  EXPECT_NE(map("moving", 2), map("moving", 1));
}

TEST_F(Cameras, AFolderIsTakenInOrderAndBegunAnew) {
  std::filesystem::create_directory(folder() / "pairs");
  const auto moving = scenes::moving_sequence();
  for (const int i : {1, 2}) {
    const scenes::LumaPair& pair = moving->pair(static_cast<std::uint32_t>(i));
    scenes::write_png(pair.left, folder() / "pairs" / ("left_" + std::to_string(i) + ".png"));
    scenes::write_png(pair.right, folder() / "pairs" / ("right_" + std::to_string(i) + ".png"));
  }
  EXPECT_EQ(run("moving", {"--frames-from", "moving"}), "");
  EXPECT_EQ(run("folder", {"--frames-from", "pairs"}), "");
  EXPECT_EQ(map("folder", 0), map("moving", 1));
  EXPECT_EQ(map("folder", 1), map("moving", 2));
  EXPECT_EQ(map("folder", 2), map("folder", 0));
}

TEST_F(Cameras, LensesChangeWhatIsSeen) {
  EXPECT_EQ(run("plain", {"--scene", "synthetic"}), "");
  EXPECT_EQ(run("bent", {"--scene", "synthetic", "--distort=-0.1,0.01"}), "");
  EXPECT_EQ(run("turned", {"--scene", "synthetic", "--misalign", "1,2,3"}), "");
  EXPECT_NE(map("bent", 0), map("plain", 0));
  EXPECT_EQ(map("turned", 0), map("plain", 0)) << "it is the right camera's";
}

TEST_F(Cameras, WhatCannotBeReadIsSaid) {
  EXPECT_THAT(run("out", {"--frames-from", "nowhere"}),
              HasSubstr("nowhere: there is no such folder or video"));
  EXPECT_THAT(run("out", {"--frames-from", "moving", "--scene", "aloe"}), HasSubstr("excludes"));
  EXPECT_THAT(run("out", {"--distort=-0.5,0"}), HasSubstr("fold the picture"));
  EXPECT_THAT(run("out", {"--distort", "1"}), HasSubstr("--distort"));
  EXPECT_THAT(run("out", {"--drop-frame", "left"}),
              HasSubstr("--drop-frame left: wants the number of a frame"));
  EXPECT_THAT(run("out", {"--late-frame", "left:4"}),
              HasSubstr("--late-frame left:4: wants FRAME:MILLISECONDS"));
  EXPECT_THAT(run("out", {"--camera-rate", "-1"}), HasSubstr("--camera-rate"));
}

TEST_F(Cameras, FlagsAreDrivenAndLoggedInOneForm) {
  // PF1 follows PF0, by polling.
  const std::string program =
      "P0.L = 0x0700; P0.H = 0xFFC0; R0 = 2; W[P0 + 0x30] = R0; R0 = 1; W[P0 + 0x40] = R0;\n"
      "R7 = 0;\n"
      "again: R0 = W[P0] (Z); R1 = R0 << 1; R2 = 2; R1 = R1 & R2; W[P0] = R1;\n"
      "R7 += 1; R6 = 2000 (X); CC = R7 == R6; IF !CC JUMP again; HLT;\n";
  write("pins.txt", "# a pulse\n10.0 PF0 1\n\n30.5 PF0 0 # and its end\n");
  const Finished finished = finback({"exec", "--environment", "chip", write("follow.s", program),
                                     "--flags-input", "pins.txt", "--flags", "log.txt"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  std::istringstream log(read_text_file(folder() / "log.txt"));
  double rise = 0;
  double fall = 0;
  std::string pin;
  std::string other;
  int high = 0;
  int low = 1;
  log >> rise >> pin >> high >> fall >> other >> low;
  EXPECT_EQ(pin + other, "PF1PF1");
  EXPECT_EQ(high, 1);
  EXPECT_EQ(low, 0);
  EXPECT_GT(rise, 10.0);
  EXPECT_LT(rise, 10.5);
  EXPECT_GT(fall, 30.5);
  EXPECT_LT(fall, 31.0);

  write("late.txt", "10 PF0 1\n5 PF0 0\n");
  write("pin.txt", "10 PF48 1\n");
  write("what.txt", "\n10 PF0 high\n");
  for (const auto& [file, message] :
       {std::pair("late.txt", "late.txt:2: is earlier than the line before"),
        std::pair("pin.txt", "pin.txt:1: PF48 is no flag: they are PF0 to PF47"),
        std::pair("what.txt", "what.txt:2: wants TIME PIN LEVEL")}) {
    const Finished refused =
        finback({"exec", "--environment", "chip", "follow.s", "--flags-input", file});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(message));
  }
}

TEST_F(Cameras, TheUartsFileIsWrittenAlsoWhenTheProgramFaults) {
  const std::string program =
      "P0.L = 0x0400; P0.H = 0xFFC0; R0 = 3; W[P0 + 0xC] = R0; R0 = 1; W[P0 + 0x24] = R0;\n"
      "R0 = 88; W[P0] = R0;\n"
      "R7 = 2000 (X);\nwait: R7 += -1; CC = R7 == 0; IF !CC JUMP wait;\n"
      "P1 = 2; R0 = [P1];\n";
  const Finished finished =
      finback({"exec", "--environment", "chip", write("send.s", program), "--uart", "sent.txt"});
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_EQ(read_text_file(folder() / "sent.txt"), "X");
}

TEST_F(Cameras, ThePageOfTheDevicesRuns) { check_page_examples("devices.md", folder().string()); }

}  // namespace
}  // namespace finback::cli
