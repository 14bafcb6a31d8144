// Unified diffs, as diff -u writes them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include <common/text_diff.hpp>

namespace finback {
namespace {

std::string diff(const std::string& before, const std::string& after) {
  return unified_diff({"a", before}, {"b", after});
}

TEST(TextDiff, OfEqualTextsIsEmpty) {
  EXPECT_EQ(diff("one\ntwo\n", "one\ntwo\n"), "");
  EXPECT_EQ(diff("", ""), "");
}

TEST(TextDiff, ShowsThreeLinesAroundAChange) {
  EXPECT_EQ(diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n"),
            "--- a\n+++ b\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST(TextDiff, NamesWhatIsNotThere) {
  EXPECT_EQ(unified_diff({}, {"new", "x\n"}), "--- /dev/null\n+++ new\n@@ -0,0 +1,1 @@\n+x\n");
  EXPECT_EQ(unified_diff({"old", "x\n"}, {}), "--- old\n+++ /dev/null\n@@ -1,1 +0,0 @@\n-x\n");
}

TEST(TextDiff, ParesNearChangesAndPartsFarOnes) {
  const std::string before = "a\n1\n2\n3\n4\n5\n6\nb\n1\n2\n3\n4\n5\n6\n7\nc\n";
  const std::string after = "A\n1\n2\n3\n4\n5\n6\nB\n1\n2\n3\n4\n5\n6\n7\nC\n";
  const std::string text = diff(before, after);
  EXPECT_EQ(text.find("@@ -1,11 +1,11 @@"), 12U);                // six lines between: one hunk
  EXPECT_NE(text.find("@@ -13,4 +13,4 @@"), std::string::npos);  // seven: two
}

// Applied, a diff gives the other text: read back by its own rules.
std::string applied(const std::string& before, const std::string& patch) {
  std::istringstream old_lines(before);
  std::istringstream in(patch);
  std::string result;
  std::string line;
  std::size_t taken = 0;
  const auto copy_until = [&](std::size_t end) {
    for (std::string kept; taken < end && std::getline(old_lines, kept); ++taken) {
      result += kept + '\n';
    }
  };
  while (std::getline(in, line)) {
    if (line.starts_with("@@ -")) {
      const std::size_t first = std::stoul(line.substr(4));
      const bool none = line.substr(0, line.find('+')).ends_with(",0 ");
      copy_until(none ? first : first - 1);
    } else if (!line.starts_with("---") && !line.starts_with("+++")) {
      std::string old_line;
      if (line[0] != '+') {
        std::getline(old_lines, old_line);
        EXPECT_EQ(old_line, line.substr(1));
        ++taken;
      }
      result += line[0] == '-' ? "" : line.substr(1) + '\n';
    }
  }
  copy_until(~std::size_t{0});
  return result;
}

TEST(TextDiff, LeadsFromEveryTextToEveryOther) {
  std::mt19937 random(1);
  const auto text = [&] {
    std::string lines;
    for (std::size_t count = random() % 30; count > 0; --count) {
      lines += fmt::format("line {}\n", random() % 6);
    }
    return lines;
  };
  for (int i = 0; i < 300; ++i) {
    const std::string before = text();
    const std::string after = text();
    EXPECT_EQ(applied(before, diff(before, after)), after);
  }
}

}  // namespace
}  // namespace finback
