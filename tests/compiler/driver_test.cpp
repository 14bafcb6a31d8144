// The command line, the files it writes, and their general form.
#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

constexpr const char* kSmall = "int twice(int x) {\n  return 2 * x;\n}\n";

class Driver : public CompilerTest {};

TEST_F(Driver, HelpNamesTheOptionsAndAnExample) {
  const Finished help = cc({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"-O", "-o", "-I", "-D", "Example", "Exit codes"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST_F(Driver, UsageErrorsExitWithOne) {
  write("a.c", kSmall);
  EXPECT_EQ(cc({}).exit_code, 1);
  EXPECT_EQ(cc({"--frobnicate", "a.c"}).exit_code, 1);
  EXPECT_EQ(cc({"-O9", "a.c"}).exit_code, 1);
  EXPECT_EQ(cc({"-o", "one.bir", "a.c", "a.c"}).exit_code, 1);
}

TEST_F(Driver, MissingFilesExitWithTwo) {
  const Finished finished = cc({"nowhere.c"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("nowhere.c"), std::string::npos);
}

TEST_F(Driver, UnwritableOutputExitsWithTwo) {
  write("a.c", kSmall);
  const Finished finished = cc({"-o", "no/such/folder/a.bir", "a.c"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("no/such/folder/a.bir"), std::string::npos) << finished.err;
}

TEST_F(Driver, MinusIsStandardOutput) {
  write("a.c", kSmall);
  const Finished finished = cc({"-o", "-", "a.c"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.out.find("_twice:"), std::string::npos) << finished.out;
  EXPECT_EQ(read("-"), "");
}

TEST_F(Driver, SeveralInputsGiveAFileEach) {
  write("a.c", kSmall);
  write("b.c", "int y;\n");
  EXPECT_EQ(cc({"-c", "-g", "a.c", "b.c"}).exit_code, 0);
  EXPECT_NE(read("a.bir").find("_twice:"), std::string::npos);
  EXPECT_NE(read("b.bir").find("_y:"), std::string::npos);
}

TEST_F(Driver, MacrosAndFoldersReachThePreprocessor) {
  std::filesystem::create_directory(folder() / "inc");
  write("inc/value.h", "#define VALUE (BASE + 1)\n");
  const std::string bir =
      compile("#include <value.h>\nint v = VALUE;\n", {"-I", "inc", "-DBASE=41"});
  EXPECT_NE(bir.find(".byte4 42"), std::string::npos) << bir;
}

TEST_F(Driver, AssemblyMayStandInAHeader) {
  write("ones.h",
        "static inline int ones(int x) {\n  __asm__(\"%h0 = ONES %1; %0 = %h0 (Z);\" : \"=d\"(x) : "
        "\"d\"(x));\n  return x;\n}\n");
  const std::string bir = compile("#include \"ones.h\"\nint f(int x) { return ones(x); }\n");
  EXPECT_NE(bir.find("ONES R"), std::string::npos) << bir;
}

TEST_F(Driver, WhatClangSaysIsSaidOnce) {
  write("nop.h", "static inline void nop(void) { __asm__(\"NOP;\" : : : \"P0\"); }\n");
  for (const char* header : {"", "#include \"nop.h\"\nvoid g(void) { nop(); }\n"}) {
    write("warned.c", std::string(header) + "int f(void) { int unused; return 1; }\n");
    const Finished warned = cc({"warned.c"});
    EXPECT_EQ(warned.exit_code, 0) << warned.err;
    EXPECT_EQ(count(warned.err, "warning: unused variable"), 1) << warned.err;
    write("wrong.c", std::string(header) + "int f(void) { int unused; return x; }\n");
    const Finished wrong = cc({"wrong.c"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_EQ(count(wrong.err, "error: use of undeclared"), 1) << wrong.err;
  }
}

TEST_F(Driver, TheSameInputsGiveTheSameBytes) {
  const std::string first = compile(kSmall);
  EXPECT_EQ(compile(kSmall), first);
  EXPECT_FALSE(first.empty());
}

TEST_F(Driver, FilesBeginWithTheirVersionAndSource) {
  const std::string bir = compile(kSmall);
  EXPECT_EQ(bir.rfind(".bir 1\n.file 1 \"unit.c\"\n", 0), 0U) << bir;
}

TEST_F(Driver, LinesOfTheSourceAreInTheOutput) {
  const std::string bir = compile("int f(int *p) {\n  p[0] = 1;\n  return p[1];\n}\n");
  EXPECT_NE(bir.find(".loc 1 2 "), std::string::npos) << bir;
  EXPECT_NE(bir.find(".loc 1 3 "), std::string::npos) << bir;
}

TEST_F(Driver, LinesOfHeadersNameTheirOwnFile) {
  write("inline.h", "static inline int get(volatile int *p) {\n  return *p;\n}\n");
  const std::string bir =
      compile("#include \"inline.h\"\nint f(volatile int *p) { return get(p) + 1; }\n");
  EXPECT_NE(bir.find(".file 2 \"./inline.h\""), std::string::npos) << bir;
  EXPECT_NE(bir.find(".loc 2 2 "), std::string::npos) << bir;
}

TEST_F(Driver, ObjectsKeepSectionSizeAndAlignment) {
  const std::string bir = compile(
      "const short table[3] = {1, -2, 3};\n"
      "static int hidden[2] __attribute__((used));\n"
      "int shown = 7;\n"
      "char fast[100] __attribute__((section(\".l1.data\"), aligned(32)));\n");
  EXPECT_NE(bir.find(".section .rodata\n.global _table\n.type _table, @object"), std::string::npos);
  EXPECT_NE(bir.find(".size _table, 6"), std::string::npos);
  EXPECT_EQ(bir.find(".global _hidden"), std::string::npos);
  EXPECT_NE(bir.find(".type _hidden, @object"), std::string::npos);
  EXPECT_NE(bir.find(".data\n.global _shown"), std::string::npos) << bir;
  EXPECT_NE(bir.find(".section .l1.data\n.global _fast\n.type _fast, @object\n.align 32"),
            std::string::npos)
      << bir;
}

}  // namespace
}  // namespace finback::compiler
