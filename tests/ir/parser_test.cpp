// BIR text -> program, and the exact place and wording of what cannot be read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <tests/ir/support.hpp>

#include <isa_sim/ir/printer.hpp>

namespace finback::ir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kExample = R"(.file 1 "shd.c"
.text
.global _shd_update_row
.type _shd_update_row, @function
.align 2
_shd_update_row:
  .loc 1 12 3
  [--SP] = (R7:4, P5:3);
  LINK 12;
  P1 = 20 (X);
  P0.L = _table; P0.H = _table + 4;
  LSETUP (.Lloop0, .Lend0) LC0 = P1;
.Lloop0:
  .loc 1 13
  R2 = R0 + R1;
  R2.L = ONES R2 || R0 = [P0++] || NOP;
.Lend0:
  [P2++] = R2;
  UNLINK;
  (R7:4, P5:3) = [SP++];
  RTS;
.Lfunc_end:
.size _shd_update_row, .Lfunc_end-_shd_update_row
.section .rodata
.align 4
.global _table
.type _table, @object
_table:
  .byte 1,2,3
.size _table, 3
)";

TEST(Parser, ReadsWhatTheCompilerPrints) {
  const Program p = program(kExample);
  EXPECT_THAT(problems(p, isa::instruction_syntax()), IsEmpty());
  EXPECT_THAT(p.source_files, ElementsAre("", "shd.c"));
  ASSERT_EQ(p.functions.size(), 1u);
  const Function& f = p.functions[0];
  EXPECT_EQ(f.name, "_shd_update_row");
  EXPECT_EQ(f.binding, Binding::global);
  EXPECT_EQ(f.align, 2u);
  EXPECT_EQ(f.section, ".text");
  ASSERT_EQ(f.packets.size(), 12u);
  EXPECT_EQ(f.labels.at(".Lloop0"), 6u);
  EXPECT_EQ(f.labels.at(".Lend0"), 8u);
  EXPECT_EQ(f.labels.at(".Lfunc_end"), 12u);
  EXPECT_EQ(f.packets[0].file, 1);
  EXPECT_EQ(f.packets[0].line, 12);
  EXPECT_EQ(f.packets[6].line, 13);
  EXPECT_EQ(f.packets[7].slots.size(), 3u);
  EXPECT_EQ(f.packets[7].written.to_string(), "a.bir:17:3");
  ASSERT_EQ(p.objects.size(), 1u);
  const Object& o = p.objects[0];
  EXPECT_EQ(o.name, "_table");
  EXPECT_EQ(o.section, ".rodata");
  EXPECT_EQ(o.align, 4u);
  EXPECT_EQ(o.size, 3u);
  EXPECT_THAT(o.initial, ElementsAre(1, 2, 3));
}

TEST(Parser, ReadsDirectivesEndedBySemicolonAndElfTypeNames) {
  const Program p = program(
      ".text; .global _f; .type _f, STT_FUNC; .align 4; _f: RTS;\n"
      ".type _g, %function\n_g: RTS; .data; .type _x, STT_OBJECT\n"
      "_x: .long 7;");
  ASSERT_EQ(p.functions.size(), 2u);
  EXPECT_EQ(p.functions[0].align, 4u);
  EXPECT_EQ(p.functions[1].align, 2u);
  ASSERT_EQ(p.objects.size(), 1u);
  EXPECT_EQ(p.objects[0].section, ".data");
}

TEST(Parser, ReadsAllKindsOfData) {
  const Program p = program(R"(.data
_x: .byte 1, -1, 'a'
    .short 0x1234
    .2byte -2
    .align 4
    .long 1, _y + 8, _y-4, -0x80000000
    .quad -2
    .ascii "a\n", "\x41\101\""
    .asciz "z"
    .space 3
    .space 2, 0xff
    .zero 5
)");
  ASSERT_EQ(p.objects.size(), 1u);
  const Object& o = p.objects[0];
  EXPECT_EQ(o.align, 4u);
  EXPECT_THAT(o.initial, ElementsAre(1, 255, 97, 0x34, 0x12, 0xfe, 0xff, 0,  // to the alignment
                                     1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80,  // .long
                                     0xfe, 255, 255, 255, 255, 255, 255, 255,            // .quad
                                     'a', '\n', 'A', 'A', '"', 'z', 0, 0, 0, 0, 255, 255));
  EXPECT_EQ(o.size, o.initial.size() + 5);
  EXPECT_THAT(o.relocations, ElementsAre(Relocation{12, 4, "_y", 8}, Relocation{16, 4, "_y", -4}));
}

TEST(Parser, ReadsCommonObjectsAndSizes) {
  const Program p = program(
      ".comm _a, 100, 8\n.lcomm _b, 3\n.bss\n.type _c, @object\n_c:\n"
      ".space 4\n.size _c, 16\n");
  ASSERT_EQ(p.objects.size(), 3u);
  EXPECT_EQ(p.objects[0].binding, Binding::global);
  EXPECT_EQ(p.objects[0].align, 8u);
  EXPECT_EQ(p.objects[0].size, 100u);
  EXPECT_EQ(p.objects[1].binding, Binding::local);
  EXPECT_EQ(p.objects[1].size, 3u);
  EXPECT_EQ(p.objects[2].size, 16u);
}

