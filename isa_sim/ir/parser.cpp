#include <algorithm>
#include <fmt/format.h>

#include <common/file.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/parser_state.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::ir {

using isa::Token;
using isa::TokenKind;

Program Parser::run() {
  read_heading();
  while (position_ < tokens_.size()) {
    read_statement();
  }
  end_object();
  apply_bindings();
  return std::move(program_);
}

SourcePlace Parser::place(const Token& token) const { return {file_, token.line, token.column}; }

void Parser::fail(const Token& token, const std::string& message) const {
  throw InputError(place(token), message);
}

void Parser::read_heading() {
  static constexpr std::string_view kWanted = "a BIR file begins with `.bir 1`";
  if (tokens_.empty()) {
    throw InputError(SourcePlace{file_, 1, 1}, std::string(kWanted) + ", but this one is empty");
  }
  if (tokens_[0].text != ".bir") {
    fail(tokens_[0], std::string(kWanted));
  }
  const Arguments arguments = read_arguments();
  if (arguments.size() != 1 || arguments[0].kind != TokenKind::number) {
    fail(tokens_[0], std::string(kWanted));
  }
  if (arguments[0].number != 1) {
    fail(arguments[0], fmt::format("BIR version {} is not known: this Finback reads version 1",
                                   arguments[0].number));
  }
}

Parser::Arguments Parser::read_arguments() {
  const std::size_t start = ++position_;
  while (position_ < tokens_.size() && !tokens_[position_].first_in_line &&
         !tokens_[position_].is(";")) {
    ++position_;
  }
  const Arguments arguments(tokens_.data() + start, position_ - start);
  if (position_ < tokens_.size() && tokens_[position_].is(";")) {
    ++position_;
  }
  return arguments;
}

void Parser::read_statement() {
  const Token& token = tokens_[position_];
  const bool labelled = position_ + 1 < tokens_.size() && tokens_[position_ + 1].is(":");
  if (token.is(";")) {
    ++position_;
  } else if (token.kind == TokenKind::name && labelled) {
    read_label(token);
    position_ += 2;
  } else if (token.kind == TokenKind::number && labelled) {
    fail(token, "numbered labels are not BIR: give the label a name, such as .L1");
  } else if (token.kind == TokenKind::name && token.text.starts_with('.')) {
    read_directive(token);
  } else {
    read_packet();
  }
}

void Parser::read_label(const Token& token) {
  const std::string name(token.text);
  if (isa::register_by_name(name)) {
    fail(token, fmt::format("{} is a register, no label can be called so", name));
  }
  const auto type = types_.find(name);
  if (type != types_.end() ? type->second == SymbolType::function : false) {
    begin_function(token, name);
  } else if (type != types_.end() || !section_.code) {
    begin_object(token, name);
  } else if (in_function_) {
    Function& function = program_.functions.back();
    if (!function.labels.emplace(name, function.packets.size()).second) {
      fail(token, fmt::format("label {} stands twice in {}", name, function.name));
    }
    align_.reset();
  } else {
    fail(token, fmt::format("label {} stands outside a function: write `.type {}, @function` "
                            "before it",
                            name, name));
  }
}

void Parser::begin_function(const Token& token, const std::string& name) {
  end_object();
  Function function;
  function.name = name;
  function.section = section_.name;
  function.align = std::max(align_.value_or(1), 2u);
  function.written = place(token);
  program_.functions.push_back(std::move(function));
  in_function_ = true;
  align_.reset();
  source_file_ = source_line_ = 0;
}

void Parser::begin_object(const Token& token, const std::string& name) {
  end_object();
  Object object;
  object.name = name;
  object.section = section_.name;
  object.align = align_.value_or(1);
  object.written = place(token);
  object_.emplace(std::move(object));
  align_.reset();
}

void Parser::end_object() {
  if (object_) {
    program_.objects.push_back(object_->finish());
    object_.reset();
  }
}

void Parser::apply_bindings() {
  for (Function& function : program_.functions) {
    function.binding = binding_of(function.name);
    for (const auto& [label, packet] : function.labels) {
      const auto bound = bindings_.find(label);
      if (bound != bindings_.end() && bound->second.first != Binding::local) {
        fail(*bound->second.second,
             fmt::format("{} is a label inside {}: only functions and objects can be global", label,
                         function.name));
      }
    }
  }
  for (Object& object : program_.objects) {
    object.binding = binding_of(object.name);
  }
}

Binding Parser::binding_of(const std::string& name) const {
  const auto found = bindings_.find(name);
  return found == bindings_.end() ? Binding::local : found->second.first;
}

void Parser::read_packet() {
  const Token& first = tokens_[position_];
  if (!in_function_ || !section_.code) {
    fail(first, in_function_ ? fmt::format("an instruction in the data section {}: write .text "
                                           "before it",
                                           section_.name)
                             : "an instruction outside a function: write `.type _name, "
                               "@function` and `_name:` before it");
  }
  Packet packet;
  packet.file = source_file_;
  packet.line = source_line_;
  packet.written = place(first);
  std::size_t start = position_;
  for (;; ++position_) {
    if (position_ == tokens_.size()) {
      fail(first, "this instruction never ends: add ';'");
    }
    const bool ends = tokens_[position_].is(";");
    if (ends || tokens_[position_].is("||")) {
      packet.slots.push_back(read_instruction(start));
      start = position_ + 1;
    }
    if (ends) {
      break;
    }
  }
  ++position_;
  order_slots(packet, syntax_.table());
  program_.functions.back().packets.push_back(std::move(packet));
  align_.reset();
}

ParsedInstruction Parser::read_instruction(std::size_t start) {
  const Arguments words(tokens_.data() + start, position_ - start);
  if (auto parsed = syntax_.match(words)) {
    return *std::move(parsed);
  }
  const isa::SyntaxProblem problem = syntax_.explain(words);
  fail(tokens_[start + problem.token], problem.message);
}

Program parse(std::string_view text, const std::string& file, const isa::Syntax& syntax) {
  return Parser(text, file, syntax).run();
}

Program parse(std::string_view text, const std::string& file) {
  return parse(text, file, isa::instruction_syntax());
}

Program load_program(const std::filesystem::path& path) {
  Program program = assembler::is_assembler_file(path) ? assembler::assemble_file(path)
                                                       : parse(read_text_file(path), path.string());
  verify(program);
  return program;
}

}  // namespace finback::ir
