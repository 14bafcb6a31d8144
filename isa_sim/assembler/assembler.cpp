#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/file.hpp>
#include <common/parameter.hpp>
#include <isa_sim/assembler/assembler.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::assembler {

using isa::Token;
using isa::TokenKind;

namespace {

// `R0`, `ASTAT`; and whatever is written as if it were a part of one, such as `R0.L`.
bool is_register(std::string_view name) {
  const std::string upper = isa::upper_case(name);
  const auto flags = isa::spellings(isa::OperandKind::status_flag);
  if (isa::register_by_name(upper) || upper == "PC" ||
      std::ranges::find(flags, upper, &isa::Spelling::text) != flags.end()) {
    return true;
  }
  const std::size_t dot = upper.rfind('.');
  return dot != std::string::npos && dot > 0 && dot + 2 == upper.size() &&
         std::string_view("LHBXW").find(upper.back()) != std::string_view::npos;
}

std::string_view behind(std::string_view text, std::string_view word) {
  return without_blanks_around(text.substr(word.size()));
}

}  // namespace

Assembler::Assembler(const Options& options, const isa::Syntax& syntax)
    : options_(options), syntax_(syntax) {}

// --- messages ---

SourcePlace Assembler::place_of(const Statement& statement, std::string_view at) {
  const std::string_view whole = statement.source->text();
  const bool inside = at.data() >= whole.data() && at.data() <= whole.data() + whole.size();
  return statement.source->place(inside ? static_cast<std::size_t>(at.data() - whole.data())
                                        : statement.offset);
}

void Assembler::fail(const Statement& statement, std::string_view at,
                     const std::string& message) const {
  source_.fail(place_of(statement, at), message);
}

void Assembler::fail(const Directive& directive, const std::string& message) const {
  const std::string_view at =
      directive.at_end() ? directive.name : directive.tokens[directive.position].text;
  fail(directive.statement, at, message);
}

void Assembler::warn(const Statement& statement, std::string_view at,
                     const std::string& message) const {
  if (options_.note) {
    options_.note(fmt::format("{}: warning: {}{}", place_of(statement, at).to_string(), message,
                              source_.context()));
  }
}

// --- statements ---

ir::Program Assembler::run(std::string_view text, const std::string& file) {
  const std::filesystem::path path(file);
  stem_ = path.stem().string();
  program_.path = file;
  program_.source_files.emplace_back();
  sections_.clear();
  enter_section(".text");
  define_constants();
  push_file(std::string(text), file, path);
  read_all();
  return finish(file);
}

void Assembler::define_constants() {
  for (const auto& [name, value] : options_.defines) {
    Symbol& symbol = symbols_.get(name);
    symbol.kind = Symbol::Kind::number;
    symbol.number = value;
  }
}

void Assembler::read_all() {
  while (!source_.empty()) {
    Statement statement;
    if (!source_.next(statement)) {
      if (conditionals_.size() > source_.conditionals()) {
        source_.fail(conditionals_.back().begun, "this condition is never closed: add .endif");
      }
      source_.end_text();
      continue;
    }
    statement_ = &statement;
    if (in_false_branch()) {
      skip_statement(statement);
    } else {
      read_statement(statement);
    }
  }
}

void Assembler::read_statement(Statement statement) {
  read_labels(statement);
  if (statement.text.empty()) {
    return;
  }
  const std::string_view word = name_at(statement.text);
  const std::string_view rest = behind(statement.text, word);
  if (!word.empty() && read_equation(statement, word, rest)) {
    return;
  }
  const auto macro = word.empty() ? macros_.end() : macros_.find(lower_case(word));
  if (macro != macros_.end()) {
    const Macro called = macro->second;  // it may redefine itself
    call_macro(called, statement, rest);
  } else if (word.starts_with('.')) {
    read_directive(statement, word, rest);
  } else {
    read_instruction(statement);
  }
}

void Assembler::read_labels(Statement& statement) {
  for (;;) {
    const std::string_view name = name_at(statement.text);
    const std::string_view rest = behind(statement.text, name);
    if (name.empty() || !rest.starts_with(':')) {
      return;
    }
    const std::string_view next = without_blanks_around(rest.substr(1));
    if (name[0] >= '0' && name[0] <= '9') {
      if (name.size() > 9 || name.find_first_not_of("0123456789") != std::string_view::npos) {
        fail(statement, name, fmt::format("'{}' is neither a number nor a name", name));
      }
      define_label(symbols_.begin_numbered(std::stoll(std::string(name))), statement, name,
                   section().location());
    } else {
      if (is_register(name) && !next.empty() && next[0] >= '0' && next[0] <= '9') {
        return;  // R1:0
      }
      if (is_register(name)) {
        fail(statement, name, fmt::format("{} is a register, no label can be called so", name));
      }
      define_label(symbols_.get(name), statement, name, section().location());
    }
    statement.text = next;
    if (!next.empty()) {
      statement.offset = static_cast<std::size_t>(next.data() - statement.source->text().data());
    }
    statement_ = &statement;
  }
}

