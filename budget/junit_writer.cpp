#include <filesystem>
#include <fmt/format.h>

#include <budget/writers.hpp>

namespace finback::budget {

namespace {

// "value 15.2, limit >= 20, baseline 62.0 (-75.5 %)".
std::string message_of(const Check& check) {
  const CheckRow row = row_of(check);
  std::string text = fmt::format("{} is {}, limit {}", row.metric, row.value, row.limit);
  if (!row.origin.empty()) {
    text += fmt::format(" ({})", row.origin);
  }
  if (check.is_new) {
    text += "; new";
  } else if (check.baseline) {
    text += fmt::format("; baseline {}, {}", row.baseline, row.change);
  }
  return text;
}

std::string why_text(const Verdict& verdict, std::size_t check) {
  std::string text;
  for (const Explanation& reason : verdict.why) {
    for (const std::size_t explained : reason.checks) {
      if (explained == check) {
        text += reason.headline + "\n";
        for (const std::string& detail : reason.details) {
          text += "  " + detail + "\n";
        }
      }
    }
  }
  return text;
}

std::string case_begin(const Check& check) {
  return fmt::format(
      "    <testcase classname=\"budget\" name=\"{} {} {}\"", xml_escaped(check.metric),
      xml_escaped(check.limit->demand.relation_text()),
      xml_escaped(check.limit->demand.relative ? check.limit->demand.origin_text()
                                               : fmt::format("{}", check.limit->demand.number)));
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&apos;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      default:
        // Other control characters cannot stand in XML at all.
        escaped += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    }
  }
  return escaped;
}

std::string to_junit(const Verdict& verdict) {
  const std::string suite =
      fmt::format("{}: {}", std::filesystem::path(verdict.budget).filename().string(), verdict.run);
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\"",
                  verdict.broken.size() + verdict.held.size(), verdict.broken.size());
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"finback check\" {}>\n", counts);
  text += fmt::format("  <testsuite name=\"{}\" {} skipped=\"0\">\n", xml_escaped(suite), counts);
  for (std::size_t i = 0; i < verdict.broken.size(); ++i) {
    text += case_begin(verdict.broken[i]) + ">\n";
    text +=
        fmt::format("      <failure type=\"budget\" message=\"{}\">{}</failure>\n",
                    xml_escaped(message_of(verdict.broken[i])), xml_escaped(why_text(verdict, i)));
    text += "    </testcase>\n";
  }
  for (const Check& check : verdict.held) {
    text += case_begin(check) + "/>\n";
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace finback::budget
