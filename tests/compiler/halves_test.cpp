// That loops over 16-bit arrays take two elements a round, where C lets them. Their values:
// programs/halves_in_pairs.c and random_halves_test.cpp.
#include <sstream>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class Halves : public CompilerTest {
 protected:
  /// The body of a function that stores `element` in each of z[0] to z[n - 1]; x and y are arrays,
  /// too.
  std::string loop_over(const std::string& element, const std::string& type = "short") const {
    return function_of(
        compile("#include <fract_math.h>\nstatic inline int limited(int x) {\n"
                "  return x > 32767 ? 32767 : x < -32768 ? -32768 : x;\n}\nvoid f(" +
                type + " *restrict z, const " + type + " *restrict x, const " + type +
                " *restrict y, int k, int n) {\n  for (int i = 0; i < n; i++) z[i] = " + element +
                ";\n}\n"),
        "f");
  }
};

TEST_F(Halves, AreTakenTwoAtATime) {
  for (const auto& [element, instruction] : std::vector<std::pair<std::string, std::string>>{
           {"x[i] + y[i]", " +|+ R"},
           {"x[i] - k", " -|- R"},
           {"x[i] < y[i] ? x[i] : y[i]", "= MIN("},
           {"x[i] > 7 ? x[i] : 7", "= MAX("},
           {"(x[i] >> 1) < 0 ? -(x[i] >> 1) : x[i] >> 1", "= ABS R"},
           {"x[i] >> 3", " >>> 3 (V)"},
           {"x[i] << 2", " << 2 (V)"},
           {"limited(x[i] + y[i])", " +|+ R"},
           {"sub_fr1x16(x[i], y[i])", " -|- R"},
           {"mult_fr1x16(x[i], y[i])", ".H * R"},
           {"limited(x[i] * y[i] >> 15)", ".H * R"},
           {"x[i] * 23170 >> 15", ".H * R"},
           {"(x[i] + y[i]) >> 1", " (ASR)"},
           {"x[i] > y[i] ? x[i] - y[i] : y[i] - x[i]", " -|- R"}}) {
    const std::string body = loop_over(element);
    EXPECT_GE(count(body, instruction), 1) << element << "\n" << body;
    EXPECT_GE(count(body, "= [P"), 1) << element << "\n" << body;
    EXPECT_EQ(count(body, "= 3 (X)"), 1) << "words lie at multiples of 4\n" << body;
  }
  EXPECT_GE(count(loop_over("x[i] >> 3", "unsigned short"), " >> 3 (V)"), 1);
}

// A round of two elements is as short as a word's: both loads in a packet, then the store beside
// the sum.
TEST_F(Halves, OfASumTakeTwoPacketsAPair) {
  const std::string body = loop_over("x[i] + y[i]");
  EXPECT_EQ(count(body, "MNOP || R2 = [P0++] || R1 = [I0++];"), 1) << body;
  EXPECT_EQ(count(body, "R0 = R2 +|+ R1 || [P1++] = R0 || NOP;"), 1) << body;
}

TEST_F(Halves, ThatAreKnownToBeAlignedAreNotTested) {
  const std::string body = function_of(
      compile("static short a[100], b[100];\nvoid fill(short *x);\nvoid set(void) { fill(a); }\n"
              "short *f(void) {\n  for (int i = 0; i < 100; i++) b[i] = -a[i];\n  return b;\n}\n"),
      "f");
  EXPECT_GE(count(body, "-|-"), 1) << body;
  EXPECT_EQ(count(body, "JUMP"), 0) << body;
}

TEST_F(Halves, AreTakenOneByOneWhereTwoWouldBeSomethingElse) {
  for (const char* element :
       {"x[i] * y[i]", "x[i] * y[i] >> 15", "x[i] + i", "x[i + 1] - x[i]", "x[2 * i] + 1",
        "x[i] + *(volatile const short *)&y[i]", "x[i] > k ? x[i] : k"})
    EXPECT_EQ(count(loop_over(element), "= [P0"), 0) << element << "\n" << loop_over(element);
  EXPECT_EQ(count(loop_over("x[i] < y[i] ? x[i] : y[i]", "unsigned short"), "(V)"), 0);
}

TEST_F(Halves, ArePairsOfExtremesToo) {
  const std::string body =
      function_of(compile("int f(const short *x, int n) {\n  int most = -1;\n"
                          "  for (int i = 0; i < n; i++) most = x[i] > most ? x[i] : most;\n"
                          "  return most;\n}\n"),
                  "f");
  EXPECT_EQ(count(body, "(V) || R2 = [P0++] || NOP;"), 1) << body;
  // One by one, the greatest so far is extended once, not in each round.
  EXPECT_EQ(count(body, "MAX(R0, R1) || R1 = W[P0++] (X) || NOP;"), 1) << body;
}

// Whether words are aligned is asked once for all rows, whose pointers go on without a product.
TEST_F(Halves, OfRowsAreTestedOnce) {
  const std::string body = function_of(
      compile("void f(short *restrict z, const short *restrict x, int width, int height) {\n"
              "  for (int row = 0; row < height; row++)\n"
              "    for (int i = 0; i < width; i++) z[row * width + i] = -x[row * width + i];\n}\n"),
      "f");
  EXPECT_GE(count(body, " -|- R"), 1) << body;
  EXPECT_EQ(count(body, "*="), 0) << body;
  EXPECT_EQ(count(body, "= 3 (X)"), 1) << body;
  EXPECT_LT(body.find("= 3 (X)"), body.find("LSETUP")) << body;
}

// What two and a half hundred elements more cost: a scalar loop takes two cycles for each and
// half a one where both loads meet in a sub-bank.
TEST_F(Halves, TakeAboutHalfTheCycles) {
  write(
      "cycles.c",
      "#include <stdio.h>\nshort a[512], b[512], c[512];\n"
      "static unsigned now(void) {\n  unsigned x;\n"
      "  __asm__ volatile(\"%0 = CYCLES;\" : \"=d\"(x) : : \"memory\");\n  return x;\n}\n"
      "__attribute__((noinline)) static unsigned add(short *restrict z, const short *restrict x,\n"
      "                                              const short *restrict y, int n) {\n"
      "  unsigned start = now();\n  for (int i = 0; i < n; i++) z[i] = x[i] + y[i];\n"
      "  return now() - start;\n}\n"
      "int main(void) {\n  unsigned few = add(c, a, b, 256);\n"
      "  few = add(c, a, b, 256);\n  unsigned pairs = add(c, a, b, 512) - few;\n"
      "  few = add(c, a + 1, b, 256);\n"
      "  printf(\"%u %u\\n\", pairs, add(c, a + 1, b, 511) - few);\n  return 0;\n}\n");
  const Finished finished = execute((folder() / "cycles.c").string(), "2");
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  std::istringstream out(finished.out);
  unsigned pairs = 0;
  unsigned singles = 0;
  out >> pairs >> singles;
  ASSERT_TRUE(out) << finished.out;
  EXPECT_GE(pairs, 2 * 128U);
  EXPECT_LE(pairs, 390U);  // three cycles a pair, measured
  EXPECT_GE(singles, 2 * 255U);
}

}  // namespace
}  // namespace finback::compiler
