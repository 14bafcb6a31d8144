#include "assembly.hpp"

#include <cctype>
#include <string_view>

#include "../target/BfinInlineAsm.hpp"

namespace finback::compiler {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Reads preprocessed C just far enough to find asm statements and the strings in them.
class Rewriter {
 public:
  explicit Rewriter(const std::string& text) : text_(text) {}

  bool run(std::string& result) {
    while (at_ < text_.size()) {
      if (text_[at_] == '"' || text_[at_] == '\'') {
        copy_literal();
      } else if (is_word(text_[at_])) {
        const std::string_view word = copy_word();
        if (word == "asm" || word == "__asm" || word == "__asm__")
          assembly();
      } else {
        out_ += text_[at_++];
      }
    }
    result = std::move(out_);
    return found_;
  }

 private:
  std::string_view copy_word() {
    const size_t begin = at_;
    // C++ writes 1'000 for 1000.
    const bool number = std::isdigit(static_cast<unsigned char>(text_[begin])) != 0;
    while (at_ < text_.size() && (is_word(text_[at_]) || (number && text_[at_] == '\'')))
      ++at_;
    const std::string_view word(text_.data() + begin, at_ - begin);
    out_ += word;
    return word;
  }

  /// A string or character constant, with its quotes.
  std::string_view literal() {
    const size_t begin = at_;
    const char quote = text_[at_++];
    while (at_ < text_.size() && text_[at_] != quote)
      at_ += text_[at_] == '\\' ? 2 : 1;
    at_ = std::min(at_ + 1, text_.size());
    return {text_.data() + begin, at_ - begin};
  }
  void copy_literal() { out_ += literal(); }

  void assembly() {
    // Qualifiers may stand before the parenthesis.
    while (at_ < text_.size() && text_[at_] != '(') {
      if (is_word(text_[at_]))
        copy_word();
      else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
        out_ += text_[at_++];
      else
        return;
    }
    found_ = true;
    int depth = 0;
    int part = 0;  // text, outputs, inputs, clobbers
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' && depth == 1 && part > 0) {
        out_ += part == 3 ? clobber(literal()) : constraint(literal());
        continue;
      }
      if (c == '"' || c == '\'') {
        copy_literal();
        continue;
      }
      depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
      part += c == ':' && depth == 1 ? 1 : 0;
      out_ += c;
      ++at_;
      if (depth == 0)
        return;
    }
  }

  static std::string constraint(std::string_view quoted) {
    std::string result(quoted);
    for (char& c : result)
      c = c == 'd' ? llvm::kDataConstraint : c;
    return result;
  }

  static std::string clobber(std::string_view quoted) {
    const std::string_view name = quoted.substr(1, quoted.size() - 2);
    const std::string other = llvm::clobberForClang({name.data(), name.size()});
    return '"' + (other.empty() ? std::string(name) : other) + '"';
  }

  const std::string& text_;
  std::string out_;
  size_t at_ = 0;
  bool found_ = false;
};

}  // namespace

bool rewrite_assembly(std::string& text) {
  std::string result;
  const bool found = Rewriter(text).run(result);
  if (found)
    text = std::move(result);
  return found;
}

}  // namespace finback::compiler
