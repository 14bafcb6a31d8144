#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include <isa_sim/assembler/source_stack.hpp>

namespace finback::assembler {

std::size_t end_of_statement(std::string_view text, std::size_t position) {
  while (position < text.size() && text[position] != ';' && text[position] != '\n') {
    const bool quote = text[position] == '"' || text[position] == '\'';
    position = quote ? end_of_quoted(text, position) : position + 1;
  }
  return std::min(position, text.size());
}

SourceStack::Frame& SourceStack::push_frame(Kind kind, std::shared_ptr<const SourceText> text,
                                            const std::string& name, std::size_t conditionals) {
  bytes_ += text->text().size();
  if (frames_.size() >= kDeepest || bytes_ > kLongestTogether) {
    fail(current_, fmt::format("macros, repetitions and included files nest more than {} deep, or "
                               "have more than {} MB together: does one call itself without end?",
                               kDeepest, kLongestTogether >> 20));
  }
  Frame frame;
  frame.kind = kind;
  frame.text = std::move(text);
  frame.name = name;
  frame.conditionals = conditionals;
  if (!frames_.empty()) {
    frame.called_at = current_;
  }
  frames_.push_back(std::move(frame));
  return frames_.back();
}

void SourceStack::push(Kind kind, std::shared_ptr<const SourceText> text, const std::string& name,
                       std::size_t conditionals) {
  push_frame(kind, std::move(text), name, conditionals);
}

void SourceStack::push_repetition(NextText next, std::size_t conditionals) {
  std::shared_ptr<const SourceText> first = next();
  if (first != nullptr) {
    push_frame(Kind::repetition, std::move(first), "", conditionals).next = std::move(next);
  }
}

bool SourceStack::next(Statement& statement) {
  Frame& frame = frames_.back();
  const std::string_view text = frame.text->text();
  std::size_t start = frame.position;
  while (start < text.size() &&
         (is_blank(text[start]) || text[start] == '\n' || text[start] == ';')) {
    ++start;
  }
  if (start == text.size()) {
    frame.position = start;
    return false;
  }
  const std::size_t end = end_of_statement(text, start);
  statement.source = frame.text;
  statement.offset = start;
  statement.text = without_blanks_around(text.substr(start, end - start));
  statement.ends_line = end == text.size() || text[end] == '\n';
  frame.position = std::min(end + 1, text.size());
  current_ = frame.text->place(start);
  if (++statements_ > kMostStatements) {
    fail(current_, fmt::format("this is statement number {}: does a macro or a repetition never "
                               "end?",
                               statements_));
  }
  return true;
}

void SourceStack::end_text() {
  Frame& frame = frames_.back();
  if (frame.next) {
    if (std::shared_ptr<const SourceText> again = frame.next(); again != nullptr) {
      if (++statements_ > kMostStatements) {
        fail(frame.called_at, "this repetition does not end");
      }
      bytes_ += again->text().size() - frame.text->text().size();
      frame.text = std::move(again);
      frame.position = 0;
      return;
    }
  }
  pop_frame();
}

void SourceStack::pop_frame() {
  bytes_ -= frames_.back().text->text().size();
  frames_.pop_back();
}

void SourceStack::leave_all() {
  while (!frames_.empty()) {
    pop_frame();
  }
}

bool SourceStack::leave_macro(std::size_t& conditionals) {
  const auto macro = std::ranges::find(frames_.rbegin(), frames_.rend(), Kind::macro, &Frame::kind);
  const auto file = std::ranges::find(frames_.rbegin(), frames_.rend(), Kind::file, &Frame::kind);
  if (macro == frames_.rend() || file < macro) {
    return false;
  }
  conditionals = macro->conditionals;
  for (auto left = macro - frames_.rbegin(); left >= 0; --left) {
    pop_frame();
  }
  return true;
}

const std::string& SourceStack::file() const {
  return std::ranges::find(frames_.rbegin(), frames_.rend(), Kind::file, &Frame::kind)->name;
}

void SourceStack::fail(const SourcePlace& place, const std::string& message) const {
  throw InputError(place, message + context());
}

std::string SourceStack::context() const {
  static constexpr int kMostTold = 4;
  std::string told;
  int count = 0;
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    if (frame->called_at.line == 0 || frame->kind == Kind::repetition) {
      continue;
    }
    if (++count > kMostTold) {
      told += ", ...";
      break;
    }
    const SourcePlace at{frame->called_at.file, frame->called_at.line, 0};
    told += told.empty() ? " (" : ", ";
    told += frame->kind == Kind::macro
                ? fmt::format("in macro {}, called at {}", frame->name, at.to_string())
                : fmt::format("included at {}", at.to_string());
  }
  return told.empty() ? told : told + ")";
}

SourcePlace SourceStack::in_file(const Statement& statement) const {
  for (std::size_t i = frames_.size(); i-- > 0;) {
    if (frames_[i].kind == Kind::file) {
      return i + 1 < frames_.size() ? frames_[i + 1].called_at
                                    : statement.source->place(statement.offset);
    }
  }
  return statement.source->place(statement.offset);
}

}  // namespace finback::assembler
