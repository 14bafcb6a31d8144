// Instructions: gathering their tokens, folding expressions to what the instruction table reads,
// and operands that are known only at the end of the file.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

#include <isa_sim/assembler/assembler.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::assembler {

using isa::Token;
using isa::TokenKind;

namespace {

// A number that only the longest form of an instruction takes, and every one of its kinds does.
constexpr std::int64_t kPlaceholder = 0x4000;
constexpr std::int64_t kOtherPlaceholder = 0x4004;

bool is_word(const Token& token, std::string_view word) {
  return token.kind == TokenKind::name && lower_case(token.text) == word;
}

// A number in a register's or a symbol's place: `LSETUP (4, 8) LC0 = P0 >> 1` has two of them.
bool ends_distances(const Token& token) { return token.is(")"); }

// As the 32 bits that an operand has.
std::int64_t as_operand(std::int64_t number) {
  const bool fits = number >= std::numeric_limits<std::int32_t>::min() &&
                    number <= std::numeric_limits<std::uint32_t>::max();
  return fits ? static_cast<std::int32_t>(static_cast<std::uint32_t>(number)) : number;
}

// The text that several tokens were written as, if they stand on one line.
std::string_view written(const Token& first, const Token& last) {
  const char* end = last.text.data() + last.text.size();
  const bool together = first.line == last.line && end >= first.text.data();
  return together ? std::string_view(first.text.data(),
                                     static_cast<std::size_t>(end - first.text.data()))
                  : first.text;
}

}  // namespace

// An instruction's tokens with its expressions replaced; those whose value is not known yet stand
// as a symbol.
struct Assembler::Folded {
  struct Later {
    std::size_t token = 0;
    std::size_t count = 1;  // tokens that stand for it: a symbol, or a symbol, a sign and a number
    ExpressionPointer expression;
  };
  std::vector<Token> tokens;
  std::vector<Later> later;
  // Found by match_later: operand index of each that is to be filled in.
  std::vector<std::pair<std::size_t, ExpressionPointer>> operands;
};

// --- tokens ---

bool Assembler::begins_other_statement(std::string_view text) const {
  const std::string_view word = name_at(text);
  const std::string_view rest = without_blanks_around(text.substr(word.size()));
  if (word.empty()) {
    return false;
  }
  return word.starts_with('.') || rest.starts_with(':') || macros_.contains(lower_case(word));
}

std::vector<Token> Assembler::gather_instruction(Statement& statement) {
  std::vector<Token> tokens = tokens_of(statement, statement.text);
  for (int lines = 1; statement.ends_line; ++lines) {
    // An instruction may go on in the next line; where it is one already, only by `||`.
    const std::string_view text = source_.text()->text();
    std::size_t next = source_.position();
    while (next < text.size() && (is_blank(text[next]) || text[next] == '\n')) {
      ++next;
    }
    const bool joined = text.substr(next, 2) == "||" || (!tokens.empty() && tokens.back().is("||"));
    if (next == text.size() || lines == kMostLines ||
        (!joined && (begins_other_statement(text.substr(next, 80)) || is_complete(tokens)))) {
      break;
    }
    Statement more;
    if (!source_.next(more)) {
      break;
    }
    std::vector<Token> added = tokens_of(more, more.text);
    for (Token& token : added) {
      token.line += lines;
    }
    tokens.insert(tokens.end(), added.begin(), added.end());
    statement.ends_line = more.ends_line;
  }
  return tokens;
}

bool Assembler::is_complete(const std::vector<Token>& tokens) {
  std::size_t start = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    if (i == tokens.size() || tokens[i].is("||")) {
      Folded folded = fold(std::span(tokens).subspan(start, i - start));
      if (!match(folded)) {
        return false;
      }
      start = i + 1;
    }
  }
  return true;
}

// --- folding ---

// Names within one instruction: its words are none.
class Assembler::InInstruction : public ExpressionReader::Names {
 public:
  InInstruction(Assembler& assembler, std::span<const Token> tokens)
      : assembler_(assembler), tokens_(tokens) {}

  Symbol* symbol(const Token& token) override {
    const bool word =
        assembler_.syntax_.has_word(token) && (token.text.size() > 1 || is_option(token));
    return word ? nullptr : assembler_.symbol(token);
  }

