// Instructions of assembler files: where they end, their expressions and labels.
#include <gmock/gmock.h>

#include "support.hpp"

namespace finback::assembler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Instruction, EndsAtItsSemicolonOrItsLine) {
  EXPECT_THAT(code_of("R0 = R1\nR2 = R3; R4 = R5\n  R6 =\n  R7;\n"),
              ElementsAre("R0 = R1", "R2 = R3", "R4 = R5", "R6 = R7"));
  EXPECT_THAT(code_of("R2.L = ONES R0\n || R0 = [P0++] ||\n NOP;\n").size(), 1u);
  EXPECT_THAT(code_of("R0 = R1 // comment\nR2 = R3 # comment\n/* R4\n = */ R5 = R6;"),
              ElementsAre("R0 = R1", "R2 = R3", "R5 = R6"));
}

TEST(Instruction, IsWrittenInAnyCase) {
  EXPECT_THAT(code_of("r0 = r1; p0.l = 5; nop; Rts;"),
              ElementsAre("R0 = R1", "P0.L = 5", "NOP", "RTS"));
}

TEST(Instruction, FoldsExpressions) {
  EXPECT_THAT(code_of("n = 3\nR0 = n * 2 (X); R0 += -(n + 1); R1 = [P0 + (4 * n)];"
                      "R1 = [FP - 8 + 4]; R2 = R3 << n - 1; R0.L = 0x1234 & ~0xf;"),
              ElementsAre("R0 = 6 (X)", "R0 += -4", "R1 = [P0 + 12]", "R1 = [FP + -4]",
                          code_of("R2 = R3 << 2;")[0], "R0.L = 4656"));
  EXPECT_THAT(code_of("R0 = 0xFFFFFFFF; R0.H = -2 >> 16;"), ElementsAre("R0 = -1 (X)", "R0.H = -1"))
      << "32 bits with a sign";
}

TEST(Instruction, TakesHalves) {
  EXPECT_THAT(code_of("R0.L = LO(0x12345678); R0.H = HI(0x12345678);"),
              ElementsAre("R0.L = 22136", "R0.H = 4660"));
  EXPECT_THAT(code_of("P0.L = LO(x + 4); P0.H = x + 4; .data\nx: .long 0, 0"),
              ElementsAre("P0.L = x + 4", "P0.H = x + 4"));
  EXPECT_THAT(error_of("P0.H = LO(x);"), HasSubstr("only be put into the low half"));
}

TEST(Instruction, FillsInWhatFollows) {
  EXPECT_THAT(code_of("R0 = end - start (X); R1.L = end - start; R2.H = HI(end - start);"
                      "R3 = later (X);\n.data\nstart: .space 100\nend:\nlater = 5\n"),
              ElementsAre("R0 = 100 (X)", "R1.L = 100", "R2.H = 0", "R3 = 5 (X)"));
  EXPECT_THAT(error_of("R0 = [P0 + (end - start)];\n.data\nstart: .space 3\nend:\n"),
              HasSubstr("3 does not fit here"));
}

TEST(Instruction, NumberedLabelsAreTheNearest) {
  const ir::Program whole = program("1: JUMP 1f; 1: JUMP 1b; JUMP 1f; 1: NOP;");
  const ir::Piece& text = piece(whole, ".text");
  const auto target = [&](std::size_t index) {
    const std::string& symbol = text.packets[index].packet.slots[0].operand[0].symbol;
    const auto label = std::ranges::find(text.labels, symbol, &ir::PieceLabel::name);
    return label == text.labels.end() ? 999u : label->offset;
  };
  EXPECT_EQ(target(0), 4u);
  EXPECT_EQ(target(1), 4u);
  EXPECT_EQ(target(2), 12u);
  EXPECT_EQ(error_of("JUMP 1b;"), "a.s:1:6: no label 1: stands before this");
  EXPECT_EQ(error_of("JUMP 1f;"), "a.s:1:6: no label 1: follows this");
}

TEST(Instruction, NumbersToBranchToAreDistances) {
  const ir::Program whole =
      program("NOP; JUMP.S -2; IF CC JUMP 4 (BP); LSETUP (4, 8) LC0 = P0 >> 1;");
  const ir::Piece& text = piece(whole, ".text");
  ASSERT_EQ(text.packets.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) {
    const ir::OperandValue& operand = text.packets[i].packet.slots[0].operand[0];
    EXPECT_FALSE(operand.symbol.empty());
    EXPECT_EQ(operand.number, i == 1 ? -2 : 4);
  }
}

TEST(Instruction, LoopsHaveNames) {
  const ir::Program whole =
      program("LOOP sum LC0 = P1; LOOP_BEGIN sum; R0 = [P0++]; R1 = R1 + R0; LOOP_END sum; RTS;");
  const ir::Piece& text = piece(whole, ".text");
  const auto offset = [&](const char* name) {
    return std::ranges::find(text.labels, name, &ir::PieceLabel::name)->offset;
  };
  EXPECT_EQ(offset("L$L$sum__BEGIN"), 4u);
  EXPECT_EQ(offset("L$L$sum__END"), 6u);
}

}  // namespace
}  // namespace finback::assembler
