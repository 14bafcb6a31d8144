// Syntax patterns: reading, printing, choosing among entries, and saying why nothing reads a text.
// With a table of its own, so that these tests hold whatever the real one has.
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include <common/error.hpp>
#include <isa_sim/isa/registers.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Instruction entry(std::string_view syntax, int length = 2, Slot slot = Slot::alone) {
  return {.syntax = syntax, .length = length, .slot = slot};
}

constexpr std::array kTable = {
    /* 0 */ entry("{D!} = {imm7} (X)"),
    /* 1 */ entry("{D!} = {imm16} {?(X)}", 4),
    /* 2 */ entry("{D!} = [{P@+}++]", 2, Slot::access),
    /* 3 */ entry("{D!} = [{P@} + {off4x4}]", 2, Slot::access),
    /* 4 */ entry("{D!} = [FP + {off5n4}]", 2, Slot::access),
    /* 5 */ entry("{D!} = [{P@} + {off16x4}]", 4),
    /* 6 */ entry("{Dx!} = ONES {D}", 4, Slot::dsp),
    /* 7 */ entry("{D!} = {D} +|+ {D}", 4, Slot::dsp),
    /* 8 */ entry("{D+} = ({=0} + {D}) << 1"),
    /* 9 */ entry("[--SP] = ({Dlist}, {Plist})"),
    /* 10 */ entry("LSETUP ({ltop}, {lbottom}) LC0 = {P@}", 4),
    /* 11 */ entry("{Pl!} = {any16}", 4),
    /* 12 */ entry("{Ph!} = {any16}", 4),
    /* 13 */ entry("{D+} += {imm7}"),
    /* 14 */ entry("IF CC JUMP {pc10} (BP)"),
    /* 15 */ entry("SAA ({DD}, {DD})", 4, Slot::dsp),
    /* 16 */ entry("A0 = 0", 4, Slot::dsp),
    /* 17 */ entry("{G!} = {G}"),
    /* 18 */ entry("{D!} = {Db} (X)"),
    /* 19 */ entry("I0 += {M}"),
};

const Syntax& syntax() {
  static const Syntax the_syntax(kTable);
  return the_syntax;
}

std::string reads_as(std::string_view text) {
  const ParsedInstruction parsed = syntax().parse(text);
  return std::to_string(parsed.instruction) + ": " + syntax().print(parsed);
}

