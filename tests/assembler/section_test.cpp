// Sections: order, alignment, labels, data among code.
#include <gmock/gmock.h>

#include "support.hpp"

namespace finback::assembler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Data, HasTheSizesOfTheGnuAssembler) {
  EXPECT_THAT(bytes_of(".byte 1\n.db 2\n.word 3\n.short 4\n.dw 5\n.byte2 6\n.hword 7"),
              ElementsAre(1, 2, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0));
  EXPECT_THAT(bytes_of(".long 1\n.dd 2, -1\n.byte4 3"),
              ElementsAre(1, 0, 0, 0, 2, 0, 0, 0, 255, 255, 255, 255, 3, 0, 0, 0));
  EXPECT_THAT(bytes_of(".quad -2"), ElementsAre(254, 255, 255, 255, 255, 255, 255, 255));
  EXPECT_THAT(bytes_of(".ascii \"a;\\n\"\n.asciz \"b\", \"c\"\n"),
              ElementsAre('a', ';', 10, 'b', 0, 'c', 0));
}

TEST(Data, KeepsRoom) {
  EXPECT_THAT(bytes_of(".byte 1\n.space 2\n.skip 1, 9\n.fill 2, 2, 0x102\n"),
              ElementsAre(1, 0, 0, 9, 2, 1, 2, 1));
  EXPECT_THAT(bytes_of(".byte 1\n.align 4\n.byte 2\n.p2align 1, 7\n.byte 3\n.align 16,,2\n"),
              ElementsAre(1, 0, 0, 0, 2, 7, 3));
  EXPECT_THAT(bytes_of(".byte 1\n.org 4\n.byte 2\n. = . + 1\n.byte 3"),
              ElementsAre(1, 0, 0, 0, 2, 0, 3));
  EXPECT_THAT(error_of(".long 1\n.org 2"),
              HasSubstr("a.s:2:6: 0x2 lies behind: the section is at 0x4"));
}

TEST(Data, SaysWhatDoesNotFit) {
  std::string said;
  Options options;
  options.note = [&](const std::string& message) { said += message; };
  (void)program(".byte 255, -128, 256", options);
  EXPECT_EQ(said, "a.s:1:18: warning: 0x100 does not fit into 1 byte: 0x0 is taken");
}

TEST(Sections, AreOnePieceEach) {
  const ir::Program whole = program(
      ".text\nNOP;\n.data\n.byte 1\n.section .rodata,\"a\"\n.byte 2\n.text\nNOP;\n.previous\n.byte "
      "3\n"
      ".pushsection .data\n.byte 4\n.popsection\n.byte 5\n");
  EXPECT_EQ(piece(whole, ".text").packets.size(), 2u);
  EXPECT_THAT(piece(whole, ".data").initial, ElementsAre(1, 4));
  EXPECT_THAT(piece(whole, ".rodata").initial, ElementsAre(2, 3, 5));
  EXPECT_TRUE(piece(whole, ".text").code);
  EXPECT_FALSE(piece(whole, ".data").code);
}

TEST(Sections, HoldBytesAmongInstructions) {
  const ir::Program whole = program("RTS;\n.byte 1, 2, 3\n.align 4\nafter: RTS;\n.long after\n");
  const ir::Piece& text = piece(whole, ".text");
  ASSERT_EQ(text.packets.size(), 2u);
  EXPECT_EQ(text.packets[1].offset, 8u);
  EXPECT_EQ(text.relocations.at(0).offset, 10u);
  EXPECT_THAT(error_of("NOP;\n.byte 1\nNOP;"),
              HasSubstr("a.s:3:1: an instruction stands at an even address"));
}

TEST(Sections, ZerosAmongInstructionsAreNops) {
  EXPECT_THAT(code_of("RTS;\n.align 8\nRTS;\n.space 4\nRTS;").size(), 3u + 3u + 2u);
}

TEST(Sections, LabelsBeginFunctions) {
  const ir::Program whole = program(".global _f\n_f: NOP;\n.Lx: NOP;\n1: NOP;\ng: NOP;\n");
  std::vector<std::string> beginning;
  for (const ir::PieceLabel& label : piece(whole, ".text").labels) {
    if (label.begins) {
      beginning.push_back(label.name);
      EXPECT_EQ(label.binding, label.name == "_f" ? ir::Binding::global : ir::Binding::local);
    }
  }
  EXPECT_THAT(beginning, ElementsAre("_f", "g"));
}

TEST(Sections, CommonObjectsStandAlone) {
  const ir::Program whole = program(".comm _a, 12, 8\n.lcomm b, 4\n");
  ASSERT_EQ(whole.objects.size(), 2u);
  EXPECT_EQ(whole.objects[0].name, "_a");
  EXPECT_EQ(whole.objects[0].binding, ir::Binding::global);
  EXPECT_EQ(whole.objects[0].align, 8u);
  EXPECT_EQ(whole.objects[1].binding, ir::Binding::local);
}

}  // namespace
}  // namespace finback::assembler
