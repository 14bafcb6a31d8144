// What people write wrong, and what they are told.
#include <gmock/gmock.h>

#include "support.hpp"

namespace finback::assembler {
namespace {

using testing::HasSubstr;

TEST(Errors, NameThePlace) {
  EXPECT_EQ(error_of("NOP;\n  R0 = R1 + * R2;\n"),
            "a.s:2:3: no instruction reads 'R0 = R1 + * R2'");
  EXPECT_EQ(error_of("start: R0 += 100;"), "a.s:1:14: immediate 100 does not fit: -64..63");
  EXPECT_EQ(error_of("/* never closed"), "a.s:1:1: this comment is never closed: add */");
  EXPECT_EQ(error_of(".ascii \"abc\n"), "a.s:1:8: this string is never closed: add \"");
  EXPECT_EQ(error_of(".data\n.byte 1,\n"), "a.s:2:1: .byte wants a value");
  EXPECT_EQ(error_of(".byte 1 2"), "a.s:1:9: ',' is wanted before '2'");
}

TEST(Errors, NameTheMacroTheyStandIn) {
  EXPECT_EQ(
      error_of(".macro inner x\nR0 += \\x;\n.endm\n.macro outer\n inner 99\n.endm\n\nouter\n"),
      "a.s:2:7: immediate 99 does not fit: -64..63 (in macro inner, called at a.s:5, in macro "
      "outer, called at a.s:8)");
}

TEST(Errors, FollowTheMarksOfThePreprocessor) {
  EXPECT_EQ(error_of("# 40 \"b.S\"\nNOP;\nfoo;\n"), "b.S:41:1: no instruction reads 'foo'");
}

TEST(Errors, NameTheNearest) {
  EXPECT_EQ(error_of(".glbal x"), "a.s:1:1: unknown directive .glbal, did you mean .global?");
}

TEST(Errors, OfPairs) {
  EXPECT_EQ(error_of("\n.if 1\nNOP;"), "a.s:2:1: this condition is never closed: add .endif");
  EXPECT_EQ(error_of(".endif"), "a.s:1:1: .endif without .if");
  EXPECT_EQ(error_of(".macro m\nNOP;"), "a.s:1:1: this .macro is never closed: add .endm");
  EXPECT_EQ(error_of(".rept 2\nNOP;"), "a.s:1:1: this .rept is never closed: add .endr");
  EXPECT_EQ(error_of(".endm"), "a.s:1:1: .endm ends nothing here");
  EXPECT_EQ(error_of(".popsection"), "a.s:1:1: .popsection without .pushsection");
}

TEST(Errors, OfSymbols) {
  EXPECT_EQ(error_of("a: NOP;\na: NOP;"), "a.s:2:1: a is defined already, at a.s:1:1");
  EXPECT_EQ(error_of("R0: NOP;"), "a.s:1:1: R0 is a register, no label can be called so");
  EXPECT_EQ(error_of("a: NOP;\n.set a, 1"), "a.s:2:6: a is a label already, at a.s:1:1");
  EXPECT_EQ(error_of("JUMP .Lnowhere;"), "a.s:1:6: .Lnowhere is nowhere in this file");
  EXPECT_EQ(
      error_of(".space later\nlater = 3"),
      "a.s:1:8: a number of bytes is wanted that is known here, but later is not defined yet");
}

TEST(Errors, CanBeAskedFor) {
  EXPECT_EQ(error_of(".error \"not for this chip\""), "a.s:1:1: not for this chip");
  EXPECT_EQ(error_of(".err"), "a.s:1:1: .err stands here");
}

}  // namespace
}  // namespace finback::assembler
