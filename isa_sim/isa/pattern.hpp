// One table entry's syntax taken apart: literal tokens and operands, as reading wants them, and
// pieces of text between operands, as printing wants them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {

// A step of a pattern: a literal token, an operand, or an earlier operand once more.
struct PatternStep {
  enum class Kind : std::uint8_t { literal, operand, repeated } kind = Kind::literal;
  std::string literal;  // upper case
  OperandKind operand = OperandKind::data;
  int repeats = -1;  // which operand is repeated
  bool operator==(const PatternStep&) const = default;
};

struct Pattern {
  std::vector<PatternStep> steps;
  std::vector<PatternStep> short_steps;  // without `{?text}`; empty when there is none
  OperandRoles roles;
  std::vector<std::string> texts;  // between the values printed: one more than `values`
  std::vector<int> values;         // operand numbers in the order of printing
};

// Throws std::logic_error that names the pattern when it is malformed.
[[nodiscard]] Pattern compile_pattern(std::string_view syntax);

// An operand's value as text.
[[nodiscard]] std::string print_operand(OperandKind kind, const OperandValue& value);

// What a kind takes, for messages: "a data register R0..R7", "a number -64..63".
[[nodiscard]] std::string describe(OperandKind kind);

}  // namespace finback::isa
