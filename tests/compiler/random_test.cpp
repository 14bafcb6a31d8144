// Random C programs by csmith, compiled for a 32-bit host and by finback-cc, print the same
// checksum. csmith makes programs of defined behaviour, but for some that
// never end.
//
// The fields of its packed structures have their addresses taken, which is undefined: those are
// left out (wide_bit_fields.c has packed ones).

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

// 300 programs; FINBACK_RANDOM_C asks for more (CONTRIBUTING.md).
constexpr unsigned kPrograms = 300;
constexpr int kBatches = 30;
constexpr int kFirstSeed = 1;
constexpr int kDoesNotEnd = 3;
constexpr const char* kCsmithHeaders = "/usr/include/csmith";

class RandomC : public CompilerTest, public ::testing::WithParamInterface<int> {
 protected:
  /// All of the runtime that such a program can want.
  static std::string unit(const std::string& name) { return FINBACK_RUNTIME "/" + name + ".bir"; }

  /// False: the program does not end.
  bool compare(int seed) const {
    const Finished made = run({"csmith", "--seed", std::to_string(seed), "--no-argc",
                               "--no-packed-struct", "--max-funcs", "5", "--max-block-depth", "3",
                               "--max-block-size", "4", "--max-expr-complexity", "8"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    write("random.c", made.out);
    const std::string headers = std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/random";
    const Finished built = run({FINBACK_HOST_CC, "-m32", "-w", "-O1", "-I", headers, "-I",
                                kCsmithHeaders, "-o", "host", "random.c"});
    EXPECT_EQ(built.exit_code, 0) << built.err;
    // Nobody waits for one that runs for ever.
    const Finished wanted = run({"timeout", "0.2", "./host"});
    if (wanted.exit_code != 0)
      return false;
    for (const char level : {'0', '1', '2', '3', 's'}) {
      const Finished compiled = cc({std::string("-O") + level, "-W", "no-everything", "-I", headers,
                                    "-I", kCsmithHeaders, "random.c"});
      EXPECT_EQ(compiled.exit_code, 0) << "seed " << seed << " -O" << level << compiled.err;
      const Finished got = run({FINBACK_BIR_RUN, "random.bir", unit("divide"), unit("divide_long"),
                                unit("memory"), unit("absolute_differences")});
      if (got.exit_code == kDoesNotEnd)
        return false;  // for the host it took less than a fifth of a second
      EXPECT_EQ(got.exit_code, 0) << "seed " << seed << " -O" << level << ": " << got.err;
      EXPECT_EQ(got.out, wanted.out) << "seed " << seed << " -O" << level;
    }
    return true;
  }
};

TEST_P(RandomC, PrintsWhatTheHostPrints) {
  write("empty.c", "#include <stdint.h>\nint main(void) { return 0; }\n");
  if (run({FINBACK_HOST_CC, "-m32", "-o", "host", "empty.c"}).exit_code != 0)
    GTEST_SKIP() << "the host's compiler makes no 32-bit programs (Debian's gcc-multilib)";
  const int programs = static_cast<int>(programs_to_try(kPrograms)) / kBatches;
  int compared = 0;
  for (int i = 0; i < programs && !HasFailure(); ++i)
    compared += compare(kFirstSeed + GetParam() * programs + i) ? 1 : 0;
  EXPECT_GE(compared, programs / 2) << "most of them do not end";
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomC, ::testing::Range(0, kBatches));

}  // namespace
}  // namespace finback::compiler