void Assembler::define_label(Symbol& symbol, const Statement& statement, std::string_view at,
                             std::uint32_t offset) {
  if (symbol.kind != Symbol::Kind::undefined || symbol.common) {
    fail(statement, at,
         fmt::format("{} is defined already, at {}", symbol.name, symbol.defined.to_string()));
  }
  symbol.kind = Symbol::Kind::label;
  symbol.section = current_section_;
  symbol.offset = offset;
  symbol.defined = source_.in_file(statement);
}

bool Assembler::read_equation(const Statement& statement, std::string_view name,
                              std::string_view rest) {
  const bool sets = rest.starts_with('=') && !rest.starts_with("==") && !is_register(name);
  if (!sets || (name[0] >= '0' && name[0] <= '9')) {
    return false;
  }
  Directive directive{statement, name, without_blanks_around(rest.substr(1)), {}, 0};
  directive.tokens = tokens_of(statement, directive.rest);
  const ExpressionPointer value = read_expression(directive, "a value");
  expect_end(directive);
  if (name == ".") {
    move_to(statement, directive.rest, *value, 0);
  } else {
    set_symbol(symbols_.get(name), value, place_of(statement, name));
  }
  return true;
}

// --- expressions ---

Symbol* Assembler::symbol(const Token& token) {
  if (token.text == ".") {
    Symbol& here = symbols_.unnamed();
    define_label(here, *statement_, token.text, section().location());
    return &here;
  }
  if (is_numbered_reference(token.text)) {
    Symbol* found = symbols_.find_numbered(token.text);
    if (found == nullptr) {
      fail(*statement_, token.text,
           fmt::format("no label {}: stands before this",
                       token.text.substr(0, token.text.size() - 1)));
    }
    if (!found->used && found->kind == Symbol::Kind::undefined) {
      found->defined = place_of(*statement_, token.text);
    }
    found->used = true;
    return found;
  }
  if (is_register(token.text)) {
    return nullptr;
  }
  Symbol& found = symbols_.get(token.text);
  if (!found.used && found.kind == Symbol::Kind::undefined) {
    found.defined = place_of(*statement_, token.text);
  }
  found.used = true;
  return &found;
}

std::vector<Token> Assembler::tokens_of(const Statement& statement, std::string_view text) const {
  std::vector<Token> tokens;
  if (const auto bad = isa::split_words(text, isa::Dialect::assembler, tokens)) {
    fail(statement, text.substr(std::min(bad->offset, text.size())), bad->message);
  }
  return tokens;
}

ExpressionPointer Assembler::read_expression(Directive& directive, std::string_view wanted) {
  if (directive.at_end()) {
    fail(directive, fmt::format("{} wants {}", directive.name, wanted));
  }
  const std::size_t start = directive.position;
  ExpressionReader reader(directive.tokens, *this, ExpressionReader::Precedence::directives);
  ExpressionPointer expression = reader.read(start, directive.position);
  if (expression == nullptr) {
    directive.position = start;
    fail(directive, reader.too_long()
                        ? std::string("this expression is too long: set symbols to parts of it")
                        : fmt::format("'{}' cannot stand here: {} is wanted",
                                      directive.tokens[start].text, wanted));
  }
  return expression;
}

std::int64_t Assembler::read_number(Directive& directive, std::string_view wanted) {
  const std::size_t start = directive.position;
  const ExpressionPointer expression = read_expression(directive, wanted);
  return number_of(directive.statement, directive.tokens[start].text, *expression, wanted);
}

std::int64_t Assembler::number_of(const Statement& statement, std::string_view at,
                                  const Expression& expression, std::string_view wanted) const {
  const Value value = evaluate(expression);
  if (!value.is_number()) {
    fail(statement, at,
         value.problem.empty()
             ? fmt::format(
                   "{} is wanted that is known here, but {} is {}", wanted, value.symbol->name,
                   value.symbol->kind == Symbol::Kind::label ? "an address" : "not defined yet")
             : value.problem);
  }
  return value.number;
}

void Assembler::set_symbol(Symbol& symbol, const ExpressionPointer& expression,
                           const SourcePlace& place) {
  if (symbol.kind == Symbol::Kind::label || symbol.common) {
    source_.fail(place, fmt::format("{} is a label already, at {}", symbol.name,
                                    symbol.defined.to_string()));
  }
  const Value value = evaluate(*expression);
  if (value.is_number()) {
    symbol.kind = Symbol::Kind::number;
    symbol.number = value.number;
  } else if (value.symbol == &symbol) {
    source_.fail(place, fmt::format("{} is set to itself", symbol.name));
  } else {
    symbol.kind = Symbol::Kind::equated;
    symbol.equated =
        value.is_address() ? make_sum(symbols_.get(value.symbol->name), value.number) : expression;
  }
  symbol.defined = place;
}

