#include <algorithm>

#include <isa_sim/isa/matcher.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::isa {
namespace {

bool takes_register(OperandKind kind, int reg) {
  switch (kind) {
    case OperandKind::data:
      return is_data_register(reg);
    case OperandKind::data_even:
      return is_data_register(reg) && (reg - R0) % 2 == 0;
    case OperandKind::data_odd:
      return is_data_register(reg) && (reg - R0) % 2 == 1;
    case OperandKind::pointer:
      return is_pointer_register(reg);
    case OperandKind::index:
      return reg >= I0 && reg <= I3;
    case OperandKind::modify:
      return reg >= M0 && reg <= M3;
    case OperandKind::address:
      return reg >= I0 && reg <= L3;
    case OperandKind::any:
      return reg <= ASTAT;
    case OperandKind::system:
      return reg >= I0 && reg <= ASTAT;
    default:
      return false;
  }
}

// The value of a half or byte register, or -1.
int part_value(OperandKind kind, const Word& word) {
  const bool low = word.part == 'L';
  const bool high = word.part == 'H';
  const bool data = is_data_register(word.reg);
  const bool address = is_address_register(word.reg);
  switch (kind) {
    case OperandKind::data_low:
      return data && low ? word.reg : -1;
    case OperandKind::data_high:
      return data && high ? word.reg | kHighHalf : -1;
    case OperandKind::data_half:
      return data && (low || high) ? word.reg | (high ? kHighHalf : 0) : -1;
    case OperandKind::data_byte:
      return data && word.part == 'B' ? word.reg : -1;
    case OperandKind::pointer_low:
      return address && low ? word.reg : -1;
    case OperandKind::pointer_high:
      return address && high ? word.reg | kHighHalf : -1;
    default:
      return -1;
  }
}

bool has_other_parity(OperandKind kind, const Word& word) {
  return (kind == OperandKind::data_even || kind == OperandKind::data_odd) && word.part == '\0' &&
         word.reg >= 0 && is_data_register(word.reg);
}

bool fits(OperandKind kind, std::int64_t value) {
  const auto range = immediate_range(kind);
  return range && value >= range->minimum && value <= range->maximum && value % range->scale == 0;
}

// Walks the tree of patterns along one instruction's tokens and keeps the first entry in table
// order. When `misfits` is given, one operand of each reading may be anything.
class Matcher {
 public:
  Matcher(const PatternTree& tree, std::span<const Token> tokens, std::vector<Misfit>* misfits)
      : tree_(tree), tokens_(tokens), words_(tree.look_up_all(tokens)), misfits_(misfits) {}

  Reading run() {
    walk(0, 0, 0, false);
    return best_;
  }

 private:
  struct Read {
    RawValue value;
    std::size_t tokens = 0;  // how many it takes; 0: the operand does not fit
  };

  // `negative`: the pattern's '+' was written '-', so the next operand is a number to be negated.
  void walk(int node_index, std::size_t position, int operands, bool negative) {
    const Node& node = tree_.node(node_index);
    for (const Node::Edge& edge : node.operands) {
      if (is_choice(edge.step.operand) && !negative) {
        walk_choice(edge, position, operands);
      }
    }
    if (position == tokens_.size()) {
      if (node.entry >= 0) {
        finish(node.entry);
      }
      return;
    }
    if (!negative) {
      walk_literals(node, position, operands);
    }
    for (const Node::Edge& edge : node.operands) {
      if (is_choice(edge.step.operand) || (negative && is_register(edge.step.operand))) {
        continue;
      }
      if (edge.step.kind == PatternStep::Kind::repeated) {
        walk_repeated(edge, position, operands);
      } else {
        walk_operand(edge, position, operands, negative);
      }
    }
  }

  void walk_literals(const Node& node, std::size_t position, int operands) {
    const int literal = words_[position].literal;
    if (literal == kNoWord) {
      return;
    }
    for (const Node::Edge& edge : node.literals) {
      if (edge.literal == literal) {
        walk(edge.target, position + 1, operands, false);
      } else if (edge.literal == tree_.plus() && literal == tree_.minus()) {
        walk(edge.target, position + 1, operands, true);
      }
    }
  }

  void walk_choice(const Node::Edge& edge, std::size_t position, int operands) {
    const auto slot = static_cast<std::size_t>(operands);
    bool read = false;
    for (const auto& [literals, value] : tree_.choices().at(edge.step.operand)) {
      if (begins_with(literals, position)) {
        current_.operand[slot] = {value, nullptr};
        walk(edge.target, position + literals.size(), operands + 1, false);
        read |= !literals.empty();
      }
    }
    if (!read && misfits_ != nullptr && !misfit_ && position < tokens_.size() &&
        tokens_[position].is("(")) {
      // What stands inside the parenthesis, or the parenthesis where nothing follows.
      misfit_ =
          Misfit{std::min(position + 1, tokens_.size() - 1), edge.step.operand, {}, false, false};
      current_.operand[slot] = {};
      walk(edge.target, after_parenthesis(position), operands + 1, false);
      misfit_.reset();
    }
  }

  [[nodiscard]] bool begins_with(const std::vector<int>& literals, std::size_t position) const {
    return literals.size() <= words_.size() - position &&
           std::ranges::equal(literals, std::span(words_).subspan(position, literals.size()), {},
                              {}, &Word::literal);
  }

  [[nodiscard]] std::size_t after_parenthesis(std::size_t position) const {
    while (position < tokens_.size() && !tokens_[position].is(")")) {
      ++position;
    }
    return std::min(position + 1, tokens_.size());
  }

