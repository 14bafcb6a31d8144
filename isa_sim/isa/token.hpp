// The words of BIR text: names, numbers, strings and operator signs, with their places.
//
// Knows the GNU assembler's comments (`/* */`, `//`, `#` at the start of a line) and nothing of
// instructions. Names keep their dots ("R0.L", "JUMP.S", ".Lloop"). Numbers are as in C (decimal,
// 0x, 0b, leading 0 is octal, 'c'). Source: GNU as manual, "Syntax" and "Blackfin Syntax".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace finback::isa {

enum class TokenKind : std::uint8_t {
  name,    // letters, digits, _ . $, not starting with a digit
  number,  // `number` holds its value
  text,    // a string between quotes; `text` is what stands between them, escapes untouched
  sign,    // the longest operator that fits: "+|+", ">>>", "||", "(" ...
};

struct Token {
  TokenKind kind = TokenKind::sign;
  bool first_in_line = false;
  int line = 0;    // from 1
  int column = 0;  // from 1, in bytes
  std::int64_t number = 0;
  std::string_view text;  // as written; views the text that was split
  [[nodiscard]] bool is(std::string_view sign) const {
    return kind == TokenKind::sign && text == sign;
  }
};

// Assembler files write some words that BIR does not: references to numbered labels (`1b`, `2f`,
// names to us), fractions (`0.5` is 0x4000), `h#1F o#17 b#11 d#9`, `4k`, and a character without
// its second quote.
enum class Dialect : std::uint8_t { bir, assembler };

// Where a text cannot be split, and why.
struct BadWord {
  std::size_t offset = 0;
  int line = 0;  // as a token's
  int column = 0;
  std::string message;
};

// ASCII letters alone.
[[nodiscard]] std::string upper_case(std::string_view text);

// Appends the tokens of a whole text, which view it. Returns what stops it, if anything does.
[[nodiscard]] std::optional<BadWord> split_words(std::string_view text, Dialect dialect,
                                                 std::vector<Token>& tokens);

// Splits a whole BIR text. The tokens view `text`. Throws InputError with file, line and column at
// a character that cannot stand there, an unclosed string or comment, or a number out of 64 bits.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text, const std::string& file = "");

}  // namespace finback::isa
