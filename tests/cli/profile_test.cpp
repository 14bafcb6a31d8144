// finback profile and finback annotate, as a user runs them.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "page_examples.hpp"
#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class Profile : public ProgramTest {
 protected:
  // The program's JSON; the run must be fine.
  [[nodiscard]] json printed(const std::vector<std::string>& arguments) const {
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json::parse(finished.out);
  }
};

std::uint64_t sum_of(const json& object) {
  std::uint64_t sum = 0;
  for (const auto& [name, value] : object.items()) {
    sum += value.get<std::uint64_t>();
  }
  return sum;
}

// A loop of 10 packets that are told to be lines 2 and 3, and a call.
constexpr const char* kTwoLines =
    "  P0 = 5 (X);\n"
    "  LSETUP (.Ltop, .Lbottom) LC0 = P0;\n"
    ".loc 1 2 0\n"
    ".Ltop:\n"
    "  R1 = 3 (X);\n"
    ".loc 1 3 0\n"
    ".Lbottom:\n"
    "  R1 += 1;\n"
    "  R0 = 0 (X);\n"
    "  RTS;\n";

std::string two_lines_text() {
  std::string text = program_text(kTwoLines);
  return text.insert(text.find('\n') + 1, ".file 1 \"loop.c\"\n");
}

TEST_F(Profile, OfAFunctionSumsOverLinesInstructionsAndCauses) {
  const json a = printed({"annotate", "shd_update_row", "--scene", "synthetic", "--frames", "1",
                          "--place", "core_b.shd_scores=l3", "--json"});
  const auto whole = a["exclusive_cycles"].get<std::uint64_t>();
  EXPECT_GT(whole, 0U);
  EXPECT_EQ(sum_of(a["causes"]), whole);
  std::uint64_t by_line = 0;
  std::uint64_t by_packet = 0;
  std::uint64_t l3 = 0;
  for (const json& line : a["lines"]) {
    by_line += line["cycles"].get<std::uint64_t>();
    EXPECT_EQ(sum_of(line["causes"]), line["cycles"]);
    std::uint64_t of_line = 0;
    for (const json& packet : line["code"]) {
      of_line += packet["cycles"].get<std::uint64_t>();
      EXPECT_EQ(sum_of(packet["causes"]), packet["cycles"]);
      l3 += packet["bytes"].value("l3", std::uint64_t{0});
    }
    EXPECT_EQ(of_line, line["cycles"]);
    by_packet += of_line;
  }
  EXPECT_EQ(by_line, whole);
  EXPECT_EQ(by_packet, whole);
  EXPECT_EQ(l3, a["bytes"]["l3"]);
  EXPECT_GT(l3, 0U);
}

TEST_F(Profile, IsTheSameOfARunAndOfItsResult) {
  const std::vector<std::string> what = {"--scene", "synthetic", "--frames", "1"};
  std::vector<std::string> run = {"run", "--out", "o"};
  std::vector<std::string> profile = {"profile"};
  run.insert(run.end(), what.begin(), what.end());
  profile.insert(profile.end(), what.begin(), what.end());
  ASSERT_EQ(finback(run).exit_code, 0);
  const Finished fresh = finback(profile);
  const Finished stored = finback({"profile", "--result", "o/result.json"});
  ASSERT_EQ(fresh.exit_code, 0) << fresh.err;
  EXPECT_EQ(stored.out, fresh.out);
  const json part = printed({"profile", "--result", "o/result.json", "--json"});
  const json whole = json::parse(read_text_file(folder() / "o/result.json"));
  for (const auto& [key, value] : part.items()) {
    EXPECT_EQ(value, whole[key]) << key;
  }
  EXPECT_TRUE(part.contains("functions") && part.contains("lines") && part.contains("objects"));
}

TEST_F(Profile, NamesTheMemoryThatAFunctionWaitsFor) {
  const Finished finished =
      finback({"profile", "--scene", "synthetic", "--frames", "1", "--place",
               "core_b.shd_scores=l3", "--by", "stalls", "--core", "b", "--top", "1"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, ::testing::ContainsRegex("shd_update_row +core_b .* l3_read"));
  EXPECT_THAT(finished.out, ::testing::ContainsRegex("shd_scores +core_b +l3 "));
  EXPECT_THAT(finished.out, Not(HasSubstr("wait_for_core_b")));
}

TEST_F(Profile, IsPlainInAPipeAndColouredOnRequest) {
  const std::vector<std::string> plain = {"annotate", "main",      "--core",   "a",
                                          "--scene",  "synthetic", "--frames", "1"};
  EXPECT_THAT(finback(plain).out, Not(HasSubstr("\033[")));
  std::vector<std::string> coloured = plain;
  coloured.insert(coloured.end(), {"--color", "always"});
  EXPECT_THAT(finback(coloured).out, HasSubstr("\033["));
}

TEST_F(Profile, ShowsSourceBesideCode) {
  write("main.bir", two_lines_text());
  write("loop.c", "one\ntwo\nthree\n");
  const Finished finished = finback({"annotate", "main", "--firmware", "main.bir"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("loop.c"));
  EXPECT_THAT(finished.out, ::testing::ContainsRegex(" 5 +[0-9.]+ +5 +2 two\n"));
  EXPECT_THAT(finished.out, HasSubstr("R1 = 3 (X);\n"));
  EXPECT_THAT(finished.out, HasSubstr(".Lbottom:\n"));
}

TEST_F(Profile, FindsSourcesWhereItIsTold) {
  std::filesystem::create_directories(folder() / "code");
  std::filesystem::create_directories(folder() / "src");
  write("code/main.bir", two_lines_text());
  const Finished missing = finback({"annotate", "main", "--firmware", "code/main.bir"});
  ASSERT_EQ(missing.exit_code, 0) << missing.err;
  EXPECT_THAT(missing.out, HasSubstr("The text of loop.c was not found; --source FOLDER"));
  write("src/loop.c", "one\ntwo\nthree\n");
  const Finished found =
      finback({"annotate", "main", "--firmware", "code/main.bir", "--source", "src"});
  EXPECT_THAT(found.out, HasSubstr("3 three"));
  EXPECT_THAT(found.out, Not(HasSubstr("was not found")));
}

TEST_F(Profile, OfWrongInputsIsOneLine) {
  write("broken.json", "{");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"annotate", "shd_updat_row"}, "did you mean shd_update_row?"},
      {{"annotate", "shd_update_row", "--core", "a"}, "core_a has no function shd_update_row"},
      {{"profile", "--result", "nowhere.json"}, "nowhere.json"},
      {{"profile", "--result", "broken.json"}, "broken.json: no JSON"},
      {{"profile", "--firmware", "mesv2"}, "did you mean 'mesvs2'"}};
  for (const auto& [arguments, message] : cases) {
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 2) << message;
    EXPECT_EQ(finished.out, "");
    EXPECT_THAT(finished.err, HasSubstr(message));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
}

TEST_F(Profile, PageSaysWhatIsPrinted) {
  check_page_examples("finback-profile.md", folder().string());
  check_page_examples("finback-annotate.md", folder().string());
}

}  // namespace
}  // namespace finback::cli
