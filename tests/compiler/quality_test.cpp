// That the machine's strengths are used: hardware loops, stepping accesses, ONES, packets, banks.
#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class Quality : public CompilerTest {};

// The code of a function's first hardware loop.
std::string loop_of(const std::string& body) {
  const size_t setup = body.find("LSETUP (");
  const size_t top = setup == std::string::npos ? setup : body.find('.', setup);
  if (top == std::string::npos)
    return "";
  const std::string begin = body.substr(top, body.find(',', top) - top) + ":";
  const size_t last = body.find(".L", top + 2);
  const std::string end = body.substr(last, body.find(')', last) - last) + ":";
  const size_t from = body.find("\n" + begin);
  return body.substr(from, body.find(';', body.find("\n" + end)) + 1 - from);
}

// The loads of the next pass stand beside the arithmetic of this one, the second one through an I
// register: a packet a product.
TEST_F(Quality, SmallLoopsLoadAhead) {
  const std::string loop = loop_of(
      function_of(compile("int f(const short *x, const short *y, int n) {\n  int s = 0;\n"
                          "  for (int i = 0; i < n; i++) s += x[i] * y[-i];\n  return s;\n}\n"),
                  "f"));
  EXPECT_EQ(count(loop, ";"), 1) << loop;
  EXPECT_EQ(count(loop, "A0 += R1.L * R0.L (IS) || R0 = W[P0++] (X) || R1.L = W[I"), 1) << loop;
}

// W[I0++] does not extend: where the upper half is read, a load through a P register makes it.
TEST_F(Quality, SignedHalvesThatAreReadInFullKeepOffTheIRegisters) {
  const auto loop_over = [&](const std::string& type) {
    return loop_of(function_of(
        compile("int f(const " + type + " *x, const " + type + " *y, int n) {\n  int s = 0;\n" +
                "  for (int i = 0; i < n; i++) s += x[i] < y[i];\n  return s;\n}\n"),
        "f"));
  };
  EXPECT_EQ(count(loop_over("int"), "[I"), 1) << loop_over("int");
  EXPECT_EQ(count(loop_over("short"), "[I"), 0) << loop_over("short");
}

TEST_F(Quality, HandlersKeepOffTheIRegisters) {
  const auto body_of = [&](const std::string& kind) {
    return function_of(compile("#include <finback/blackfin.h>\nextern int a[9], b[9];\n" + kind +
                               " void f(void) {\n  for (int i = 0; i < 9; i++) {\n"
                               "    int t = a[i];\n    a[i] = b[i];\n    b[i] = t;\n  }\n}\n"),
                       "f");
  };
  EXPECT_GE(count(body_of(""), "[I"), 1) << body_of("");
  EXPECT_EQ(count(body_of("FINBACK_INTERRUPT"), "[I"), 0) << body_of("FINBACK_INTERRUPT");
}

// The store of one pass beside the load of the next.
TEST_F(Quality, CopyLoopIsOnePacket) {
  const std::string loop = loop_of(
      function_of(compile("void copy(unsigned *restrict d, const unsigned *restrict s, int n) {\n"
                          "  for (int i = 0; i < n; i++) d[i] = s[i];\n}\n"),
                  "copy"));
  EXPECT_EQ(count(loop, ";"), 1) << loop;
  EXPECT_EQ(count(loop, "MNOP || "), 1) << loop;
}

// What is stored may be what the next pass loads.
TEST_F(Quality, CopyLoopOverItselfIsAHardwareLoopOfTwoInstructions) {
  const std::string loop =
      loop_of(function_of(compile("void copy(unsigned *d, const unsigned *s, int n) {\n"
                                  "  for (int i = 0; i < n; i++) d[i] = s[i];\n}\n"),
                          "copy"));
  EXPECT_EQ(count(loop, ";"), 2) << loop;
  EXPECT_EQ(count(loop, "++]"), 2) << loop;
}

// The score of the last pass beside the next distance: 12 instructions, one of which issues alone,
// in five packets.
TEST_F(Quality, PassesOfALoopOverlap) {
  const std::string text =
      "void f(unsigned l, const unsigned short *restrict r, unsigned short *restrict u,\n"
      "       unsigned short *restrict o, unsigned short *restrict s) {\n"
      "  for (int k = 0; k < 31; k++) {\n"
      "    unsigned n = (unsigned)__builtin_popcount(l ^ *r--), sum = *u + n - *o;\n"
      "    *o++ = (unsigned short)n;\n    *u++ = (unsigned short)sum;\n"
      "    *s = (unsigned short)(*s + sum);\n    s++;\n  }\n}\n";
  const std::string fast = loop_of(function_of(compile(text), "f"));
  EXPECT_EQ(count(fast, ";"), 5) << fast;
  EXPECT_EQ(count(fast, "= W[") + count(fast, "] = "), 7) << fast;
  const std::string small = function_of(compile("__attribute__((minsize)) " + text), "f");
  EXPECT_EQ(count(small, "ONES"), 1) << small;
}

