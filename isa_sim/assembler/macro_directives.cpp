// Macros, repetitions and included files.
#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include <common/file.hpp>
#include <isa_sim/assembler/assembler.hpp>

namespace finback::assembler {
namespace {

namespace fs = std::filesystem;

bool begins_repetition(std::string_view word) {
  return word == ".rept" || word == ".rep" || word == ".irp" || word == ".irpc";
}

}  // namespace

// The text between this directive and the one that ends it, which the source then goes on behind.
// `begin`, `end`: the directives that nest, ".macro" and ".endm"; "" stands for the repetitions.
std::shared_ptr<const SourceText> Assembler::take_body(const Directive& directive,
                                                       std::string_view begin,
                                                       std::string_view end) {
  const std::shared_ptr<const SourceText> whole = source_.text();
  const std::size_t start = source_.position();
  int depth = 1;
  for (Statement statement; source_.next(statement);) {
    const std::string word = lower_case(name_at(statement.text));
    if (begin.empty() ? begins_repetition(word) : word == begin) {
      ++depth;
    } else if (word == end && --depth == 0) {
      return SourceText::part_of(whole, start, statement.offset);
    }
  }
  fail(directive.statement, directive.name,
       fmt::format("this {} is never closed: add {}", directive.name, end));
}

void Assembler::call_macro(const Macro& macro, const Statement& statement, std::string_view rest) {
  Replacements replacements;
  try {
    replacements = bind_arguments(macro, rest);
  } catch (const std::string& problem) {
    fail(statement, statement.text, problem);
  }
  std::shared_ptr<const SourceText> text =
      replace_names(macro.body, replacements, expansions_++, SourceStack::kLongestExpansion);
  if (text == nullptr) {
    fail(statement, statement.text,
         fmt::format("macro {} becomes more than {} bytes here", macro.name,
                     SourceStack::kLongestExpansion));
  }
  source_.push(SourceStack::Kind::macro, std::move(text), macro.name, conditionals_.size());
}

void Assembler::read_macro(Directive& directive) {
  Macro macro;
  try {
    macro = read_macro_head(directive.rest);
  } catch (const std::string& problem) {
    fail(directive, problem);
  }
  macro.body = take_body(directive, ".macro", ".endm");
  std::string key = lower_case(macro.name);
  if (macros_.contains(key)) {
    fail(directive, fmt::format("macro {} is defined already: write .purgem {} before", macro.name,
                                macro.name));
  }
  macros_.emplace(std::move(key), std::move(macro));
}

void Assembler::read_stray_end(Directive& directive) {
  fail(directive, fmt::format("{} ends nothing here", directive.name));
}

void Assembler::read_exit_macro(Directive& directive) {
  std::size_t conditionals = 0;
  if (!source_.leave_macro(conditionals)) {
    fail(directive, ".exitm outside of a macro");
  }
  conditionals_.resize(conditionals);
}

void Assembler::read_purge(Directive& directive) {
  do {
    const std::string_view name = take_name(directive, "the name of a macro");
    if (macros_.erase(lower_case(name)) == 0) {
      fail(directive.statement, name, fmt::format("there is no macro {}", name));
    }
  } while (take_comma(directive));
}

void Assembler::read_repeat(Directive& directive) {
  const std::int64_t count = read_number(directive, "a number");
  expect_end(directive);
  if (count < 0) {
    fail(directive, fmt::format("{} times is no number of repetitions", count));
  }
  const std::shared_ptr<const SourceText> body = take_body(directive, "", ".endr");
  source_.push_repetition([body, left = count]() mutable { return left-- > 0 ? body : nullptr; },
                          conditionals_.size());
}

// .irp name, values; .irpc name, characters
void Assembler::read_repeat_each(Directive& directive) {
  const std::string_view rest = directive.rest;
  const std::string name(name_at(rest));
  if (name.empty()) {
    fail(directive, fmt::format("{} wants a name", directive.name));
  }
  std::string_view values = without_blanks_around(rest.substr(name.size()));
  if (values.starts_with(',')) {
    values = without_blanks_around(values.substr(1));
  }
  std::vector<std::string> all;
  if (lower_case(directive.name) == ".irp") {
    all = split_arguments(values);
  } else {
    for (const char c : values) {
      all.emplace_back(1, c);
    }
  }
  if (all.empty()) {
    all.emplace_back();  // once, with nothing
  }
  const std::shared_ptr<const SourceText> body = take_body(directive, "", ".endr");
  source_.push_repetition(
      [body, name, all = std::move(all), next = std::size_t{0},
       number = expansions_++]() mutable -> std::shared_ptr<const SourceText> {
        return next < all.size() ? replace_names(body, {{name, all[next++]}}, number,
                                                 SourceStack::kLongestExpansion)
                                 : nullptr;
      },
      conditionals_.size());
}

// --- files ---

void Assembler::push_file(const std::string& text, const std::string& file, const fs::path& path) {
  folders_[file] = path.parent_path();
  source_.push(SourceStack::Kind::file, SourceText::of_file(text, file), file,
               conditionals_.size());
}

// A file that is named in quotes: beside the file that names it, in the include folders, in the
// current folder.
fs::path Assembler::find_file(Directive& directive, std::string& name) {
  name = read_text(directive);
  std::vector<fs::path> folders = {folders_[source_.file()]};
  folders.insert(folders.end(), options_.include_folders.begin(), options_.include_folders.end());
  folders.emplace_back();
  for (const fs::path& folder : folders) {
    std::error_code error;
    fs::path path = folder / name;
    if (fs::is_regular_file(path, error)) {
      return path;
    }
  }
  directive.position = 0;
  fail(directive,
       fmt::format("{} is neither beside {} nor in a folder given by -I", name, source_.file()));
}

void Assembler::read_include(Directive& directive) {
  std::string name;
  const fs::path path = find_file(directive, name);
  expect_end(directive);
  push_file(read_text_file(path), path.string(), path);
}

// .incbin "file"[, skip[, count]]
void Assembler::read_include_bytes(Directive& directive) {
  std::string name;
  const fs::path path = find_file(directive, name);
  std::int64_t skip = 0;
  std::int64_t count = -1;
  if (take_comma(directive)) {
    skip = read_number(directive, "a number of bytes");
    count = take_comma(directive) ? read_number(directive, "a number of bytes") : -1;
  }
  expect_end(directive);
  std::error_code error;
  const auto size = static_cast<std::int64_t>(fs::file_size(path, error));
  if (error || skip < 0 || skip > size || count > size - skip) {
    fail(directive, fmt::format("{} has {} bytes", name, size));
  }
  count = count < 0 ? size - skip : count;
  reserve(directive, count, 1);
  const std::string bytes = read_text_file(path);
  for (const char c : std::string_view(bytes).substr(static_cast<std::size_t>(skip),
                                                     static_cast<std::size_t>(count))) {
    section().number(static_cast<unsigned char>(c), 1);
  }
}

void Assembler::read_end(Directive&) {
  conditionals_.clear();
  source_.leave_all();
}

// .print, .warning, .error, .err, .abort
void Assembler::read_message(Directive& directive) {
  const std::string name = lower_case(directive.name);
  std::string text = directive.at_end() ? "" : read_text(directive);
  expect_end(directive);
  if (name == ".print") {
    if (options_.note) {
      options_.note(text);
    }
  } else if (name == ".warning") {
    warn(directive.statement, directive.name, text.empty() ? ".warning stands here" : text);
  } else {
    fail(directive.statement, directive.name,
         text.empty() ? fmt::format("{} stands here", directive.name) : text);
  }
}

}  // namespace finback::assembler
