// Random loops over 16-bit arrays print the same on the host and on the simulated machine: trees of
// what C does with halves, each defined for all values, over arrays that may lie anywhere.
#include <fmt/format.h>
#include <random>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

constexpr int kLoops = 24;     // of a program
constexpr int kMostBits = 30;  // of a value, with its sign
constexpr unsigned kProgramsOnEveryRun = 2;

struct Expression {
  std::string text;
  int bits;
};

class LoopWriter {
 public:
  explicit LoopWriter(unsigned seed) : random_(seed) {}

  /// A program of loops, all called with odd and even counts and addresses.
  std::string program();

 private:
  unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
  std::string leaf_constant() {
    return fmt::format("({})", static_cast<int>(below(65536)) - 32768);
  }
  Expression leaf();
  Expression node(int depth);
  static Expression half(const Expression& wide, const char* type = "short") {
    return {fmt::format("({})({})", type, wide.text), type[0] == 's' ? 16 : 17};
  }
  Expression of_two(const Expression& a, const Expression& b);
  Expression of_one(const Expression& a);
  std::string loop(int number);

  std::mt19937 random_;
};

Expression LoopWriter::leaf() {
  switch (below(7)) {
    case 0:
      return {leaf_constant(), 16};
    case 1:
      return {"(short)k", 16};
    case 2:
      return {"(unsigned short)x[i]", 17};
    case 3:
    case 4:
      return {"x[i]", 17};
    default:
      return {"y[i]", 17};
  }
}

Expression LoopWriter::of_two(const Expression& a, const Expression& b) {
  const int more = std::max(a.bits, b.bits) + 1;
  switch (below(11)) {
    case 0:
    case 1:
      return {fmt::format("({} + {})", a.text, b.text), more};
    case 2:
    case 3:
      return {fmt::format("({} - {})", a.text, b.text), more};
    case 4:
      return {fmt::format("least({}, {})", a.text, b.text), more - 1};
    case 5:
      return {fmt::format("most({}, {})", a.text, b.text), more - 1};
    case 6:
      return {fmt::format("limited({} {} {})", a.text, below(2) == 0 ? "+" : "-", b.text), 16};
    case 7:
      return {fmt::format("limited(({}) * ({}) >> 15)", half(a).text, half(b).text), 16};
    case 8:
      return {fmt::format("(({} + {}) >> 1)", half(a).text, half(b).text), 16};
    case 9:
      return half(
          {fmt::format("({}) * {} >> {}", half(a).text, leaf_constant(), 15 + below(2)), 17});
    default:
      return {fmt::format("({} {} {})", a.text, "&|^"[below(3)], b.text), more};
  }
}

Expression LoopWriter::of_one(const Expression& a) {
  const unsigned by = below(15) + 1;
  switch (below(7)) {
    case 0:
      return {fmt::format("({} >> {})", a.text, by), a.bits};
    case 1:
      return {fmt::format("(int)((unsigned){} >> {})", half(a).text, by), 31};
    case 2:
      return half({fmt::format("(unsigned){} << {}", a.text, by), 32});
    case 3:
      return {fmt::format("amount({})", a.text), a.bits + 1};
    case 4:
      return half(a);
    case 5:
      return half(a, "unsigned short");
    default:
      return {fmt::format("(- {})", a.text), a.bits + 1};
  }
}

Expression LoopWriter::node(int depth) {
  if (depth == 0)
    return leaf();
  const Expression a = node(depth - 1);
  const Expression made = below(3) == 0 ? of_one(a) : of_two(a, node(depth - 1));
  return made.bits > kMostBits ? half(made) : made;
}

std::string LoopWriter::loop(int number) {
  const char* apart = below(3) == 0 ? "" : "restrict";
  const char* type = below(3) == 0 ? "unsigned short" : "short";
  return fmt::format(
      "__attribute__((noinline)) static void loop{}(short* {} z, const {}* {} x,\n"
      "    const short* y, int n, int k) {{\n  (void)y, (void)k;\n"
      "  {} best = k / 2;\n  for (int i = 0; i < n; i++) {{\n    z[i] = (short)({});\n{}  }}\n"
      "  z[n] = best;\n}}\n",
      number, apart, type, apart, below(2) == 0 ? "short" : "int",
      node(static_cast<int>(below(3)) + 1).text,
      below(3) == 0 ? fmt::format("    best = {}({}, best);\n", below(2) == 0 ? "least" : "most",
                                  half(node(1)).text)
                    : "");
}

std::string LoopWriter::program() {
  std::string text =
      "#include \"report.h\"\nenum { COUNT = 48 };\nstatic short a[COUNT], b[COUNT], c[COUNT];\n"
      "static int least(int x, int y) { return x < y ? x : y; }\n"
      "static int most(int x, int y) { return x > y ? x : y; }\n"
      "static int limited(int x) { return most(least(x, 32767), -32768); }\n"
      "static int amount(int x) { return x < 0 ? -x : x; }\n"
      "static unsigned filled(void) {\n  unsigned state = 7, sum = 0;\n"
      "  for (int i = 0; i < COUNT; i++) {\n    sum = mix(sum, (unsigned)c[i]);\n"
      "    a[i] = (short)next_number(&state);\n    b[i] = (short)(next_number(&state) % 9 * "
      "8191);\n"
      "    c[i] = (short)i;\n  }\n  return sum;\n}\n";
  std::string calls;
  for (int number = 0; number < kLoops; ++number) {
    text += loop(number);
    calls += fmt::format(
        "  for (int n = 0; n < 36; n += 1 + n / 2)\n    for (int at = 0; at < 3; at++) {{\n"
        "      loop{}(c + at % 2, (void*)(a + at / 2), b + at / 2, n, {});\n"
        "      sum = mix(sum, filled());\n    }}\n  report(\"{}\", sum);\n",
        number, static_cast<int>(below(65536)) - 32768, number);
  }
  return text + "int main(void) {\n  unsigned sum = filled();\n" + calls + "  return 0;\n}\n";
}

class RandomHalves : public CompilerTest {};

TEST_F(RandomHalves, PrintWhatTheHostPrints) {
  const unsigned programs = programs_to_try(kProgramsOnEveryRun);
  const std::string headers = std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/programs";
  for (unsigned seed = 1; seed <= programs && !HasFailure(); ++seed) {
    write("halves.c", LoopWriter(seed).program());
    const Finished built =
        run({FINBACK_HOST_CC, "-w", "-O1", "-I", headers, "-o", "host", "halves.c"});
    ASSERT_EQ(built.exit_code, 0) << built.err;
    const Finished expected = run({"./host"});
    for (const char level : {'1', '2', '3'}) {
      const Finished compiled = cc({std::string("-O") + level, "--verify", "-W", "no-everything",
                                    "-I", headers, "halves.c"});
      ASSERT_EQ(compiled.exit_code, 0) << "seed " << seed << " -O" << level << compiled.err;
      const Finished got = run({FINBACK_BIR_RUN, "halves.bir"});
      EXPECT_EQ(got.out, expected.out) << "seed " << seed << " -O" << level << got.err;
    }
  }
}

}  // namespace
}  // namespace finback::compiler