TEST(Parser, KeepsAFunctionOpenAcrossATableOfJumps) {
  const Program p = program(
      ".text\n.type _f, @function\n_f: NOP;\n.section .rodata\n.align 4\n"
      ".LJTI0: .long .La\n.text\n.La: RTS;\n");
  ASSERT_EQ(p.functions.size(), 1u);
  EXPECT_EQ(p.functions[0].packets.size(), 2u);
  EXPECT_EQ(p.functions[0].labels.at(".La"), 1u);
  ASSERT_EQ(p.objects.size(), 1u);
  EXPECT_EQ(p.objects[0].name, ".LJTI0");
}

TEST(Parser, PutsPacketsIntoSlotOrder) {
  const Program p = function("R0 = [P0++] || R2.L = ONES R2;\n NOP || R1 = [I0++] || MNOP; RTS;");
  const isa::Syntax& syntax = isa::instruction_syntax();
  EXPECT_EQ(print(p.functions[0].packets[0], syntax), "R2.L = ONES R2 || R0 = [P0++]");
  EXPECT_EQ(print(p.functions[0].packets[1], syntax), "MNOP || R1 = [I0++] || NOP");
}

TEST(Parser, IgnoresWhatSaysNothing) {
  EXPECT_EQ(parse_error(".ident \"cc\"\n.file \"x.c\"\n.file 0 \"/d\" \"x.c\"\n.cfi_startproc\n"
                        ".hidden _x\n.section .note.GNU-stack,\"\",@progbits\n.text\n;;\n"),
            "");
}

TEST(Parser, LocLastsUntilTheFunctionEnds) {
  const Program p = program(
      ".file 1 \"d\" \"a.c\"\n.type _f, @function\n.type _g, @function\n"
      "_f:\n.loc 1 5 2 prologue_end\nNOP; RTS;\n_g: RTS;\n");
  EXPECT_EQ(p.source_files[1], "d/a.c");
  EXPECT_EQ(p.functions[0].packets[1].line, 5);
  EXPECT_EQ(p.functions[1].packets[0].file, 0);
  EXPECT_EQ(p.functions[1].packets[0].line, 0);
}

TEST(ParserErrors, Heading) {
  EXPECT_EQ(error_of([] { (void)parse("", "a.bir"); }),
            "a.bir:1:1: a BIR file begins with `.bir 1`, but this one is empty");
  EXPECT_EQ(error_of([] { (void)parse("\n NOP;", "a.bir"); }),
            "a.bir:2:2: a BIR file begins with `.bir 1`");
  EXPECT_EQ(error_of([] { (void)parse(".bir 2\n", "a.bir"); }),
            "a.bir:1:6: BIR version 2 is not known: this Finback reads version 1");
  EXPECT_EQ(parse_error(".bir 1"), "a.bir:2:1: .bir stands once, at the head of the file");
}

TEST(ParserErrors, Instructions) {
  const std::string head = ".type _f, @function\n_f:\n";
  EXPECT_EQ(parse_error(head + "  R0 += 99;"), "a.bir:4:9: immediate 99 does not fit: -64..63");
  EXPECT_EQ(parse_error(head + "  R0 = R1 +* R2;"),
            "a.bir:4:3: no instruction reads 'R0 = R1 +* R2'");
  EXPECT_EQ(parse_error(head + "  MNOP || R0 = [R1++];"),
            "a.bir:4:17: R1 cannot stand here: a pointer register P0..P5, SP, FP or an index "
            "register I0..I3 is wanted");
  EXPECT_EQ(parse_error(head + "NOP\nNOP;"),
            "a.bir:4:1: no instruction reads 'NOP NOP': is a ';' missing?");
  EXPECT_EQ(parse_error(head + "NOP"), "a.bir:4:1: this instruction never ends: add ';'");
  EXPECT_EQ(parse_error(head + "NOP || ;"), "a.bir:4:8: an instruction is missing");
  EXPECT_EQ(parse_error("NOP;"),
            "a.bir:2:1: an instruction outside a function: write `.type _name, @function` and "
            "`_name:` before it");
  EXPECT_EQ(parse_error(head + "RTS;\n.size _f, .-_f\nNOP;"),
            "a.bir:6:1: an instruction outside a function: write `.type _name, @function` and "
            "`_name:` before it");
  EXPECT_EQ(parse_error(head + "RTS;\n.data\nNOP;"),
            "a.bir:6:1: an instruction in the data section .data: write .text before it");
}

TEST(ParserErrors, Labels) {
  EXPECT_EQ(parse_error("_f: RTS;"),
            "a.bir:2:1: label _f stands outside a function: write `.type _f, @function` before it");
  EXPECT_EQ(parse_error(".type _f, @function\n_f:\n.La: NOP;\n.La: RTS;"),
            "a.bir:5:1: label .La stands twice in _f");
  EXPECT_EQ(parse_error("R0: RTS;"), "a.bir:2:1: R0 is a register, no label can be called so");
  EXPECT_EQ(parse_error("1: RTS;"),
            "a.bir:2:1: numbered labels are not BIR: give the label a name, such as .L1");
  EXPECT_EQ(parse_error(".type _f, @function\n_f:\n_g: RTS;\n.global _g"),
            "a.bir:5:9: _g is a label inside _f: only functions and objects can be global");
}

