// docs/finback-explore.md is executed: its space, its commands, and what it says that they print.
// So is the shipped space looked at.
#include <gmock/gmock.h>
#include <sstream>

#include "../cli/page_examples.hpp"
#include "../cli/program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExploreManual : public ProgramTest {
 protected:
  const std::string page_ = read_text_file(FINBACK_SOURCE_DIR "/docs/finback-explore.md");
};

TEST_F(ExploreManual, PageSaysWhatIsPrinted) {
  check_page_examples("finback-explore.md", folder().string());
  EXPECT_EQ(files(),
            (std::vector<std::string>{"out", "out/space.sqlite", "points.csv", "space.toml"}));
}

TEST_F(ExploreManual, NamesEveryOption) {
  const Finished help = finback({"explore", "--help"});
  std::istringstream words(help.out);
  for (std::string word; words >> word;) {
    const std::string option = word.substr(0, word.find_first_of(",="));
    if (option.starts_with("--") && option != "--help") {
      EXPECT_THAT(page_, HasSubstr("`" + option)) << option;
    }
  }
}

TEST_F(ExploreManual, HasAShippedSpaceThatIsGood) {
  const Finished finished =
      finback({"explore", FINBACK_SOURCE_DIR "/firmware/spaces/mesvs2.toml", "--dry-run"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("mesvs2.toml: 768 points: "));
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace finback::cli
