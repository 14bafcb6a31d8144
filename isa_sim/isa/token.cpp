#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

#include <common/error.hpp>
#include <isa_sim/isa/token.hpp>

namespace finback::isa {
namespace {

// Longest first: the first that fits is taken.
constexpr std::array<std::string_view, 26> kSigns = {
    ">>>=", ">>>", "<<<", "<<=", ">>=", "+|+", "+|-", "-|+", "-|-", "++", "--", "+=", "-=",
    "*=",   "&=",  "|=",  "^=",  "<<",  ">>",  "==",  "<=",  "||",  "!=", ">=", "&&", "=>"};
constexpr std::string_view kSingleSigns = "()[]{},;:+-*/&|^~!<>=@%";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool starts_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == '$';
}
bool continues_name(char c) { return starts_name(c) || is_digit(c); }

// The value of a digit in any base up to 16, or 99.
int digit_value(char c) {
  if (is_digit(c)) {
    return c - '0';
  }
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : 99;
}

class Tokenizer {
 public:
  Tokenizer(std::string_view text, Dialect dialect, std::vector<Token>& tokens)
      : text_(text), dialect_(dialect), tokens_(tokens) {}

  // Throws BadWord.
  void run() {
    while (skip_blanks()) {
      Token token;
      token.first_in_line = line_ != last_token_line_;
      token.line = last_token_line_ = line_;
      token.column = column();
      const std::size_t start = position_;
      const char c = text_[position_];
      if (starts_name(c)) {
        if (!read_marked_number(token)) {
          read_name(token);
        }
      } else if (is_digit(c)) {
        read_number(token);
      } else if (c == '"') {
        read_text(token);
      } else if (c == '\'') {
        read_character(token);
      } else {
        read_sign();
      }
      if (token.kind != TokenKind::text) {
        token.text = text_.substr(start, position_ - start);
      }
      tokens_.push_back(token);
    }
  }

 private:
  [[nodiscard]] int column() const { return static_cast<int>(position_ - line_start_) + 1; }
  [[nodiscard]] char at(std::size_t position) const {
    return position < text_.size() ? text_[position] : '\0';
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw BadWord{position_, line_, column(), message};
  }

  void new_line() {
    ++line_;
    line_start_ = position_ + 1;
  }

  void skip_to_end_of_line() { position_ = std::min(text_.find('\n', position_), text_.size()); }

  void skip_block_comment() {
    const std::size_t end = text_.find("*/", position_ + 2);
    if (end == std::string_view::npos) {
      fail("this comment is never closed: add */");
    }
    for (; position_ < end; ++position_) {
      if (text_[position_] == '\n') {
        new_line();
      }
    }
    position_ = end + 2;
  }

