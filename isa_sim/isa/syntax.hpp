// The syntax of instructions, compiled from the table: reading, printing, and the role of operands.
//
// A pattern is literal text with operands between braces, `{kind marks}` (operand.hpp); `{=N}`
// stands for operand N once more and must be written the same, `{?text}` at the end for literal
// text that may be left out ("R0 = 5 (X)"). Where several entries read the same text the first in
// the table wins, so that short forms stand before long ones. Spaces and the case of registers and
// mnemonics are free. Does not know packets or directives: those are ir/parser's. Source: the
// algebraic syntax of the Blackfin Programming Reference, as GNU as reads it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isa_sim/isa/instruction.hpp>
#include <isa_sim/isa/operand.hpp>
#include <isa_sim/isa/token.hpp>

namespace finback::isa {

// The value of an operand before linking: a number (see OperandKind), or symbol + number.
struct OperandValue {
  std::int32_t number = 0;
  std::string symbol;  // empty: `number` is the value
  bool operator==(const OperandValue&) const = default;
};

struct ParsedInstruction {
  int instruction = -1;  // index in the table
  std::array<OperandValue, kMaxOperands> operand;
  bool operator==(const ParsedInstruction&) const = default;
};

// The operands of one table entry, in the order of its pattern (which is that of their values).
struct OperandRoles {
  std::array<OperandRole, kMaxOperands> role{};
  int count = 0;
  [[nodiscard]] auto begin() const { return role.begin(); }
  [[nodiscard]] auto end() const { return role.begin() + count; }
  const OperandRole& operator[](int index) const { return role[static_cast<std::size_t>(index)]; }
};

// Why no entry reads a text.
struct SyntaxProblem {
  std::string message;    // "immediate 99 does not fit: -64..63"
  std::size_t token = 0;  // index of the token to blame
};

class Syntax {
 public:
  // `table` must outlive the syntax. Throws std::logic_error naming the entry whose pattern is
  // malformed.
  explicit Syntax(std::span<const Instruction> table);
  Syntax(const Syntax&) = delete;
  Syntax& operator=(const Syntax&) = delete;
  ~Syntax();

  // The first entry that reads all of `tokens` (one instruction, without `;` or `||`). The two
  // parts of a vector instruction may stand in either order.
  [[nodiscard]] std::optional<ParsedInstruction> match(std::span<const Token> tokens) const;
  // Whether some instruction has this word or sign in its text, in a choice of it, too.
  [[nodiscard]] bool has_word(const Token& token) const;
  // Why `match` found nothing: one operand that does not fit, or that no instruction looks so.
  [[nodiscard]] SyntaxProblem explain(std::span<const Token> tokens) const;
  // `match` of one instruction given as text. Throws InputError "line:column: why".
  [[nodiscard]] ParsedInstruction parse(std::string_view text) const;

  // The canonical text, without `;`; `match` reads it back. Numbers of code addresses print as hex.
  [[nodiscard]] std::string print(const ParsedInstruction& instruction) const;
  [[nodiscard]] const OperandRoles& roles(int instruction) const;
  [[nodiscard]] std::span<const Instruction> table() const { return table_; }

  // What is wrong with the table, one line each; empty when every entry prints sampled operands to
  // text that is read back as the same and no two entries have the same syntax.
  [[nodiscard]] std::vector<std::string> check_table() const;
  // Pairs of entries that no text tells apart.
  [[nodiscard]] std::span<const std::pair<int, int>> same_syntax() const;

 private:
  [[nodiscard]] std::optional<ParsedInstruction> match_as_written(
      std::span<const Token> tokens) const;

  struct Compiled;
  std::span<const Instruction> table_;
  std::unique_ptr<Compiled> compiled_;
};

// Operand values to try: the ends of the kind's range and some between; a symbol for code
// addresses.
[[nodiscard]] std::vector<OperandValue> sample_values(OperandKind kind);

// The syntax of instruction_table(), compiled at the first call.
[[nodiscard]] const Syntax& instruction_syntax();
// The roles of the operands of instruction_table()[instruction].
[[nodiscard]] const OperandRoles& roles_of(int instruction);
// The text of a linked instruction of instruction_table(), for traces and listings.
[[nodiscard]] std::string disassemble(int instruction,
                                      const std::array<std::int32_t, kMaxOperands>& operand);

}  // namespace finback::isa
