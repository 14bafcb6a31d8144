// The runtime as a program meets it, where the host's library does something else: ends of
// programs, the heap's size, what is not there. And which operations on floats need no call.
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
