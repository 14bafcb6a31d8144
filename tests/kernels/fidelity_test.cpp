// The core against published cycle counts, by the kernels of benchmarks/kernels.
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <tuple>

#include "published.hpp"

namespace finback::kernels {
namespace {

TEST(Fidelity, KernelsTakeTheCyclesThatWerePublished) {
  for (const Published& figure : published()) {
    const std::int64_t less = difference(figure);
    EXPECT_EQ(within(less, figure), figure.reached)
        << figure.kernel << ", " << figure.size << ": " << less << " of " << figure.cycles;
  }
}

// Whatever is executed more often with size costs exactly what was published: only the fixed term
// of a kernel, which is its own code, may differ.
TEST(Fidelity, LoopsTakeExactlyTheCyclesThatWerePublished) {
  std::map<std::string, std::int64_t> fixed;
  for (const Published& figure : published()) {
    const std::int64_t less = difference(figure);
    EXPECT_EQ(fixed.emplace(figure.kernel, less).first->second, less)
        << figure.kernel << ", " << figure.size;
  }
}

// What the figures can see: a latency changed, and they are missed.
TEST(Fidelity, OtherLatenciesMissThePublishedFigures) {
  for (const auto& [kernel, parameter, value] :
       {std::tuple{"matmmlt_fr16", &core::CoreParameters::branch_taken, 8.0},
        std::tuple{"countones", &core::CoreParameters::branch_taken, 9.0},
        std::tuple{"countones", &core::CoreParameters::branch_taken, 3.0},
        std::tuple{"float_gt", &core::CoreParameters::branch_taken, 6.0},
        std::tuple{"sqrt_fr16", &core::CoreParameters::alu_to_ex1, 2.0}}) {
    const Published& figure = *std::ranges::find(published(), kernel, &Published::kernel);
    KernelCall call = figure.call();
    (call.parameters().*parameter).set(value);
    const std::int64_t less = difference(figure, call);
    EXPECT_FALSE(within(less, figure)) << kernel << " with " << value << ": " << less;
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
