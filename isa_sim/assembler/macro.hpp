// Macros and repetitions: what they are made of, and the text they become.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isa_sim/assembler/source_text.hpp>

namespace finback::assembler {

struct MacroParameter {
  std::string name;
  std::string standard;  // when no argument is given
  bool required = false;
  bool rest = false;  // takes all that is left (`:vararg`)
};

struct Macro {
  std::string name;
  std::vector<MacroParameter> parameters;
  std::shared_ptr<const SourceText> body;
};

// What names stand for in a body: `\name`.
using Replacements = std::vector<std::pair<std::string, std::string>>;

// Reads "name a, b=1, c:req, d:vararg". Throws std::string, what is wrong.
[[nodiscard]] Macro read_macro_head(std::string_view text);

// Reads the arguments of a call. Throws std::string, what is wrong.
[[nodiscard]] Replacements bind_arguments(const Macro& macro, std::string_view text);

// Arguments as macros take them: separated by commas or blanks, blanks around operators dropped,
// quotes around a string taken off.
[[nodiscard]] std::vector<std::string> split_arguments(std::string_view text);

// The body with `\name` replaced, `\()` taken out and `\@` as `number`. Longer than `limit` bytes:
// nullptr.
[[nodiscard]] std::shared_ptr<const SourceText> replace_names(
    const std::shared_ptr<const SourceText>& body, const Replacements& replacements,
    std::uint64_t number, std::size_t limit);

}  // namespace finback::assembler
