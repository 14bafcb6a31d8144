// What events, modes, system and debug instructions do: small programs that check themselves with
// DBGA and end by HLT.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
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
    // LSETUP's loops may not end so; loops written by hand may.
    {"jump_from_the_bottom_counts_the_pass",
     "R3.L = .Ltop; R3.H = .Ltop; LT0 = R3; R3.L = .Lend; R3.H = .Lend; LB0 = R3; R3 = 4; LC0 = R3;"
     "R1 = 0; .Ltop: R1 += 1; CC = R1 == 2; .Lend: IF CC JUMP .Lout; ABORT; .Lout: R2 = LC0;"
     "DBGA (R1.L, 2); DBGA (R2.L, 2);"},
    {"call_from_the_bottom_returns_to_the_top",
     "R3.L = .Ltop; R3.H = .Ltop; LT1 = R3; R3.L = .Lend; R3.H = .Lend; LB1 = R3; R3 = 3; LC1 = R3;"
     "R1 = 0; R2 = 0; .Ltop: R2 += 1; .Lend: CALL _five; DBGA (R1.L, 15); DBGA (R2.L, 3);"
     "R2 = LC1; DBGA (R2.L, 0);",
     ".type _five, @function\n_five: R1 += 5; RTS;\n.size _five, .-_five\n"},
    {"count_written_in_the_loop",
     "P1 = 9; R1 = 0; R2 = 2; LSETUP (.Ltop, .Lend) LC0 = P1; .Ltop: R1 += 1; CC = R1 == 3;"
     "IF !CC JUMP .Lend; LC0 = R2; .Lend: NOP; DBGA (R1.L, 4);"},
    {"two_loops_with_one_bottom",
     "P1 = 3; P2 = 2; R1 = 0; R2 = 0; LSETUP (.Louter, .Lend) LC0 = P2; .Louter: R2 += 1;"
     "LSETUP (.Linner, .Lend) LC1 = P1; .Linner: R1 += 1; .Lend: NOP; DBGA (R1.L, 6);"
     "DBGA (R2.L, 2);"},
    {"loop_top_has_an_even_address", "R1 = -1; LT0 = R1; R2 = LT0; DBGAL (R2, 0xFFFE);"},
    {"testset_in_l1",
     "P1.L = _lock; P1.H = _lock; TESTSET (P1); R1 = CC; TESTSET (P1); R2 = CC;"
     "R3 = B[P1] (Z); DBGA (R1.L, 1); DBGA (R2.L, 0); DBGA (R3.L, 0x80);",
     ".data\n.align 4\n.type _lock, @object\n_lock: .space 4\n.size _lock, 4\n"},
};

// The programs below begin in supervisor mode at IVG15, with all interrupts masked. P0 = EVT0.
constexpr const char* kHandlers =
    ".type _count, @function\n_count: R7 += 1; RTI;\n.size _count, .-_count\n"
    ".type _exception, @function\n_exception: R7 += 1; R6 = SEQSTAT; R5 = RETX; RTX;\n"
    ".size _exception, .-_exception\n"
    // goes on behind an instruction of four bytes, or of two
    ".type _skip4, @function\n_skip4: R7 += 1; R6 = SEQSTAT; R5 = RETX; R4 = R5; R4 += 4;\n"
    "RETX = R4; RTX;\n.size _skip4, .-_skip4\n"
    ".type _skip2, @function\n_skip2: R7 += 1; R6 = SEQSTAT; R5 = RETX; R4 = R5; R4 += 2;\n"
    "RETX = R4; RTX;\n.size _skip2, .-_skip2\n"
    ".type _skip8, @function\n_skip8: R7 += 1; R6 = SEQSTAT; R5 = RETX; R4 = R5; R4 += 8;\n"
    "RETX = R4; RTX;\n.size _skip8, .-_skip8\n"
    ".data\n.align 4\n.type _words, @object\n_words: .byte4 1, 2, 3, 4\n.size _words, 16\n";

