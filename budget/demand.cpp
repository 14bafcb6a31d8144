#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

#include <budget/demand.hpp>

namespace finback::budget {

namespace {

constexpr std::string_view kBaseline = "baseline";
constexpr const char* kForms =
    "write \"<= 20\", \">= 20\", \"== 20\", \"<= baseline\", \"<= baseline + 64\" or "
    "\"<= baseline + 1 %\"";

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Takes a demand's text apart from left to right.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) { skip_blanks(); }

  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) {
      return false;
    }
    rest_.remove_prefix(word.size());
    skip_blanks();
    return true;
  }

  std::optional<double> take_number() {
    std::string digits;
    std::size_t used = 0;
    for (; used < rest_.size() && rest_[used] != ' ' && rest_[used] != '%'; ++used) {
      if (rest_[used] != '_') {
        digits += rest_[used];
      } else if (used == 0 || used + 1 == rest_.size() || !is_digit(rest_[used - 1]) ||
                 !is_digit(rest_[used + 1])) {
        return std::nullopt;
      }
    }
    double number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) {
      return std::nullopt;
    }
    rest_.remove_prefix(used);
    skip_blanks();
    return number;
  }

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  void skip_blanks() {
    while (!rest_.empty() && rest_.front() == ' ') {
      rest_.remove_prefix(1);
    }
  }

  std::string_view rest_;
};

std::optional<Relation> take_relation(Scanner& scanner) {
  if (scanner.take("<=")) {
    return Relation::at_most;
  }
  if (scanner.take(">=")) {
    return Relation::at_least;
  }
  return scanner.take("==") ? std::optional(Relation::equal) : std::nullopt;
}

// What follows "baseline": nothing, or "+ 64", "- 64", "+ 1 %".
bool take_tolerance(Scanner& scanner, Demand& demand) {
  const bool minus = scanner.take("-");
  if (!minus && !scanner.take("+")) {
    return true;
  }
  const std::optional<double> number = scanner.take_number();
  if (!number || *number < 0) {
    return false;
  }
  demand.number = minus ? -*number : *number;
  demand.percent = scanner.take("%");
  return true;
}

std::optional<Demand> scan(std::string_view text) {
  Scanner scanner(text);
  Demand demand;
  const std::optional<Relation> relation = take_relation(scanner);
  if (!relation) {
    return std::nullopt;
  }
  demand.relation = *relation;
  demand.relative = scanner.take(kBaseline);
  if (demand.relative) {
    if (!take_tolerance(scanner, demand)) {
      return std::nullopt;
    }
  } else {
    const std::optional<double> number = scanner.take_number();
    if (!number) {
      return std::nullopt;
    }
    demand.number = *number;
  }
  return scanner.at_end() ? std::optional(demand) : std::nullopt;
}

}  // namespace

double Demand::bound(double baseline) const {
  if (!relative) {
    return number;
  }
  return baseline + (percent ? std::abs(baseline) * number / 100 : number);
}

bool Demand::holds(double value, double bound) const {
  switch (relation) {
    case Relation::at_most:
      return value <= bound;
    case Relation::at_least:
      return value >= bound;
    case Relation::equal:
      break;
  }
  return value == bound;
}

double Demand::excess(double value, double bound) const {
  if (holds(value, bound)) {
    return 0;
  }
  return bound == 0 ? std::numeric_limits<double>::infinity()
                    : std::abs(value - bound) / std::abs(bound);
}

std::string_view Demand::relation_text() const {
  switch (relation) {
    case Relation::at_most:
      return "<=";
    case Relation::at_least:
      return ">=";
    case Relation::equal:
      break;
  }
  return "==";
}

std::string Demand::origin_text() const {
  if (!relative) {
    return "";
  }
  if (number == 0) {
    return std::string(kBaseline);
  }
  return fmt::format("{} {} {}{}", kBaseline, number < 0 ? '-' : '+', std::abs(number),
                     percent ? " %" : "");
}

Demand parse_demand(std::string_view text, const SourcePlace& written) {
  const std::optional<Demand> demand = scan(text);
  if (!demand) {
    throw InputError(written, fmt::format("'{}' is no comparison: {}", text, kForms));
  }
  return *demand;
}

bool is_pattern(std::string_view name) { return name.find_first_of("*?") != name.npos; }

}  // namespace finback::budget
