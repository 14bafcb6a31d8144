#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <unordered_map>

#include <common/error.hpp>
#include <isa_sim/isa/pattern.hpp>
#include <isa_sim/isa/registers.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {
namespace {

constexpr int kNoWord = -1;
constexpr std::size_t kLongestWord = 23;  // longer names are symbols

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

// The spellings of each kind of choice, taken apart into tokens.
using Choices =
    std::map<OperandKind, std::vector<std::pair<std::vector<std::string>, std::int32_t>>>;

// An operand that does not fit, in a reading that is otherwise complete.
struct Misfit {
  std::size_t token = 0;
  OperandKind kind = OperandKind::data;
  std::string repeated;  // what operand was to be written once more; "" for others
  bool number = false;   // a number stands there
};

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

bool fits(OperandKind kind, std::int64_t value) {
  const auto range = immediate_range(kind);
  return range && value >= range->minimum && value <= range->maximum && value % range->scale == 0;
}

}  // namespace

struct Syntax::Compiled {
  std::vector<Pattern> patterns;
  std::vector<Node> nodes{Node{}};
  Choices choices;
  std::unordered_map<std::string_view, Word> words;
  std::vector<std::unique_ptr<std::string>> word_texts;  // what the keys of `words` view
  std::vector<std::pair<int, int>> same_syntax;

  Word& word(const std::string& text) {
    const auto found = words.find(text);
    if (found != words.end()) {
      return found->second;
    }
    word_texts.push_back(std::make_unique<std::string>(text));
    return words[*word_texts.back()];
  }

  void add_registers() {
    for (int reg = 0; reg < kRegisterCount; ++reg) {
      const std::string name(register_name(static_cast<Register>(reg)));
      word(name).reg = reg;
      if (is_data_register(reg) || is_address_register(reg)) {
        for (const char part : {'L', 'H', 'B'}) {
          Word& half = word(name + "." + part);
          half.reg = reg;
          half.part = part;
        }
      }
    }
  }

  int literal_id(const std::string& text) {
    Word& entry = word(text);
    if (entry.literal == kNoWord) {
      entry.literal = next_literal++;
    }
    return entry.literal;
  }

  int target(int from, const PatternStep& step) {
    const bool literal = step.kind == PatternStep::Kind::literal;
    const int id = literal ? literal_id(step.literal) : kNoWord;
    Node& node = nodes[static_cast<std::size_t>(from)];
    std::vector<Node::Edge>& edges = literal ? node.literals : node.operands;
    const auto found = std::ranges::find(edges, step, &Node::Edge::step);
    if (found != edges.end()) {
      return found->target;
    }
    const int added = static_cast<int>(nodes.size());
    edges.push_back({step, id, added});
    std::ranges::sort(edges, {}, &Node::Edge::literal);
    nodes.emplace_back();
    return added;
  }

  void add_choice(OperandKind kind) {
    auto& all = choices[kind];
    for (const Spelling& spelling : spellings(kind)) {
      auto& [texts, value] = all.emplace_back();
      value = spelling.value;
      for (const Token& token : tokenize(spelling.text)) {
        texts.emplace_back(token.text);
      }
    }
  }

  void add(int entry, Pattern pattern) {
    for (const OperandRole& role : pattern.roles) {
      if (is_choice(role.kind) && !choices.contains(role.kind)) {
        add_choice(role.kind);
      }
    }
    add_steps(entry, pattern.steps);
    if (!pattern.short_steps.empty()) {
      add_steps(entry, pattern.short_steps);
    }
    patterns.push_back(std::move(pattern));
  }

  void add_steps(int entry, const std::vector<PatternStep>& steps) {
    int node = 0;
    for (const PatternStep& step : steps) {
      node = target(node, step);
    }
    int& end = nodes[static_cast<std::size_t>(node)].entry;
    if (end >= 0) {
      same_syntax.emplace_back(end, entry);
    } else {
      end = entry;
    }
  }

  [[nodiscard]] Word look_up(const Token& token) const {
    if (token.text.size() > kLongestWord || token.kind == TokenKind::text) {
      return {};
    }
    std::array<char, kLongestWord> buffer{};
    std::ranges::transform(token.text, buffer.begin(), [](unsigned char c) {
      return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    });
    const auto found = words.find(std::string_view(buffer.data(), token.text.size()));
    return found == words.end() ? Word{} : found->second;
  }

