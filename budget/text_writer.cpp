#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tuple>

#include <budget/numbers.hpp>
#include <budget/writers.hpp>

namespace finback::budget {

namespace {

// Rows and named limits beyond these stand behind --all.
constexpr std::size_t kRowsShown = 20;
constexpr std::size_t kNamesShown = 4;

using Cells = std::array<std::string, 6>;

// Columns as wide as their widest cell; the first is to the left, numbers are to the right.
std::string aligned(const std::vector<Cells>& rows) {
  std::array<std::size_t, 6> widths{};
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line = fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (i + 1 == row.size()) {
        line += "  " + row[i];
      } else {
        line += fmt::format("  {:>{}}", row[i], widths[i]);
      }
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Cells cells_of(const Check& check) {
  const CheckRow row = row_of(check);
  const std::string origin = row.origin.empty() ? "" : fmt::format(" ({})", row.origin);
  return {row.metric,   row.value,  row.limit,
          row.baseline, row.change, (check.holds ? "pass" : "FAIL") + origin};
}

void add_table(std::string& text, const Verdict& verdict, bool all) {
  std::vector<Cells> rows = {{"limit on", "value", "limit", "baseline", "change", "verdict"}};
  const std::size_t shown =
      all ? verdict.broken.size() : std::min(kRowsShown, verdict.broken.size());
  for (std::size_t i = 0; i < shown; ++i) {
    rows.push_back(cells_of(verdict.broken[i]));
  }
  if (all) {
    for (const Check& check : verdict.held) {
      rows.push_back(cells_of(check));
    }
  }
  if (rows.size() > 1) {
    text += "\n" + aligned(rows);
  }
  if (shown < verdict.broken.size()) {
    text += fmt::format("  and {} more (--all shows them)\n", verdict.broken.size() - shown);
  }
}

std::string names_text(const Verdict& verdict, const Explanation& reason) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamesShown, reason.checks.size()); ++i) {
    names.push_back(verdict.broken[reason.checks[i]].metric);
  }
  const std::size_t more = reason.checks.size() - names.size();
  return fmt::format("{}{}", fmt::join(names, ", "),
                     more == 0 ? "" : fmt::format(" and {} more", more));
}

void add_reasons(std::string& text, const Verdict& verdict) {
  if (!verdict.why.empty()) {
    text += "\nWhy\n";
  }
  for (const Explanation& reason : verdict.why) {
    text += fmt::format("  {}\n", reason.headline);
    for (const std::string& detail : reason.details) {
      text += fmt::format("    {}\n", detail);
    }
    text += fmt::format("    breaks {}\n", names_text(verdict, reason));
  }
}

}  // namespace

CheckRow row_of(const Check& check) {
  CheckRow row;
  row.metric = check.metric;
  std::string bound;
  std::tie(row.value, bound) = distinct_texts(check.value, check.bound);
  row.limit = fmt::format("{} {}", check.limit->demand.relation_text(), bound);
  row.origin = check.limit->demand.origin_text();
  row.baseline = !check.baseline || check.is_new ? "-" : number_text(*check.baseline);
  if (check.baseline) {
    row.change = check.is_new ? "new" : percent_text(*check.baseline, check.value);
  }
  return row;
}

std::string summary_of(const Verdict& verdict) {
  const std::size_t total = verdict.broken.size() + verdict.held.size();
  if (verdict.passed()) {
    return total == 1 ? "the limit holds" : fmt::format("all {} limits hold", total);
  }
  return fmt::format("{} of {} limits {} broken", verdict.broken.size(), total,
                     verdict.broken.size() == 1 ? "is" : "are");
}

std::string difference_of(const Verdict& verdict) {
  if (verdict.baseline.empty()) {
    return "";
  }
  if (verdict.differing == 0) {
    return fmt::format("No difference from the baseline: all {} metrics are equal.",
                       verdict.metrics);
  }
  return fmt::format("{} of {} metrics differ from the baseline{}", verdict.differing,
                     verdict.metrics,
                     verdict.passed() ? "; --update-baseline takes these as the new ones." : ".");
}

std::string to_text(const Verdict& verdict, bool all) {
  std::string text = fmt::format("Budget {}: {}", verdict.budget, verdict.run);
  if (!verdict.baseline.empty()) {
    text += fmt::format(", against {}", verdict.baseline);
  }
  text += "\n";
  if (!verdict.changed.empty()) {
    text += fmt::format("Changed: {}\n", fmt::join(verdict.changed, "; "));
  }
  text += "\n";
  for (const Headline& headline : verdict.headlines) {
    text += fmt::format("  {:<20} {}\n", headline.name, headline_text(headline));
  }
  add_table(text, verdict, all);
  add_reasons(text, verdict);
  text += "\n";
  if (!verdict.passed() && !all && !verdict.held.empty()) {
    text += fmt::format("{} limit{} hold{} (--all shows them).\n", verdict.held.size(),
                        verdict.held.size() == 1 ? "" : "s", verdict.held.size() == 1 ? "s" : "");
  }
  if (const std::string difference = difference_of(verdict); !difference.empty()) {
    text += difference + "\n";
  }
  text += fmt::format("Verdict: {}\n", summary_of(verdict));
  return text;
}

}  // namespace finback::budget
