#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <isa_sim/assembler/expression.hpp>

namespace finback::assembler {
namespace {

using isa::Token;
using isa::TokenKind;

constexpr int kMostSteps = 100'000;  // of one evaluation

struct Operator {
  std::string_view sign;
  int in_directives;
  int in_instructions;
};

// Ranks: the higher bind first.
constexpr std::array kOperators = {
    Operator{"*", 5, 10}, Operator{"/", 5, 10}, Operator{"%", 5, 10}, Operator{"<<", 5, 8},
    Operator{">>", 5, 8}, Operator{"|", 4, 3},  Operator{"&", 4, 5},  Operator{"^", 4, 4},
    Operator{"!", 4, 0},  Operator{"+", 3, 9},  Operator{"-", 3, 9},  Operator{"==", 2, 6},
    Operator{"!=", 2, 6}, Operator{"<", 2, 7},  Operator{">", 2, 7},  Operator{"<=", 2, 7},
    Operator{">=", 2, 7}, Operator{"&&", 1, 0}, Operator{"||", 1, 0},
};
constexpr std::string_view kShiftOfOperand = ">>>";  // what `>>` is within an instruction
constexpr std::array<std::string_view, 4> kUnary = {"-", "~", "!", "+"};

std::int64_t wrap(std::uint64_t value) { return static_cast<std::int64_t>(value); }

std::optional<std::int64_t> apply(std::string_view sign, std::int64_t left, std::int64_t right) {
  const auto a = static_cast<std::uint64_t>(left);
  const auto b = static_cast<std::uint64_t>(right);
  const auto truth = [](bool holds) { return holds ? std::int64_t{-1} : std::int64_t{0}; };
  if (sign == "+")
    return wrap(a + b);
  if (sign == "-")
    return wrap(a - b);
  if (sign == "*")
    return wrap(a * b);
  if (sign == "/" || sign == "%") {
    if (right == 0) {
      return std::nullopt;
    }
    if (right == -1) {  // the one quotient that does not fit would trap
      return sign == "/" ? wrap(0 - a) : 0;
    }
    return sign == "/" ? left / right : left % right;
  }
  if (sign == "<<")
    return b > 63 ? 0 : wrap(a << b);
  if (sign == ">>")
    return b > 63 ? 0 : wrap(a >> b);
  if (sign == kShiftOfOperand) {  // operands have 32 bits and a sign
    return static_cast<std::int64_t>(static_cast<std::int32_t>(a)) >>
           std::min<std::uint64_t>(b, 31);
  }
  if (sign == "|")
    return left | right;
  if (sign == "&")
    return left & right;
  if (sign == "^")
    return left ^ right;
  if (sign == "!")
    return left | ~right;
  if (sign == "==")
    return truth(left == right);
  if (sign == "!=")
    return truth(left != right);
  if (sign == "<")
    return truth(left < right);
  if (sign == ">")
    return truth(left > right);
  if (sign == "<=")
    return truth(left <= right);
  if (sign == ">=")
    return truth(left >= right);
  if (sign == "&&")
    return left != 0 && right != 0 ? 1 : 0;
  return left != 0 || right != 0 ? 1 : 0;
}

Value problem(std::string text) { return {0, nullptr, std::move(text)}; }

// `steps`: that are left, so that symbols which depend on each other come to an end.
Value evaluate_at(const Expression& expression, int depth, int& steps);

Value evaluate_symbol(const Symbol& symbol, int depth, int& steps) {
  switch (symbol.kind) {
    case Symbol::Kind::number:
      return {symbol.number, nullptr, {}};
    case Symbol::Kind::equated:
      return evaluate_at(*symbol.equated, depth + 1, steps);
    default:
      return {0, &symbol, {}};
  }
}

// Both are addresses.
Value difference(const Value& left, const Value& right) {
  const Symbol& one = *left.symbol;
  const Symbol& other = *right.symbol;
  if (&one == &other) {
    return {left.number - right.number, nullptr, {}};
  }
  for (const Symbol* symbol : {&one, &other}) {
    if (symbol->kind != Symbol::Kind::label) {
      return problem(
          fmt::format("{} is not defined in this file, so that its difference to {} is "
                      "not known",
                      symbol->name, symbol == &one ? other.name : one.name));
    }
  }
  if (one.section != other.section) {
    return problem(
        fmt::format("{} and {} stand in different sections: their difference is not "
                    "known",
                    one.name, other.name));
  }
  return {left.number + one.offset - right.number - other.offset, nullptr, {}};
}

Value evaluate_binary(const Expression& expression, int depth, int& steps) {
  Value left = evaluate_at(*expression.left, depth + 1, steps);
  if (!left.problem.empty()) {
    return left;
  }
  Value right = evaluate_at(*expression.right, depth + 1, steps);
  if (!right.problem.empty()) {
    return right;
  }
  const std::string_view sign = expression.sign;
  if (left.is_number() && right.is_number()) {
    const auto result = apply(sign, left.number, right.number);
    return result ? Value{*result, nullptr, {}} : problem("division by zero");
  }
  if (sign == "+" && (left.is_number() || right.is_number())) {
    return {
        wrap(static_cast<std::uint64_t>(left.number) + static_cast<std::uint64_t>(right.number)),
        left.is_address() ? left.symbol : right.symbol,
        {}};
  }
  if (sign == "-" && right.is_number()) {
    return {
        wrap(static_cast<std::uint64_t>(left.number) - static_cast<std::uint64_t>(right.number)),
        left.symbol,
        {}};
  }
  if (left.is_address() && right.is_address() && sign != "+") {
    Value apart = difference(left, right);
    if (sign == "-" || !apart.problem.empty()) {
      return apart;
    }
    if (sign.find_first_of("=<>!") != std::string_view::npos && sign != "<<" && sign != ">>" &&
        sign != "!") {
      return {*apply(sign, apart.number, 0), nullptr, {}};
    }
  }
  const Symbol& symbol = left.is_address() ? *left.symbol : *right.symbol;
  return problem(fmt::format("'{}' wants numbers, but {} is {}", sign, symbol.name,
                             symbol.kind == Symbol::Kind::label
                                 ? "an address, which is not known before the program is placed"
                                 : "not defined in this file"));
}

Value evaluate_at(const Expression& expression, int depth, int& steps) {
  static constexpr int kDeepest = 4000;
  if (--steps < 0 || depth > kDeepest) {
    return problem("this expression depends on itself, or on too many others");
  }
  switch (expression.kind) {
    case Expression::Kind::number:
      return {expression.number, nullptr, {}};
    case Expression::Kind::symbol:
      return evaluate_symbol(*expression.symbol, depth, steps);
    case Expression::Kind::unary: {
      Value value = evaluate_at(*expression.left, depth + 1, steps);
      if (!value.problem.empty()) {
        return value;
      }
      if (value.is_address()) {
        return problem(fmt::format("'{}' wants a number, but {} is an address", expression.sign,
                                   value.symbol->name));
      }
      if (expression.sign == "-") {
        value.number = wrap(0 - static_cast<std::uint64_t>(value.number));
      } else {
        value.number = expression.sign == "~" ? ~value.number : (value.number == 0 ? 1 : 0);
      }
      return value;
    }
    case Expression::Kind::binary:
      return evaluate_binary(expression, depth, steps);
  }
  return {};
}

ExpressionPointer make_number(std::int64_t number) {
  Expression expression;
  expression.number = number;
  return std::make_shared<const Expression>(std::move(expression));
}

ExpressionPointer make_symbol(Symbol& symbol) {
  Expression expression;
  expression.kind = Expression::Kind::symbol;
  expression.symbol = &symbol;
  return std::make_shared<const Expression>(std::move(expression));
}

// `right`: nullptr for an operator of one operand.
ExpressionPointer make_operation(std::string_view sign, ExpressionPointer left,
                                 ExpressionPointer right) {
  Expression expression;
  expression.kind = right == nullptr ? Expression::Kind::unary : Expression::Kind::binary;
  expression.sign = sign;
  expression.depth = 1 + std::max(left->depth, right == nullptr ? 0 : right->depth);
  expression.left = std::move(left);
  expression.right = std::move(right);
  return std::make_shared<const Expression>(std::move(expression));
}

}  // namespace

Value evaluate(const Expression& expression) {
  int steps = kMostSteps;
  return evaluate_at(expression, 0, steps);
}

ExpressionPointer make_half(const ExpressionPointer& number, bool high) {
  constexpr std::int64_t kHalf = 0xffff;
  return make_operation("&", make_operation(">>", number, make_number(high ? 16 : 0)),
                        make_number(kHalf));
}

ExpressionPointer make_sum(Symbol& symbol, std::int64_t number) {
  return number == 0 ? make_symbol(symbol)
                     : make_operation("+", make_symbol(symbol), make_number(number));
}

ExpressionPointer ExpressionReader::read(std::size_t start, std::size_t& end) {
  position_ = start;
  too_long_ = false;
  ExpressionPointer expression = binary(1, 0);
  end = position_;
  return expression;
}

int ExpressionReader::rank(const Token& token) const {
  if (token.kind != TokenKind::sign) {
    return 0;
  }
  const auto found = std::ranges::find(kOperators, token.text, &Operator::sign);
  if (found == kOperators.end()) {
    return 0;
  }
  return precedence_ == Precedence::directives ? found->in_directives : found->in_instructions;
}

ExpressionPointer ExpressionReader::binary(int lowest, int depth) {
  ExpressionPointer left = primary(depth);
  while (left != nullptr && position_ < tokens_.size()) {
    const int own = rank(tokens_[position_]);
    if (own < lowest || own == 0) {
      break;
    }
    const std::size_t at = position_++;
    ExpressionPointer right = binary(own + 1, depth + 1);
    if (right == nullptr) {
      position_ = at;  // what stands before the sign is an expression all the same
      break;
    }
    std::string_view sign = std::ranges::find(kOperators, tokens_[at].text, &Operator::sign)->sign;
    if (sign == ">>" && precedence_ == Precedence::instructions) {
      sign = kShiftOfOperand;
    }
    left = make_operation(sign, std::move(left), std::move(right));
    if (left->depth > kDeepestTree) {
      too_long_ = true;
      return nullptr;
    }
  }
  return left;
}

ExpressionPointer ExpressionReader::primary(int depth) {
  if (position_ >= tokens_.size() || depth > kDeepest) {
    too_long_ = too_long_ || depth > kDeepest;
    return nullptr;
  }
  const Token& token = tokens_[position_];
  const std::size_t start = position_;
  if (token.kind == TokenKind::number) {
    ++position_;
    return make_number(token.number);
  }
  if (token.kind == TokenKind::name) {
    Symbol* symbol = names_.symbol(token);
    if (symbol == nullptr) {
      return nullptr;
    }
    ++position_;
    if (symbol->kind == Symbol::Kind::number) {  // as it is now: it may be set again
      return make_number(symbol->number);
    }
    if (symbol->kind == Symbol::Kind::equated) {
      return symbol->equated;
    }
    return make_symbol(*symbol);
  }
  if (token.is("(")) {
    ++position_;
    ExpressionPointer inside = binary(1, depth + 1);
    if (inside != nullptr && position_ < tokens_.size() && tokens_[position_].is(")")) {
      ++position_;
      return inside;
    }
  } else if (const auto sign = std::ranges::find(kUnary, token.text);
             token.kind == TokenKind::sign && sign != kUnary.end()) {
    ++position_;
    ExpressionPointer operand = primary(depth + 1);
    if (operand != nullptr) {
      return *sign == "+" ? operand : make_operation(*sign, std::move(operand), nullptr);
    }
  }
  position_ = start;
  return nullptr;
}

}  // namespace finback::assembler
