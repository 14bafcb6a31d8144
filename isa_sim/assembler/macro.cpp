#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/assembler/macro.hpp>

namespace finback::assembler {
namespace {

std::size_t skip_blanks(std::string_view text, std::size_t position) {
  while (position < text.size() && is_blank(text[position])) {
    ++position;
  }
  return position;
}

// Blanks stay only between two words: "a + b" is one argument, "a b" are two.
std::string without_free_blanks(std::string_view text) {
  std::string result;
  const auto word = [](char c) { return is_name_character(c) || c == '"' || c == '\\'; };
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"' || text[i] == '\'') {
      const std::size_t end = end_of_quoted(text, i);
      result += text.substr(i, end - i);
      i = end;
    } else if (is_blank(text[i]) || text[i] == '\n') {
      std::size_t next = i;
      while (next < text.size() && (is_blank(text[next]) || text[next] == '\n')) {
        ++next;
      }
      if (!result.empty() && next < text.size() && word(result.back()) && word(text[next])) {
        result += ' ';
      }
      i = next;
    } else {
      result += text[i++];
    }
  }
  return result;
}

// Where the argument that begins at `position` ends: at a comma, or a blank outside of brackets.
std::size_t end_of_argument(std::string_view text, std::size_t position) {
  int open = 0;
  while (position < text.size() && text[position] != ',' && (open > 0 || text[position] != ' ')) {
    const char c = text[position];
    if (c == '"' || c == '\'') {
      position = end_of_quoted(text, position);
      continue;
    }
    open += c == '(' || c == '[' ? 1 : (c == ')' || c == ']') && open > 0 ? -1 : 0;
    ++position;
  }
  return position;
}

std::string without_quotes(std::string_view text) {
  const bool quoted =
      text.size() > 1 && text.front() == '"' && end_of_quoted(text, 0) == text.size();
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

// Arguments one after the other.
class Arguments {
 public:
  explicit Arguments(std::string_view text)
      : text_(without_free_blanks(without_blanks_around(text))) {}

  [[nodiscard]] bool at_end() const { return position_ >= text_.size(); }
  [[nodiscard]] std::string_view rest() const {
    return std::string_view(text_).substr(std::min(position_, text_.size()));
  }
  void skip(std::size_t count) { position_ += count; }

  std::string take() {
    const std::size_t end = end_of_argument(text_, position_);
    std::string argument =
        without_quotes(std::string_view(text_).substr(position_, end - position_));
    position_ = end;
    // One separator; a comma at the very end leaves an empty argument behind it.
    trailing_ =
        position_ < text_.size() && text_[position_] == ',' && position_ + 1 == text_.size();
    position_ += position_ < text_.size() ? 1 : 0;
    return argument;
  }
  [[nodiscard]] bool trailing() const { return trailing_; }

 private:
  std::string text_;
  std::size_t position_ = 0;
  bool trailing_ = false;
};

MacroParameter read_parameter(std::string_view text, std::size_t& position) {
  MacroParameter parameter;
  parameter.name = name_at(text, position);
  if (parameter.name.empty()) {
    throw fmt::format("a parameter of a macro is a name, not '{}'", text.substr(position));
  }
  position = skip_blanks(text, position + parameter.name.size());
  if (position < text.size() && text[position] == ':') {
    position = skip_blanks(text, position + 1);
    const std::string kind = lower_case(name_at(text, position));
    if (kind != "req" && kind != "vararg") {
      throw fmt::format("':{}' is nothing that a parameter can be: write :req or :vararg", kind);
    }
    parameter.required = kind == "req";
    parameter.rest = kind == "vararg";
    position = skip_blanks(text, position + kind.size());
  }
  if (position < text.size() && text[position] == '=') {
    position = skip_blanks(text, position + 1);
    const std::size_t end = end_of_argument(text, position);
    parameter.standard = without_quotes(text.substr(position, end - position));
    position = end;
  }
  return parameter;
}

}  // namespace

