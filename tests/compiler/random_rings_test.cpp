// Random loops over circular buffers print the same on the host and on the simulated machine: every
// way of C to go round, two buffers in a loop, stores between loads, loops in loops.
#include <array>
#include <fmt/format.h>
#include <random>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

constexpr int kFunctions = 8;  // of a program
constexpr int kBuffers = 4;
constexpr unsigned kProgramsOnEveryRun = 3;

struct RingBuffer {
  std::string name;
  std::string type;
  int count = 0;
  [[nodiscard]] bool power_of_two() const { return (count & (count - 1)) == 0; }
};

class RingWriter {
 public:
  explicit RingWriter(unsigned seed) : random_(seed) {
    constexpr std::array kTypes = {"signed char", "short",         "unsigned short",
                                   "int",         "unsigned char", "unsigned"};
    constexpr std::array kCounts = {3, 7, 8, 16, 21, 32, 50};
    for (int i = 0; i < kBuffers; ++i)
      buffers_.push_back({fmt::format("x{}", i), kTypes.at(below(kTypes.size())),
                          kCounts.at(below(kCounts.size()))});
  }

  /// Functions, each called from every place of its buffers on, with 0 to 39 rounds.
  std::string program();

 private:
  unsigned below(std::size_t limit) { return static_cast<unsigned>(random_() % limit); }
  const RingBuffer& buffer() { return buffers_[below(buffers_.size())]; }
  std::string step(const std::string& index, const RingBuffer& ring);
  std::string access(const std::string& index, const RingBuffer& ring);
  std::string masked_access();
  std::string round(const std::string& index, const RingBuffer& ring);
  std::string pointer_round(const RingBuffer& ring);
  std::string function(int number, std::string& calls);

  std::mt19937 random_;
  std::vector<RingBuffer> buffers_;
};

// The count as a number, or as the argument that has its value.
std::string RingWriter::step(const std::string& index, const RingBuffer& ring) {
  const std::string n = below(2) == 0 ? "n" + index : std::to_string(ring.count);
  const unsigned by = 1 + below(static_cast<std::size_t>(ring.count) - 1);
  const auto form = [&](fmt::string_view text) {
    return fmt::format(fmt::runtime(text), fmt::arg("i", index), fmt::arg("n", n),
                       fmt::arg("s", by), fmt::arg("mask", ring.count - 1));
  };
  constexpr std::array kForms = {"if (++{i} == {n}) {i} = 0;",
                                 "if (++{i} >= {n}) {i} = 0;",
                                 "{i} = {i} == 0 ? {n} - 1 : {i} - 1;",
                                 "{i} = {i} + 1 < {n} ? {i} + 1 : 0;",
                                 "{i} = {i} + {s} < {n} ? {i} + {s} : {i} + {s} - {n};",
                                 "{i} = {i} >= {s} ? {i} - {s} : {i} - {s} + {n};",
                                 "{i} = (int)(((unsigned){i} + {s}) % (unsigned){n});",
                                 "{i} = circindex((int){i}, {s}, (unsigned){n});",
                                 "{i} = circindex((int){i}, -{s}, (unsigned){n});"};
  constexpr std::array kMasked = {"{i} = ({i} + {s}) & {mask};", "{i} = ({i} - {s}) & {mask};"};
  return ring.power_of_two() && below(3) == 0 ? form(kMasked.at(below(kMasked.size())))
                                              : form(kForms.at(below(kForms.size())));
}

std::string RingWriter::access(const std::string& index, const RingBuffer& ring) {
  switch (below(5)) {
    case 0:
      return fmt::format("{}[{}] = ({})(s >> 3);", ring.name, index, ring.type);
    case 1:
      return fmt::format("if (s & 4) s ^= (unsigned){}[{}];", ring.name, index);
    default:
      return fmt::format("s = s * 5 + (unsigned){}[{}];", ring.name, index);
  }
}

/// An index that the loop's own counter makes.
std::string RingWriter::masked_access() {
  const RingBuffer& ring = buffer();
  return ring.power_of_two()
             ? fmt::format("s += (unsigned){}[(h {} {} * (unsigned)k) & {}];", ring.name,
                           below(2) == 0 ? '+' : '-', 1 + 2 * below(2), ring.count - 1)
             : "s += 3;";
}

std::string RingWriter::round(const std::string& index, const RingBuffer& ring) {
  std::string accesses = access(index, ring);
  if (below(3) == 0)
    accesses += " " + access(index, ring);
  return below(4) == 0 ? step(index, ring) + " " + accesses : accesses + " " + step(index, ring);
}