constexpr Program kInterrupts[] = {
    {"wait_until_unmasked",
     "R1.L = _count; R1.H = _count; [P0 + 28] = R1; R7 = 0; RAISE 7; RAISE 8; R2 = R7; R3 = 0x80;"
     "STI R3; DBGA (R2.L, 0); DBGA (R7.L, 1); P1.L = 0x210C; P1.H = 0xFFE0; R4 = [P1];"
     "DBGA (R4.L, 0x100);",
     kHandlers},
    {"mask_reads_its_fixed_bits",
     "R1 = -1; STI R1; CLI R2; CLI R3; DBGAL (R2, 0xFFFF);"
     "DBGAH (R2, 0); DBGAL (R3, 0x1F);"},
    {"a_write_to_the_mask_lets_in_at_once",
     "R1.L = _count; R1.H = _count; [P0 + 28] = R1; R7 = 0; RAISE 7; P1.L = 0x2104; P1.H = 0xFFE0;"
     "R3 = 0x80; [P1] = R3; R2 = R7; R3 = 0; DBGA (R2.L, 1);",
     kHandlers},
    {"of_two_the_lower_number_comes_first",
     "R1.L = _first; R1.H = _first; [P0 + 28] = R1; R1.L = _second; R1.H = _second; [P0 + 32] = R1;"
     "R7 = 3; RAISE 8; RAISE 7; R3 = 0x180; STI R3; DBGA (R7.L, 7);",
     ".type _first, @function\n_first: R7 <<= 1; RTI;\n.size _first, .-_first\n"
     ".type _second, @function\n_second: R7 += 1; RTI;\n.size _second, .-_second\n"},
    {"none_interrupts_a_handler_that_keeps_reti",
     "R1.L = _keeps; R1.H = _keeps; [P0 + 32] = R1; R1.L = _count; R1.H = _count; [P0 + 28] = R1;"
     "R7 = 0; R3 = 0x180; STI R3; RAISE 8; DBGA (R6.L, 0); DBGA (R7.L, 1);",
     ".type _keeps, @function\n_keeps: RAISE 7; NOP; R6 = R7; RTI;\n.size _keeps, .-_keeps\n"
     ".type _count, @function\n_count: R7 += 1; RTI;\n.size _count, .-_count\n"},
    {"a_pushed_reti_lets_higher_ones_in",
     "R1.L = _nests; R1.H = _nests; [P0 + 32] = R1; R1.L = _count; R1.H = _count; [P0 + 28] = R1;"
     "R7 = 0; R5 = 0; R3 = 0x180; STI R3; RAISE 8; DBGA (R6.L, 1); DBGA (R7.L, 1); DBGA (R5.L, 1);"
     "P1.L = 0x2108; P1.H = 0xFFE0; R1 = [P1]; DBGAL (R1, 0x8000);",
     ".type _nests, @function\n_nests: RAISE 7; R5 += 1; [--SP] = RETI; R6 = R7; RETI = [SP++]; "
     "RTI;\n.size _nests, .-_nests\n"
     ".type _count, @function\n_count: R7 += 1; P1.L = 0x2108; P1.H = 0xFFE0; R1 = [P1];"
     "DBGAL (R1, 0x8190); RTI;\n.size _count, .-_count\n"},
    {"a_handler_interrupts_itself_only_if_allowed",
     "R1.L = _self; R1.H = _self; [P0 + 28] = R1; R3 = 0x80; STI R3; R7 = 0; RAISE 7;"
     "DBGA (R7.L, 2); DBGA (R6.L, 0); R1 = SYSCFG; BITSET (R1, 2); SYSCFG = R1; R7 = 0; RAISE 7;"
     "DBGA (R7.L, 2); DBGA (R6.L, 1);",
     // R6: whether the second began before the first had ended
     ".type _self, @function\n_self: R7 += 1; R5 = RETI; R4 = 1; R5 = R5 & R4; R6 = 0; CC = R7 == "
     "1; IF !CC JUMP .Lend; [--SP] = RETI; RAISE 7; RETI = [SP++]; .Lend: R6 = R6 | R5; RTI;\n"
     ".size _self, .-_self\n"},
    {"non_maskable_is_taken_under_any_mask",
     "R1.L = _nmi; R1.H = _nmi; [P0 + 8] = R1; CLI R1; R7 = 0; RAISE 2; DBGA (R7.L, 1);",
     ".type _nmi, @function\n_nmi: R7 += 1; RTN;\n.size _nmi, .-_nmi\n"},
    {"hardware_error_is_raised_with_its_cause",
     "R1.L = _count; R1.H = _count; [P0 + 20] = R1; R3 = 0x20; STI R3; R7 = 0; RAISE 5;"
     "R1 = SEQSTAT; R1 >>= 14; DBGA (R7.L, 1); DBGA (R1.L, 0x18);",
     kHandlers},
    {"a_loop_goes_on_after_an_interrupt",
     "R1.L = _count; R1.H = _count; [P0 + 28] = R1; R3 = 0x80; STI R3; R7 = 0; R5 = 0; P1 = 5;"
     "LSETUP (.Ltop, .Lend) LC1 = P1; .Ltop: R5 += 1; RAISE 7; .Lend: R6 = R7; DBGA (R5.L, 5);"
     "DBGA (R7.L, 5); DBGA (R6.L, 5);",
     kHandlers},
    {"reset_ends_the_program", "RAISE 1; ABORT;"},
};