TEST(ParserErrors, Directives) {
  EXPECT_EQ(parse_error(".globel _f"),
            "a.bir:2:1: unknown directive .globel, did you mean .global?");
  EXPECT_EQ(parse_error(".frobnicate"), "a.bir:2:1: unknown directive .frobnicate");
  EXPECT_EQ(parse_error(".global"), "a.bir:2:1: .global wants a symbol");
  EXPECT_EQ(parse_error(".global _a _b"), "a.bir:2:12: symbols are separated by ','");
  EXPECT_EQ(parse_error(".type _f, @thing"),
            "a.bir:2:12: a symbol's type is @function or @object, not 'thing'");
  EXPECT_EQ(parse_error(".type _f @object"), "a.bir:2:10: .type wants ',' after '_f'");
  EXPECT_EQ(parse_error(".align 3"),
            "a.bir:2:8: an alignment is a power of two up to 1048576 bytes");
  EXPECT_EQ(parse_error(".p2align 40"),
            "a.bir:2:10: an alignment is a power of two up to 1048576 bytes");
  EXPECT_EQ(parse_error(".text 5"), "a.bir:2:7: '5' is too much here");
  EXPECT_EQ(parse_error(".loc 1 5"),
            "a.bir:2:6: file 1 is not declared: write `.file 1 \"name\"` before");
  EXPECT_EQ(parse_error(".file 1 \"a.c\"\n.file 1 \"b.c\""), "a.bir:3:7: file 1 is a.c already");
  EXPECT_EQ(parse_error(".file 70000 \"a.c\""), "a.bir:2:7: a file number is at most 65535");
  EXPECT_EQ(parse_error(".size _f, 4"), "a.bir:2:7: _f is no function or object before this line");
  EXPECT_EQ(parse_error(".data\n_x: .long 1\n.size _x, 2"),
            "a.bir:4:11: _x has 4 bytes already: its size cannot be 2");
  EXPECT_EQ(parse_error(".comm _x, 0"), "a.bir:2:11: an object has 1 byte to 256 MB");
}

TEST(ParserErrors, Data) {
  EXPECT_EQ(parse_error(".byte 1"),
            "a.bir:2:1: .byte stands in no object: write a label before it, in .data, .bss or "
            ".rodata");
  EXPECT_EQ(parse_error(".data\n_x: .byte 256"), "a.bir:3:11: 256 does not fit into 1 byte");
  EXPECT_EQ(parse_error(".data\n_x: .byte2 -32769"),
            "a.bir:3:12: -32769 does not fit into 2 bytes");
  EXPECT_EQ(parse_error(".data\n_x: .byte 1 2"), "a.bir:3:13: values are separated by ','");
  EXPECT_EQ(parse_error(".data\n_x: .byte 1,"), "a.bir:3:5: .byte wants a value");
  EXPECT_EQ(parse_error(".data\n_x: .byte2 _y"),
            "a.bir:3:12: an address takes 4 bytes: write .byte4");
  EXPECT_EQ(parse_error(".data\n_x: .byte4 _y-_z"),
            "a.bir:3:14: after a symbol, only + or - a number can stand");
  EXPECT_EQ(parse_error(".data\n_x: .word 1"),
            "a.bir:3:5: .word has 2 or 4 bytes, depending on the assembler: write .byte2 or "
            ".byte4");
  EXPECT_EQ(parse_error(".data\n_x: .space 999999999"), "a.bir:3:12: an object has at most 256 MB");
  EXPECT_EQ(parse_error(".data\n_x: .space 1, 256"), "a.bir:3:12: a byte is 0..255");
  EXPECT_EQ(parse_error(".data\n_x: .ascii \"\\q\""),
            "a.bir:3:12: unknown escape \\q in this string");
  EXPECT_EQ(parse_error(".data\n_x: .ascii \"\\777\""),
            "a.bir:3:12: a \\ escape in this string is no byte");
}

// Damage at random places: whatever stands there, the text is read or refused, never more.
TEST(ParserErrors, DamagedTextIsReadOrRefused) {
  static constexpr std::string_view kDamage = "{}[]();:|.,\"'\\#/*-+=@0x9RP_\n\xff";
  const std::string whole = std::string(".bir 1\n") + kExample;
  std::mt19937 random(7);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = kDamage[random() % kDamage.size()];
          break;
        case 1:
          text.erase(at, 1 + random() % 20);
          break;
        default:
          text.resize(at + 1);
      }
    }
    const std::string error = error_of([&] {
      const Program p = parse(text, "a.bir");
      (void)problems(p, isa::instruction_syntax());
      (void)print(p);
    });
    EXPECT_TRUE(error.empty() || error.starts_with("a.bir:")) << error << "\n" << text;
    refused += error.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace finback::ir
