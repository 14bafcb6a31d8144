#include <algorithm>
#include <charconv>

#include <isa_sim/assembler/source_text.hpp>

namespace finback::assembler {
namespace {

SourcePlace place_in(std::string_view text, std::size_t offset, const std::string& file) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {file, static_cast<int>(std::ranges::count(before, '\n')) + 1,
          static_cast<int>(offset - line_start) + 1};
}

// `h#1F` is a number, no comment.
bool marks_number(std::string_view text, std::size_t hash) {
  static constexpr std::string_view kBases = "hHoObBdDfF";
  const bool letter = hash > 0 && kBases.find(text[hash - 1]) != std::string_view::npos &&
                      (hash == 1 || !is_name_character(text[hash - 2]));
  return letter && hash + 1 < text.size() && is_name_character(text[hash + 1]);
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::string_view name_at(std::string_view text, std::size_t position) {
  std::size_t end = position;
  while (end < text.size() && is_name_character(text[end])) {
    ++end;
  }
  return text.substr(position, end - position);
}

std::string_view without_blanks_around(std::string_view text) {
  const auto blank = [](char c) { return is_blank(c) || c == '\n'; };
  while (!text.empty() && blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::size_t end_of_quoted(std::string_view text, std::size_t start) {
  std::size_t end = start + 1;
  if (text[start] == '\'') {  // a character, with or without its second quote
    end += end < text.size() && text[end] == '\\' ? 2 : 1;
    end += end < text.size() && text[end] == '\'' ? 1 : 0;
    return std::min(end, text.size());
  }
  while (end < text.size() && text[end] != '"' && text[end] != '\n') {
    end += text[end] == '\\' && end + 1 < text.size() && text[end + 1] != '\n' ? 2 : 1;
  }
  return std::min(end + (end < text.size() && text[end] == '"' ? 1 : 0), text.size());
}

std::string without_comments(std::string text, const std::string& file) {
  const auto blank = [&text](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      text[i] = text[i] == '\n' ? '\n' : ' ';
    }
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (c == '"' || c == '\'') {
      i = end_of_quoted(text, i);
    } else if ((c == '/' && next == '/') || (c == '#' && !marks_number(text, i))) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      blank(i, end);
      i = end;
    } else if (c == '/' && next == '*') {
      const std::size_t end = text.find("*/", i + 2);
      if (end == std::string::npos) {
        throw InputError(place_in(text, i, file), "this comment is never closed: add */");
      }
      blank(i, end + 2);
      i = end + 2;
    } else {
      ++i;
    }
  }
  return text;
}

std::shared_ptr<const SourceText> SourceText::of_file(std::string text, const std::string& file) {
  auto source = std::make_shared<SourceText>();
  source->text_ = std::move(text);
  source->index_lines(file);
  source->text_ = without_comments(std::move(source->text_), file);
  return source;
}

void SourceText::index_lines(const std::string& file) {
  files_.push_back(file);
  Line line{0, 1, 0};
  for (std::size_t start = 0; start <= text_.size();) {
    line.offset = start;
    lines_.push_back(line);
    const std::size_t end = std::min(text_.find('\n', start), text_.size());
    ++line.line;
    read_mark(std::string_view(text_).substr(start, end - start), line);
    start = end + 1;
  }
}

// `# 12 "a.S"`, or `#line 12 "a.S"`: the next line is line 12 of a.S.
void SourceText::read_mark(std::string_view line, Line& next) {
  if (!line.starts_with('#')) {
    return;
  }
  line = without_blanks_around(line.substr(1));
  if (line.starts_with("line ")) {
    line = without_blanks_around(line.substr(5));
  }
  int number = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  const std::string_view rest =
      without_blanks_around(line.substr(static_cast<std::size_t>(end - line.data())));
  const std::size_t close = rest.size() > 1 ? rest.find('"', 1) : std::string_view::npos;
  if (error != std::errc() || number < 1 || !rest.starts_with('"') ||
      close == std::string_view::npos) {
    return;
  }
  const std::string name(rest.substr(1, close - 1));
  const auto known = std::ranges::find(files_, name);
  next.line = number;
  next.file = static_cast<std::size_t>(known - files_.begin());
  if (known == files_.end()) {
    files_.push_back(name);
  }
}

std::shared_ptr<const SourceText> SourceText::part_of(std::shared_ptr<const SourceText> whole,
                                                      std::size_t from, std::size_t to) {
  std::string text(whole->text().substr(from, to - from));
  return made_of(std::move(whole), std::move(text), {{0, from, false}});
}

std::shared_ptr<const SourceText> SourceText::made_of(std::shared_ptr<const SourceText> original,
                                                      std::string text, std::vector<Cut> cuts) {
  auto source = std::make_shared<SourceText>();
  source->text_ = std::move(text);
  source->original_ = std::move(original);
  source->cuts_ = std::move(cuts);
  return source;
}

SourcePlace SourceText::place(std::size_t offset) const {
  if (original_ != nullptr) {
    const auto after = std::ranges::upper_bound(cuts_, offset, {}, &Cut::offset);
    const Cut& cut = *std::prev(after);
    return original_->place(cut.argument ? cut.from : cut.from + (offset - cut.offset));
  }
  const auto after = std::ranges::upper_bound(lines_, offset, {}, &Line::offset);
  const Line& line = *std::prev(after);
  return {files_[line.file], line.line, static_cast<int>(offset - line.offset) + 1};
}

}  // namespace finback::assembler
