// The parser's inside: what it keeps between statements. Statements, labels and packets are read in
// parser.cpp, directives in parser_directives.cpp.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isa_sim/ir/object_builder.hpp>
#include <isa_sim/ir/program.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::ir {

struct Section {
  std::string name = ".text";
  bool code = true;
};

enum class SymbolType : std::uint8_t { function, object };

class Parser {
 public:
  Parser(std::string_view text, const std::string& file, const isa::Syntax& syntax)
      : file_(file), syntax_(syntax), tokens_(isa::tokenize(text, file)) {
    program_.path = file;
    program_.source_files.emplace_back();
  }

  Program run();

 private:
  // Handlers take the directive's arguments.
  using Arguments = std::span<const isa::Token>;
  using Handler = void (Parser::*)(const isa::Token& directive, Arguments);
  struct Directive {
    std::string_view name;
    Handler handler;
  };

  [[nodiscard]] SourcePlace place(const isa::Token& token) const;
  [[noreturn]] void fail(const isa::Token& token, const std::string& message) const;
  void read_heading();

  // The rest of the statement at a directive: to the end of the line or `;`.
  Arguments read_arguments();
  void read_statement();

  // --- labels, functions, objects ---

  void read_label(const isa::Token& token);
  void begin_function(const isa::Token& token, const std::string& name);
  void begin_object(const isa::Token& token, const std::string& name);
  void end_object();
  void apply_bindings();
  [[nodiscard]] Binding binding_of(const std::string& name) const;

  // --- instructions ---

  void read_packet();
  ParsedInstruction read_instruction(std::size_t start);

  // --- directives ---

  void read_directive(const isa::Token& token);
  static const std::vector<Directive>& directives();
  static std::int64_t bytes_of(std::string_view directive);
  void repeat_heading(const isa::Token& directive, Arguments);
  void refuse_word(const isa::Token& directive, Arguments);
  void expect_end(Arguments arguments, std::size_t count) const;

  // The argument at `index`, which must be of `kind`.
  const isa::Token& expect(const isa::Token& directive, Arguments arguments, std::size_t index,
                           isa::TokenKind kind, std::string_view wanted) const;
  void read_file(const isa::Token& directive, Arguments arguments);
  void read_loc(const isa::Token& directive, Arguments arguments);
  void enter_section(const std::string& name, bool code);
  void enter_named_section(const isa::Token& directive, Arguments arguments);
  void read_section(const isa::Token& directive, Arguments arguments);
  void read_names(const isa::Token& directive, Arguments arguments, Binding binding);
  void read_global(const isa::Token& directive, Arguments arguments);
  void read_weak(const isa::Token& directive, Arguments arguments);
  void read_local(const isa::Token& directive, Arguments arguments);
  void expect_comma(const isa::Token& directive, Arguments arguments, std::size_t index) const;
  void read_type(const isa::Token& directive, Arguments arguments);
  void read_size(const isa::Token& directive, Arguments arguments);
  Object* find_object(std::string_view name);
  void read_align(const isa::Token& directive, Arguments arguments);
  void read_p2align(const isa::Token& directive, Arguments arguments);
  void set_align(const isa::Token& token, std::int64_t bytes);

  // .comm name, size[, align] and .lcomm.
  void read_common(const isa::Token& directive, Arguments arguments);

  // --- data ---

  ObjectBuilder& data_object(const isa::Token& directive);
  void read_data(const isa::Token& directive, Arguments arguments);

  // One value at `index`: a number, or a symbol with or without an offset. Returns where it ends.
  std::size_t read_value(const isa::Token& directive, Arguments arguments, std::size_t index,
                         int bytes, ObjectBuilder& object);
  std::size_t read_address(Arguments arguments, std::size_t index, int bytes,
                           ObjectBuilder& object);
  void read_space(const isa::Token& directive, Arguments arguments);
  void read_strings(const isa::Token& directive, Arguments arguments);
  [[nodiscard]] std::string unescape(const isa::Token& token) const;

  const std::string& file_;
  const isa::Syntax& syntax_;
  std::vector<isa::Token> tokens_;
  std::size_t position_ = 0;
  Program program_;
  Section section_;
  bool in_function_ = false;  // of program_.functions.back()
  std::optional<ObjectBuilder> object_;
  std::optional<std::uint32_t> align_;  // asked for, for what comes next
  int source_file_ = 0;
  int source_line_ = 0;
  std::map<std::string, SymbolType> types_;
  std::map<std::string, std::pair<Binding, const isa::Token*>> bindings_;
};

}  // namespace finback::ir
