// docs/fidelity.md says what is simulated: every line of its tables, and its example.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>

#include "published.hpp"
#include <common/file.hpp>

namespace finback::kernels {
namespace {

using testing::HasSubstr;

std::string page() { return read_text_file(FINBACK_FIDELITY_PAGE); }

std::string row(const Published& figure) {
  const std::int64_t less = difference(figure);
  return fmt::format("| `{}` | {} | {} | {} | {:+} | {} | {} |", figure.kernel, figure.size,
                     figure.cycles, static_cast<std::int64_t>(figure.cycles) + less, less,
                     figure.source, within(less, figure) ? "yes" : "no");
}

// The page's block of that language.
std::string block(const std::string& language) {
  const std::string text = page();
  const std::string fence = "```" + language + "\n";
  const std::size_t at = text.find(fence);
  if (at == std::string::npos) {
    throw std::runtime_error("the page has no block of " + language);
  }
  const std::size_t begin = at + fence.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

// Every kernel once, with its first size.
std::vector<Published> one_of_each() {
  std::vector<Published> firsts;
  std::set<std::string> seen;
  for (const Published& figure : published()) {
    if (seen.insert(figure.kernel).second) {
      firsts.push_back(figure);
    }
  }
  return firsts;
}

TEST(FidelityPage, ShowsWhatIsSimulated) {
  const std::string text = page();
  for (const Published& figure : published()) {
    EXPECT_THAT(text, HasSubstr("\n" + row(figure) + "\n"));
  }
}

TEST(FidelityPage, ShowsNothingElse) {
  const std::string text = page();
  std::size_t rows = 0;
  for (const char* answer : {" | yes |\n", " | no |\n"}) {
    for (std::size_t at = text.find(answer); at != std::string::npos;
         at = text.find(answer, at + 1)) {
      ++rows;
    }
  }
  EXPECT_EQ(rows, published().size());
}

TEST(FidelityPage, ShowsFixedAndGrowingTerms) {
  const std::string text = page();
  for (const Terms& terms : published_terms()) {
    const Published& figure = *std::ranges::find(published(), terms.kernel, &Published::kernel);
    EXPECT_THAT(
        text, HasSubstr(fmt::format("\n| `{0}` | {1} + {2} | {3} + {2} |\n", terms.kernel,
                                    terms.fixed, terms.growing, terms.fixed + difference(figure))));
  }
}

TEST(FidelityPage, ShowsWhatOneMoreCycleOfALatencyDoes) {
  const std::string text = page();
  for (const Published& figure : one_of_each()) {
    const Cycles before = figure.call().run();
    std::string line = "\n| `" + figure.kernel + "` |";
    for (const auto parameter :
         {&core::CoreParameters::branch_taken, &core::CoreParameters::branch_mispredicted,
          &core::CoreParameters::load_to_address, &core::CoreParameters::move_to_address,
          &core::CoreParameters::alu_to_ex1, &core::CoreParameters::multiply32}) {
      KernelCall call = figure.call();
      IntegerParameter& latency = call.parameters().*parameter;
      latency.set(latency.value() + 1);
      line += fmt::format(" {} |", call.run() - before);
    }
    EXPECT_THAT(text, HasSubstr(line + "\n"));
  }
}

TEST(FidelityPage, ItsExamplePrintsWhatItSays) {
  const auto without_head = [](const std::string& bir) { return bir.substr(bir.find('\n') + 1); };
  core::CoreHarness harness(
      without_head(block("bir")) +
      without_head(read_text_file(std::string(FINBACK_KERNELS) + "/countones.bir")));
  harness.run({core::EventController::kSupervisor, 0});
  EXPECT_EQ(harness.printed(), block("text"));
}

}  // namespace
}  // namespace finback::kernels
