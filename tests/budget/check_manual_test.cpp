// The manual's pages say what the program does: docs/finback-check.md is executed, docs/metrics.md
// names every metric of a run and no other. So does the project's own budget.
#include <gmock/gmock.h>
#include <map>
#include <set>
#include <sstream>

#include "../cli/page_examples.hpp"
#include "../cli/program.hpp"
#include <budget/demand.hpp>
#include <common/file.hpp>
#include <common/pattern.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

class Manual : public ProgramTest {
 protected:
  static std::string page(const std::string& name) {
    return read_text_file(std::filesystem::path(FINBACK_SOURCE_DIR) / "docs" / name);
  }
};

TEST_F(Manual, PageSaysWhatIsPrinted) {
  check_page_examples("finback-check.md", folder().string());
}

// Each row's metric as a pattern, with its unit; "also `_per_frame`" makes two.
std::map<std::string, std::string> families_of(const std::string& text) {
  const std::vector<std::pair<std::string, std::string>> words = {
      {"CORE", "core_?"}, {"LEVEL", "l?"}, {"OWNER", "*"},     {"NAME", "*"},
      {"REGION", "*"},    {"CAUSE", "*"},  {"INITIATOR", "*"}, {"COMPONENT", "*"}};
  std::map<std::string, std::string> families;
  for (const std::string& line : lines_of(text)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) {
      const std::size_t begin = cell.find_first_not_of(' ');
      cells.push_back(begin == std::string::npos
                          ? ""
                          : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
    }
    if (cells.size() != 4 || !cells[1].starts_with('`')) {
      continue;
    }
    std::string pattern = cells[1].substr(1, cells[1].size() - 2);
    for (const auto& [word, stands_for] : words) {
      for (std::size_t at = pattern.find(word); at != std::string::npos; at = pattern.find(word)) {
        pattern.replace(at, word.size(), stands_for);
      }
    }
    families[pattern] = cells[2];
    if (cells[3].find("also `_per_frame`") != std::string::npos) {
      families[pattern + "_per_frame"] = cells[2];
    }
  }
  return families;
}

TEST_F(Manual, NamesEveryMetricAndNoOther) {
  const std::map<std::string, std::string> families = families_of(page("metrics.md"));
  write("b.toml", "[run]\nscene = \"synthetic\"\nframes = 1\n");
  const Finished listed = finback({"check", "b.toml", "--list"});
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  std::set<std::string> seen;
  for (const std::string& line : lines_of(listed.out)) {
    std::istringstream words(line);
    std::string name;
    std::string value;
    std::string unit;
    words >> name >> value >> unit;
    bool told = false;
    for (const auto& [pattern, its_unit] : families) {
      if (matches_pattern(pattern, name) && its_unit == unit) {
        seen.insert(pattern);
        told = true;
      }
    }
    EXPECT_TRUE(told) << "docs/metrics.md does not name " << name << " in '" << unit << "'";
  }
  for (const auto& [pattern, unit] : families) {
    EXPECT_TRUE(seen.contains(pattern)) << "no metric is " << pattern << " in '" << unit << "'";
  }
}

TEST_F(Manual, BudgetOfTheShippedFirmwareHolds) {
  const Finished checked =
      finback({"check", std::string(FINBACK_SOURCE_DIR) + "/firmware/budgets/mesvs2.toml"});
  EXPECT_EQ(checked.exit_code, 0)
      << checked.out << checked.err
      << "if this is meant, run scripts/refresh-traces.sh and review the change";
}

TEST_F(Manual, BudgetIsInstalledBesideTheProgram) {
  const Finished listed =
      finback({"check", std::string(FINBACK_BUILD_DIR) + "/share/finback/budgets/mesvs2.toml",
               "--list", "frames_per_second", "--scene", "synthetic", "--frames", "1"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("frames_per_second"));
}

}  // namespace
}  // namespace finback::cli