TEST_F(Quality, AccessesAtDistancesStepTheirPointers) {
  const std::string text = compile(
      "void both(int *restrict d, const int *restrict s, int n) {\n"
      "  for (int i = 0; i < n; i++, d += 2, s++) { d[1] = s[0] - s[128]; d[0] = s[0]; }\n}\n"
      "void apart(int *d, const int *s, int n) {\n"
      "  for (int i = 0; i < n; i++, d += 2) { d[1] = *s++; d[0] = *s++; }\n}\n");
  const std::string loop = loop_of(function_of(text, "both"));
  EXPECT_EQ(count(loop, "++]"), 4) << text;
  EXPECT_EQ(count(loop, "+="), 0) << text;
  EXPECT_EQ(count(loop_of(function_of(text, "apart")), "+= 8"), 1) << "who knows?\n" << text;
}

// restrict of a function that is inlined once before a loop holds in all its rounds; of one that is
// inlined into the loop it holds in a round.
TEST_F(Quality, RestrictOfInlinedFunctionsLetsPassesOverlap) {
  const std::string functions =
      "static inline void copy(unsigned *restrict d, const unsigned *restrict s, int n) {\n"
      "  for (int i = 0; i < n; i++) d[i] = s[i];\n}\n"
      "static inline void one(unsigned *restrict d, const unsigned *restrict s) { *d = *s; }\n";
  const std::string outside =
      compile(functions + "void f(unsigned *d, unsigned *s, int n) { copy(d, s, n); }\n");
  EXPECT_EQ(count(function_of(outside, "f"), " = [P"), 2) << "ahead, and in the loop\n" << outside;
  const std::string inside = compile(functions +
                                     "void f(unsigned *d, unsigned *s, int n) {\n"
                                     "  for (int i = 0; i < n; i++) one(d + i, s + i);\n}\n");
  EXPECT_EQ(count(function_of(inside, "f"), " = [P"), 1) << inside;
}

// A shift, RND, and no limit in a register; a sum that wraps says nothing of its limits.
TEST_F(Quality, SaturatedShiftsAreTwoInstructions) {
  const std::string text = compile(
      "short f(int x) {\n  int r = (x + 16384) >> 15;\n"
      "  return r > 32767 ? 32767 : r < -32768 ? -32768 : (short)r;\n}\n"
      "short g(unsigned x) {\n  int r = (int)(x + 16384u) >> 15;\n"
      "  return r > 32767 ? 32767 : r < -32768 ? -32768 : (short)r;\n}\n");
  const std::string fraction = function_of(text, "f");
  EXPECT_EQ(count(fraction, "<< 1 (S)"), 1) << text;
  EXPECT_EQ(count(fraction, "(RND)"), 1) << text;
  EXPECT_EQ(count(fraction, "MAX"), 0) << text;
  EXPECT_EQ(count(function_of(text, "g"), "(RND)"), 0) << text;
}

TEST_F(Quality, NestedLoopsUseBothCounters) {
  const std::string body = function_of(
      compile("int sum(const unsigned char m[20][30]) {\n  int s = 0;\n"
              "  for (int i = 0; i < 20; i++)\n    for (int j = 0; j < 30; j++) s += m[i][j];\n"
              "  return s;\n}\n"),
      "sum");
  EXPECT_EQ(count(body, "LC0 ="), 1) << body;
  EXPECT_EQ(count(body, "LC1 ="), 1) << body;
  EXPECT_EQ(count(body, "JUMP"), 0) << body;
}

TEST_F(Quality, SumsOfProductsLiveInAccumulators) {
  const std::string body = function_of(
      compile("int f(const short *x, const short *y, int n) {\n  int s = 0, t = 0;\n"
              "  for (int i = 0; i < n; i++) {\n    s += x[i] * y[i];\n    t += y[i] * y[i];\n  }\n"
              "  return s ^ t;\n}\n"),
      "f");
  EXPECT_EQ(count(loop_of(body), "A0 +="), 1) << body;
  EXPECT_EQ(count(loop_of(body), "A1 +="), 1) << body;
}

