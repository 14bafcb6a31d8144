// docs/finback-explore.md is executed: its space, its commands, and what it says that they print.
// The numbers are the firmware's of the day and may differ. So is the shipped space looked at.
#include <cctype>
#include <gmock/gmock.h>
#include <sstream>

#include "../cli/program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kPrompt = "$ finback ";

// The fenced blocks of a language, in their order.
std::vector<std::string> blocks_of(const std::string& page, const std::string& language) {
  std::vector<std::string> blocks;
  const std::string fence = "\n```" + language + "\n";
  for (std::size_t begin = page.find(fence); begin != std::string::npos;
       begin = page.find(fence, begin)) {
    begin += fence.size();
    const std::size_t end = page.find("\n```\n", begin);
    blocks.push_back(page.substr(begin, end + 1 - begin));
  }
  return blocks;
}

// A text without its numbers and the width of its columns.
std::string shape_of(const std::string& text) {
  std::string shape;
  for (const char c : text) {
    const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '*';
    if (number ? !shape.ends_with('#') : !(c == ' ' && shape.ends_with(' '))) {
      shape += number ? '#' : c;
    }
  }
  return shape;
}

class ExploreManual : public ProgramTest {
 protected:
  const std::string page_ = read_text_file(FINBACK_SOURCE_DIR "/docs/finback-explore.md");
};

TEST_F(ExploreManual, SaysWhatTheProgramDoes) {
  const std::vector<std::string> spaces = blocks_of(page_, "toml");
  const std::vector<std::string> transcripts = blocks_of(page_, "console");
  ASSERT_EQ(spaces.size(), 1U);
  ASSERT_EQ(transcripts.size(), 2U);
  write("space.toml", spaces[0]);
  for (const std::string& transcript : transcripts) {
    const std::size_t end = transcript.find('\n');
    ASSERT_TRUE(transcript.starts_with(kPrompt)) << transcript;
    std::istringstream words(transcript.substr(std::string(kPrompt).size(), end));
    std::vector<std::string> arguments;
    std::string line;
    std::getline(words, line);
    words = std::istringstream(line);
    for (std::string word; words >> word;) {
      arguments.push_back(word);
    }
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    std::string expected = transcript.substr(end + 1);
    const std::size_t cut = expected.find("...\n");  // what follows may be anything
    expected = cut == std::string::npos ? expected : expected.substr(0, cut);
    EXPECT_THAT(shape_of(finished.err + finished.out), ::testing::StartsWith(shape_of(expected)))
        << finished.err << finished.out;
  }
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