  // Goes to the next token; false at the end of the text.
  bool skip_blanks() {
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == '\n') {
        new_line();
        ++position_;
      } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f') {
        ++position_;
      } else if ((c == '/' && at(position_ + 1) == '/') ||
                 (c == '#' && line_ != last_token_line_)) {
        skip_to_end_of_line();
      } else if (c == '/' && at(position_ + 1) == '*') {
        skip_block_comment();
      } else {
        return true;
      }
    }
    return false;
  }

  void read_name(Token& token) {
    token.kind = TokenKind::name;
    while (position_ < text_.size() && continues_name(text_[position_])) {
      ++position_;
    }
  }

  void read_number(Token& token) {
    if (dialect_ != Dialect::bir && read_assembler_number(token)) {
      return;
    }
    token.kind = TokenKind::number;
    const std::size_t start = position_;
    int base = 10;
    const char mark = static_cast<char>(at(position_ + 1) | 0x20);
    if (text_[position_] == '0' && (mark == 'x' || mark == 'b')) {
      base = mark == 'x' ? 16 : 2;
      position_ += 2;
      if (digit_value(at(position_)) >= base) {
        fail("this number has no digits");
      }
    } else if (text_[position_] == '0' && is_digit(at(position_ + 1)) &&
               !is_decimal_all_the_same()) {
      base = 8;
    }
    std::int64_t value = 0;
    for (; position_ < text_.size() && continues_name(text_[position_]); ++position_) {
      const int digit = digit_value(text_[position_]);
      if (digit >= base && ends_in_k(base)) {
        value *= 1024;
        ++position_;
        break;
      }
      if (digit >= base) {
        fail(fmt::format("'{}' is no digit of a base {} number", text_[position_], base));
      }
      if (value > (std::numeric_limits<std::int64_t>::max() - digit) / base) {
        position_ = start;
        fail("this number does not fit into 64 bits");
      }
      value = value * base + digit;
    }
    token.number = value;
  }

  // A fraction, or a reference to a numbered label.
  bool read_assembler_number(Token& token) {
    std::size_t end = position_;
    while (is_digit(at(end))) {
      ++end;
    }
    const char mark = static_cast<char>(at(end) | 0x20);
    if ((mark == 'b' || mark == 'f') && !continues_name(at(end + 1))) {
      token.kind = TokenKind::name;
      position_ = end + 1;
      return true;
    }
    if (text_.substr(position_, end - position_) != "0" || at(end) != '.' ||
        !is_digit(at(end + 1))) {
      return false;
    }
    std::int64_t digits = 0;
    std::int64_t scale = 1;
    for (++end; is_digit(at(end)); ++end) {
      if (scale < 1'000'000'000'000) {
        digits = digits * 10 + (at(end) - '0');
        scale *= 10;
      }
    }
    token.kind = TokenKind::number;
    token.number = digits * 0x8000 / scale;
    position_ = end;
    return true;
  }

  // "h#1F": the letter names the base.
  bool read_marked_number(Token& token) {
    static constexpr std::string_view kLetters = "hobd";
    static constexpr std::array kBases = {16, 8, 2, 10};
    const std::size_t letter = kLetters.find(static_cast<char>(text_[position_] | 0x20));
    if (dialect_ == Dialect::bir || letter == std::string_view::npos || at(position_ + 1) != '#' ||
        digit_value(at(position_ + 2)) >= kBases[letter]) {
      return false;
    }
    token.kind = TokenKind::number;
    std::int64_t value = 0;
    for (position_ += 2; digit_value(at(position_)) < kBases[letter]; ++position_) {
      if (value >> 32 != 0) {
        fail("this number does not fit into 32 bits");
      }
      value = value * kBases[letter] + digit_value(at(position_));
    }
    token.number = value;
    return true;
  }

  // `08` can be nothing else.
  [[nodiscard]] bool is_decimal_all_the_same() const {
    std::size_t end = position_;
    bool large = false;
    for (; is_digit(at(end)); ++end) {
      large = large || at(end) > '7';
    }
    return dialect_ == Dialect::assembler && large;
  }

  // "4k" is 4096.
  [[nodiscard]] bool ends_in_k(int base) const {
    return dialect_ != Dialect::bir && base == 10 && (text_[position_] | 0x20) == 'k' &&
           !continues_name(at(position_ + 1));
  }

  void read_text(Token& token) {
    token.kind = TokenKind::text;
    std::size_t end = position_ + 1;
    while (at(end) != '"') {
      if (end >= text_.size() || text_[end] == '\n') {
        fail("this string is never closed: add \"");
      }
      end += text_[end] == '\\' ? 2 : 1;
    }
    token.text = text_.substr(position_ + 1, end - position_ - 1);
    position_ = end + 1;
  }

  void read_character(Token& token) {
    token.kind = TokenKind::number;
    std::size_t end = position_ + 1;
    char value = at(end);
    if (value == '\\') {
      static constexpr std::string_view kLetters = "ntr0\\'\"";
      static constexpr std::string_view kValues{"\n\t\r\0\\'\"", 7};
      const std::size_t letter = kLetters.find(at(++end));
      if (letter == std::string_view::npos) {
        fail("unknown escape in a character: write \\n \\t \\r \\0 \\\\ \\' or the number");
      }
      value = kValues[letter];
    }
    const bool one_quote = dialect_ != Dialect::bir && end < text_.size() && text_[end] != '\n';
    if (at(end + 1) != '\'' && one_quote) {
      --end;  // without its second quote
    } else if (at(end + 1) != '\'') {
      fail("a character stands between two quotes, as in 'a'");
    }
    token.number = static_cast<unsigned char>(value);
    position_ = end + 2;
  }

  void read_sign() {
    for (const std::string_view sign : kSigns) {
      if (text_.substr(position_, sign.size()) == sign) {
        position_ += sign.size();
        return;
      }
    }
    const char c = text_[position_];
    if (kSingleSigns.find(c) == std::string_view::npos) {
      const bool printable = c > ' ' && c < '\x7f';
      fail(printable ? fmt::format("'{}' cannot stand here", c)
                     : fmt::format("byte 0x{:02x} cannot stand here: programs are plain ASCII text",
                                   static_cast<unsigned char>(c)));
    }
    ++position_;
  }

  std::string_view text_;
  Dialect dialect_;
  std::vector<Token>& tokens_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  int last_token_line_ = 0;
};

}  // namespace

std::optional<BadWord> split_words(std::string_view text, Dialect dialect,
                                   std::vector<Token>& tokens) {
  try {
    Tokenizer(text, dialect, tokens).run();
  } catch (BadWord& bad) {
    return std::move(bad);
  }
  return std::nullopt;
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return upper;
}

std::vector<Token> tokenize(std::string_view text, const std::string& file) {
  std::vector<Token> tokens;
  tokens.reserve(text.size() / 3);
  if (const auto bad = split_words(text, Dialect::bir, tokens)) {
    throw InputError(SourcePlace{file, bad->line, bad->column}, bad->message);
  }
  return tokens;
}

}  // namespace finback::isa
