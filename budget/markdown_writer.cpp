#include <fmt/format.h>
#include <fmt/ranges.h>

#include <budget/writers.hpp>

namespace finback::budget {

namespace {

// Names stay legible in the raw text, too.
std::string code_span(const std::string& name) {
  return name.find_first_of("`|\n") == std::string::npos ? "`" + name + "`" : markdown_cell(name);
}

void add_table(std::string& text, const std::vector<Check>& checks) {
  text += "\n| metric | value | limit | baseline | change |\n|---|---:|---:|---:|---:|\n";
  for (const Check& check : checks) {
    const CheckRow row = row_of(check);
    const std::string origin = row.origin.empty() ? "" : fmt::format(" ({})", row.origin);
    text += fmt::format("| {} | {} | {} | {} | {} |\n", code_span(row.metric),
                        markdown_cell(row.value), markdown_cell(row.limit + origin),
                        markdown_cell(row.baseline), markdown_cell(row.change));
  }
}

// A list within a list is two spaces further in, as details are.
void add_reasons(std::string& text, const std::vector<Explanation>& why) {
  text += "\n**Why**\n\n";
  for (const Explanation& reason : why) {
    text += fmt::format("- {}\n", markdown_cell(reason.headline));
    for (const std::string& detail : reason.details) {
      const std::size_t indent = detail.find_first_not_of(' ');
      text +=
          fmt::format("  {}- {}\n", detail.substr(0, indent), markdown_cell(detail.substr(indent)));
    }
  }
}

}  // namespace

std::string markdown_cell(std::string_view text) {
  constexpr std::string_view kSpecial = "\\`*_[]<>#|~";
  std::string escaped;
  for (const char c : text) {
    if (kSpecial.find(c) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string to_markdown(const Verdict& verdict) {
  std::string text = fmt::format("### {} Cycle budget: {}\n\n",
                                 verdict.passed() ? "\u2705" : "\u274c", summary_of(verdict));
  text += markdown_cell(verdict.run) + "\n\n";
  for (const Headline& headline : verdict.headlines) {
    text +=
        fmt::format("- {}: {}\n", code_span(headline.name), markdown_cell(headline_text(headline)));
  }
  if (!verdict.changed.empty()) {
    text += fmt::format("- changed: {}\n",
                        markdown_cell(fmt::format("{}", fmt::join(verdict.changed, "; "))));
  }
  if (!verdict.passed()) {
    add_table(text, verdict.broken);
    add_reasons(text, verdict.why);
  }
  if (const std::string difference = difference_of(verdict); !difference.empty()) {
    text += "\n" + markdown_cell(difference) + "\n";
  }
  if (!verdict.held.empty()) {
    text += fmt::format("\n<details><summary>{} limit{} hold{}</summary>\n", verdict.held.size(),
                        verdict.held.size() == 1 ? "" : "s", verdict.held.size() == 1 ? "s" : "");
    add_table(text, verdict.held);
    text += "\n</details>\n";
  }
  return text;
}

}  // namespace finback::budget
