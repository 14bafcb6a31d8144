// That products of halves take one cycle, two of them where both multipliers can be used. Their
// values: programs/products_in_pairs.c and programs/sums_of_products.c.
#include <sstream>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class Products : public CompilerTest {};

// How many lines have two products and `accesses` loads or stores beside them.
int pairs_with(const std::string& body, int accesses) {
  std::istringstream lines(body);
  std::string line;
  int found = 0;
  while (std::getline(lines, line))
    if (count(line, "A1 ") == 1 && count(line, ", A0 ") == 1 && count(line, "NOP") == 0 &&
        count(line, "||") == accesses)
      ++found;
  return found;
}

TEST_F(Products, FactorsAreHalvesOfRegisters) {
  const std::string text = compile(
      "int low_high(int x, int y) { return (short)x * (y >> 16); }\n"
      "unsigned highs(unsigned x, unsigned y) { return (x >> 16) * (y >> 16); }\n"
      "int times9(int x) { return x * 9; }\n");
  EXPECT_EQ(count(function_of(text, "low_high"), "R0 = R0.L * R1.H (IS);"), 1) << text;
  EXPECT_EQ(count(function_of(text, "low_high"), ";"), 2) << text;
  EXPECT_EQ(count(function_of(text, "highs"), ".H * R"), 1) << text;
  EXPECT_EQ(count(function_of(text, "times9"), "*"), 0) << text;
}

// Both factors as words: a packet for two products.
TEST_F(Products, TwoOfASumTakeAPacket) {
  const std::string text = compile(
      "int f(const short *x, const short *y, int n) {\n  int s = 0;\n"
      "  for (int i = 0; i < n; i++) s += x[i] * y[i];\n  return s;\n}\n");
  EXPECT_EQ(pairs_with(function_of(text, "f"), 2), 1) << text;
  EXPECT_EQ(count(text, "= 511 (X)"), 1) << "40 bits hold no more\n" << text;
  EXPECT_EQ(count(text, "= 3 (X)"), 1) << "words lie at multiples of 4\n" << text;
}

TEST_F(Products, WhatIsKnownIsNotTested) {
  const std::string body =
      function_of(compile("static short x[1000] __attribute__((aligned(4)));\n"
                          "static short y[1000] __attribute__((aligned(4)));\n"
                          "void fill(short *x, short *y);\nvoid set(void) { fill(x, y); }\n"
                          "int f(void) {\n  int s = 0;\n"
                          "  for (int i = 0; i < 1000; i++) s += x[i] * y[i];\n  return s;\n}\n"),
                  "f");
  EXPECT_EQ(pairs_with(body, 2), 1) << body;
  EXPECT_EQ(count(body, "JUMP"), 0) << body;
}

// Neighbours in a row of the result share the other factor.
TEST_F(Products, ColumnsAreTakenTwoAtATime) {
  const std::string body = function_of(
      compile("void f(const short a[restrict 16][16], const short b[restrict 16][16],\n"
              "       int p[restrict 16][16]) {\n"
              "  for (int i = 0; i < 16; i++)\n    for (int j = 0; j < 16; j++) {\n"
              "      int s = 0;\n      for (int k = 0; k < 16; k++) s += a[i][k] * b[k][j];\n"
              "      p[i][j] = s;\n    }\n}\n"),
      "f");
  // Eight rounds, written out: a row's two factors and two pairs of columns each.
  EXPECT_GE(count(body, ", A0 +="), 16) << body;
  EXPECT_GE(pairs_with(body, 2), 7) << body;
}

TEST_F(Products, ColumnsAreReadByStrides) {
  const std::string body =
      function_of(compile("int f(const int m[9][20]) {\n  int s = 0;\n"
                          "  for (int i = 0; i < 9; i++) s ^= m[i][3];\n  return s;\n}\n"),
                  "f");
  EXPECT_GE(count(body, " ++ P"), 1) << body;
}

