// What has no counterpart on the host: instructions by name, interrupt handlers.
#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

class TargetOnly : public CompilerTest {};

TEST_F(TargetOnly, EveryNamedInstructionIsThere) {
  const std::string body = function_of(
      compile("#include <finback/blackfin.h>\n"
              "unsigned f(volatile unsigned char *lock, unsigned x) {\n"
              "  unsigned mask = __builtin_bfin_cli();\n  __builtin_bfin_csync();\n"
              "  __builtin_bfin_ssync();\n  int got = __builtin_bfin_testset(lock);\n"
              "  __builtin_bfin_raise(14);\n  __builtin_bfin_excpt(3);\n  __builtin_bfin_nop();\n"
              "  __builtin_bfin_sti(mask);\n  __builtin_bfin_idle();\n"
              "  return __builtin_bfin_ones(x) + (unsigned)got;\n}\n"),
      "f");
  size_t at = 0;
  for (const char* text : {"CLI R", "CSYNC;", "SSYNC;", "TESTSET (P", "RAISE 14;", "EXCPT 3;",
                           "NOP;", "STI R", "IDLE;"}) {
    size_t found = body.find(text, at);
    EXPECT_NE(found, std::string::npos) << text << " in\n" << body;
    at = found == std::string::npos ? at : found;
  }
  EXPECT_EQ(count(body, "ONES"), 1) << body;
  EXPECT_EQ(count(body, "CALL"), 0) << body;
}

TEST_F(TargetOnly, HandlersSaveWhatTheyTouchAndReturnByRti) {
  const std::string body =
      function_of(compile("#include <finback/blackfin.h>\nvolatile int ticks;\n"
                          "FINBACK_INTERRUPT void tick(void) { ticks++; }\n"),
                  "tick");
  EXPECT_EQ(count(body, "= ASTAT"), 1) << body;
  EXPECT_EQ(count(body, "ASTAT ="), 1) << body;
  EXPECT_EQ(count(body, "RTI;"), 1) << body;
  EXPECT_EQ(count(body, "RTS;"), 0) << body;
  EXPECT_EQ(count(body, "[--SP]"), count(body, "[SP++]")) << body;
}

TEST_F(TargetOnly, HandlersThatCallSaveEverything) {
  const std::string body = function_of(compile("#include <finback/blackfin.h>\nvoid work(void);\n"
                                               "FINBACK_INTERRUPT void tick(void) { work(); }\n"),
                                       "tick");
  for (const char* reg :
       {"LC0", "LC1", "LT0", "LB1", "I0", "M3", "B2", "L1", "A0.W", "A1.X", "R3", "P2"}) {
    EXPECT_EQ(count(body, std::string("[--SP] = ") + reg + ";"), 1) << reg << body;
    EXPECT_EQ(count(body, std::string(reg) + " = [SP++];"), 1) << reg << body;
  }
  EXPECT_EQ(count(body, "LINK 12;"), 1) << body;
}

constexpr const char* kInterrupted = R"(
#include <finback/blackfin.h>
#define EVT14 (*(void (*volatile *)(void))0xFFE02038)
#define RESULT (*(volatile unsigned *)0xFFC0F01Cu)
static volatile unsigned ticks, work_done;
__attribute__((noinline)) static unsigned scramble(unsigned n) {
  unsigned s = 1;
  for (unsigned i = 0; i < n; i++) s = s * 31 + i;
  return s;
}
FINBACK_INTERRUPT void tick(void) { ticks += 1; work_done = scramble(5); }
__attribute__((noinline)) static unsigned sum(unsigned n, int disturb) {
  unsigned s = 0;
  for (unsigned i = 0; i < n; i++) {
    for (unsigned k = 0; k < 4; k++) s = s * 3 + (i ^ k);
    if (disturb) __builtin_bfin_raise(14);
  }
  return s;
}
int main(void) {
  EVT14 = tick;
  unsigned calm = sum(10, 0);
  __builtin_bfin_sti(0x401F);
  unsigned disturbed = sum(10, 1);
  RESULT = calm == disturbed ? 'y' : 'n';
  RESULT = ticks == 10 ? 'y' : 'n';
  RESULT = '\n';
  return 0;
}
)";

TEST_F(TargetOnly, InterruptedLoopsGoOnAsIfNothingHadHappened) {
  write("interrupted.c", kInterrupted);
  for (const char* level : {"0", "2"}) {
    const Finished finished = execute("interrupted.c", level);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(finished.out, "yy\n") << "-O" << level;
  }
}

}  // namespace
}  // namespace finback::compiler