 private:
  // The X of `(X)` and `(S, V)`; elsewhere it is a symbol of that name.
  [[nodiscard]] bool is_option(const Token& token) const {
    static constexpr std::string_view kOptions = "MSTXZ";
    if (kOptions.find(isa::upper_case(token.text)) == std::string_view::npos) {
      return true;
    }
    const auto at = static_cast<std::size_t>(&token - tokens_.data());
    const bool opened = at > 0 && (tokens_[at - 1].is("(") || tokens_[at - 1].is(","));
    const bool half = at > 1 && (is_word(tokens_[at - 2], "lo") || is_word(tokens_[at - 2], "hi"));
    return opened && !half && at + 1 < tokens_.size() &&
           (tokens_[at + 1].is(")") || tokens_[at + 1].is(","));
  }

  Assembler& assembler_;
  std::span<const Token> tokens_;
};

// Behind it, a sign joins two operands.
bool Assembler::ends_operand(const Token& token) const {
  if (token.kind == TokenKind::name) {
    return isa::register_by_name(token.text) || !syntax_.has_word(token);
  }
  return token.kind != TokenKind::sign || token.is(")") || token.is("]") || token.is("++") ||
         token.is("--");
}

Assembler::Folded Assembler::fold(std::span<const Token> tokens) {
  Folded folded;
  for (std::size_t position = 0; position < tokens.size();) {
    if (!fold_half(tokens, position, folded)) {
      position = fold_one(tokens, position, folded);
    }
  }
  return folded;
}

// `LO(x)`, `HI(x)`: the halves of a number; of an address, that which the register written takes.
bool Assembler::fold_half(std::span<const Token> tokens, std::size_t& position, Folded& folded) {
  const bool low = is_word(tokens[position], "lo");
  if ((!low && !is_word(tokens[position], "hi")) || position + 1 >= tokens.size() ||
      !tokens[position + 1].is("(")) {
    return false;
  }
  const std::size_t before = folded.tokens.size();
  const std::size_t end = fold_one(tokens, position + 1, folded);
  const bool one_token = folded.tokens.size() == before + 1;
  if (one_token && folded.tokens.back().kind == TokenKind::sign) {
    folded.tokens.pop_back();
    return false;
  }
  if (one_token && folded.tokens.back().kind == TokenKind::number) {
    std::int64_t& number = folded.tokens.back().number;
    number = (low ? number : number >> 16) & 0xffff;
  } else if (one_token && !folded.later.empty() && folded.later.back().token == before &&
             !evaluate(*folded.later.back().expression).is_address()) {
    folded.later.back().expression = make_half(folded.later.back().expression, !low);
  } else if (before > 0) {
    const std::string half = lower_case(tokens[0].text);
    if (!half.ends_with(low ? ".l" : ".h")) {
      fail(*statement_, tokens[position].text,
           fmt::format("{} of an address can only be put into the {} half of a register",
                       low ? "LO" : "HI", low ? "low" : "high"));
    }
  }
  position = end;
  return true;
}

std::size_t Assembler::fold_one(std::span<const Token> tokens, std::size_t position,
                                Folded& folded) {
  const Token& first = tokens[position];
  const bool after_operand = position > 0 && ends_operand(tokens[position - 1]);
  InInstruction names(*this, tokens);
  std::size_t end = position;
  ExpressionPointer expression;
  // `+ 8`, `* 2` behind an operand: the sign is the instruction's; `- 8 + 4` is `+ -4`.
  const bool joins = after_operand && first.kind == TokenKind::sign;
  if (!joins || first.is("-")) {
    expression = ExpressionReader(tokens, names, ExpressionReader::Precedence::instructions)
                     .read(position, end);
  }
  const Value value = expression == nullptr ? Value{} : evaluate(*expression);
  const bool plain = end == position + (joins ? 2 : 1) &&
                     (tokens[end - 1].kind == TokenKind::number || (joins && value.is_number()));
  if (expression == nullptr || plain) {
    folded.tokens.push_back(first);
    folded.tokens.back().number = as_operand(first.number);
    return position + 1;
  }
  Token token = first;
  if (joins) {
    folded.tokens.push_back(Token{TokenKind::sign, false, first.line, first.column, 0, "+"});
  }
  if (value.is_number()) {
    token.kind = TokenKind::number;
    token.text = written(first, tokens[end - 1]);
    token.number = as_operand(value.number);
    folded.tokens.push_back(token);
    return end;
  }
  const std::size_t at = folded.tokens.size();
  token.kind = TokenKind::name;
  if (!value.is_address()) {
    // What is written is a name that no symbol has, if it stands on one line.
    token.text = first.line == tokens[end - 1].line
                     ? written(first, tokens[end - 1])
                     : std::string_view(texts_.emplace_back(
                           fmt::format("later#{}", later_operands_.size() + folded.later.size())));
  } else if (token.text != value.symbol->name) {
    token.text = value.symbol->name;
  }
  folded.tokens.push_back(token);
  if (value.is_address() && value.number != 0) {
    Token more = token;
    more.kind = TokenKind::sign;
    more.text = value.number < 0 ? "-" : "+";
    folded.tokens.push_back(more);
    more.kind = TokenKind::number;
    more.number = value.number < 0 ? -value.number : value.number;
    folded.tokens.push_back(more);
  }
  if (!value.is_address() || value.symbol->kind == Symbol::Kind::undefined) {
    folded.later.push_back({at, folded.tokens.size() - at, expression});
  }
  return end;
}

