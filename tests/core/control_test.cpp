// What events, modes, system and debug instructions do: small programs that check themselves with
// DBGA and end by HLT.
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <span>

#include "control_programs.hpp"
#include "core_harness.hpp"

namespace finback::core {
namespace {

using testing::HasSubstr;

// Addresses of core registers, and jumps to a failure, for all programs. A program begins with P0 =
// EVT0 and ends by HLT.
constexpr const char* kEpilogue =
    "HLT;\n"
    ".Lfail: ABORT;\n";

struct Program {
  const char* name;
  const char* body;
  const char* functions = "";  // further ones
};

std::string text_of(const Program& item) {
  return ".text\n.global _start\n.type _start, @function\n_start:\nP0.L = 0x2000; P0.H = "
         "0xFFE0;\n" +
         std::string(item.body) + "\n" + kEpilogue + ".size _start, .-_start\n" + item.functions;
}

std::ostream& operator<<(std::ostream& out, const Program& item) { return out << item.name; }

constexpr Program kDebug[] = {
    {"assertions_that_hold",
     "R1.L = 0x1234; R1.H = 0xFEDC; P1 = R1; M1 = R1; RETS = R1;"
     "DBGA (R1.L, 0x1234); DBGA (R1.H, 0xFEDC); DBGA (R1.H, -292); DBGA (P1.L, 0x1234);"
     "DBGA (M1.H, 0xFEDC); DBGAL (RETS, 0x1234); DBGAH (RETS, 0xFEDC);"},
    {"emulator_that_is_not_there", "EMUEXCPT; R1 = 1; DBGA (R1.L, 1);"},
};

constexpr Program kFlow[] = {
    {"jump_relative",
     "P1 = 8; R1 = 0; JUMP (PC + P1); R1 = 1; HLT; NOP; R2 = 2; DBGA (R1.L, 0);"
     "DBGA (R2.L, 2);"},
    {"call_relative",
     "R1 = 0; P1.L = _five; P1.H = _five; P2.L = .Lcall; P2.H = .Lcall; P1 -= P2;"
     ".Lcall: CALL (PC + P1); DBGA (R1.L, 5);",
     ".type _five, @function\n_five: R1 += 5; RTS;\n.size _five, .-_five\n"},
    {"extended_forms", "R1 = 0; JUMP.X .Lover; R1 = 1; .Lover: CALL.X _five; DBGA (R1.L, 5);",
     ".type _five, @function\n_five: R1 += 5; RTS;\n.size _five, .-_five\n"},
    {"cache_control",
     "P1 = 32; P2 = P1; P3 = P1; P4 = P1; PREFETCH [P1++]; FLUSH [P2++]; FLUSHINV [P3++];"
     "IFLUSH [P4++]; PREFETCH [P1]; FLUSH [P2]; FLUSHINV [P3]; IFLUSH [P4];"
     "DBGAL (P1, 64); DBGAL (P2, 64); DBGAL (P3, 64); DBGAL (P4, 64);"},
    {"testset_in_l1",
     "P1.L = _lock; P1.H = _lock; TESTSET (P1); R1 = CC; TESTSET (P1); R2 = CC;"
     "R3 = B[P1] (Z); DBGA (R1.L, 1); DBGA (R2.L, 0); DBGA (R3.L, 0x80);",
     ".data\n.align 4\n.type _lock, @object\n_lock: .space 4\n.size _lock, 4\n"},
};

class Control : public testing::TestWithParam<Program> {};

TEST_P(Control, ChecksItself) {
  CoreHarness harness(text_of(GetParam()));
  harness.run();
  EXPECT_EQ(harness.exit_status(), 0U) << harness.why();
}

std::string name_of_program(const testing::TestParamInfo<Program>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Flow, Control, testing::ValuesIn(kFlow), name_of_program);
INSTANTIATE_TEST_SUITE_P(Debug, Control, testing::ValuesIn(kDebug), name_of_program);

constexpr Program kPrinting = {
    "printing",
    "R1 = 5; R2.L = 0xFFFF; R2.H = 2; P1 = R1; A0.W = R1; A1.W = R1; R3 = -1; A1.X = R3;"
    "DBG R1; PRNT P1; DBG A0; DBG A1; DBGCMPLX (R2); R4 = 79; OUTC R4; OUTC 75; OUTC 10; DBGHALT;"};
constexpr Program kPrintAll = {"print_all", "DBG;"};

TEST(Debug, PrintsAsTheGnuSimulatorDoes) {
  CoreHarness harness(text_of(kPrinting));
  harness.run();
  EXPECT_EQ(
      harness.printed(),
      "DBG : R1 = 0x00000005\nDBG : P1 = 0x00000005\nDBG : A0 = 0x5\nDBG : A1 = 0xff00000005\n"
      "DBG : R2 = (2, -1)\nOK\n");
  EXPECT_EQ(harness.exit_status(), 0U);
}

TEST(Debug, PrintsAllRegisters) {
  CoreHarness harness(text_of(kPrintAll));
  harness.run();
  EXPECT_THAT(harness.printed(), HasSubstr("DBG : R0 = 0x00000000\n"));
  EXPECT_THAT(harness.printed(), HasSubstr("DBG : P0 = 0xffe02000\n"));
  EXPECT_THAT(harness.printed(), HasSubstr("DBG : ASTAT = "));
}

TEST(Debug, AbortEndsWithStatus1) {
  CoreHarness harness(text_of({"abort", "JUMP .Lfail;"}));
  harness.run();
  EXPECT_EQ(harness.exit_status(), 1U);
}

TEST(Debug, FailedAssertionNamesPlaceRegisterAndValues) {
  CoreHarness harness(text_of({"assertion", "R1.H = 0x1234;\nDBGA (R1.H, 0x4321);"}));
  harness.run();
  EXPECT_EQ(harness.exit_status(), 1U);
  EXPECT_THAT(harness.why(), HasSubstr("core_a in start (0xffa0000c, test.bir:8): R1.H is 0x1234, "
                                       "expected 0x4321"));
}

// The time and the packets of what ran before an early end are counted, and no more.
TEST(Debug, EarlyEndCountsWhatRan) {
  CoreHarness harness(program("R1 = 1;\nR2 = 2;\nDBGA (R1.L, 2);\nR3 = 3;\nR4 = 4;"));
  EXPECT_EQ(harness.run(), 3U);
  const CoreProfile profile = harness.core().profile();
  EXPECT_EQ(profile.packets, 3U);
  EXPECT_EQ(profile.causes[static_cast<std::size_t>(Cause::issue)], 3U);
}

}  // namespace

std::vector<std::string> control_programs() {
  std::vector<std::string> texts = {text_of(kPrinting), text_of(kPrintAll)};
  for (const std::span<const Program> group : {std::span<const Program>(kDebug), {kFlow}}) {
    for (const Program& item : group) {
      texts.push_back(text_of(item));
    }
  }
  return texts;
}

}  // namespace finback::core
