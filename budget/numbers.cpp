#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

#include <budget/numbers.hpp>
#include <report/metrics.hpp>

namespace finback::budget {

namespace {

// Commas into the digits before the point; what does not begin with digits stays.
std::string grouped(const std::string& digits) {
  const std::size_t begin = digits.starts_with('-') ? 1 : 0;
  std::size_t end = digits.find_first_not_of("0123456789", begin);
  end = end == std::string::npos ? digits.size() : end;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > begin && i < end && (end - i) % 3 == 0) {
      text += ',';
    }
    text += digits[i];
  }
  return text;
}

}  // namespace

std::string number_text(double value) {
  std::string text = report::metric_text(value);
  if (text.ends_with(".0")) {  // rounded to a whole number
    text.resize(text.size() - 2);
  }
  return grouped(text);
}

std::string exact_text(double value) { return grouped(fmt::format("{}", value)); }

std::string signed_text(std::int64_t value) {
  return (value < 0 ? "-" : "+") + grouped(fmt::format("{}", std::abs(value)));
}

std::string percent_text(double before, double after) {
  if (before == after) {
    return "0 %";
  }
  if (before == 0) {
    return "from 0";
  }
  const double percent = 100 * (after - before) / std::abs(before);
  return std::abs(percent) >= 0.1 ? fmt::format("{:+.1f} %", percent)
                                  : fmt::format("{:+.1g} %", percent);
}

}  // namespace finback::budget