// --- reading ---

std::optional<ir::ParsedInstruction> Assembler::match(Folded& folded) {
  if (auto parsed = syntax_.match(folded.tokens)) {
    for (const Folded::Later& later : folded.later) {
      const std::string_view name = folded.tokens[later.token].text;
      const auto operand = std::ranges::find(parsed->operand, name, &ir::OperandValue::symbol);
      if (operand != parsed->operand.end()) {
        folded.operands.emplace_back(operand - parsed->operand.begin(), later.expression);
      }
    }
    return parsed;
  }
  return folded.later.empty() ? match_distance(folded) : match_later(folded);
}

// `JUMP 4`: a number where a place in the code is wanted is the distance to it.
std::optional<ir::ParsedInstruction> Assembler::match_distance(const Folded& folded) {
  static constexpr std::array<std::string_view, 5> kBranches = {"jump", "call", "if", "lsetup",
                                                                "loop"};
  const std::string word = folded.tokens.empty() ? "" : lower_case(folded.tokens[0].text);
  if (std::ranges::count(kBranches, word.substr(0, word.find('.'))) == 0) {
    return std::nullopt;
  }
  std::vector<Token> tokens;
  bool ended = false;
  for (const Token& token : folded.tokens) {
    tokens.push_back(token);
    ended = ended || ends_distances(token);
    if (token.kind != TokenKind::number || ended) {
      continue;
    }
    Symbol& here = symbols_.unnamed();
    define_label(here, *statement_, token.text, section().location());
    Token distance = token;
    tokens.back().kind = TokenKind::name;
    tokens.back().text = here.name;
    tokens.push_back(tokens.back());
    tokens.back().kind = TokenKind::sign;
    tokens.back().text = token.number < 0 ? "-" : "+";
    distance.number = token.number < 0 ? -token.number : token.number;
    tokens.push_back(distance);
  }
  return syntax_.match(tokens);
}

// As if what is not known were a number: a large one, since its form must hold whatever comes.
std::optional<ir::ParsedInstruction> Assembler::match_later(Folded& folded) {
  std::vector<Token> kept;
  std::vector<std::size_t> now_at;
  std::size_t from = 0;
  for (const Folded::Later& later : folded.later) {
    kept.insert(kept.end(), folded.tokens.begin() + static_cast<std::ptrdiff_t>(from),
                folded.tokens.begin() + static_cast<std::ptrdiff_t>(later.token + 1));
    kept.back().kind = TokenKind::number;
    kept.back().number = kPlaceholder;
    now_at.push_back(kept.size() - 1);
    from = later.token + later.count;
  }
  kept.insert(kept.end(), folded.tokens.begin() + static_cast<std::ptrdiff_t>(from),
              folded.tokens.end());
  auto parsed = syntax_.match(kept);
  if (!parsed) {
    return std::nullopt;
  }
  for (std::size_t index = 0; index < folded.later.size(); ++index) {
    Token& token = kept[now_at[index]];
    token.number = kOtherPlaceholder;
    const auto other = syntax_.match(kept);
    token.number = kPlaceholder;
    if (!other || other->instruction != parsed->instruction) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < parsed->operand.size(); ++i) {
      if (parsed->operand[i] != other->operand[i]) {
        folded.operands.emplace_back(i, folded.later[index].expression);
      }
    }
  }
  return parsed;
}

