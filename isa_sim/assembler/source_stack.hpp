// What is being read: the file, inside it the files that it includes, the macros it calls and the
// repetitions of these; cut into statements.
//
// Bounds how deep this nests and how many statements there are, so that a text cannot run away.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <isa_sim/assembler/source_text.hpp>

namespace finback::assembler {

// From one `;` or end of line to the next, without blanks around; never empty.
struct Statement {
  std::shared_ptr<const SourceText> source;
  std::size_t offset = 0;
  std::string_view text;   // of `source`
  bool ends_line = false;  // by the end of the line, not by `;`
};

class SourceStack {
 public:
  static constexpr std::size_t kDeepest = 200;
  static constexpr std::uint64_t kMostStatements = 4'000'000;
  static constexpr std::size_t kLongestExpansion = 16 << 20;  // bytes
  static constexpr std::size_t kLongestTogether = 64 << 20;   // of texts that nest

  enum class Kind : std::uint8_t { file, macro, repetition };

  // Reads `text` next. `name`: of the macro, for messages. Throws InputError when it nests too
  // deep.
  void push(Kind kind, std::shared_ptr<const SourceText> text, const std::string& name,
            std::size_t conditionals);
  // The same, then what `next` gives until it gives nullptr.
  using NextText = std::function<std::shared_ptr<const SourceText>()>;
  void push_repetition(NextText next, std::size_t conditionals);

  // The next statement of the innermost text, or false at its end; empty() tells whether there are
  // texts around it, which end_text goes on with.
  [[nodiscard]] bool next(Statement& statement);
  [[nodiscard]] bool empty() const { return frames_.empty(); }
  void end_text();

  // Ends the innermost macro, and the repetitions in it; false outside of one. How many open
  // conditionals it began with.
  [[nodiscard]] bool leave_macro(std::size_t& conditionals);
  // How many conditionals were open when the innermost text began.
  [[nodiscard]] std::size_t conditionals() const { return frames_.back().conditionals; }
  void leave_all();

  // The text behind the last statement, for bodies and incomplete instructions; and going on
  // elsewhere in it.
  [[nodiscard]] const std::shared_ptr<const SourceText>& text() const {
    return frames_.back().text;
  }
  [[nodiscard]] std::size_t position() const { return frames_.back().position; }
  void go_to(std::size_t position) { frames_.back().position = position; }
  // The innermost file.
  [[nodiscard]] const std::string& file() const;

  // Throws InputError at a place of a text, followed by the macros it stands in.
  [[noreturn]] void fail(const SourcePlace& place, const std::string& message) const;
  // " (in macro CHECKREG, called at b.s:40)"
  [[nodiscard]] std::string context() const;
  // Where a statement stands in a file: of macros, their outermost call.
  [[nodiscard]] SourcePlace in_file(const Statement& statement) const;

 private:
  struct Frame {
    Kind kind = Kind::file;
    std::shared_ptr<const SourceText> text;
    std::size_t position = 0;
    std::string name;
    SourcePlace called_at;  // empty for the first file
    std::size_t conditionals = 0;
    NextText next;
  };

  Frame& push_frame(Kind kind, std::shared_ptr<const SourceText> text, const std::string& name,
                    std::size_t conditionals);
  void pop_frame();

  std::vector<Frame> frames_;
  std::size_t bytes_ = 0;  // of all texts in the stack
  SourcePlace current_;    // of the last statement
  std::uint64_t statements_ = 0;
};

// Where the statement that begins at `position` ends: at `;` or the end of the line, outside of
// quotes.
[[nodiscard]] std::size_t end_of_statement(std::string_view text, std::size_t position);

}  // namespace finback::assembler
