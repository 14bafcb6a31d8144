// The runtime as a program meets it, where the host's library does something else: ends of
// programs, the heap's size, what is not there. And which operations on floats need no call.
#include <fstream>
#include <sstream>
#include <vector>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class Runtime : public CompilerTest {
 protected:
  /// What a program does at -O2.
  [[nodiscard]] Finished outcome(std::string_view text) const {
    write("program.c", text);
    return execute("program.c", "2");
  }
};

TEST_F(Runtime, ExitEndsWithItsStatus) {
  const Finished finished = outcome(
      "#include <stdio.h>\n#include <stdlib.h>\n"
      "__attribute__((noinline)) void leave(void) { puts(\"leaving\"); exit(3); }\n"
      "int main(void) { leave(); puts(\"still here\"); return 0; }\n");
  EXPECT_EQ(finished.exit_code, 3) << finished.err;
  EXPECT_EQ(finished.out, "leaving\n");
}

TEST_F(Runtime, AbortEndsWithTheStatusOfAnAbort) {
  const Finished finished = outcome("#include <stdlib.h>\nint main(void) { abort(); }\n");
  EXPECT_NE(finished.err.find("status 134 "), std::string::npos) << finished.err;
}

TEST_F(Runtime, AnAssertionThatDoesNotHoldIsPrinted) {
  const Finished finished = outcome(
      "#include <assert.h>\nstatic_assert(sizeof(int) == 4, \"\");\n"
      "int main(void) {\n  volatile int x = 3;\n  assert(x == 3);\n  assert(x > 17);\n}\n");
  EXPECT_EQ(finished.out, "program.c:6: main: assertion failed: x > 17\n");
  EXPECT_NE(finished.err.find("status 134 "), std::string::npos) << finished.err;
}

TEST_F(Runtime, AssertionsCanBeLeftOut) {
  const Finished finished = outcome(
      "#define NDEBUG\n#include <assert.h>\nint main(void) {\n  assert(0);\n  return 5;\n}\n");
  EXPECT_EQ(finished.exit_code, 5) << finished.err;
}

constexpr const char* kCountBlocks =
    "#include <stdlib.h>\n%s\n"
    "int main(void) {\n  int blocks = 0;\n  while (malloc(1000) != NULL) ++blocks;\n"
    "  return blocks;\n}\n";

TEST_F(Runtime, TheHeapHasEightKilobytesUnlessAUnitChooses) {
  std::string text = kCountBlocks;
  const size_t at = text.find("%s");
  EXPECT_EQ(outcome(std::string(text).replace(at, 2, "")).exit_code, 8);
  EXPECT_EQ(outcome(std::string(text).replace(at, 2, "HEAP(40000);")).exit_code, 39);
}

TEST_F(Runtime, WhatIsNotThereIsNamedWhenItIsLinked) {
  const Finished finished =
      outcome("volatile float x = 2;\nint main(void) { return (int)__builtin_sqrtf(x); }\n");
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("refers to _sqrtf, which no unit"), std::string::npos)
      << finished.err;
}

TEST_F(Runtime, HeadersServeCppToo) {
  write("program.cpp",
        "#include <assert.h>\n#include <ctype.h>\n#include <setjmp.h>\n#include <stdio.h>\n"
        "#include <stdlib.h>\n#include <string.h>\nstatic_assert(sizeof(long) == 4, \"\");\n"
        "static jmp_buf place;\nint main() {\n  assert(strlen(\"abc\") == 3);\n"
        "  if (setjmp(place) == 0) longjmp(place, 1);\n"
        "  printf(\"%d %c %g\\n\", atoi(\"5\"), toupper('a'), 0.5);\n}\n");
  const Finished finished = execute("program.cpp", "2");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "5 A 0.5\n");
}

/// The numbers of a table's row that begins with `name`, as far as it has them.
std::vector<double> row_of(const std::string& page, const std::string& name) {
  const size_t at = page.find("\n| " + name + " |");
  std::vector<double> numbers;
  if (at == std::string::npos)
    return numbers;
  std::istringstream cells(page.substr(at + name.size() + 5, page.find('\n', at + 1) - at));
  for (std::string cell; std::getline(cells, cell, '|') && cell.find('\n') == std::string::npos;)
    if (cell.find_first_not_of(' ') != std::string::npos)
      numbers.push_back(std::stod(cell));
  return numbers;
}

TEST_F(Runtime, CostsWhatThePageSays) {
  std::ostringstream page;
  page << std::ifstream(std::string(FINBACK_SOURCE_DIR) + "/docs/runtime.md").rdbuf();
  const std::string source = std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/costs.c";
  for (const Copying copying : {Copying::plain, Copying::fast}) {
    const Finished finished = execute(source, "2", copying);
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_GE(count(finished.out, "\n"), 28);
    std::istringstream lines(finished.out);
    for (std::string line; std::getline(lines, line);) {
      const std::string name = line.substr(2, line.rfind(" | ", line.size() - 4) - 2);
      const std::vector<double> said = row_of(page.str(), name);
      const std::vector<double> measured = row_of("\n" + line, name);
      ASSERT_FALSE(said.empty() || measured.empty()) << line;
      const double wanted = copying == Copying::fast ? said.back() : said.front();
      EXPECT_NEAR(measured.front(), wanted, 0.15 * wanted) << line;
    }
  }
}

TEST_F(Runtime, BothUnitsThatCopyDoTheSame) {
  const std::string source = std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/programs/copies.c";
  const Finished plain = execute(source, "2");
  const Finished fast = execute(source, "2", Copying::fast);
  EXPECT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_EQ(fast.exit_code, 0) << fast.err;
  EXPECT_EQ(fast.out, plain.out);
  EXPECT_NE(fast.err, plain.err);  // other code: other cycles
}

TEST_F(Runtime, ArithmeticOfFloatsIsACallEach) {
  const std::string bir = compile(
      "float f(float a, float b) { return a * b + 1; }\n"
      "int g(double a, double b) { return a < b; }\n"
      "double h(unsigned a) { return a; }\n");
  EXPECT_EQ(count(function_of(bir, "f"), "CALL"), 2) << bir;
  EXPECT_EQ(count(function_of(bir, "f"), "CALL ___mulsf3"), 1) << bir;
  EXPECT_EQ(count(function_of(bir, "f"), "CALL ___addsf3"), 1) << bir;
  EXPECT_EQ(count(function_of(bir, "g"), "CALL ___ltdf2"), 1) << bir;
  EXPECT_EQ(count(function_of(bir, "h"), "CALL ___floatunsidf"), 1) << bir;
}

TEST_F(Runtime, SignsOfFloatsNeedNoCall) {
  const std::string bir = compile(
      "float negative(float a) { return -a; }\n"
      "double absolute(double a) { return __builtin_fabs(a); }\n"
      "int is_negative(float a) { return !!__builtin_signbit(a); }\n"
      "float choose(int which, float a, float b) { return which ? a : b; }\n");
  EXPECT_EQ(count(bir, "CALL"), 0) << bir;
}

}  // namespace
}  // namespace finback::compiler