ir::Packet Assembler::read_packet(const std::vector<Token>& tokens, const Statement& statement) {
  ir::Packet packet;
  std::vector<std::pair<ir::ParsedInstruction, LaterOperand>> later;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    if (i < tokens.size() && !tokens[i].is("||")) {
      continue;
    }
    const std::span<const Token> words = std::span(tokens).subspan(start, i - start);
    Folded folded = fold(words);
    const auto parsed = match(folded);
    if (!parsed) {
      const isa::SyntaxProblem problem = syntax_.explain(folded.tokens);
      const std::string_view at =
          folded.tokens.empty() ? statement.text : folded.tokens[problem.token].text;
      const bool own = std::ranges::any_of(
          tokens, [at](const Token& token) { return at.data() == token.text.data(); });
      fail(statement, own ? at : tokens[std::min(start, tokens.size() - 1)].text, problem.message);
    }
    for (const auto& [operand, expression] : folded.operands) {
      LaterOperand value;
      value.expression = expression;
      value.operand = operand;
      value.place = source_.in_file(statement);
      value.context = source_.context();
      later.emplace_back(*parsed, std::move(value));
    }
    packet.slots.push_back(*parsed);
    start = i + 1;
  }
  ir::order_slots(packet, syntax_.table());
  for (auto& [parsed, value] : later) {
    const auto slot = std::ranges::find(packet.slots, parsed);
    value.slot = static_cast<std::size_t>(slot - packet.slots.begin());
    value.section = current_section_;
    later_operands_.push_back(std::move(value));
  }
  return packet;
}

void Assembler::read_instruction(Statement statement) {
  const std::vector<Token> tokens = gather_instruction(statement);
  if (read_loop(tokens, statement)) {
    return;
  }
  emit(read_packet(tokens, statement), statement);
}

void Assembler::emit(ir::Packet packet, const Statement& statement) {
  if (++packets_ > kMostPackets) {
    fail(statement, statement.text,
         fmt::format("a file has at most {} instructions", kMostPackets));
  }
  if (section().location() % 2 != 0) {
    fail(statement, statement.text,
         "an instruction stands at an even address: write .align 2 before it");
  }
  packet.written = source_.in_file(statement);
  packet.file = loc_file_ > 0 ? loc_file_ : source_file(packet.written.file);
  packet.line = loc_file_ > 0 ? loc_line_ : packet.written.line;
  const std::uint32_t length = ir::packet_length(packet, syntax_.table());
  bytes_ += length;
  const std::size_t index = section().packet(std::move(packet), length);
  for (; operands_placed_ < later_operands_.size(); ++operands_placed_) {
    later_operands_[operands_placed_].packet = index;
  }
}

// --- at the end of the file ---

void Assembler::finish_operands() {
  for (const LaterOperand& later : later_operands_) {
    ir::ParsedInstruction& instruction =
        sections_[later.section].packet_at(later.packet).slots[later.slot];
    ir::OperandValue& operand = instruction.operand[later.operand];
    const isa::OperandKind kind =
        syntax_.roles(instruction.instruction)[static_cast<int>(later.operand)].kind;
    const Value value = evaluate(*later.expression);
    if (!value.problem.empty()) {
      throw InputError(later.place, value.problem + later.context);
    }
    const bool wants_address = isa::is_code_address(kind) || kind == isa::OperandKind::any16 ||
                               kind == isa::OperandKind::imm16 ||
                               kind == isa::OperandKind::uimm16;  // its low half
    if (value.is_address()) {
      if (!wants_address) {
        throw InputError(later.place, fmt::format("{} is no number of this file{}",
                                                  value.symbol->name, later.context));
      }
      operand = {static_cast<std::int32_t>(value.number), value.symbol->name};
      continue;
    }
    if (!operand.symbol.empty() && value.symbol == nullptr &&
        symbols_.find(operand.symbol) != nullptr) {
      continue;  // a symbol that is a number: the linker puts it in
    }
    const auto number = static_cast<std::int32_t>(as_operand(value.number));
    const auto range = isa::immediate_range(kind);
    if (!range || isa::is_code_address(kind) || number < range->minimum ||
        number > range->maximum || number % range->scale != 0) {
      throw InputError(later.place, fmt::format("{} does not fit here: {}..{}{}", value.number,
                                                range ? range->minimum : 0,
                                                range ? range->maximum : 0, later.context));
    }
    operand = {number, ""};
  }
}

}  // namespace finback::assembler