std::string RingWriter::pointer_round(const RingBuffer& ring) {
  const int by = static_cast<int>(below(2 * static_cast<std::size_t>(ring.count) + 1)) - ring.count;
  return fmt::format(
      "{0} p = circptr(p, {1} * (int)sizeof *p, {2}, sizeof {2});",
      below(2) == 0 ? "s = (s << 1) ^ (unsigned)*p;" : fmt::format("*p = ({})(s + 1);", ring.type),
      by, ring.name);
}

std::string RingWriter::function(int number, std::string& calls) {
  std::string parameters;
  std::string arguments;
  std::string body;
  const unsigned rings = 1 + below(2);
  for (unsigned i = 0; i < rings; ++i) {
    const RingBuffer& ring = buffer();
    parameters += fmt::format("{0} i{1}, {0} ni{1}, ", below(2) == 0 ? "int" : "unsigned", i);
    arguments += fmt::format("h % {0}, {0}, ", ring.count);
    body += "    " + round(fmt::format("i{}", i), ring) + "\n";
  }
  std::string pointer;
  if (below(3) == 0) {
    const RingBuffer& ring = buffer();
    pointer = fmt::format("  {} *p = {} + {};\n", ring.type, ring.name,
                          below(static_cast<std::size_t>(ring.count)));
    body += "    " + pointer_round(ring) + "\n";
  }
  if (below(3) == 0)
    body += "    " + masked_access() + "\n";
  calls += fmt::format("    sum = mix(sum, f{}({}(unsigned)h * 3, h));\n", number, arguments);
  return fmt::format(
      "APART static unsigned f{}({}unsigned h, int count) {{\n  unsigned s = h;\n{}{}"
      "  for (int k = 0; k < count; ++k) {{\n{}  }}\n  return mix(s, {});\n}}\n",
      number, parameters, pointer, below(3) == 0 ? "  for (int o = 0; o < 3; ++o)\n" : "", body,
      below(2) == 0 ? "(unsigned)i0" : "h");
}

std::string RingWriter::program() {
  std::string text =
      fmt::format("#include \"{}/tests/compiler/programs/report.h\"\n", FINBACK_SOURCE_DIR) +
      "#ifdef __FINBACK__\n#include <ccblkfn.h>\n#else\n"
      "static int circindex(int index, int step, unsigned count) {\n"
      "  int n = index + step;\n"
      "  return n < 0 ? n + (int)count : n >= (int)count ? n - (int)count : n;\n}\n"
      "static void *circptr(const void *p, int s, const void *b, unsigned n) {\n"
      "  return (char *)b + circindex((int)((char *)p - (char *)b), s, n);\n}\n"
      "#endif\n";
  std::string begin;
  std::string end;
  for (const RingBuffer& ring : buffers_) {
    text += fmt::format("static {} {}[{}];\n", ring.type, ring.name, ring.count);
    begin += fmt::format("  for (int i = 0; i < {}; ++i) {}[i] = ({})(i * 37 + 11);\n", ring.count,
                         ring.name, ring.type);
    end += fmt::format("  for (int i = 0; i < {}; ++i) sum = mix(sum, (unsigned){}[i]);\n",
                       ring.count, ring.name);
  }
  std::string calls;
  for (int number = 0; number < kFunctions; ++number)
    text += function(number, calls);
  return text + "int main(void) {\n  unsigned sum = 0;\n" + begin +
         "  for (int h = 0; h < 40; ++h) {\n" + calls + "    report(\"sum\", sum);\n  }\n" + end +
         "  report(\"end\", sum);\n  return 0;\n}\n";
}

/// How many loops set a length and take it back.
int rings_of(const std::string& bir) {
  int rings = 0;
  for (const char* back : {"L0 = 0 (X);", "L1 = 0 (X);", "L2 = 0 (X);", "L3 = 0 (X);"})
    rings += count(bir, back);
  return rings;
}

class RandomRings : public CompilerTest {};

TEST_F(RandomRings, PrintWhatTheHostPrints) {
  const unsigned programs = programs_to_try(kProgramsOnEveryRun);
  int rings = 0;
  for (unsigned seed = 1; seed <= programs && !HasFailure(); ++seed) {
    write("rings.c", RingWriter(seed).program());
    const Finished built = run({FINBACK_HOST_CC, "-w", "-O1", "-o", "host", "rings.c"});
    ASSERT_EQ(built.exit_code, 0) << built.err;
    const Finished expected = run({"./host"});
    for (const char level : {'1', '2', '3'}) {
      const Finished got = execute("rings.c", std::string(1, level));
      EXPECT_EQ(got.exit_code, 0) << "seed " << seed << " -O" << level << ": " << got.err;
      EXPECT_EQ(got.out, expected.out) << "seed " << seed << " -O" << level;
    }
    rings += rings_of(read("rings.bir"));
  }
  EXPECT_GE(rings, static_cast<int>(programs * kFunctions) / 2) << "few are compiled as rings";
}

}  // namespace
}  // namespace finback::compiler
