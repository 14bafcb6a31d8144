// Kernels as finback-cc compiles them against the same written by hand: both right, and the table
// of docs/fidelity.md true to the cycle. FINBACK_REFRESH writes the table anew.
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compared.hpp"
#include <common/file.hpp>

namespace finback::kernels {
namespace {

KernelCall call_of(const Compared& one, const std::string& folder) {
  KernelCall call(one.kernel, folder);
  call.with(FINBACK_RUNTIME "/absolute_differences.bir");
  one.arguments(call);
  return call;
}

Cycles checked_cycles(const Compared& one, const std::string& folder) {
  SCOPED_TRACE(one.kernel + " of " + folder + ", " + one.size);
  KernelCall call = call_of(one, folder);
  const Cycles cycles = call.run();
  one.check(call);
  return cycles;
}

double ratio(Cycles compiled, Cycles by_hand) {
  return static_cast<double>(compiled) / static_cast<double>(by_hand);
}

// The table's lines below its head, all kernels run and checked.
std::string table() {
  std::string lines;
  double logarithms = 0;
  for (const Compared& one : compared()) {
    const Cycles by_hand = checked_cycles(one, FINBACK_HAND_WRITTEN);
    const Cycles compiled = checked_cycles(one, FINBACK_COMPILED);
    logarithms += std::log(ratio(compiled, by_hand));
    lines += fmt::format("| `{}` | {} | {} | {} | {:.2f} |\n", one.kernel, one.size, by_hand,
                         compiled, ratio(compiled, by_hand));
  }
  const double mean = std::exp(logarithms / static_cast<double>(compared().size()));
  return lines + fmt::format("| geometric mean | | | | {:.2f} |\n", mean);
}

// The place of the table's lines in the page.
std::pair<std::size_t, std::size_t> place_of_table(const std::string& page) {
  const std::string head =
      "| kernel | size | hand-written | compiled | ratio |\n|---|---|---|---|---|\n";
  const std::size_t at = page.find(head);
  if (at == std::string::npos) {
    throw std::runtime_error("the page has no table of compiled kernels");
  }
  const std::size_t begin = at + head.size();
  return {begin, page.find("\n\n", begin) + 1};
}

TEST(CompiledKernels, PageSaysWhatIsPrinted) {
  std::string page = read_text_file(FINBACK_FIDELITY_PAGE);
  const auto [begin, end] = place_of_table(page);
  const std::string lines = table();
  if (std::getenv("FINBACK_REFRESH") == nullptr) {
    EXPECT_EQ(page.substr(begin, end - begin), lines)
        << "if the change is meant, run scripts/refresh-traces.sh";
    return;
  }
  write_file_whole(FINBACK_FIDELITY_PAGE, page.replace(begin, end - begin, lines));
}

TEST(CompiledKernels, AreRightOnOtherInputs) {
  for (const Compared& one : other_inputs()) {
    checked_cycles(one, FINBACK_COMPILED);
  }
}

TEST(HandWrittenKernels, AreRightOnOtherInputs) {
  for (const Compared& one : other_inputs()) {
    checked_cycles(one, FINBACK_HAND_WRITTEN);
  }
}

// What its check, which is by definition and allows for roundings, does not see.
TEST(CompiledKernels, TransformGivesTheSameBits) {
  for (const auto* all : {&compared(), &other_inputs()}) {
    for (const Compared& one : *all) {
      if (one.kernel == "fft256") {
        KernelCall by_hand = call_of(one, FINBACK_HAND_WRITTEN);
        KernelCall compiled = call_of(one, FINBACK_COMPILED);
        by_hand.run();
        compiled.run();
        EXPECT_EQ(by_hand.halves(1), compiled.halves(1)) << one.size;
      }
    }
  }
}

}  // namespace
}  // namespace finback::kernels