Macro read_macro_head(std::string_view text) {
  Macro macro;
  std::size_t position = skip_blanks(text, 0);
  macro.name = name_at(text, position);
  if (macro.name.empty() || (macro.name[0] >= '0' && macro.name[0] <= '9')) {
    throw std::string(".macro wants a name");
  }
  position += macro.name.size();
  for (;;) {
    position = skip_blanks(text, position);
    if (position < text.size() && text[position] == ',') {
      position = skip_blanks(text, position + 1);
    }
    if (position >= text.size()) {
      return macro;
    }
    MacroParameter parameter = read_parameter(text, position);
    if (std::ranges::count(macro.parameters, parameter.name, &MacroParameter::name) > 0) {
      throw fmt::format("macro {} has two parameters {}", macro.name, parameter.name);
    }
    if (!macro.parameters.empty() && macro.parameters.back().rest) {
      throw fmt::format("no parameter can follow {}, which takes all that is left",
                        macro.parameters.back().name);
    }
    macro.parameters.push_back(std::move(parameter));
  }
}

Replacements bind_arguments(const Macro& macro, std::string_view text) {
  Replacements replacements;
  for (const MacroParameter& parameter : macro.parameters) {
    replacements.emplace_back(parameter.name, parameter.standard);
  }
  std::vector<bool> given(macro.parameters.size());
  Arguments arguments(text);
  for (std::size_t next = 0; !arguments.at_end();) {
    const std::string_view name = name_at(arguments.rest(), 0);
    const std::string_view behind = arguments.rest().substr(name.size());
    const auto named = std::ranges::find(macro.parameters, name, &MacroParameter::name);
    std::size_t index = next;
    if (named != macro.parameters.end() && behind.starts_with('=') && !behind.starts_with("==")) {
      index = static_cast<std::size_t>(named - macro.parameters.begin());
      arguments.skip(name.size() + 1);
    } else {
      ++next;
    }
    if (index >= macro.parameters.size()) {
      throw fmt::format("macro {} takes {} argument{}, here is one more: '{}'", macro.name,
                        macro.parameters.size(), macro.parameters.size() == 1 ? "" : "s",
                        arguments.rest());
    }
    std::string argument;
    if (macro.parameters[index].rest) {
      argument = arguments.rest();
      arguments.skip(argument.size());
    } else {
      argument = arguments.take();
    }
    if (!argument.empty()) {
      replacements[index].second = std::move(argument);
      given[index] = true;
    }
  }
  for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
    if (macro.parameters[i].required && !given[i]) {
      throw fmt::format("macro {} wants an argument for {}", macro.name, macro.parameters[i].name);
    }
  }
  return replacements;
}

std::vector<std::string> split_arguments(std::string_view text) {
  std::vector<std::string> all;
  Arguments arguments(text);
  while (!arguments.at_end()) {
    all.push_back(arguments.take());
    if (arguments.trailing()) {
      all.emplace_back();
    }
  }
  return all;
}

std::shared_ptr<const SourceText> replace_names(const std::shared_ptr<const SourceText>& body,
                                                const Replacements& replacements,
                                                std::uint64_t number, std::size_t limit) {
  const std::string_view text = body->text();
  std::string result;
  std::vector<SourceText::Cut> cuts = {{0, 0, false}};
  const auto put = [&](std::string_view argument, std::size_t at, std::size_t behind) {
    cuts.push_back({result.size(), at, true});
    result += argument;
    cuts.push_back({result.size(), behind, false});
  };
  for (std::size_t i = 0; i < text.size() && result.size() <= limit;) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i++];
      continue;
    }
    if (text.substr(i, 3) == "\\()") {
      put("", i, i + 3);
      i += 3;
      continue;
    }
    if (text[i + 1] == '@') {
      put(std::to_string(number), i, i + 2);
      i += 2;
      continue;
    }
    // `\reg.L`: a name with its dot, or else the name before it.
    std::string_view name = name_at(text, i + 1);
    auto found = std::ranges::find(replacements, name, &Replacements::value_type::first);
    while (found == replacements.end() && name.rfind('.') != std::string_view::npos) {
      name = name.substr(0, name.rfind('.'));
      found = std::ranges::find(replacements, name, &Replacements::value_type::first);
    }
    if (found == replacements.end()) {
      result += text[i++];
      result += text[i++];  // whatever it is: `\\` begins no name
      continue;
    }
    put(found->second, i, i + 1 + name.size());
    i += 1 + name.size();
  }
  return result.size() > limit ? nullptr
                               : SourceText::made_of(body, std::move(result), std::move(cuts));
}

}  // namespace finback::assembler
