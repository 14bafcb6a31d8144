// The core against published cycle counts: the kernels of benchmarks/kernels, and the table of
// docs/fidelity.md that shows them.
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

#include "published.hpp"
#include <common/file.hpp>

namespace finback::kernels {
namespace {

using testing::HasSubstr;

std::int64_t difference(const Published& figure) {
  return static_cast<std::int64_t>(figure.call().run()) - static_cast<std::int64_t>(figure.cycles);
}

bool within(std::int64_t difference, const Published& figure) {
  return std::abs(difference) <= static_cast<std::int64_t>(tolerance(figure.cycles));
}

std::string row(const Published& figure) {
  const std::int64_t less = difference(figure);
  return fmt::format("| `{}` | {} | {} | {} | {:+} | {} |", figure.kernel, figure.size,
                     figure.cycles, static_cast<std::int64_t>(figure.cycles) + less, less,
                     within(less, figure) ? "yes" : "no");
}

TEST(Fidelity, KernelsTakeTheCyclesThatWerePublished) {
  for (const Published& figure : published()) {
    EXPECT_EQ(within(difference(figure), figure), figure.reached) << row(figure);
  }
}

// Whatever is executed more often with size costs exactly what was published: only the fixed term
// of a kernel, which is its own code, may differ.
TEST(Fidelity, LoopsTakeExactlyTheCyclesThatWerePublished) {
  std::map<std::string, std::int64_t> fixed;
  for (const Published& figure : published()) {
    const std::int64_t less = difference(figure);
    EXPECT_EQ(fixed.emplace(figure.kernel, less).first->second, less) << row(figure);
  }
}

TEST(Fidelity, PageShowsWhatIsSimulated) {
  const std::string page = read_text_file(FINBACK_FIDELITY_PAGE);
  for (const Published& figure : published()) {
    EXPECT_THAT(page, HasSubstr("\n" + row(figure) + "\n"));
  }
}

// The other way round: no line of the table is about something else.
TEST(Fidelity, PageShowsNothingElse) {
  const std::string page = read_text_file(FINBACK_FIDELITY_PAGE);
  std::size_t rows = 0;
  for (const char* answer : {" | yes |\n", " | no |\n"}) {
    for (std::size_t at = page.find(answer); at != std::string::npos;
         at = page.find(answer, at + 1)) {
      ++rows;
    }
  }
  EXPECT_EQ(rows, published().size());
}

// What the figures can see: a parameter changed, and they are missed.
TEST(Fidelity, OtherLatenciesMissThePublishedFigures) {
  const auto figure = [](const std::string& kernel) {
    return *std::ranges::find(published(), kernel, &Published::kernel);
  };
  for (const auto& [kernel, parameter, value] :
       {std::tuple{"matmmlt_fr16", &core::CoreParameters::branch_taken, 8.0},
        std::tuple{"countones", &core::CoreParameters::branch_taken, 9.0},
        std::tuple{"countones", &core::CoreParameters::branch_taken, 3.0},
        std::tuple{"float_gt", &core::CoreParameters::branch_taken, 6.0},
        std::tuple{"sqrt_fr16", &core::CoreParameters::alu_to_ex1, 5.0}}) {
    const Published reached = figure(kernel);
    KernelCall call = reached.call();
    (call.parameters().*parameter).set(value);
    const auto less =
        static_cast<std::int64_t>(call.run()) - static_cast<std::int64_t>(reached.cycles);
    EXPECT_FALSE(within(less, reached)) << kernel << " with " << value << ": " << less;
  }
}

// "Buffers in separate sub-banks" is a condition of the published figures: without it the accesses
// of a packet stand in each other's way.
TEST(Fidelity, BuffersInOneSubBankCostCycles) {
  const Halves x = noise(100);
  KernelCall apart = multiply(x, x, 10, 10, 10);
  KernelCall together = multiply(x, x, 10, 10, 10);
  together.crowded();
  EXPECT_GT(together.run(), apart.run() + 100);
  EXPECT_EQ(together.halves(2), apart.halves(2));
}

}  // namespace
}  // namespace finback::kernels
