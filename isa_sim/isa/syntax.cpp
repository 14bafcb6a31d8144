#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/isa/matcher.hpp>
#include <isa_sim/isa/pattern.hpp>
#include <isa_sim/isa/pattern_tree.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {
namespace {

// The two parts of a vector instruction, "R0 = A0, R1 = A1 (IS)", in the other order; a closing
// option stays at the end, but (M), which belongs to its part. Empty when there are no two parts.
std::vector<Token> swap_parts(std::span<const Token> tokens) {
  int depth = 0;
  std::size_t comma = tokens.size();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    depth += tokens[i].is("(") ? 1 : tokens[i].is(")") ? -1 : 0;
    if (depth == 0 && tokens[i].is(",")) {
      comma = i;
    }
  }
  if (comma >= tokens.size() || comma == 0) {
    return {};
  }
  std::size_t option = tokens.size();
  if (tokens.size() > comma + 3 && tokens.back().is(")") && tokens[tokens.size() - 3].is("(") &&
      tokens[tokens.size() - 2].kind == TokenKind::name && tokens[tokens.size() - 2].text != "M" &&
      tokens[tokens.size() - 2].text != "m") {
    option = tokens.size() - 3;
  }
  std::vector<Token> swapped(tokens.begin() + static_cast<std::ptrdiff_t>(comma) + 1,
                             tokens.begin() + static_cast<std::ptrdiff_t>(option));
  swapped.push_back(tokens[comma]);
  swapped.insert(swapped.end(), tokens.begin(),
                 tokens.begin() + static_cast<std::ptrdiff_t>(comma));
  swapped.insert(swapped.end(), tokens.begin() + static_cast<std::ptrdiff_t>(option), tokens.end());
  return swapped;
}

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

struct Syntax::Compiled {
  PatternTree tree;
};

Syntax::Syntax(std::span<const Instruction> table)
    : table_(table), compiled_(std::make_unique<Compiled>()) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    compiled_->tree.add(static_cast<int>(i), compile_pattern(table[i].syntax));
    if (!table[i].also.empty()) {
      compiled_->tree.add_spelling(static_cast<int>(i), compile_pattern(table[i].also));
    }
  }
}

Syntax::~Syntax() = default;

std::optional<ParsedInstruction> Syntax::match(std::span<const Token> tokens) const {
  auto parsed = match_as_written(tokens);
  if (!parsed) {
    if (const std::vector<Token> swapped = swap_parts(tokens); !swapped.empty()) {
      parsed = match_as_written(swapped);
    }
  }
  return parsed;
}

std::optional<ParsedInstruction> Syntax::match_as_written(std::span<const Token> tokens) const {
  if (tokens.empty()) {
    return std::nullopt;
  }
  const Reading reading = read_tokens(compiled_->tree, tokens, nullptr);
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

bool Syntax::has_word(const Token& token) const {
  return compiled_->tree.look_up(token).literal != kNoWord;
}

SyntaxProblem Syntax::explain(std::span<const Token> tokens) const {
  if (tokens.empty()) {
    return {"an instruction is missing", 0};
  }
  std::vector<Misfit> misfits;
  if (read_tokens(compiled_->tree, tokens, &misfits).entry >= 0) {
    return {"nothing is wrong", 0};
  }
  if (misfits.empty()) {
    const bool lines = tokens.front().line != tokens.back().line;
    return {fmt::format("no instruction reads '{}'{}", text_of(tokens),
                        lines ? ": is a ';' missing?" : ""),
            0};
  }
  // A register of the wrong parity is all that is wrong with what was meant; else the reading that
  // went well furthest is it.
  if (std::ranges::any_of(misfits, &Misfit::near)) {
    std::erase_if(misfits, [](const Misfit& misfit) { return !misfit.near; });
  }
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
      compiled_->tree.patterns().at(static_cast<std::size_t>(instruction.instruction));
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
  return compiled_->tree.patterns().at(static_cast<std::size_t>(instruction)).roles;
}

std::span<const std::pair<int, int>> Syntax::same_syntax() const {
  return compiled_->tree.same_syntax();
}

}  // namespace finback::isa