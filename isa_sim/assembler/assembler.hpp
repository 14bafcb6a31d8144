// The assembler's inside: what it keeps between statements. Statements, labels and the end of the
// file are read in assembler.cpp, instructions in instruction_reader.cpp, directives in
// conditionals.cpp, macro_directives.cpp, data_directives.cpp and symbol_directives.cpp.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/assembler/expression.hpp>
#include <isa_sim/assembler/macro.hpp>
#include <isa_sim/assembler/section.hpp>
#include <isa_sim/assembler/source_stack.hpp>
#include <isa_sim/assembler/symbol_table.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::assembler {

class Assembler : private ExpressionReader::Names {
 public:
  static constexpr std::uint64_t kMostBytes = 256ull << 20;  // of a file, in all its sections
  static constexpr std::size_t kMostPackets = 1'000'000;
  static constexpr int kMostLines = 64;  // of one instruction

  Assembler(const Options& options, const isa::Syntax& syntax);

  ir::Program run(std::string_view text, const std::string& file);

 private:
  // A directive with what stands behind its name; tokens are made when they are asked for.
  struct Directive {
    Statement statement;
    std::string_view name;  // as written
    std::string_view rest;
    std::vector<isa::Token> tokens;
    std::size_t position = 0;  // of the next token
    [[nodiscard]] bool at_end() const { return position >= tokens.size(); }
  };
  using Handler = void (Assembler::*)(Directive&);
  struct KnownDirective {
    std::string_view name;
    Handler handler;
    bool words = false;  // `rest` is read as it stands, not as tokens
  };
  struct Conditional {
    bool taken = false;  // some branch was
    bool active = false;
    bool otherwise = false;  // .else was seen
    SourcePlace begun;
  };

  // --- messages ---
  [[nodiscard]] static SourcePlace place_of(const Statement& statement, std::string_view at);
  [[noreturn]] void fail(const Statement& statement, std::string_view at,
                         const std::string& message) const;
  [[noreturn]] void fail(const Directive& directive, const std::string& message) const;
  void warn(const Statement& statement, std::string_view at, const std::string& message) const;

  // --- statements ---
  void define_constants();
  void read_all();
  void read_statement(Statement statement);
  // Takes labels off the front of a statement.
  void read_labels(Statement& statement);
  [[nodiscard]] bool read_equation(const Statement& statement, std::string_view name,
                                   std::string_view rest);
  void define_label(Symbol& symbol, const Statement& statement, std::string_view at,
                    std::uint32_t offset);
  [[nodiscard]] bool in_false_branch() const {
    return !conditionals_.empty() && !conditionals_.back().active;
  }
  ir::Program finish(const std::string& file);
  void finish_symbols(ir::Program& program);
  void check_private_labels() const;

  // --- expressions ---
  Symbol* symbol(const isa::Token& token) override;
  std::vector<isa::Token> tokens_of(const Statement& statement, std::string_view text) const;
  // The expression at the directive's next tokens.
  ExpressionPointer read_expression(Directive& directive, std::string_view wanted);
  std::int64_t read_number(Directive& directive, std::string_view wanted);
  std::int64_t number_of(const Statement& statement, std::string_view at,
                         const Expression& expression, std::string_view wanted) const;
  void set_symbol(Symbol& symbol, const ExpressionPointer& expression, const SourcePlace& place);
  bool take_comma(Directive& directive) const;
  void expect_end(const Directive& directive) const;
  std::string_view take_name(Directive& directive, std::string_view wanted) const;

  // --- instructions ---
  struct Folded;
  class InInstruction;
  void read_instruction(Statement statement);
  std::vector<isa::Token> gather_instruction(Statement& statement);
  [[nodiscard]] bool begins_other_statement(std::string_view text) const;
  [[nodiscard]] bool is_complete(const std::vector<isa::Token>& tokens);
  ir::Packet read_packet(const std::vector<isa::Token>& tokens, const Statement& statement);
  [[nodiscard]] bool ends_operand(const isa::Token& token) const;
  Folded fold(std::span<const isa::Token> tokens);
  bool fold_half(std::span<const isa::Token> tokens, std::size_t& position, Folded& folded);
  std::size_t fold_one(std::span<const isa::Token> tokens, std::size_t position, Folded& folded);
  std::optional<ir::ParsedInstruction> match(Folded& folded);
  std::optional<ir::ParsedInstruction> match_later(Folded& folded);
  std::optional<ir::ParsedInstruction> match_distance(const Folded& folded);
  [[nodiscard]] bool read_loop(const std::vector<isa::Token>& tokens, const Statement& statement);
  void emit(ir::Packet packet, const Statement& statement);
  void finish_operands();

