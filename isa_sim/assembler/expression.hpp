// Expressions of numbers and symbols: reading, and their value as far as it is known.
//
// Numbers have 64 bits and wrap. A value is a number or a symbol plus a number; the difference of
// two labels of a section is a number. Operators bind as the GNU assembler says in directives
// (`*` before `|` before `+` before comparisons) and as in C within instructions; a comparison that
// holds is -1.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <isa_sim/assembler/symbol_table.hpp>
#include <isa_sim/isa/token.hpp>

namespace finback::assembler {

struct Expression {
  enum class Kind : std::uint8_t { number, symbol, unary, binary };
  Kind kind = Kind::number;
  std::int64_t number = 0;
  Symbol* symbol = nullptr;
  std::string_view sign;  // of an operator, viewing a constant
  std::shared_ptr<const Expression> left;
  std::shared_ptr<const Expression> right;
  int depth = 1;  // of the tree
};
using ExpressionPointer = std::shared_ptr<const Expression>;

// A number, or a symbol's address and a number. `problem`: why it is neither (yet).
struct Value {
  std::int64_t number = 0;
  const Symbol* symbol = nullptr;
  std::string problem;
  [[nodiscard]] bool is_number() const { return symbol == nullptr && problem.empty(); }
  [[nodiscard]] bool is_address() const { return symbol != nullptr && problem.empty(); }
};

// As far as symbols are defined now.
[[nodiscard]] Value evaluate(const Expression& expression);

// The low or the high 16 bits of a number.
[[nodiscard]] std::shared_ptr<const Expression> make_half(
    const std::shared_ptr<const Expression>& number, bool high);
// A symbol plus a number.
[[nodiscard]] std::shared_ptr<const Expression> make_sum(Symbol& symbol, std::int64_t number);

// Reads expressions in a list of tokens.
class ExpressionReader {
 public:
  enum class Precedence : std::uint8_t { directives, instructions };

  // What a name stands for: its symbol, or nullptr where it cannot stand in an expression
  // (registers, words of instructions). Called for "." too.
  class Names {
   public:
    virtual ~Names() = default;
    [[nodiscard]] virtual Symbol* symbol(const isa::Token& token) = 0;
  };

  ExpressionReader(std::span<const isa::Token> tokens, Names& names, Precedence precedence)
      : tokens_(tokens), names_(names), precedence_(precedence) {}

  // The longest expression that begins at token `start`; nullptr when none does. `end`: the token
  // behind it.
  [[nodiscard]] ExpressionPointer read(std::size_t start, std::size_t& end);
  // The last one was none because it has more operators, or nests deeper, than any is allowed to.
  [[nodiscard]] bool too_long() const { return too_long_; }

 private:
  static constexpr int kDeepest = 100;       // parentheses and signs in each other
  static constexpr int kDeepestTree = 1000;  // operators in a row

  [[nodiscard]] ExpressionPointer binary(int lowest, int depth);
  [[nodiscard]] ExpressionPointer primary(int depth);
  [[nodiscard]] int rank(const isa::Token& token) const;

  std::span<const isa::Token> tokens_;
  Names& names_;
  Precedence precedence_;
  std::size_t position_ = 0;
  bool too_long_ = false;
};

}  // namespace finback::assembler