// The accumulator saturates where C wraps, and a handler would have to save it.
TEST_F(Quality, SumsThatWrapAndHandlersKeepOffTheAccumulators) {
  const std::string text = compile(
      "#include <finback/blackfin.h>\nextern short a[], b[];\nextern volatile int out;\n"
      "unsigned wrap(int n) {\n  unsigned s = 0;\n"
      "  for (int i = 0; i < n; i++) s += (unsigned)(a[i] * b[-i]);\n  return s;\n}\n"
      "FINBACK_INTERRUPT void handler(void) {\n  int s = 0;\n"
      "  for (int i = 0; i < 9; i++) s += a[i] * b[i];\n  out = s;\n}\n");
  EXPECT_EQ(count(function_of(text, "wrap"), "A0"), 0) << text;
  EXPECT_EQ(count(function_of(text, "handler"), "A0"), 0) << text;
}

TEST_F(Quality, SwitchesOfEightJumpThroughATable) {
  const std::string text = compile(
      "int g(int);\nint f(int n) {\n  switch (n) {\n    case 0: return g(1);\n    case 1: return "
      "n;\n"
      "    case 2: return g(9);\n    case 3: return -n;\n    case 4: return g(7);\n"
      "    case 5: return n * n;\n    case 6: return g(2);\n    case 7: return ~n;\n  }\n"
      "  return 0;\n}\n");
  EXPECT_EQ(count(function_of(text, "f"), "JUMP (P"), 1) << text;
  EXPECT_EQ(count(text, ".type _f.jumps0, @object"), 1) << text;
}

TEST_F(Quality, LoopsWithCallsKeepOffTheCounters) {
  const std::string body = function_of(
      compile("void g(int);\nvoid f(int n) {\n  for (int i = 0; i < n; i++) g(i);\n}\n"), "f");
  EXPECT_EQ(count(body, "LSETUP"), 0) << body;
}

TEST_F(Quality, DivisionInALoopIsACall) {
  const std::string body = function_of(compile("void f(unsigned *p, int n, unsigned d) {\n  for "
                                               "(int i = 0; i < n; i++) p[i] /= d;\n}\n"),
                                       "f");
  EXPECT_EQ(count(body, "LSETUP"), 0) << body;
  EXPECT_EQ(count(body, "CALL ___udivsi3"), 1) << body;
}

TEST_F(Quality, PopcountIsOnesInAPacket) {
  const std::string body = function_of(
      compile("unsigned f(const unsigned short *a, const unsigned short *b, int n) {\n  unsigned s "
              "= 0;\n"
              "  while (n--) s += (unsigned)__builtin_popcount(*a++ ^ *b++);\n  return s;\n}\n"),
      "f");
  EXPECT_EQ(count(body, "LSETUP"), 1) << body;
  EXPECT_EQ(count(loop_of(body), "ONES"), 1) << body;
  EXPECT_EQ(count(loop_of(body), " = 0 (X)"), 0) << "one zero serves all\n" << body;
}

TEST_F(Quality, ArithmeticSharesPacketsWithAccesses) {
  const std::string body = function_of(
      compile(
          "void f(short *restrict d, const short *restrict a, const short *restrict b, int n) {\n"
          "  for (int i = 0; i < n; i++) d[i] = (short)(a[i] + b[i] + 3 * d[i]);\n}\n"),
      "f");
  EXPECT_GE(count(body, "||"), 2) << body;
}

TEST_F(Quality, ShortProductsTakeOneCycle) {
  const std::string body =
      function_of(compile("int dot(const short *a, const short *b, int n) {\n  int s = 0;\n"
                          "  while (n--) s += *a++ * *b++;\n  return s;\n}\n"),
                  "dot");
  EXPECT_EQ(count(loop_of(body), "(IS)"), 1) << body;
  EXPECT_EQ(count(body, "*="), 0) << body;
}

TEST_F(Quality, AddressesAreComputedInPointerRegisters) {
  const std::string body =
      function_of(compile("extern int *rows[];\nint f(int n) { return rows[n][3]; }\n"), "f");
  EXPECT_EQ(count(body, "<< 2)"), 1) << body;
  EXPECT_NE(body.find("+ 12]"), std::string::npos) << body;
}

TEST_F(Quality, SelectionIsAPredicatedMove) {
  const std::string body =
      function_of(compile("unsigned f(unsigned a, unsigned b) { return a < b ? a : b; }\n"), "f");
  EXPECT_EQ(count(body, "IF "), 1) << body;
  EXPECT_EQ(count(body, "JUMP"), 0) << body;
}