  [[nodiscard]] std::vector<Word> look_up_all(std::span<const Token> tokens) const {
    std::vector<Word> found;
    found.reserve(tokens.size());
    for (const Token& token : tokens) {
      found.push_back(look_up(token));
    }
    return found;
  }

  int next_literal = 0;
  int plus = literal_id("+");
  int minus = literal_id("-");
};

namespace {

// Walks the tree of patterns along one instruction's tokens and keeps the first entry in table
// order. When `misfits` is given, one operand of each reading may be anything.
class Matcher {
 public:
  Matcher(const std::vector<Node>& nodes, const Choices& choices, std::span<const Token> tokens,
          std::vector<Word> words, int plus, int minus, std::vector<Misfit>* misfits)
      : nodes_(nodes),
        choices_(choices),
        tokens_(tokens),
        words_(std::move(words)),
        plus_(plus),
        minus_(minus),
        misfits_(misfits) {}

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
    const Node& node = nodes_[static_cast<std::size_t>(node_index)];
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
      } else if (edge.literal == plus_ && literal == minus_) {
        walk(edge.target, position + 1, operands, true);
      }
    }
  }

  void walk_choice(const Node::Edge& edge, std::size_t position, int operands) {
    const auto slot = static_cast<std::size_t>(operands);
    bool read = false;
    for (const auto& [tokens, value] : choices_.at(edge.step.operand)) {
      if (begins_with(tokens, position)) {
        current_.operand[slot] = {value, nullptr};
        walk(edge.target, position + tokens.size(), operands + 1, false);
        read |= !tokens.empty();
      }
    }
    if (!read && misfits_ != nullptr && !misfit_ && position < tokens_.size() &&
        tokens_[position].is("(")) {
      misfit_ = Misfit{position + 1, edge.step.operand, {}, false};
      current_.operand[slot] = {};
      walk(edge.target, after_parenthesis(position), operands + 1, false);
      misfit_.reset();
    }
  }

  [[nodiscard]] bool begins_with(const std::vector<std::string>& texts,
                                 std::size_t position) const {
    if (texts.size() > tokens_.size() - position) {
      return false;
    }
    return std::ranges::equal(texts, tokens_.subspan(position, texts.size()),
                              [](const std::string& text, const Token& token) {
                                return std::ranges::equal(text, token.text,
                                                          [](unsigned char a, unsigned char b) {
                                                            return a == std::toupper(b);
                                                          });
                              });
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
      misfit_ = Misfit{position, edge.step.operand, {}, is_number(position)};
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
      misfit_ =
          Misfit{position, edge.step.operand, print_operand(edge.step.operand, wanted), false};
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

  const std::vector<Node>& nodes_;
  const Choices& choices_;
  std::span<const Token> tokens_;
  std::vector<Word> words_;
  int plus_;
  int minus_;
  std::vector<Misfit>* misfits_;
  std::optional<Misfit> misfit_;
  Reading current_;
  Reading best_;
};

std::string text_of(std::span<const Token> tokens) {
  std::string text;
  const Token* before = nullptr;
  for (const Token& token : tokens) {
    const bool apart =
        before != nullptr && (before->line != token.line ||
                              before->text.data() + before->text.size() != token.text.data());
    text += apart ? " " : "";
    text += token.text;
    before = &token;
  }
  return text;
}

// The message for what the misfits at one token have in common.
std::string explain_misfits(const std::vector<Misfit>& misfits, const std::string& written) {
  std::optional<OperandKind> widest;
  std::vector<std::string> wanted;
  for (const Misfit& misfit : misfits) {
    const auto range = is_code_address(misfit.kind) ? std::nullopt : immediate_range(misfit.kind);
    if (range && misfit.number) {
      const auto size = [](OperandKind kind) {
        return immediate_range(kind)->maximum - immediate_range(kind)->minimum;
      };
      widest = !widest || size(misfit.kind) > size(*widest) ? misfit.kind : *widest;
    }
    const std::string description =
        misfit.repeated.empty() ? describe(misfit.kind) : misfit.repeated + " once more";
    if (std::ranges::find(wanted, description) == wanted.end()) {
      wanted.push_back(description);
    }
  }
  if (widest) {
    const auto range = immediate_range(*widest);
    return fmt::format("immediate {} does not fit: {}..{}{}", written, range->minimum,
                       range->maximum,
                       range->scale == 1 ? "" : fmt::format(", multiples of {}", range->scale));
  }
  return fmt::format("{} cannot stand here: {} is wanted", written, fmt::join(wanted, " or "));
}

}  // namespace

