// A verdict for people and for machines of continuous integration.
#pragma once

#include <string>
#include <string_view>

#include <budget/verdict.hpp>

namespace finback::budget {

// Tables for a terminal; `all`: with the limits that hold.
[[nodiscard]] std::string to_text(const Verdict& verdict, bool all);

// JUnit XML: a test case a check.
[[nodiscard]] std::string to_junit(const Verdict& verdict);

// For the comment of a pull request.
[[nodiscard]] std::string to_markdown(const Verdict& verdict);

// GitHub's workflow commands: an annotation for each reason, at the line of source that changed
// most, or at the limit when that is not known. "" when all limits hold.
[[nodiscard]] std::string to_github(const Verdict& verdict);

// What tells a check in a row of a table.
struct CheckRow {
  std::string metric;
  std::string value;
  std::string limit;     // "<= 17,885,760"
  std::string origin;    // "baseline + 1 %", or ""
  std::string baseline;  // "-" when there is none
  std::string change;    // against the baseline: "+69.0 %", "new"
};
[[nodiscard]] CheckRow row_of(const Check& check);

// "3 of 42 limits are broken", "all 42 limits hold".
[[nodiscard]] std::string summary_of(const Verdict& verdict);

// How the run differs from the baseline as a whole: one sentence, or "" without a baseline.
[[nodiscard]] std::string difference_of(const Verdict& verdict);

// Text that XML can hold between tags and in attributes.
[[nodiscard]] std::string xml_escaped(std::string_view text);
// A message of a workflow command, and a property of one.
[[nodiscard]] std::string github_message(std::string_view text);
[[nodiscard]] std::string github_property(std::string_view text);
// Text in a cell of a Markdown table.
[[nodiscard]] std::string markdown_cell(std::string_view text);

}  // namespace finback::budget
