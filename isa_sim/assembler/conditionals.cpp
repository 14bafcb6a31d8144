// .if and its kin.
#include <fmt/format.h>

#include <isa_sim/assembler/assembler.hpp>

namespace finback::assembler {

void Assembler::begin_conditional(const Directive& directive, bool holds) {
  Conditional conditional;
  conditional.taken = conditional.active = holds;
  conditional.begun = place_of(directive.statement, directive.name);
  conditionals_.push_back(std::move(conditional));
}

void Assembler::read_if(Directive& directive) {
  const std::int64_t value = read_number(directive, "a number");
  expect_end(directive);
  const std::string name = lower_case(directive.name);
  const bool holds = name == ".ifeq"   ? value == 0
                     : name == ".ifge" ? value >= 0
                     : name == ".ifgt" ? value > 0
                     : name == ".ifle" ? value <= 0
                     : name == ".iflt" ? value < 0
                                       : value != 0;
  begin_conditional(directive, holds);
}

void Assembler::read_if_defined(Directive& directive) {
  const std::string_view name = take_name(directive, "a symbol");
  expect_end(directive);
  begin_conditional(directive,
                    symbols_.is_defined(name) == (lower_case(directive.name) == ".ifdef"));
}

void Assembler::read_if_blank(Directive& directive) {
  begin_conditional(directive, directive.rest.empty() == (lower_case(directive.name) == ".ifb"));
}

// .ifc a, b as they stand; .ifeqs "a", "b".
void Assembler::read_if_same(Directive& directive) {
  std::size_t comma = 0;
  while (comma < directive.rest.size() && directive.rest[comma] != ',') {
    const bool quote = directive.rest[comma] == '"' || directive.rest[comma] == '\'';
    comma = quote ? end_of_quoted(directive.rest, comma) : comma + 1;
  }
  if (comma >= directive.rest.size()) {
    fail(directive, fmt::format("{} compares two texts: write ',' between them", directive.name));
  }
  const auto bare = [](std::string_view text) {
    text = without_blanks_around(text);
    const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') &&
                        text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
  };
  const bool same = bare(directive.rest.substr(0, comma)) == bare(directive.rest.substr(comma + 1));
  const std::string name = lower_case(directive.name);
  begin_conditional(directive, same == (name == ".ifc" || name == ".ifeqs"));
}

void Assembler::read_else(Directive& directive) {
  if (conditionals_.size() <= source_.conditionals()) {
    fail(directive, ".else without .if");
  }
  Conditional& conditional = conditionals_.back();
  if (conditional.otherwise) {
    fail(directive,
         fmt::format("a second .else for the {} of line {}", ".if", conditional.begun.line));
  }
  conditional.otherwise = true;
  conditional.active = !conditional.taken;
  conditional.taken = true;
}

void Assembler::read_else_if(Directive& directive) {
  if (conditionals_.size() <= source_.conditionals()) {
    fail(directive, ".elseif without .if");
  }
  Conditional& conditional = conditionals_.back();
  if (conditional.otherwise) {
    fail(directive, ".elseif after .else");
  }
  conditional.active = false;
  if (!conditional.taken) {
    directive.tokens = tokens_of(directive.statement, directive.rest);
    const bool holds = read_number(directive, "a number") != 0;
    expect_end(directive);
    conditional.taken = conditional.active = holds;
  }
}

void Assembler::read_end_if(Directive& directive) {
  if (conditionals_.size() <= source_.conditionals()) {
    fail(directive, ".endif without .if");
  }
  conditionals_.pop_back();
}

// In a branch that is not taken only conditionals count, and of them those that end it.
void Assembler::skip_statement(const Statement& statement) {
  const std::string_view word = name_at(statement.text);
  const std::string name = lower_case(word);
  Directive directive{
      statement, word, without_blanks_around(statement.text.substr(word.size())), {}, 0};
  if (name.starts_with(".if")) {
    const KnownDirective* known = find_directive(name);
    if (known != nullptr) {  // a whole conditional of no account: none of its branches is taken
      begin_conditional(directive, false);
      conditionals_.back().taken = true;
    }
  } else if (name == ".else") {
    read_else(directive);
  } else if (name == ".elseif") {
    read_else_if(directive);
  } else if (name == ".endif") {
    read_end_if(directive);
  }
}

}  // namespace finback::assembler
