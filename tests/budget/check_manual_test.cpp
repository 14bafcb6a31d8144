// The manual's pages say what the program does: docs/finback-check.md is executed, docs/metrics.md
// names every metric of a run and no other. So does the project's own budget.
#include <cctype>
#include <gmock/gmock.h>
#include <map>
#include <set>
#include <sstream>

#include "../cli/program.hpp"
#include <budget/demand.hpp>
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kAnything = "...";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

// The fenced blocks of a language, in their order.
std::vector<std::string> blocks_of(const std::string& page, const std::string& language) {
  std::vector<std::string> blocks;
  const std::string fence = "\n```" + language + "\n";
  std::size_t begin = page.find(fence);
  while (begin != std::string::npos) {
    begin += fence.size();
    const std::size_t end = page.find("\n```\n", begin);
    blocks.push_back(page.substr(begin, end + 1 - begin));
    begin = page.find(fence, end);
  }
  return blocks;
}

// A line without its numbers and the width of its columns: those are the firmware's of the day.
std::string shape_of(const std::string& line) {
  std::string shape;
  for (const char c : line) {
    const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0;
    const bool within = (c == ',' || c == '.') && shape.ends_with('#');
    if (number ? !shape.ends_with('#') : !within && !(c == ' ' && shape.ends_with(' '))) {
      shape += number ? '#' : c;
    }
  }
  return shape;
}

// A command of a transcript, and what the page says that it prints.
struct Command {
  std::string text;
  std::vector<std::string> output;
};

std::vector<Command> commands_of(const std::string& page) {
  std::vector<Command> commands;
  for (const std::string& block : blocks_of(page, "console")) {
    for (const std::string& line : lines_of(block)) {
      if (line.starts_with("$ ")) {
        commands.push_back({line.substr(2), {}});
      } else if (!commands.empty()) {
        commands.back().output.push_back(line);
      }
    }
  }
  return commands;
}

void expect_printed(const Command& command, const std::string& printed) {
  const std::vector<std::string> lines = lines_of(printed);
  std::size_t at = 0;
  bool skipping = false;
  for (const std::string& expected : command.output) {
    if (expected == kAnything) {
      skipping = true;
      continue;
    }
    while (skipping && at < lines.size() && shape_of(lines[at]) != shape_of(expected)) {
      ++at;
    }
    skipping = false;
    ASSERT_LT(at, lines.size()) << command.text << " does not print: " << expected;
    EXPECT_EQ(shape_of(lines[at]), shape_of(expected)) << command.text;
    ++at;
  }
  EXPECT_TRUE(skipping || at == lines.size()) << command.text << " also prints: " << lines[at];
}

class Manual : public ProgramTest {
 protected:
  static std::string page(const std::string& name) {
    return read_text_file(std::filesystem::path(FINBACK_SOURCE_DIR) / "docs" / name);
  }
  [[nodiscard]] Finished shell(const std::string& command) const {
    const std::string bin = std::filesystem::path(FINBACK_PROGRAM).parent_path().string();
    return run_program({"sh", "-c", "PATH=\"" + bin + ":$PATH\"; " + command}, folder());
  }
};

TEST_F(Manual, ExampleOfCheckIsTrue) {
  const std::string text = page("finback-check.md");
  write("budgets.toml", blocks_of(text, "toml").at(0));
  const std::vector<Command> commands = commands_of(text);
  EXPECT_GE(commands.size(), 4U);
  Finished last;
  for (const Command& command : commands) {
    if (command.text == "echo $?") {
      EXPECT_EQ(std::to_string(last.exit_code), command.output.at(0));
      continue;
    }
    last = shell(command.text);
    EXPECT_THAT(last.err, IsEmpty()) << command.text;
    expect_printed(command, last.out);
  }
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
      if (budget::matches(pattern, name) && its_unit == unit) {
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