bool Assembler::take_comma(Directive& directive) const {
  if (directive.at_end()) {
    return false;
  }
  if (!directive.tokens[directive.position].is(",")) {
    fail(directive,
         fmt::format("',' is wanted before '{}'", directive.tokens[directive.position].text));
  }
  ++directive.position;
  return true;
}

void Assembler::expect_end(const Directive& directive) const {
  if (!directive.at_end()) {
    fail(directive,
         fmt::format("'{}' is too much here", directive.tokens[directive.position].text));
  }
}

std::string_view Assembler::take_name(Directive& directive, std::string_view wanted) const {
  if (directive.at_end() || directive.tokens[directive.position].kind != TokenKind::name) {
    fail(directive, fmt::format("{} wants {}", directive.name, wanted));
  }
  return directive.tokens[directive.position++].text;
}

// --- directives ---

const Assembler::KnownDirective* Assembler::find_directive(std::string_view name) {
  static const std::map<std::string_view, const KnownDirective*> all = [] {
    std::map<std::string_view, const KnownDirective*> result;
    for (const KnownDirective& directive : directives()) {
      result.emplace(directive.name, &directive);
    }
    return result;
  }();
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second;
}

void Assembler::read_directive(const Statement& statement, std::string_view name,
                               std::string_view rest) {
  const std::string lower = lower_case(name);
  const KnownDirective* known = find_directive(lower);
  if (known == nullptr && lower.starts_with(".cfi_")) {
    return;
  }
  if (known == nullptr) {
    std::vector<std::string> names;
    for (const KnownDirective& directive : directives()) {
      names.emplace_back(directive.name);
    }
    for (const auto& [macro, body] : macros_) {
      names.push_back(macro);
    }
    const std::string near = nearest_name(lower, names);
    fail(statement, name,
         fmt::format("unknown directive {}{}", name,
                     near.empty() ? "" : fmt::format(", did you mean {}?", near)));
  }
  Directive directive{statement, name, rest, {}, 0};
  if (!known->words) {
    directive.tokens = tokens_of(statement, rest);
  }
  (this->*known->handler)(directive);
}

// --- the end ---

ir::Program Assembler::finish(const std::string& file) {
  check_private_labels();
  finish_data();
  finish_operands();
  finish_symbols(program_);
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    ir::Piece piece = sections_[i].finish();
    if (piece.size > 0 || !piece.labels.empty()) {
      piece.written = piece.labels.empty() ? SourcePlace{file, 1, 0} : piece.labels[0].written;
      program_.pieces.push_back(std::move(piece));
    }
  }
  for (auto& [name, object] : common_) {
    program_.objects.push_back(std::move(object));
  }
  return std::move(program_);
}

void Assembler::finish_symbols(ir::Program& program) {
  for (const auto& [name, symbol] : symbols_.all()) {
    const Value value = symbol->kind == Symbol::Kind::equated ? evaluate(*symbol->equated)
                                                              : Value{0, symbol.get(), {}};
    if (symbol->kind == Symbol::Kind::number ||
        (symbol->kind == Symbol::Kind::equated && value.is_number())) {
      const std::int64_t number =
          symbol->kind == Symbol::Kind::number ? symbol->number : value.number;
      program.constants.push_back({name, symbol->binding, static_cast<std::uint32_t>(number)});
    } else if (value.is_address() && value.symbol->kind == Symbol::Kind::label) {
      const std::int64_t offset = value.number + value.symbol->offset;
      const auto size = static_cast<std::int64_t>(sections_[value.symbol->section].location());
      if (offset >= 0 && offset <= size) {
        const bool begins = symbol->kind == Symbol::Kind::label && !is_private_label(name);
        sections_[value.symbol->section].label(
            {name, symbol->binding, static_cast<std::uint32_t>(offset), begins, symbol->defined});
      }
    }
  }
}

void Assembler::check_private_labels() const {
  for (const auto& [name, symbol] : symbols_.all()) {
    if (symbol->kind != Symbol::Kind::undefined || !symbol->used || !is_private_label(name)) {
      continue;
    }
    const std::size_t hash = name.find('#');
    throw InputError(symbol->defined,
                     hash == std::string::npos
                         ? fmt::format("{} is nowhere in this file", name)
                         : fmt::format("no label {}: follows this", name.substr(0, hash)));
  }
}

// --- ways in ---

ir::Program assemble(std::string_view text, const std::string& file, const Options& options) {
  return Assembler(options, isa::instruction_syntax()).run(text, file);
}

ir::Program assemble_file(const std::filesystem::path& path, const Options& options) {
  return assemble(read_text_file(path), path.string(), options);
}

bool is_assembler_file(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending == ".s" || ending == ".asm";
}

}  // namespace finback::assembler
