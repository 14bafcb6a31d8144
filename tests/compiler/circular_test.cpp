// Circular buffers: which C runs on the address generators, what that costs, and that nothing of it
// is left behind. What they compute is asked by programs/circular_buffers.c.
#include <regex>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class Circular : public CompilerTest {};

std::string filter_stepping(const std::string& step, const std::string& start = "") {
  return "#include <ccblkfn.h>\nint f(const short *taps, const short *line, unsigned n, unsigned i,"
         " int count) {\n  int sum = 0;\n  " +
         start + ";\n  for (int k = 0; k < count; k++) {\n    sum += taps[k] * line[i];\n    " +
         step + ";\n  }\n  return sum;\n}\n";
}

// A packet a tap, with both loads, whatever C's way to go round.
TEST_F(Circular, DelayLinesAreOnePacketATap) {
  const std::regex tap(
      R"(:\n  \.loc [^\n]*\n  A0 \+= R\d\.L \* R\d\.L \(IS\) \|\| R\d = W\[P\d\+\+\] \(X\) \|\| R\d\.L = W\[I3(\+\+|--)\];)");
  for (const char* step :
       {"i = circindex(i, 1, n)", "if (++i == n) i = 0", "i = i + 1 < n ? i + 1 : 0",
        "i = (i + 1) % n", "i = i == 0 ? n - 1 : i - 1", "i = (i + 1) & 63", "i = (i - 1) & 63",
        "if (++i >= 50) i = 0", "i = i == 0 ? 49 : i - 1", "i = (i + 1) % 50"}) {
    const std::string body = function_of(compile(filter_stepping(step)), "f");
    EXPECT_TRUE(std::regex_search(body, tap)) << step << "\n" << body;
    EXPECT_EQ(count(body, "B3 = "), 1) << step << "\n" << body;
    EXPECT_EQ(count(body, "L3 = 0 (X);"), 1) << step << "\n" << body;
  }
}

TEST_F(Circular, PointersStepByTheirOwnRegister) {
  const std::string body = function_of(
      compile("#include <ccblkfn.h>\nint f(const int *x, int step, unsigned bytes, int count) {\n"
              "  int sum = 0;\n  for (const int *p = x; count > 0; count--) {\n    sum ^= *p;\n"
              "    p = circptr(p, step, x, bytes);\n  }\n  return sum;\n}\n"),
      "f");
  EXPECT_GE(count(body, " = [I3 ++ M3]"), 1) << body;
  EXPECT_EQ(count(body, "CC = "), 1) << body;  // is there a pass?
  EXPECT_EQ(count(body, "L3 = 0 (X);"), 1) << body;
}

// Where C does not say that the index begins within the circle it is asked, and the loop stands
// there twice; not at -Os.
TEST_F(Circular, AnIndexBeginsWithin) {
  const auto loops = [&](const std::string& start, const std::string& level = "-O2") {
    write("start.c", filter_stepping("if (++i == 40) i = 0", start));
    EXPECT_EQ(cc({level, "start.c"}).exit_code, 0);
    return count(read("start.bir"), "LSETUP");
  };
  EXPECT_EQ(loops(""), 2);
  EXPECT_EQ(loops("i = 0"), 1);
  EXPECT_EQ(loops("i %= 40"), 1);
  EXPECT_EQ(loops("if (i >= 40) return 0"), 1);
  EXPECT_EQ(loops("__builtin_assume(i < 40)"), 1);
  EXPECT_EQ(loops("", "-Os"), 1);
}

// Nor where the index is wanted for itself, in handlers, or beside calls.
TEST_F(Circular, ElsewhereCStaysAsItIs) {
  const auto rings = [&](const std::string& text) { return count(compile(text), "B3 = "); };
  EXPECT_EQ(rings(filter_stepping("i = (i + 1) & 63")), 1);
  EXPECT_EQ(rings(filter_stepping("sum ^= i; i = (i + 1) & 63")), 0);
  EXPECT_EQ(rings(filter_stepping("sum = sum / count; i = (i + 1) & 63")), 0);
  EXPECT_EQ(rings("#include <finback/blackfin.h>\nextern int x[8];\nint sum;\n"
                  "FINBACK_INTERRUPT void f(void) {\n  unsigned i = 3;\n"
                  "  for (int k = 0; k < 50; k++) {\n    sum += x[i];\n    i = (i + 1) & 7;\n"
                  "  }\n}\n"),
            0);
}