constexpr Program kExceptions[] = {
    {"service_returns_behind_it",
     "R1.L = _exception; R1.H = _exception; [P0 + 12] = R1; R7 = 0; EXCPT 5; DBGA (R7.L, 1);"
     "DBGA (R6.L, 5);",
     kHandlers},
    {"service_at_the_bottom_of_a_loop",
     "R1.L = _exception; R1.H = _exception; [P0 + 12] = R1; R7 = 0; P1 = 3; R3 = 0;"
     "LSETUP (.Ltop, .Lend) LC0 = P1; .Ltop: R3 += 1; .Lend: EXCPT 5; DBGA (R7.L, 3);"
     "DBGA (R3.L, 3);",
     kHandlers},
    {"misaligned_load_names_itself",
     "R1.L = _skip2; R1.H = _skip2; [P0 + 12] = R1; R7 = 0; P1 = 1; R3 = 9; R2.L = .Lhere; R2.H = "
     ".Lhere; .Lhere: R3 = [P1]; R2 = R2 - R5; DBGA (R7.L, 1); DBGA (R6.L, 0x24); DBGA (R2.L, 0);"
     "DBGA (R3.L, 9); P1.L = 0x000C; P1.H = 0xFFE0; R1 = [P1]; DBGA (R1.L, 1);",
     kHandlers},
    {"a_packet_is_undone",
     "R1.L = _skip8; R1.H = _skip8; [P0 + 12] = R1; P1.L = _words; P1.H = _words; I0 = P1; I1 = P1;"
     "R7 = 0; R1 = 1; R2 = 1; R3 = 7; I1 += 2; MNOP || R1 = [I0++] || R3 = [I1];"
     "DBGA (R7.L, 1); DBGA (R3.L, 7); R2 = P1; R4 = I0; CC = R2 == R4; R4 = CC; DBGA (R4.L, 1);"
     "I1 = P1; MNOP || R1 = [I0++] || R3 = [I1]; DBGA (R7.L, 1); DBGA (R3.L, 1);",
     kHandlers},
    {"a_list_is_undone",
     "R1.L = _skip2; R1.H = _skip2; [P0 + 12] = R1; R7 = 0; P5 = 7; P4 = 5; SP += 2; R2 = SP;"
     "(P5:4) = [SP++]; R3 = SP; CC = R2 == R3; R3 = CC; DBGA (R3.L, 1); DBGAL (P5, 7);"
     "DBGAL (P4, 5); DBGA (R7.L, 1); SP += -2;",
     kHandlers},
    {"misaligned_target_is_the_jumps_fault",
     "R1.L = _skip2; R1.H = _skip2; [P0 + 12] = R1; R7 = 0; R2.L = .Lhere; R2.H = .Lhere; P1 = 1;"
     "R1 = 3; RETS = R1; .Lhere: CALL (P1); R1 = RETS; R2 = R2 - R5; DBGA (R6.L, 0x2A);"
     "DBGA (R2.L, 0); DBGA (R1.L, 3); DBGA (R7.L, 1);",
     kHandlers},
    {"no_instruction_at_the_target",
     "R1.L = _away; R1.H = _away; [P0 + 12] = R1; P1.L = 0x3F00; P1.H = 0xFFA0; R2 = P1; JUMP "
     "(P1);",
     ".type _away, @function\n_away: R6 = SEQSTAT; R5 = RETX; DBGA (R6.L, 0x21);"
     "DBGA (R5.L, 0x3F00); HLT; RTX;\n.size _away, .-_away\n"},
    {"a_handler_that_is_no_code",
     "R1.L = _away; R1.H = _away; [P0 + 12] = R1; R1 = 0x80; [P0 + 28] = R1; STI R1; RAISE 7; "
     "ABORT;",
     ".type _away, @function\n_away: R6 = SEQSTAT; R5 = RETX; DBGA (R6.L, 0x21);"
     "DBGA (R5.L, 0x80); HLT; RTX;\n.size _away, .-_away\n"},
    {"no_fetch_from_data_memory",
     "R1.L = _away; R1.H = _away; [P0 + 12] = R1; P1.L = _words; P1.H = _words; JUMP (P1);",
     ".type _away, @function\n_away: R6 = SEQSTAT; DBGA (R6.L, 0x2B); HLT; RTX;\n"
     ".size _away, .-_away\n"
     ".data\n.align 4\n.type _words, @object\n_words: .byte4 1, 2, 3, 4\n.size _words, 16\n"},
    {"no_such_register",
     "R1.L = _skip2; R1.H = _skip2; [P0 + 12] = R1; R7 = 0; P1.L = 0; P1.H = 0xFFEE; R3 = [P1];"
     "DBGA (R7.L, 1); DBGA (R6.L, 0x2E);",
     kHandlers},
    {"single_steps",
     "R1.L = _step; R1.H = _step; [P0 + 12] = R1; R7 = 0; R1 = SYSCFG; BITSET (R1, 0); SYSCFG = R1;"
     "R2 = 1; R3 = 2; BITCLR (R1, 0); SYSCFG = R1; R4 = R7; R5 = 1; DBGA (R4.L, 4);"
     "DBGA (R7.L, 4); DBGA (R6.L, 0x10);",
     ".type _step, @function\n_step: R7 += 1; R6 = SEQSTAT; RTX;\n.size _step, .-_step\n"},
    {"no_memory_is_a_hardware_error",
     "R1.L = _count; R1.H = _count; [P0 + 20] = R1; R3 = 0x20; STI R3; R7 = 0; P1.L = 0; P1.H = "
     "0x1000; R2 = [P1]; R1 = SEQSTAT; R1 >>= 14; DBGA (R7.L, 1); DBGA (R1.L, 3);",
     kHandlers},
};

