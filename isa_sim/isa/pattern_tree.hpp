// The patterns of the instruction table as a tree, and the words that they know.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <isa_sim/isa/pattern.hpp>
#include <isa_sim/isa/token.hpp>

namespace finback::isa {

inline constexpr int kNoWord = -1;

// What a token can be, looked up once.
struct Word {
  int literal = kNoWord;  // id of a literal token of some pattern
  int reg = -1;           // a register ...
  char part = '\0';       // ... or its half 'L', 'H', or byte 'B'
};

// An operand while reading: symbols are tokens still.
struct RawValue {
  std::int64_t number = 0;
  const Token* symbol = nullptr;
  bool operator==(const RawValue&) const = default;
};

// One reading of the tokens as an entry of the table.
struct Reading {
  int entry = -1;
  std::array<RawValue, kMaxOperands> operand{};
};

// The patterns as a tree: those that begin alike share their first steps.
struct Node {
  struct Edge {
    PatternStep step;
    int literal = kNoWord;
    int target = 0;
  };
  std::vector<Edge> literals;  // ordered by id
  std::vector<Edge> operands;  // and repeated operands
  int entry = -1;              // the pattern that ends here
};

// The spellings of each kind of choice: ids of literals, and the value.
using Choices = std::map<OperandKind, std::vector<std::pair<std::vector<int>, std::int32_t>>>;

class PatternTree {
 public:
  PatternTree() { add_registers(); }

  // Entry `entry` of the table; where two have the same syntax, both are noted.
  void add(int entry, Pattern pattern);
  // Another pattern that reads as `entry`, which was added before.
  void add_spelling(int entry, const Pattern& pattern) { add_steps(entry, pattern.steps); }

  [[nodiscard]] const std::vector<Pattern>& patterns() const { return patterns_; }
  [[nodiscard]] const Node& node(int index) const {
    return nodes_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const Choices& choices() const { return choices_; }
  [[nodiscard]] const std::vector<std::pair<int, int>>& same_syntax() const { return same_syntax_; }
  [[nodiscard]] Word look_up(const Token& token) const;
  [[nodiscard]] std::vector<Word> look_up_all(std::span<const Token> tokens) const;
  // The literals + and -.
  [[nodiscard]] int plus() const { return plus_; }
  [[nodiscard]] int minus() const { return minus_; }

 private:
  Word& word(const std::string& text);
  void add_registers();
  int literal_id(const std::string& text);
  int target(int from, const PatternStep& step);
  void add_choice(OperandKind kind);
  void add_steps(int entry, const std::vector<PatternStep>& steps);

  std::vector<Pattern> patterns_;
  std::vector<Node> nodes_{Node{}};
  Choices choices_;
  std::unordered_map<std::string_view, Word> words_;
  std::vector<std::unique_ptr<std::string>> word_texts_;  // what the keys of `words_` view
  std::vector<std::pair<int, int>> same_syntax_;
  int next_literal_ = 0;
  int plus_ = literal_id("+");
  int minus_ = literal_id("-");
};

}  // namespace finback::isa
