// Each rule of the verifier, broken once: the message names the rule, and nothing else is reported.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/ir/support.hpp>

#include <isa_sim/assembler/assemble.hpp>

namespace finback::ir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> problems_of(const std::string& body) {
  return problems(function(body), isa::instruction_syntax());
}

TEST(Verifier, AcceptsLawfulPackets) {
  EXPECT_THAT(problems_of("R2.L = ONES R2 || R0 = [P0++] || R1 = [I0++];"
                          "R2.L = ONES R2 || R0 = [I1++] || R1 = [I0++];"
                          "R2.L = ONES R2 || [P0++] = R0 || R1 = [I0++];"
                          "R2.L = ONES R2 || [P0++] = R2 || NOP;"
                          "MNOP || R0 = [P0 + 4] || NOP;"
                          "R0 = [P0] || R1 = [I0];"
                          "MNOP || NOP || NOP; RTS;"),
              IsEmpty());
}

TEST(Verifier, InstructionsThatIssueAlone) {
  EXPECT_THAT(problems_of("MNOP || R0 = R1 ^ R2;\nRTS;"),
              ElementsAre("a.bir:4:1: 'R0 = R1 ^ R2' issues alone, never in a packet"));
  EXPECT_THAT(problems_of("MNOP || R0 = [P0 + 400];\nRTS;"),
              ElementsAre("a.bir:4:1: 'R0 = [P0 + 400]' issues alone, never in a packet"));
  EXPECT_THAT(problems_of("NOP; RTS || NOP;"),
              ElementsAre("a.bir:4:6: 'RTS' issues alone, never in a packet"));
}

TEST(Verifier, Slots) {
  EXPECT_THAT(problems_of("R0.L = ONES R1 || R2.L = ONES R3; RTS;"),
              ElementsAre("a.bir:4:1: at most one 32-bit DSP instruction issues in a packet: it "
                          "takes slot 0"));
  EXPECT_THAT(problems_of("R0 = [I0] || R1 = [I1] || R2 = [I2]; RTS;"),
              ElementsAre("a.bir:4:1: at most two 16-bit instructions issue in a packet: slots 1 "
                          "and 2; slot 0 takes a 32-bit DSP instruction or MNOP"));
  EXPECT_THAT(problems_of("MNOP || NOP || NOP || NOP; RTS;"),
              ElementsAre("a.bir:4:1: at most three instructions issue together, here are 4"));
}

TEST(Verifier, OneAccessThroughAPointer) {
  EXPECT_THAT(problems_of("MNOP || R0 = [P0] || R1 = [P1]; RTS;"),
              ElementsAre("a.bir:4:1: at most one access through a P register, SP or FP (or change "
                          "of an I register) issues in a packet: the other must go through an I "
                          "register"));
}

TEST(Verifier, OneStore) {
  EXPECT_THAT(problems_of("MNOP || [P0] = R0 || [I0] = R1; RTS;"),
              ElementsAre("a.bir:4:1: at most one store issues in a packet"));
}

TEST(Verifier, Destinations) {
  EXPECT_THAT(problems_of("R0.L = ONES R1 || R0 = [P0]; RTS;"),
              ElementsAre("a.bir:4:1: two instructions of this packet write R0"));
  EXPECT_THAT(problems_of("MNOP || R0 = [I0++] || R1 = [I0++]; RTS;"),
              ElementsAre("a.bir:4:1: two instructions of this packet write I0"));
  EXPECT_THAT(problems_of("P0 = [P0++]; RTS;"),
              ElementsAre("a.bir:4:1: 'P0 = [P0++]' writes P0 twice"));
}

// Rules of single instructions, in functions and in assembler files.
TEST(Verifier, OperandsThatBelongTogether) {
  constexpr const char* kHalves = "R2.H = (A1 = R0.L * R1.L), R3.L = (A0 = R0.H * R1.H)";
  const std::string problem =
      fmt::format("'{}': the two results go to the halves of one register", kHalves);
  EXPECT_THAT(problems_of(fmt::format("{};\nRTS;", kHalves)), ElementsAre("a.bir:4:1: " + problem));
  const Program pieces = assembler::assemble(fmt::format("{};\n", kHalves), "a.s");
  EXPECT_THAT(problems(pieces, isa::instruction_syntax()), ElementsAre("a.s:1:1: " + problem));
  EXPECT_THAT(problems_of("A1 += R0.L * R1.L, A0 += R0.H * R2.H;\nRTS;"),
              ElementsAre("a.bir:4:1: 'A1 += R0.L * R1.L, A0 += R0.H * R2.H': both products take "
                          "their halves from the same two registers"));
}