TEST_F(Quality, LeavesNeedNoFrame) {
  const std::string body =
      function_of(compile("int f(int a, int b, int c, int d) { return a + b * c - d; }\n"), "f");
  EXPECT_EQ(count(body, "LINK"), 0) << body;
  EXPECT_EQ(count(body, "[--SP]"), 0) << body;
}

TEST_F(Quality, LikelyBranchesArePredicted) {
  const std::string body = function_of(
      compile("int f(const char *p) {\n  int n = 0;\n  while (p[n] != 7) n++;\n  return n;\n}\n"),
      "f");
  EXPECT_EQ(count(body, "(BP)"), 1) << body;
}

// A hardware loop's layout writes the branches in it anew; what goes round is predicted all the
// same.
TEST_F(Quality, BranchesInHardwareLoopsArePredicted) {
  const std::string body = function_of(
      compile("void f(int *a, int n) {\n  for (int i = 1; i < n; i++) {\n"
              "    int v = a[i], *to = a + i;\n"
              "    while (to > a && to[-1] > v) {\n      *to = to[-1];\n      --to;\n    }\n"
              "    *to = v;\n  }\n}\n"),
      "f");
  EXPECT_EQ(count(body, "LSETUP"), 1) << body;
  EXPECT_EQ(count(body, "(BP)"), 1) << body;
}

// Four rounds of a search, each with its question; what waits for another core's word stays.
TEST_F(Quality, SearchesTakeFourRoundsAtATime) {
  const std::string text = compile(
      "int *f(int *p, int v) { while (*p < v) p++; return p; }\n"
      "int *g(int *p, int v) { while (*(volatile int *)p < v) p++; return p; }\n");
  const std::string body = function_of(text, "f");
  EXPECT_EQ(count(body, "CC = "), 4) << body;
  EXPECT_EQ(count(body, "(BP)"), 1) << body;
  EXPECT_EQ(count(body, "IF !CC JUMP"), 3) << body;
  EXPECT_EQ(count(function_of(text, "g"), "CC = "), 1) << text;
}

// A call in return position is a jump, but where arguments lie on the stack or point to it.
TEST_F(Quality, LastCallsAreJumps) {
  const std::string text = compile(
      "int g(int a, int b), h(int a, int b, int c, int d), k(int *p);\n"
      "int f(int a) { return g(a + 1, 2); }\n"
      "int on_stack(int a) { return h(a, a, a, a); }\n"
      "int of_local(int a) { return k(&a); }\n"
      "int and_more(int a) { return g(a, a) + 1; }\n");
  EXPECT_EQ(count(function_of(text, "f"), "JUMP _g"), 1) << text;
  EXPECT_EQ(count(function_of(text, "f"), "LINK"), 0) << text;
  EXPECT_EQ(count(function_of(text, "on_stack"), "CALL"), 1) << text;
  EXPECT_EQ(count(function_of(text, "of_local"), "CALL"), 1) << text;
  EXPECT_EQ(count(function_of(text, "and_more"), "CALL"), 1) << text;
}