// To user mode by RTI; R7 counts exceptions, which go on two bytes further.
constexpr const char* kToUser =
    "R1.L = _skip2; R1.H = _skip2; [P0 + 12] = R1; R1.L = .Luser; R1.H = .Luser; RETI = R1;"
    "R7 = 0; RTI; .Luser: ";
std::string user_text(const Program& item) {
  Program whole = item;
  const std::string body = std::string(kToUser) + item.body;
  whole.body = body.c_str();
  whole.functions = kHandlers;
  return text_of(whole);
}

constexpr Program kUserMode[] = {
    {"supervisors_instructions",
     "RAISE 7; CLI R1; STI R1; RTI; RTX; RTN; RTE; IDLE; DBGA (R7.L, 8); DBGA (R6.L, 0x2E);"},
    {"supervisors_registers",
     "SP += -8; R1 = SEQSTAT; R1 = SYSCFG; R1 = USP; RETI = R1; RETX = R1; RETN = R1; RETE = R1;"
     "[--SP] = RETI; R2 = SP; RETX = [SP++]; R3 = SP; CC = R2 == R3; R3 = CC; DBGA (R3.L, 1);"
     "DBGA (R7.L, 9); DBGA (R6.L, 0x2E); USP = [SP++]; DBGA (R6.L, 0x22);"},
    {"registers_of_the_core", "R1 = [P0]; DBGA (R7.L, 1); DBGA (R6.L, 0x23);"},
    {"its_own_stack_pointer",
     "R1 = SP; R1 += -64; SP = R1; R2 = [P0]; DBGA (R7.L, 1); R2 = SP; CC = R1 == R2; R3 = CC;"
     "DBGA (R3.L, 1);"},
};