  void walk_operand(const Node::Edge& edge, std::size_t position, int operands, bool negative) {
    RawValue& slot = current_.operand[static_cast<std::size_t>(operands)];
    const Read read = read_operand(edge.step.operand, position, negative);
    if (read.tokens > 0) {
      slot = read.value;
      walk(edge.target, position + read.tokens, operands + 1, false);
    } else if (misfits_ != nullptr && !misfit_) {
      misfit_ = Misfit{position,
                       edge.step.operand,
                       {},
                       is_number(position),
                       has_other_parity(edge.step.operand, words_[position])};
      slot = {};
      walk(edge.target, position + (is_signed_number(position) ? 2 : 1), operands + 1, false);
      misfit_.reset();
    }
  }

  void walk_repeated(const Node::Edge& edge, std::size_t position, int operands) {
    const RawValue& earlier = current_.operand[static_cast<std::size_t>(edge.step.repeats)];
    const Read read = read_operand(edge.step.operand, position, false);
    if (read.tokens > 0 && read.value == earlier) {
      walk(edge.target, position + read.tokens, operands, false);
    } else if (misfits_ != nullptr && !misfit_) {
      const OperandValue wanted{static_cast<std::int32_t>(earlier.number), {}};
      misfit_ = Misfit{position, edge.step.operand, print_operand(edge.step.operand, wanted), false,
                       false};
      walk(edge.target, position + 1, operands, false);
      misfit_.reset();
    }
  }

  void finish(int entry) {
    if (misfit_) {
      misfits_->push_back(*misfit_);
    } else if (best_.entry < 0 || entry < best_.entry) {
      best_ = current_;
      best_.entry = entry;
    }
  }

  [[nodiscard]] bool is_signed_number(std::size_t position) const {
    return position + 1 < tokens_.size() && tokens_[position + 1].kind == TokenKind::number &&
           (tokens_[position].is("-") || tokens_[position].is("+"));
  }
  [[nodiscard]] bool is_number(std::size_t position) const {
    return tokens_[position].kind == TokenKind::number || is_signed_number(position);
  }

  [[nodiscard]] Read read_operand(OperandKind kind, std::size_t position, bool negative) const {
    if (is_code_address(kind)) {
      return negative ? Read{} : read_symbol(position);
    }
    if (!is_register(kind)) {
      const Read read = read_number(kind, position, negative);
      return read.tokens == 0 && kind == OperandKind::any16 && !negative ? read_symbol(position)
                                                                         : read;
    }
    const Word& word = words_[position];
    if (word.reg < 0) {
      return {};
    }
    switch (kind) {
      case OperandKind::data_pair:
        return read_list(position, {R1, R3}, 2);
      case OperandKind::data_list:
        return read_list(position, {R7, R7}, 8);
      case OperandKind::pointer_list:
        return read_list(position, {P5, P5}, 6);
      default:
        break;
    }
    const int value = word.part != '\0' ? part_value(kind, word)
                                        : (takes_register(kind, word.reg) ? word.reg : -1);
    return value < 0 ? Read{} : Read{{value, nullptr}, 1};
  }

  // "R7:4": one of `first`, a colon, a number below `limit`. Of a pair, the register below `first`.
  [[nodiscard]] Read read_list(std::size_t position, std::array<int, 2> first, int limit) const {
    const Word& word = words_[position];
    if (position + 2 >= tokens_.size() || word.part != '\0' ||
        (word.reg != first[0] && word.reg != first[1]) || !tokens_[position + 1].is(":") ||
        tokens_[position + 2].kind != TokenKind::number) {
      return {};
    }
    const std::int64_t number = tokens_[position + 2].number;
    const bool pair = first[0] != first[1];
    if (pair ? number != word.reg - R0 - 1 : number < 0 || number >= limit) {
      return {};
    }
    return {{number, nullptr}, 3};
  }

  [[nodiscard]] Read read_number(OperandKind kind, std::size_t position, bool negative) const {
    Read read;
    if (tokens_[position].kind == TokenKind::number) {
      read = {{tokens_[position].number, nullptr}, 1};
    } else if (is_signed_number(position)) {
      const std::int64_t number = tokens_[position + 1].number;
      read = {{tokens_[position].is("-") ? -number : number, nullptr}, 2};
    } else {
      return {};
    }
    if (negative) {
      read.value.number = -read.value.number;
    }
    return fits(kind, read.value.number) ? read : Read{};
  }

  // "_x", "_x + 4", ".Lx - 2".
  [[nodiscard]] Read read_symbol(std::size_t position) const {
    if (tokens_[position].kind != TokenKind::name || words_[position].reg >= 0) {
      return {};
    }
    Read read{{0, &tokens_[position]}, 1};
    if (position + 2 < tokens_.size() && is_signed_number(position + 1)) {
      const std::int64_t number = tokens_[position + 2].number;
      if (number > 0x7fffffff) {
        return {};
      }
      read.value.number = tokens_[position + 1].is("-") ? -number : number;
      read.tokens = 3;
    }
    return read;
  }

  const PatternTree& tree_;
  std::span<const Token> tokens_;
  std::vector<Word> words_;
  std::vector<Misfit>* misfits_;
  std::optional<Misfit> misfit_;
  Reading current_;
  Reading best_;
};

}  // namespace

Reading read_tokens(const PatternTree& tree, std::span<const Token> tokens,
                    std::vector<Misfit>* misfits) {
  return Matcher(tree, tokens, misfits).run();
}

}  // namespace finback::isa
