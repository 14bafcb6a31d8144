// finback lab, as a user runs it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../cli/page_examples.hpp"
#include "../cli/program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class Lab : public ProgramTest {};

// The whole ladder: seconds, and minutes under sanitizers.
TEST_F(Lab, PageSaysWhatIsPrinted) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "too slow under sanitizers";
#endif
  if (!FINBACK_HAS_COMPILER) {
    GTEST_SKIP() << "one example compiles";
  }
  check_page_examples("finback-lab.md", folder());
}

TEST_F(Lab, PageNamesEveryOption) {
  const std::string page = read_text_file(FINBACK_SOURCE_DIR "/docs/finback-lab.md");
  const Finished help = finback({"lab", "climb", "--help"});
  std::istringstream words(help.out.substr(0, help.out.find("What is run")));
  for (std::string word; words >> word;) {
    const std::string option = word.substr(0, word.find_first_of(",="));
    if (option.starts_with("--") && option != "--help") {
      EXPECT_THAT(page, HasSubstr("`" + option)) << option;
    }
  }
}

TEST_F(Lab, CompareSaysTheSameInAllForms) {
  const Finished json = finback({"lab", "compare", "dma", "two_cores", "--json"});
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document.at("schema_version"), 1);
  ASSERT_EQ(document.at("runs").size(), 2U);
  const auto& two_cores = document.at("runs")[1];
  EXPECT_EQ(two_cores.at("name"), "two_cores");
  const double cycles = two_cores.at("summary").at("cycles");
  EXPECT_NEAR(two_cores.at("summary").at("times_faster"),
              document.at("runs")[0].at("summary").at("cycles").get<double>() / cycles, 1e-9);
  // Every cycle of both cores has a cause; core B starts a little later.
  double sum = 0;
  for (const auto& [cause, count] : two_cores.at("cycles_by_cause").items()) {
    sum += count.get<double>();
  }
  EXPECT_LE(sum, 2 * cycles);
  EXPECT_GT(sum, 1.99 * cycles);

  const Finished csv = finback({"lab", "compare", "dma", "two_cores", "--csv"});
  EXPECT_THAT(csv.out, StartsWith("section,name,unit,dma,two_cores\nsummary,cycles,,"));
  EXPECT_THAT(csv.out, HasSubstr(fmt::format(",{:.0f}\n", cycles)));
  const Finished text = finback({"lab", "compare", "dma", "two_cores"});
  EXPECT_THAT(text.out, HasSubstr(fmt::format("  {:.0f}\n", cycles)));
}

TEST_F(Lab, RunTakesTheOptionsOfRun) {
  const Finished finished = finback({"lab", "run", "dma", "--scene", "synthetic", "--frames", "2",
                                     "--set", "memory.l2.read_cycles=12"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, StartsWith("dma: "));
  EXPECT_THAT(finished.out, HasSubstr("Scene synthetic, machine bf561, 2 frames"));
  EXPECT_THAT(finished.out, HasSubstr("The maps of both are equal in every pixel."));
}

TEST_F(Lab, SaysWhereMapsDiffer) {
  // A firmware whose map is another one: the camera's, which is checked from both views.
  const std::string mesvs2 = (share_folder() / "firmware" / "mesvs2").string();
  const Finished finished = finback({"lab", "compare", "two_cores", mesvs2});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.out, HasSubstr("Cycles by cause"));
  EXPECT_THAT(finished.err, HasSubstr("differs from that of two_cores in "));
}

TEST_F(Lab, NamesTheNearestRung) {
  const Finished wrong = finback({"lab", "run", "vertcal"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("there is no rung 'vertcal', did you mean 'vertical'?"));
  EXPECT_THAT(wrong.err, HasSubstr("naive, l1, vertical"));
  EXPECT_EQ(finback({"lab", "compare", "l1", "nowhere/at/all"}).exit_code, 2);
  EXPECT_EQ(finback({"lab", "diff", "l1", "zzz"}).exit_code, 2);
  EXPECT_EQ(finback({"lab", "compare", "l1"}).exit_code, 1);
}

TEST_F(Lab, DiffShowsOnlyWhatDiffers) {
  EXPECT_EQ(finback({"lab", "diff", "dma", "dma"}).out, "");
  const Finished placement = finback({"lab", "diff", "naive", "l1"});
  EXPECT_THAT(placement.out, StartsWith("--- naive/placement.toml\n+++ l1/placement.toml\n"));
  EXPECT_THAT(placement.out, Not(HasSubstr("match.c")));
  const Finished by_hand = finback({"lab", "diff", "packed", "assembly"});
  EXPECT_THAT(by_hand.out, HasSubstr("--- packed/update_row.c\n+++ /dev/null\n"));
  EXPECT_THAT(by_hand.out, HasSubstr("--- /dev/null\n+++ assembly/update_row.bir\n"));
  const Finished cores = finback({"lab", "diff", "dma", "two_cores"});
  EXPECT_THAT(cores.out, HasSubstr("+++ two_cores/main_b.c"));
  EXPECT_THAT(cores.out, Not(HasSubstr("core_interrupt.c")));  // a driver
}

TEST_F(Lab, InstalledRungsAreFirmwaresByName) {
  const Finished finished = finback({"profile", "--firmware", "labs/dma", "--frames", "1"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, StartsWith("Firmware labs/dma, "));
}

}  // namespace
}  // namespace finback::cli