// Four bytes at a pointer that the loop loads: two short steps, one addition; 16 operations.
TEST_F(Quality, NeighboursAtALoadedPointerFitPackets) {
  const Finished compiled =
      cc({"-O2", "-o", "rectify.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/rectify_row.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string loop = loop_of(function_of(read("rectify.bir"), "rectify_row"));
  EXPECT_EQ(count(loop, ";"), 17) << loop;
  EXPECT_EQ(count(loop, "257]"), 0) << loop;
}

// Butterflies in three packets; what the groups go on with stays in its I registers.
TEST_F(Quality, PointersStayInTheirIRegisters) {
  const Finished compiled =
      cc({"-O2", "-o", "fft.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/fft256.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string body = function_of(read("fft.bir"), "fft256");
  const size_t inner = body.find("LC1 = ");
  ASSERT_NE(inner, std::string::npos) << body;
  const std::string loop = body.substr(inner, body.find(".LBB0_7:") - inner);
  EXPECT_EQ(count(loop, ";"), 4) << "LSETUP and three packets\n" << loop;
  const std::string group = body.substr(body.find(".LBB0_4:"), inner - body.find(".LBB0_4:"));
  EXPECT_EQ(count(group, " I0 = ") + count(group, " I1 = "), 0) << group;
}

// Sixteen products of a pair of columns, without a loop of their own.
TEST_F(Quality, ShortSumsAreWrittenOut) {
  const Finished compiled =
      cc({"-O2", "-o", "matrix.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/matrix_multiply.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string body = function_of(read("matrix.bir"), "matrix_multiply");
  const size_t pairs = body.rfind("LSETUP");
  // The sums begin with their first products and come with their last ones.
  EXPECT_EQ(count(body.substr(pairs), "A1 = R"), 1) << body;
  EXPECT_EQ(count(body.substr(pairs), "A1 += "), 15) << body;
  EXPECT_EQ(count(body.substr(pairs), "(A1 += "), 1) << body;
  EXPECT_EQ(count(body.substr(pairs), ".W;"), 0) << body;
}

// One pointer through all rows of the product, where the inner loop ends; only the factor's row is
// stepped on.
TEST_F(Quality, RowsGoOnWhereTheInnerLoopEnds) {
  const Finished compiled =
      cc({"-O2", "-o", "matrix.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/matrix_multiply.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string body = function_of(read("matrix.bir"), "matrix_multiply");
  EXPECT_EQ(count(body.substr(body.rfind("LSETUP")), "+= 32;"), 1) << body;
}

// A filter's window and its taps: no count is asked for in each round, and one pointer serves both
// of a round's places in the samples.
TEST_F(Quality, RoundsOfAFilterAskNothing) {
  const Finished compiled =
      cc({"-O2", "-o", "fir.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/fir.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string body = function_of(read("fir.bir"), "fir");
  const std::string outer = body.substr(body.find("LC0 = "));
  const std::string round = outer.substr(0, outer.find("(RND)"));
  EXPECT_EQ(count(round, "LC1 = "), 1) << body;
  EXPECT_EQ(count(round, "CC = "), 0) << body;
  EXPECT_EQ(count(round, "+= 4;"), 1) << body;
}

// What a search leads to is said by the pointer that it reads with.
TEST_F(Quality, SearchesStepOnePointer) {
  const Finished compiled =
      cc({"-O2", "-o", "sort.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/quicksort.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string body = function_of(read("sort.bir"), "quicksort");
  const size_t down = body.find("- 4];");
  const std::string search = body.substr(down, body.find("(BP)", down) - down);
  EXPECT_EQ(count(search, "- 4];"), 4) << body;
  EXPECT_EQ(count(search, "+= -4;"), 4) << body;
}

// Two loops become a call; one whose sum is wanted in each round stays.
TEST_F(Quality, SumsOfAbsoluteDifferencesAreOneCall) {
  const std::string text = compile(
      "int block(const unsigned char *a, const unsigned char *b, int step) {\n  int s = 0;\n"
      "  for (int y = 0; y < 16; y++, a += step, b += step)\n"
      "    for (int x = 0; x < 16; x++) s += __builtin_abs(a[x] - b[x]);\n  return s;\n}\n"
      "int until(const unsigned char *a, const unsigned char *b, int limit) {\n  int s = 0;\n"
      "  for (int x = 0; x < 16; x++)\n"
      "    if ((s += __builtin_abs(a[x] - b[x])) > limit) return x;\n  return s;\n}\n");
  EXPECT_EQ(count(function_of(text, "block"), "JUMP ___absolute_differences"), 1) << text;
  EXPECT_EQ(count(function_of(text, "block"), "LSETUP"), 0) << text;
  EXPECT_EQ(count(function_of(text, "until"), "CALL"), 0) << text;
}

// A census: each comparison's outcome is rotated in; the row's window is read byte by byte, and its
// values keep their registers.
TEST_F(Quality, FlagsAreRotatedIntoStrings) {
  const Finished compiled =
      cc({"-O2", "-o", "census.bir", FINBACK_SOURCE_DIR "/benchmarks/compiler/census_row.c"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const std::string loop = loop_of(function_of(read("census.bir"), "census_row"));
  EXPECT_EQ(count(loop, " = ROT "), 14) << "eight flags, two rounds\n" << loop;
  EXPECT_EQ(count(loop, " | "), 0) << loop;
  EXPECT_GE(count(loop, "++]"), 6) << loop;
}

TEST_F(Quality, AbsIsOneInstructionWhereTheSmallestIntegerCannotCome) {
  const std::string text = compile(
      "int f(short a, short b) { return __builtin_abs(a - b); }\n"
      "int g(int a) { return __builtin_abs(a); }\n");
  EXPECT_EQ(count(function_of(text, "f"), "ABS"), 1) << text;
  EXPECT_EQ(count(function_of(text, "g"), "ABS"), 0) << text;
}

}  // namespace
}  // namespace finback::compiler