Syntax::Syntax(std::span<const Instruction> table)
    : table_(table), compiled_(std::make_unique<Compiled>()) {
  compiled_->add_registers();
  for (std::size_t i = 0; i < table.size(); ++i) {
    compiled_->add(static_cast<int>(i), compile_pattern(table[i].syntax));
  }
}

Syntax::~Syntax() = default;

std::optional<ParsedInstruction> Syntax::match(std::span<const Token> tokens) const {
  if (tokens.empty()) {
    return std::nullopt;
  }
  Matcher matcher(compiled_->nodes, compiled_->choices, tokens, compiled_->look_up_all(tokens),
                  compiled_->plus, compiled_->minus, nullptr);
  const Reading reading = matcher.run();
  if (reading.entry < 0) {
    return std::nullopt;
  }
  ParsedInstruction parsed;
  parsed.instruction = reading.entry;
  for (std::size_t i = 0; i < static_cast<std::size_t>(roles(reading.entry).count); ++i) {
    const RawValue& raw = reading.operand[i];
    parsed.operand[i] = {static_cast<std::int32_t>(raw.number),
                         raw.symbol == nullptr ? std::string() : std::string(raw.symbol->text)};
  }
  return parsed;
}

SyntaxProblem Syntax::explain(std::span<const Token> tokens) const {
  if (tokens.empty()) {
    return {"an instruction is missing", 0};
  }
  std::vector<Misfit> misfits;
  Matcher matcher(compiled_->nodes, compiled_->choices, tokens, compiled_->look_up_all(tokens),
                  compiled_->plus, compiled_->minus, &misfits);
  if (matcher.run().entry >= 0) {
    return {"nothing is wrong", 0};
  }
  if (misfits.empty()) {
    const bool lines = tokens.front().line != tokens.back().line;
    return {fmt::format("no instruction reads '{}'{}", text_of(tokens),
                        lines ? ": is a ';' missing?" : ""),
            0};
  }
  // The reading that went well furthest is the one that was meant.
  const std::size_t token = std::ranges::max(misfits, {}, &Misfit::token).token;
  std::erase_if(misfits, [&](const Misfit& misfit) { return misfit.token != token; });
  const bool two = (tokens[token].is("-") || tokens[token].is("+")) && misfits.front().number;
  return {explain_misfits(misfits, text_of(tokens.subspan(token, two ? 2 : 1))), token};
}

ParsedInstruction Syntax::parse(std::string_view text) const {
  const std::vector<Token> tokens = tokenize(text);
  if (auto parsed = match(tokens)) {
    return *parsed;
  }
  const SyntaxProblem problem = explain(tokens);
  const Token at = tokens.empty() ? Token{} : tokens[problem.token];
  throw InputError(fmt::format("{}:{}: {}", at.line, at.column, problem.message));
}

std::string Syntax::print(const ParsedInstruction& instruction) const {
  const Pattern& pattern =
      compiled_->patterns.at(static_cast<std::size_t>(instruction.instruction));
  std::string text = pattern.texts[0];
  for (std::size_t i = 0; i < pattern.values.size(); ++i) {
    const int operand = pattern.values[i];
    text += print_operand(pattern.roles[operand].kind,
                          instruction.operand[static_cast<std::size_t>(operand)]);
    text += pattern.texts[i + 1];
  }
  return text;
}

const OperandRoles& Syntax::roles(int instruction) const {
  return compiled_->patterns.at(static_cast<std::size_t>(instruction)).roles;
}

std::span<const std::pair<int, int>> Syntax::same_syntax() const { return compiled_->same_syntax; }

}  // namespace finback::isa