TEST(Verifier, Anomaly05000074) {
  EXPECT_THAT(problems_of("R0 = R1 << 3 || [P0] = P1; RTS;"),
              ElementsAre("a.bir:4:1: an immediate shift and a store of a P register do not issue "
                          "together (anomaly 05000074)"));
  EXPECT_THAT(problems_of("R0 = R1 << 3 || [P0] = R2; RTS;"), IsEmpty());
}

TEST(Verifier, LoopLabels) {
  EXPECT_THAT(problems_of("LSETUP (.La, .Lb) LC0 = P0;\n.La: NOP;\nRTS;"),
              testing::Contains("a.bir:4:1: the bottom of this loop, .Lb, is no label before an "
                                "instruction of _f"));
  EXPECT_THAT(problems_of("LSETUP (.La, .Lb) LC0 = P0;\n.La: NOP;\nRTS;\n.Lb:\n"),
              ElementsAre("a.bir:4:1: the bottom of this loop, .Lb, is no label before an "
                          "instruction of _f"));
  EXPECT_THAT(problems_of(".La: NOP;\nLSETUP (.La, .Lb) LC0 = P0;\n.Lb: NOP;\nRTS;"),
              ElementsAre("a.bir:5:1: a loop's top stands after its LSETUP, and its bottom not "
                          "before its top"));
  EXPECT_THAT(problems_of("LSETUP (.La, .Lb) LC0 = P0;\n.Lb: NOP;\n.La: NOP;\nRTS;"),
              ElementsAre("a.bir:4:1: a loop's top stands after its LSETUP, and its bottom not "
                          "before its top"));
}

TEST(Verifier, LastInstructionOfALoop) {
  EXPECT_THAT(problems_of("LSETUP (.La, .Lb) LC0 = P0;\n.La: NOP;\n.Lb: CALL _g;\nRTS;"),
              ElementsAre("a.bir:6:6: the last instruction of a hardware loop is no branch, call, "
                          "return or loop set-up, but this is 'CALL _g': end the loop with a NOP"));
  EXPECT_THAT(problems_of("LSETUP (.La, .La) LC0 = P0;\n.La: NOP;\nRTS;"), IsEmpty());
}

TEST(Verifier, FunctionsEnd) {
  EXPECT_THAT(problems_of("NOP;\nR0 = R1;"),
              ElementsAre("a.bir:5:1: _f runs on past its last instruction: end it with RTS or a "
                          "jump"));
  EXPECT_THAT(problems_of(".La: IF CC JUMP .La;"),
              ElementsAre("a.bir:4:6: _f runs on past its last instruction: end it with RTS or a "
                          "jump"));
  EXPECT_THAT(problems_of(".La: IDLE; JUMP .La;"), IsEmpty());
  EXPECT_THAT(problems_of(""), ElementsAre("a.bir:3:1: function _f has no instructions"));
}

TEST(Verifier, Labels) {
  EXPECT_THAT(problems_of("JUMP .Lx;"), ElementsAre("a.bir:4:1: _f has no label .Lx"));
  EXPECT_THAT(problems_of(".Lx: RTS;\n.type _g, @function\n_g: P0.L = .Lx; RTS;"), IsEmpty());
  EXPECT_THAT(problems_of(".Lx: RTS;\n.type _g, @function\n_g: JUMP .Lx;"),
              ElementsAre("a.bir:6:5: _g has no label .Lx"));
  EXPECT_THAT(problems_of("_x: RTS;\n.data\n_x: .long 1"),
              ElementsAre("a.bir:3:1: label _x of _f is a function or an object, too"));
  EXPECT_THAT(problems_of("RTS;\n.data\n_x: .long .Lx"),
              ElementsAre("a.bir:6:1: _x takes the address of .Lx, which is nowhere in this file"));
}

TEST(Verifier, Symbols) {
  EXPECT_THAT(problems_of("RTS;\n_f: RTS;"),
              ElementsAre("a.bir:5:1: _f is defined twice in this file"));
  EXPECT_THAT(problems_of("RTS;\n.data\n_x: .long 1\n_x: .long 1"),
              ElementsAre("a.bir:7:1: _x is defined twice in this file"));
  EXPECT_THAT(problems_of("RTS;\n.data\n_x:\n_y: .long 1"),
              ElementsAre("a.bir:6:1: object _x has no bytes"));
}

TEST(Verifier, ThrowsTheFirstProblemAndCountsTheOthers) {
  const Program bad = function("JUMP .La;\nJUMP .Lb;");
  EXPECT_EQ(error_of([&] { verify(bad); }), "a.bir:4:1: _f has no label .La (and 1 more)");
}

}  // namespace
}  // namespace finback::ir
