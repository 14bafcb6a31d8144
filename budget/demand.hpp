// What a limit demands of one number: "<= 20", ">= baseline", "<= baseline + 1 %".
//
// A demand is a relation and a bound; the bound is a number, or the baseline's value of the same
// metric with something added to it. Knows nothing of metrics and files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <common/error.hpp>

namespace finback::budget {

enum class Relation : std::uint8_t { at_most, at_least, equal };

struct Demand {
  Relation relation = Relation::at_most;
  bool relative = false;  // to the baseline's value
  double number = 0;      // the bound; of a relative demand what is added to the baseline's value
  bool percent = false;   // relative: `number` is percent of it

  // What the number is held against. `baseline` matters to relative demands only.
  [[nodiscard]] double bound(double baseline) const;
  [[nodiscard]] bool holds(double value, double bound) const;
  // How far beyond `bound` a value is, as a share of the bound: 0.5 is half as much again. 0 when
  // the demand holds; infinite beyond a bound of 0.
  [[nodiscard]] double excess(double value, double bound) const;

  // "<=", and what a relative bound is made from: "baseline + 1 %"; "" when it is a plain number.
  [[nodiscard]] std::string_view relation_text() const;
  [[nodiscard]] std::string origin_text() const;
};

// Throws InputError at `written`, showing the forms, when `text` is none of them. Numbers may hold
// underscores between digits: 4_500_000.
[[nodiscard]] Demand parse_demand(std::string_view text, const SourcePlace& written);

// Whether `name` is a pattern (common/pattern.hpp).
[[nodiscard]] bool is_pattern(std::string_view name);

}  // namespace finback::budget