constexpr const char* kFilter =
    "  for (int i = 0; i < n; i++) {\n    int s = 0;\n"
    "    for (int k = 0; k < taps; k++) s += t[k] * x[i + k];\n    y[i] = (short)(s >> 15);\n"
    "  }\n}\n";

TEST_F(Products, FiltersSumUpTwoOutputsTogether) {
  const std::string text = compile(
      std::string("void f(const short *restrict x, const short *restrict t, short *restrict y,\n"
                  "       int n, int taps) {\n") +
      kFilter);
  EXPECT_GE(count(text, ".L, A0 += "), 1) << text;
  EXPECT_GE(count(text, ".H, A0 += "), 1) << text;
  EXPECT_GE(count(text, ".L = W[P"), 1) << "halves are loaded where they are wanted\n" << text;
  EXPECT_EQ(count(text, "PACK"), 0) << text;
}

// Whether the taps are even in number is asked in front of the outputs: an outer loop for each
// answer, without a branch behind its inner loop.
TEST_F(Products, WhatAllOutputsAnswerAlikeIsAskedOnce) {
  const std::string text = compile(
      std::string("void f(const short *restrict x, const short *restrict t, short *restrict y,\n"
                  "       int n, int taps) {\n") +
      kFilter);
  EXPECT_EQ(count(text, "), R2 = (A0 += "), 2) << "two sums come with their last products\n"
                                               << text;
  EXPECT_EQ(count(text, " + 2] = R"), 0) << "both stores step\n" << text;
}

// y may be what x is: each output has to be there before the next one is begun.
TEST_F(Products, OutputsThatMayBeReadAreNotSummedUpTogether) {
  const std::string text =
      compile(std::string("void f(const short *x, const short *t, short *y, int n, int taps) {\n") +
              kFilter);
  EXPECT_EQ(count(text, ", A0 += R"), 2) << "those of one output: ahead, and the last\n" << text;
  EXPECT_EQ(count(text, ".H = W"), 0) << text;
}

TEST_F(Products, SizeComesFirstWhereAskedFor) {
  write("unit.c",
        "int f(const short *x, const short *y, int n) {\n  int s = 0;\n"
        "  for (int i = 0; i < n; i++) s += x[i] * y[i];\n  return s;\n}\n");
  ASSERT_EQ(cc({"-Os", "-o", "unit.bir", "unit.c"}).exit_code, 0);
  EXPECT_EQ(count(read("unit.bir"), "A0 += "), 1);
  EXPECT_EQ(count(read("unit.bir"), "A1"), 0);
}

// The middle end's (a + b)(a - b) goes back to two products of halves; the sum is read with the
// last.
TEST_F(Products, DifferencesOfSquaresAreAddedAndTakenOff) {
  const std::string body = function_of(
      compile("void f(const short *restrict x, int *restrict y, int n) {\n  int s = 0;\n"
              "  for (int i = 0; i < n; i++) {\n    int in = x[i + 9], out = x[i];\n"
              "    s += in * in - out * out;\n    y[i] = s;\n  }\n}\n"),
      "f");
  EXPECT_GE(count(body, "A0 += "), 1) << body;
  // The first of all is no addition.
  EXPECT_EQ(count(body, "(A0 -= "), count(body, "A0 += ") + count(body, "A0 = R")) << body;
  EXPECT_EQ(count(body, "*="), 0) << body;
}

// Of a word's product only bits are wanted that the low halves decide.
TEST_F(Products, LowHalvesOfProductsTakeOneCycle) {
  const std::string text = compile(
      "unsigned char low(int a, int b) { return (unsigned char)(a * b >> 8); }\n"
      "unsigned char high(int a, int b) { return (unsigned char)(a * b >> 9); }\n");
  EXPECT_EQ(count(function_of(text, "low"), ".L * R"), 1) << text;
  EXPECT_EQ(count(function_of(text, "high"), "*="), 1) << text;
}

}  // namespace
}  // namespace finback::compiler
