// Macros, repetitions, conditionals and includes.
#include <filesystem>
#include <gmock/gmock.h>

#include "support.hpp"
#include <common/file.hpp>

namespace finback::assembler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Macro, ArgumentsStandForNames) {
  EXPECT_THAT(bytes_of(".macro two a, b\n.byte \\a, \\b\n.endm\ntwo 1, 2\ntwo 3 4\ntwo b=5, a=6\n"),
              ElementsAre(1, 2, 3, 4, 6, 5));
}

TEST(Macro, DefaultsRequiredAndRest) {
  const std::string text = ".macro m a:req, b=7, c:vararg\n.byte \\a, \\b \\c\n.endm\n";
  EXPECT_THAT(bytes_of(text + "m 1\nm 2, 3\nm 4, 5,, 8, 9\n"), ElementsAre(1, 7, 2, 3, 4, 5, 8, 9));
  EXPECT_THAT(error_of(text + "m\n"), HasSubstr("a.s:4:1: macro m wants an argument for a"));
  EXPECT_THAT(error_of(".macro n a\n.endm\nn 1, 2\n"),
              HasSubstr("macro n takes 1 argument, here is one more: '2'"));
}

TEST(Macro, BlanksAroundOperatorsAndInBracketsSeparateNothing) {
  EXPECT_THAT(bytes_of(".macro m a, b=0\n.byte \\a, \\b\n.endm\nm 1 + 2\nm (1 + 2), 4\nm \"5\" 6"),
              ElementsAre(3, 0, 3, 4, 5, 6));
}

TEST(Macro, NamesEndWhereTheyAreToldTo) {
  EXPECT_THAT(
      code_of(".macro load reg, n\n\\reg\\n\\().L = 1; \\reg\\n.H = 2;\n.endm\nload R, 3\n"),
      ElementsAre("R3.L = 1", "R3.H = 2"));
}

TEST(Macro, EachCallHasANumber) {
  EXPECT_THAT(bytes_of(".macro m\nhere\\@: .byte 1\n.endm\nm\nm\n.byte here1 - here0"),
              ElementsAre(1, 1, 1));
}

TEST(Macro, CanCallThemselvesAndLeave) {
  EXPECT_THAT(
      bytes_of(".macro count n\n.byte \\n\n.if \\n\ncount (\\n - 1)\n.endif\n.endm\ncount 2\n"),
      ElementsAre(2, 1, 0));
  EXPECT_THAT(bytes_of(".macro m n\n.if \\n\n.exitm\n.endif\n.byte \\n\n.endm\nm 1\nm 0\n.byte 9"),
              ElementsAre(0, 9));
}

TEST(Macro, CanBeForgottenAndAreFoundInAnyCase) {
  EXPECT_THAT(bytes_of(".macro M\n.byte 1\n.endm\nm\n.purgem M\n.macro m\n.byte 2\n.endm\nM"),
              ElementsAre(1, 2));
  EXPECT_THAT(error_of(".macro m\n.endm\n.macro M\n.endm\n"),
              HasSubstr("macro M is defined already"));
}

TEST(Macro, StandOnOneLineToo) {
  EXPECT_THAT(bytes_of(".macro m; .byte 1; .byte 2; .endm\nm; m"), ElementsAre(1, 2, 1, 2));
}

TEST(Repetition, OfATextAndOverValues) {
  EXPECT_THAT(bytes_of(".set n, 0\n.rept 3\n.byte n\n.set n, n + 1\n.endr"), ElementsAre(0, 1, 2));
  EXPECT_THAT(bytes_of(".irp x, 1, 2 + 3, 4\n.byte \\x\n.endr"), ElementsAre(1, 5, 4));
  EXPECT_THAT(bytes_of(".irpc x, 123\n.byte \\x\n.endr"), ElementsAre(1, 2, 3));
  EXPECT_THAT(bytes_of(".rept 2\n.rept 2\n.byte 1\n.endr\n.byte 2\n.endr"),
              ElementsAre(1, 1, 2, 1, 1, 2));
  EXPECT_THAT(bytes_of(".rept 0\n.byte 1\n.endr"), IsEmpty());
}

TEST(Conditional, ChoosesOneBranch) {
  const std::string text =
      ".if n == 1\n.byte 1\n.elseif n == 2\n.byte 2\n.elseif n\n.byte 3\n.else\n.byte 4\n.endif\n";
  EXPECT_THAT(bytes_of("n = 1\n" + text), ElementsAre(1));
  EXPECT_THAT(bytes_of("n = 2\n" + text), ElementsAre(2));
  EXPECT_THAT(bytes_of("n = 3\n" + text), ElementsAre(3));
  EXPECT_THAT(bytes_of("n = 0\n" + text), ElementsAre(4));
}

TEST(Conditional, SkipsWhatItDoesNotUnderstand) {
  EXPECT_THAT(bytes_of(".if 0\nwhatever this is\n.if x y z\n.else\n.endif\n.endif\n.byte 1"),
              ElementsAre(1));
}

TEST(Conditional, AsksManyThings) {
  EXPECT_THAT(bytes_of("a: .ifdef a\n.byte 1\n.endif\n.ifndef b\n.byte 2\n.endif\n"
                       ".ifeq 0\n.byte 3\n.endif\n.ifne 0\n.byte 4\n.endif\n"
                       ".iflt -1\n.byte 5\n.endif\n.ifge 0\n.byte 6\n.endif\n"
                       ".ifc x y, x y\n.byte 7\n.endif\n.ifnc x, x\n.byte 8\n.endif\n"
                       ".ifb\n.byte 9\n.endif\n.ifnb x\n.byte 10\n.endif\n"
                       ".ifeqs \"a,b\", \"a,b\"\n.byte 11\n.endif\n"),
              ElementsAre(1, 2, 3, 5, 6, 7, 9, 10, 11));
}

TEST(Conditional, SeesGivenSymbols) {
  Options options;
  options.defines = {{"DEBUG", 3}};
  EXPECT_THAT(code_of(".ifdef DEBUG\nR0 = DEBUG;\n.endif\nHLT;", options),
              ElementsAre("R0 = 3 (X)", "HLT"));
}

TEST(Include, ReadsFilesAndBytes) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "finback_assembler_include";
  std::filesystem::create_directories(folder / "inc");
  write_file_whole(folder / "inc/table.inc", ".byte 1\n.include \"second.inc\"\n");
  write_file_whole(folder / "inc/second.inc", ".byte 2\n.incbin \"raw\", 1, 2\n");
  write_file_whole(folder / "inc/raw", "abcd");
  write_file_whole(folder / "main.s", ".data\n.include \"table.inc\"\n.byte 3\n.end\nnot read\n");
  Options options;
  options.include_folders = {folder / "inc"};
  const ir::Program whole = assemble_file(folder / "main.s", options);
  EXPECT_THAT(whole.pieces.at(0).initial, ElementsAre(1, 2, 'b', 'c', 3));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace finback::assembler