class Control : public testing::TestWithParam<Program> {};

TEST_P(Control, ChecksItself) {
  CoreHarness harness(text_of(GetParam()));
  harness.run();
  EXPECT_EQ(harness.exit_status(), 0U) << harness.why();
}

std::string name_of_program(const testing::TestParamInfo<Program>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Flow, Control, testing::ValuesIn(kFlow), name_of_program);
INSTANTIATE_TEST_SUITE_P(Interrupts, Control, testing::ValuesIn(kInterrupts), name_of_program);
INSTANTIATE_TEST_SUITE_P(Exceptions, Control, testing::ValuesIn(kExceptions), name_of_program);
INSTANTIATE_TEST_SUITE_P(Debug, Control, testing::ValuesIn(kDebug), name_of_program);

class UserMode : public testing::TestWithParam<Program> {};

TEST_P(UserMode, ChecksItself) {
  CoreHarness harness(user_text(GetParam()));
  harness.run();
  EXPECT_EQ(harness.exit_status(), 0U) << harness.why();
}

INSTANTIATE_TEST_SUITE_P(Modes, UserMode, testing::ValuesIn(kUserMode), name_of_program);

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

// A block that was long when it began is counted as far as it ran, though blocks are short now.
TEST(Debug, BlocksCutByAChangeOfStyleAreCounted) {
  CoreHarness harness(
      text_of({"style",
               "R1.L = _step; R1.H = _step; [P0 + 12] = R1; R2 = SYSCFG; BITSET (R2, 0); NOP; NOP;"
               "NOP; SYSCFG = R2; NOP;",
               ".type _step, @function\n_step: R1 = SYSCFG; BITCLR (R1, 0); SYSCFG = R1; RTX;\n"
               ".size _step, .-_step\n"}));
  const Cycles cycles = harness.run();
  // 2 of the start, 9 before the step, NOP, 4 of the handler, HLT
  EXPECT_EQ(harness.core().profile().packets, 17U);
  Cycles sum = 0;
  for (const Cycles cause : harness.core().profile().causes) {
    sum += cause;
  }
  EXPECT_EQ(sum, cycles);
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
  for (const auto group :
       {std::span<const Program>(kDebug), std::span<const Program>(kFlow),
        std::span<const Program>(kInterrupts), std::span<const Program>(kExceptions)}) {
    std::ranges::transform(group, std::back_inserter(texts), text_of);
  }
  std::ranges::transform(kUserMode, std::back_inserter(texts), user_text);
  return texts;
}

}  // namespace finback::core