TEST_F(Circular, HandlersKeepWhatTheirAssemblyChanges) {
  const std::string body =
      function_of(compile("#include <finback/blackfin.h>\nvolatile int x;\n"
                          "FINBACK_INTERRUPT void tick(void) {\n"
                          "  __asm__ volatile(\"I0 = %0;\" : : \"d\"(x));\n}\n"),
                  "tick");
  for (const char* reg : {"I0", "M3", "B2", "L1", "A0.W", "R3"}) {
    EXPECT_EQ(count(body, std::string("[--SP] = ") + reg + ";"), 1) << reg << body;
    EXPECT_EQ(count(body, std::string(reg) + " = [SP++];"), 1) << reg << body;
  }
  EXPECT_EQ(count(body, "L0 = R3;"), 1) << body;
}

// Rings run on behind handlers that have rings of their own, or assembly.
constexpr const char* kInterruptedRings = R"(
#include <ccblkfn.h>
#define EVT13 (*(void (*volatile *)(void))0xFFE02034)
#define EVT14 (*(void (*volatile *)(void))0xFFE02038)
#define RESULT (*(volatile unsigned *)0xFFC0F01Cu)
static volatile unsigned ticks, work_done;
static int words[13];
static short halves[7];
__attribute__((noinline)) static unsigned around(const short *x, unsigned count) {
  unsigned s = 1, i = 5;
  for (unsigned k = 0; k < count; k++) {
    s = s * 31 + (unsigned)x[i];
    i = i == 0 ? 6 : i - 1;
  }
  return s;
}
FINBACK_INTERRUPT void call(void) { ticks += 1; work_done = around(halves, 9); }
FINBACK_INTERRUPT void assembly(void) {
  unsigned got;
  __asm__ volatile("I0 = %1; I1 = %1; I2 = %1; I3 = %1; R0 = [I0++]; R0 = [I1++]; R0 = [I2++];"
                   "R0 = [I3++]; %0 = I3;" : "=&d"(got) : "d"(words + 12) : "R0", "memory");
  work_done = got - (unsigned)words;
}
__attribute__((noinline)) static unsigned sum(unsigned n, int disturb) {
  unsigned s = 0;
  const int *p = words;
  const short *q = halves;
  for (unsigned i = 0; i < n; i++) {
    s = s * 3 + (unsigned)(*p ^ *q);
    p = (const int *)circptr(p, 20, words, sizeof words);
    q = (const short *)circptr(q, -2, halves, sizeof halves);
    if (disturb) { __builtin_bfin_raise(13); __builtin_bfin_raise(14); }
  }
  return s;
}
static unsigned lengths(void) {
  unsigned all;
  __asm__ volatile("%0 = L0; R0 = L1; %0 = %0 | R0; R0 = L2; %0 = %0 | R0; R0 = L3; %0 = %0 | R0;"
                   : "=&d"(all) : : "R0");
  return all;
}
int main(void) {
  EVT13 = assembly;
  EVT14 = call;
  for (int i = 0; i < 13; i++) words[i] = i * i;
  for (int i = 0; i < 7; i++) halves[i] = (short)(i * 5);
  unsigned calm = sum(40, 0);
  RESULT = lengths() == 0 ? 'y' : 'n';
  __builtin_bfin_sti(0x601F);
  unsigned disturbed = sum(40, 1);
  RESULT = calm == disturbed ? 'y' : 'n';
  RESULT = ticks == 40 ? 'y' : 'n';
  RESULT = work_done == around(halves, 9) || work_done == 52 ? 'y' : 'n';
  RESULT = lengths() == 0 ? 'y' : 'n';
  RESULT = '\n';
  return 0;
}
)";

TEST_F(Circular, InterruptedRingsGoOnAsIfNothingHadHappened) {
  write("rings.c", kInterruptedRings);
  const std::string text = compile(kInterruptedRings);
  EXPECT_EQ(count(text, "L3 = 0 (X);"), 2) << text;
  EXPECT_EQ(count(text, "L2 = 0 (X);"), 1) << text;
  for (const char* level : {"0", "2"}) {
    const Finished finished = execute("rings.c", level);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(finished.out, "yyyyy\n") << "-O" << level;
  }
}

}  // namespace
}  // namespace finback::compiler
