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

std::pair<std::string, std::string> distinct_texts(double left, double right) {
  constexpr int kFirst = 6;  // significant digits; 17 tell all numbers apart
  constexpr int kLast = 17;
  std::pair<std::string, std::string> texts = {number_text(left), number_text(right)};
  for (int digits = kFirst; digits <= kLast && texts.first == texts.second && left != right;
       ++digits) {
    texts = {grouped(fmt::format("{:.{}g}", left, digits)),
             grouped(fmt::format("{:.{}g}", right, digits))};
  }
  return texts;
}

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
  constexpr double kLarge = 1000;
  constexpr double kOneDecimal = 0.1;
  constexpr double kSmall = 0.001;
  if (percent >= kLarge && before > 0) {
    return fmt::format("x {}", number_text(std::round(after / before)));
  }
  if (std::abs(percent) < kSmall) {
    return "<0.001 %";
  }
  return fmt::format("{:+.{}f} %", percent, std::abs(percent) >= kOneDecimal ? 1 : 3);
}

}  // namespace finback::budget
