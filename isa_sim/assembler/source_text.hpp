// Text to be assembled that knows where each of its characters was written: a file, or what a macro
// became.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>

namespace finback::assembler {

class SourceText {
 public:
  // A whole file. Comments become blanks, so that places stay what they are; marks of the C
  // preprocessor (`# 12 "a.S"`) rename what follows. Throws InputError for an unclosed comment.
  [[nodiscard]] static std::shared_ptr<const SourceText> of_file(std::string text,
                                                                 const std::string& file);
  // The piece [from, to) of another text, for a macro's body.
  [[nodiscard]] static std::shared_ptr<const SourceText> part_of(
      std::shared_ptr<const SourceText> whole, std::size_t from, std::size_t to);

  // Where a text of one's own comes from: at `offset` begins what stands at `from` of the other;
  // or, of an argument, what all stands for that one place.
  struct Cut {
    std::size_t offset = 0;
    std::size_t from = 0;
    bool argument = false;
  };
  // `text` made of `original`. Cuts are ordered by offset and begin at 0.
  [[nodiscard]] static std::shared_ptr<const SourceText> made_of(
      std::shared_ptr<const SourceText> original, std::string text, std::vector<Cut> cuts);

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] SourcePlace place(std::size_t offset) const;

 private:
  // From `offset` on, `line` of `file` begins.
  struct Line {
    std::size_t offset = 0;
    int line = 0;
    std::size_t file = 0;
  };

  void index_lines(const std::string& file);
  void read_mark(std::string_view line, Line& next);

  std::string text_;
  std::vector<Line> lines_;         // of a file
  std::vector<std::string> files_;  // of a file
  std::shared_ptr<const SourceText> original_;
  std::vector<Cut> cuts_;
};

// Blanks comments (`/* */`, `//`, `#` where no number in another base begins) outside of quotes.
// Throws InputError for a comment that is never closed.
[[nodiscard]] std::string without_comments(std::string text, const std::string& file);

// Where the string or character that begins at `start` (a quote) ends: the index behind it, at most
// the end of the line.
[[nodiscard]] std::size_t end_of_quoted(std::string_view text, std::size_t start);

// A letter, digit, `_`, `.` or `$`.
[[nodiscard]] constexpr bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '$';
}
[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}
[[nodiscard]] std::string lower_case(std::string_view text);
// The name characters from `position` on; none gives an empty text.
[[nodiscard]] std::string_view name_at(std::string_view text, std::size_t position = 0);
[[nodiscard]] std::string_view without_blanks_around(std::string_view text);

}  // namespace finback::assembler