  // --- directives ---
  [[nodiscard]] static const std::vector<KnownDirective>& directives();
  [[nodiscard]] static const KnownDirective* find_directive(std::string_view name);
  void read_directive(const Statement& statement, std::string_view name, std::string_view rest);
  void ignore(Directive&) {}

  // conditionals.cpp
  void begin_conditional(const Directive& directive, bool holds);
  void read_if(Directive& directive);
  void read_if_defined(Directive& directive);
  void read_if_blank(Directive& directive);
  void read_if_same(Directive& directive);
  void read_else(Directive& directive);
  void read_else_if(Directive& directive);
  void read_end_if(Directive& directive);
  void skip_statement(const Statement& statement);

  // macro_directives.cpp
  std::shared_ptr<const SourceText> take_body(const Directive& directive, std::string_view begin,
                                              std::string_view end);
  void call_macro(const Macro& macro, const Statement& statement, std::string_view rest);
  void read_macro(Directive& directive);
  void read_stray_end(Directive& directive);
  void read_exit_macro(Directive& directive);
  void read_purge(Directive& directive);
  void read_repeat(Directive& directive);
  void read_repeat_each(Directive& directive);
  void read_include(Directive& directive);
  void read_include_bytes(Directive& directive);
  void read_end(Directive& directive);
  void read_message(Directive& directive);
  std::filesystem::path find_file(Directive& directive, std::string& name);
  void push_file(const std::string& text, const std::string& file,
                 const std::filesystem::path& path);

  // data_directives.cpp
  void read_data(Directive& directive);
  void read_strings(Directive& directive);
  void read_space(Directive& directive);
  void read_fill(Directive& directive);
  void read_align(Directive& directive);
  void read_origin(Directive& directive);
  void move_to(const Statement& statement, std::string_view at, const Expression& expression,
               std::uint8_t value);
  void put_value(const Statement& statement, std::string_view at, const ExpressionPointer& value,
                 int bytes);
  void fill(const Statement& statement, std::uint32_t count, std::uint8_t value);
  void reserve(const Directive& directive, std::int64_t count, std::int64_t each);
  void finish_data();
  [[nodiscard]] std::string read_text(Directive& directive);

  // symbol_directives.cpp
  void read_binding(Directive& directive);
  void read_set(Directive& directive);
  void read_common(Directive& directive);
  void read_section(Directive& directive);
  void read_plain_section(Directive& directive);
  void read_push_section(Directive& directive);
  void read_pop_section(Directive& directive);
  void read_previous(Directive& directive);
  std::string take_section_name(Directive& directive);
  void enter_section(const std::string& name);
  [[nodiscard]] Section& section() { return sections_[current_section_]; }
  void read_file(Directive& directive);
  void read_line(Directive& directive);
  int source_file(const std::string& name);

  // A value of a few bytes, or an instruction's operand, to be known at the end of the file.
  struct LaterValue {
    ExpressionPointer expression;
    std::size_t section = 0;
    std::uint32_t offset = 0;
    int bytes = 0;
    SourcePlace place;
    std::string context;
  };
  struct LaterOperand {
    ExpressionPointer expression;
    std::size_t section = 0;
    std::size_t packet = 0;
    std::size_t slot = 0;
    std::size_t operand = 0;
    SourcePlace place;
    std::string context;
  };

  const Options& options_;
  const isa::Syntax& syntax_;
  SourceStack source_;
  SymbolTable symbols_;
  std::map<std::string, Macro, std::less<>> macros_;  // by lower-case name
  std::uint64_t expansions_ = 0;
  std::vector<Conditional> conditionals_;
  const Statement* statement_ = nullptr;  // being read, for places of symbols
  ir::Program program_;
  std::string stem_;  // of the file's name
  std::deque<Section> sections_;
  std::map<std::string, std::size_t> section_numbers_;
  std::vector<std::string> section_names_;
  std::size_t current_section_ = 0;
  std::size_t previous_section_ = 0;
  std::vector<std::pair<std::size_t, std::size_t>> section_stack_;
  std::map<std::string, ir::Object> common_;
  std::uint64_t bytes_ = 0;
  std::size_t packets_ = 0;
  std::vector<LaterValue> later_values_;
  std::vector<LaterOperand> later_operands_;
  std::size_t operands_placed_ = 0;  // of later_operands_: their packet is known
  std::map<std::string, int> source_numbers_;
  std::map<std::int64_t, int> file_numbers_;  // of .file
  int loc_file_ = 0;                          // of .loc, until the next label of code
  int loc_line_ = 0;
  std::deque<std::string> texts_;                         // that tokens view
  std::map<std::string, std::filesystem::path> folders_;  // of the files that are read
};

}  // namespace finback::assembler
