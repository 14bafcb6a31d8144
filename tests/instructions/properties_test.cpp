// Does every entry of the instruction table keep its law, on thousands of states made of edge
// values? The build itself runs `Coverage`: an entry without a law does not build.
#include <gtest/gtest.h>

#include "laws.hpp"

namespace finback::isa::laws {
namespace {

constexpr int kTrials = 1500;

TEST(Coverage, EveryEntryHasALaw) {
  for (const Instruction& info : instruction_table()) {
    EXPECT_NE(law_of(info.syntax), nullptr)
        << info.syntax << ": add its law to tests/instructions/laws_*.cpp";
  }
}

// Every so many entries, so that tests run side by side.
constexpr int kShares = 8;
class Properties : public testing::TestWithParam<int> {};

TEST_P(Properties, EntriesKeepTheirLaws) {
  const auto table = instruction_table();
  for (int entry = GetParam(); entry < static_cast<int>(table.size()); entry += kShares) {
    const std::string_view syntax = table[static_cast<std::size_t>(entry)].syntax;
    void (*const law)(Trial&) = law_of(syntax);
    ASSERT_NE(law, nullptr) << syntax;
    Draws draws(entry, 1);
    std::string problem;
    for (int i = 0; i < kTrials && problem.empty(); ++i) {
      Trial trial = draws.draw();
      problem = run(trial, law);
    }
    EXPECT_EQ(problem, "") << syntax;
  }
}

INSTANTIATE_TEST_SUITE_P(Shares, Properties, testing::Range(0, kShares));

// A law that can fail: one wrong flag, register or byte is found.
TEST(Trials, FindWhatDiffers) {
  const int add = instruction_syntax().parse("R1 = R2 + R3").instruction;
  Draws draws(add, 1);
  Trial trial = draws.draw();
  EXPECT_NE(run(trial, [](Trial&) {}), "");
  EXPECT_NE(run(trial,
                [](Trial& t) {
                  law_of("{D!} = {D} + {D}")(t);
                  t.after.vs ^= 1;
                }),
            "");
  EXPECT_EQ(run(trial, law_of("{D!} = {D} + {D}")), "");
}

}  // namespace
}  // namespace finback::isa::laws