std::string error_of(std::string_view text) {
  try {
    return "reads as " + reads_as(text);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Syntax, ReadsAnySpacingAndCase) {
  EXPECT_EQ(reads_as("R1 = [P0++]"), "2: R1 = [P0++]");
  EXPECT_EQ(reads_as("r1=[p0++]"), "2: R1 = [P0++]");
  EXPECT_EQ(reads_as(" R1\t= [ P0 ++ ] "), "2: R1 = [P0++]");
  EXPECT_EQ(reads_as("r2.h = ones r3"), "6: R2.H = ONES R3");
  EXPECT_EQ(reads_as("[--sp]=(r7:4,p5:3)"), "9: [--SP] = (R7:4, P5:3)");
  EXPECT_EQ(reads_as("saa(r1:0,r3:2)"), "15: SAA (R1:0, R3:2)");
  EXPECT_EQ(reads_as("R0 = sp"), "17: R0 = SP");
  EXPECT_EQ(reads_as("a1.x = r7"), "17: A1.X = R7");
  EXPECT_EQ(reads_as("R3 = R5.B (X)"), "18: R3 = R5.B (X)");
}

TEST(Syntax, TakesTheFirstEntryWhoseImmediateFits) {
  EXPECT_EQ(reads_as("R0 = 63 (X)"), "0: R0 = 63 (X)");
  EXPECT_EQ(reads_as("R0 = 64 (X)"), "1: R0 = 64 (X)");
  EXPECT_EQ(reads_as("R0 = -64 (X)"), "0: R0 = -64 (X)");
  EXPECT_EQ(reads_as("R0 = -0x41 (X)"), "1: R0 = -65 (X)");
  EXPECT_EQ(reads_as("R0 = [P1 + 60]"), "3: R0 = [P1 + 60]");
  EXPECT_EQ(reads_as("R0 = [P1 + 64]"), "5: R0 = [P1 + 64]");
}

TEST(Syntax, TextMayBeLeftOut) {
  EXPECT_EQ(reads_as("R0 = 5"), "1: R0 = 5 (X)");
  EXPECT_EQ(reads_as("R0 = 500 (X)"), "1: R0 = 500 (X)");
}

TEST(Syntax, ReadsMinusOffsets) {
  EXPECT_EQ(reads_as("R0 = [FP - 8]"), "4: R0 = [FP + -8]");
  EXPECT_EQ(reads_as("R0 = [FP + -8]"), "4: R0 = [FP + -8]");
  EXPECT_EQ(reads_as("R0=[FP+-8]"), "4: R0 = [FP + -8]");
  EXPECT_EQ(reads_as("R0 = [P1 - 8]"), "5: R0 = [P1 + -8]");
  EXPECT_EQ(reads_as("R0 = [FP - -8]"), "3: R0 = [FP + 8]");
}

TEST(Syntax, ReadsSymbolsWithOffsets) {
  EXPECT_EQ(reads_as("P0.L = _x"), "11: P0.L = _x");
  EXPECT_EQ(reads_as("P0.H=_x+4"), "12: P0.H = _x + 4");
  EXPECT_EQ(reads_as("I3.H = .L_x - 12"), "12: I3.H = .L_x - 12");
  EXPECT_EQ(reads_as("IF CC JUMP .L1 (bp)"), "14: IF CC JUMP .L1 (BP)");
  EXPECT_EQ(reads_as("LSETUP(.La,.Lb)LC0=P1"), "10: LSETUP (.La, .Lb) LC0 = P1");
  const ParsedInstruction parsed = syntax().parse("P1.H = _Table + 8");
  EXPECT_EQ(parsed.operand[0].number, P1 | kHighHalf);
  EXPECT_EQ(parsed.operand[1], (OperandValue{8, "_Table"}));
}

TEST(Syntax, ValuesOfRegisterOperands) {
  EXPECT_EQ(syntax().parse("R2.H = ONES R3").operand[0].number, R2 | kHighHalf);
  EXPECT_EQ(syntax().parse("R2.L = ONES R3").operand[0].number, R2);
  EXPECT_EQ(syntax().parse("SAA (R3:2, R1:0)").operand[0].number, 2);
  EXPECT_EQ(syntax().parse("[--SP] = (R7:6, P5:2)").operand[0].number, 6);
  EXPECT_EQ(syntax().parse("[--SP] = (R7:6, P5:2)").operand[1].number, 2);
}

TEST(Syntax, RepeatedOperandsMustBeTheSame) {
  EXPECT_EQ(reads_as("R3 = (R3 + R1) << 1"), "8: R3 = (R3 + R1) << 1");
  EXPECT_EQ(error_of("R3 = (R2 + R1) << 1"), "1:7: R2 cannot stand here: R3 once more is wanted");
}

TEST(Syntax, SaysWhyAnOperandDoesNotFit) {
  EXPECT_EQ(error_of("R0 += 99"), "1:7: immediate 99 does not fit: -64..63");
  EXPECT_EQ(error_of("R0 += -65"), "1:7: immediate -65 does not fit: -64..63");
  EXPECT_EQ(error_of("R0 = 32768 (X)"), "1:6: immediate 32768 does not fit: -32768..32767");
  EXPECT_EQ(error_of("R0 = [P0 + 3]"),
            "1:12: immediate 3 does not fit: -131072..131068, multiples of 4");
  EXPECT_EQ(error_of("P0 += 1"), "1:1: P0 cannot stand here: a data register R0..R7 is wanted");
  EXPECT_EQ(error_of("R0 += R1"), "1:7: R1 cannot stand here: a number -64..63 is wanted");
  EXPECT_EQ(error_of("R0 = [R1++]"),
            "1:7: R1 cannot stand here: a pointer register P0..P5, SP, FP is wanted");
  EXPECT_EQ(error_of("LSETUP (.La, 5) LC0 = P1"), "1:14: 5 cannot stand here: a label is wanted");
  EXPECT_EQ(error_of("R3.L = _x"),
            "1:1: R3.L cannot stand here: a low half P0.L..L3.L of an address register or a high "
            "half P0.H..L3.H of an address register is wanted");
}

TEST(Syntax, SaysWhenNoInstructionLooksSo) {
  EXPECT_EQ(error_of("R0 = R1 +* R2"), "1:1: no instruction reads 'R0 = R1 +* R2'");
  EXPECT_EQ(error_of("FROBNICATE R0"), "1:1: no instruction reads 'FROBNICATE R0'");
  EXPECT_EQ(error_of("R0 += 1\nR1 += 1"),
            "1:1: no instruction reads 'R0 += 1 R1 += 1': is a ';' missing?");
  EXPECT_EQ(error_of(""), "0:0: an instruction is missing");
}

TEST(Syntax, KnowsTheRolesOfOperands) {
  const OperandRoles& load = syntax().roles(2);
  ASSERT_EQ(load.count, 2);
  EXPECT_TRUE(load[0].written && !load[0].read && !load[0].address_stage);
  EXPECT_TRUE(load[1].written && load[1].read && load[1].address_stage);
  EXPECT_EQ(load[1].kind, OperandKind::pointer);
  const OperandRoles& shift = syntax().roles(8);
  ASSERT_EQ(shift.count, 2) << "a repeated operand is none of its own";
  EXPECT_TRUE(shift[0].written && shift[0].read);
  EXPECT_TRUE(!shift[1].written && shift[1].read);
  const OperandRoles& immediate = syntax().roles(0);
  EXPECT_FALSE(immediate[1].read);
}

TEST(Syntax, RefusesMalformedPatterns) {
  const auto error_of_pattern = [](std::string_view pattern) -> std::string {
    const std::array table = {entry(pattern)};
    try {
      const Syntax bad(table);
    } catch (const std::logic_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of_pattern("{Q} = R0"), HasSubstr("unknown operand kind 'Q'"));
  EXPECT_THAT(error_of_pattern("{D?} = R0"), HasSubstr("unknown operand kind 'D?'"));
  EXPECT_THAT(error_of_pattern("{D!* } = R0"), HasSubstr("unknown operand mark '*'"));
  EXPECT_THAT(error_of_pattern("{D = R0"), HasSubstr("'{' without '}'"));
  EXPECT_THAT(error_of_pattern("{D!} = {=1}"), HasSubstr("repeats no operand before it"));
  EXPECT_THAT(error_of_pattern("{imm7!} = {D}"), HasSubstr("neither written"));
  EXPECT_THAT(error_of_pattern("{D}{D}{D}{D}{D}{D}{D}{D}{D}{D}{D}"),
              HasSubstr("too many operands"));
  EXPECT_THAT(error_of_pattern("{D!} {?(X)} = 1"), HasSubstr("stands at the end"));
  EXPECT_THAT(error_of_pattern(""), HasSubstr("it is empty"));
}

TEST(Syntax, TableCheckFindsNothingWrong) { EXPECT_THAT(syntax().check_table(), IsEmpty()); }

TEST(Syntax, TableCheckFindsTwins) {
  const std::array table = {entry("{D!} = ABS {D}"), entry("{D+} = abs {D}")};
  EXPECT_THAT(Syntax(table).check_table(),
              testing::Contains("'{D!} = ABS {D}' and '{D+} = abs {D}' have the same syntax"));
}

TEST(Syntax, TableCheckFindsWhatIsNeverReached) {
  const std::array table = {entry("{D!} = {imm16} (X)"), entry("{D!} = {imm7} (X)")};
  EXPECT_THAT(Syntax(table).check_table(),
              ElementsAre("'{D!} = {imm7} (X)': entries before it read all of its forms"));
}

TEST(Syntax, TableCheckFindsImpossibleForms) {
  const std::array table = {entry("NOP", 3), entry("{D!} = ABS {D}", 2, Slot::dsp),
                            entry("{D!} = [{P@}]", 4, Slot::access)};
  EXPECT_THAT(Syntax(table).check_table(),
              ElementsAre("'NOP': an instruction takes 2 or 4 bytes",
                          "'{D!} = ABS {D}': slot 0 of a packet takes 32-bit instructions",
                          "'{D!} = [{P@}]': slots 1 and 2 of a packet take 16-bit instructions"));
}

}  // namespace
}  // namespace finback::isa
