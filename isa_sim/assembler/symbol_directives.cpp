// Symbols, sections and places in other sources; and the table of all directives.
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include <isa_sim/assembler/assembler.hpp>

namespace finback::assembler {

using isa::TokenKind;

namespace {

constexpr std::uint32_t kSectionAlign = 4;  // bytes; as the GNU assembler aligns its sections

}  // namespace

const std::vector<Assembler::KnownDirective>& Assembler::directives() {
  using A = Assembler;
  static const std::vector<KnownDirective> all = [] {
    std::vector<KnownDirective> table;
    const auto add = [&](std::initializer_list<std::string_view> names, Handler handler,
                         bool words = false) {
      for (const std::string_view name : names) {
        table.push_back({name, handler, words});
      }
    };
    add({".if", ".ifeq", ".ifne", ".ifge", ".ifgt", ".ifle", ".iflt"}, &A::read_if);
    add({".ifdef", ".ifndef", ".ifnotdef"}, &A::read_if_defined);
    add({".ifb", ".ifnb"}, &A::read_if_blank, true);
    add({".ifc", ".ifnc", ".ifeqs", ".ifnes"}, &A::read_if_same, true);
    add({".else"}, &A::read_else, true);
    add({".elseif"}, &A::read_else_if, true);
    add({".endif"}, &A::read_end_if, true);
    add({".macro"}, &A::read_macro, true);
    add({".endm", ".endr"}, &A::read_stray_end, true);
    add({".exitm"}, &A::read_exit_macro);
    add({".purgem"}, &A::read_purge);
    add({".rept", ".rep"}, &A::read_repeat);
    add({".irp", ".irpc"}, &A::read_repeat_each, true);
    add({".include"}, &A::read_include);
    add({".incbin"}, &A::read_include_bytes);
    add({".end"}, &A::read_end);
    add({".print", ".warning", ".error", ".err", ".abort"}, &A::read_message);
    add({".byte", ".db", ".1byte", ".short", ".hword", ".dw", ".byte2", ".2byte", ".word", ".long",
         ".int", ".dd", ".byte4", ".4byte", ".quad", ".8byte"},
        &A::read_data);
    add({".ascii", ".asciz", ".string", ".string8"}, &A::read_strings);
    add({".space", ".skip", ".zero"}, &A::read_space);
    add({".fill"}, &A::read_fill);
    add({".align", ".balign", ".p2align"}, &A::read_align);
    add({".org"}, &A::read_origin);
    add({".global", ".globl", ".weak", ".local", ".extern"}, &A::read_binding);
    add({".set", ".equ", ".equiv"}, &A::read_set);
    add({".comm", ".lcomm"}, &A::read_common);
    add({".section", ".code"}, &A::read_section, true);
    add({".text", ".data", ".bss", ".rodata"}, &A::read_plain_section);
    add({".pushsection"}, &A::read_push_section, true);
    add({".popsection"}, &A::read_pop_section);
    add({".previous"}, &A::read_previous);
    add({".file"}, &A::read_file);
    add({".loc"}, &A::read_line);
    add({".type",    ".size",  ".ident",   ".hidden",      ".internal",    ".protected",
         ".version", ".line",  ".ln",      ".list",        ".nolist",      ".eject",
         ".psize",   ".sbttl", ".title",   ".func",        ".endfunc",     ".p",
         ".pdata",   ".var",   ".addrsig", ".addrsig_sym", ".sectionflags"},
        &A::ignore, true);
    return table;
  }();
  return all;
}

// --- symbols ---

void Assembler::read_binding(Directive& directive) {
  const std::string name = lower_case(directive.name);
  do {
    Symbol& symbol = symbols_.get(take_name(directive, "a symbol"));
    symbol.binding = name == ".weak"                         ? ir::Binding::weak
                     : name == ".local" || name == ".extern" ? symbol.binding
                                                             : ir::Binding::global;
  } while (take_comma(directive));
}

void Assembler::read_set(Directive& directive) {
  const std::string_view name = take_name(directive, "a symbol");
  if (!take_comma(directive)) {
    fail(directive, fmt::format("{} wants ',' and a value", directive.name));
  }
  const ExpressionPointer value = read_expression(directive, "a value");
  expect_end(directive);
  if (lower_case(directive.name) == ".equiv" && symbols_.is_defined(name)) {
    fail(directive.statement, name, fmt::format("{} is defined already", name));
  }
  if (name == ".") {
    move_to(directive.statement, directive.rest, *value, 0);
  } else {
    set_symbol(symbols_.get(name), value, place_of(directive.statement, name));
  }
}

// .comm name, size[, align]
void Assembler::read_common(Directive& directive) {
  const std::string_view name = take_name(directive, "a symbol");
  if (!take_comma(directive)) {
    fail(directive, fmt::format("{} wants ',' and a number of bytes", directive.name));
  }
  const std::int64_t size = read_number(directive, "a number of bytes");
  const std::int64_t align = take_comma(directive) ? read_number(directive, "an alignment") : 4;
  expect_end(directive);
  if (align < 1 || align > (1 << 20) || (align & (align - 1)) != 0) {
    fail(directive, "an alignment is a power of two up to 1 MB");
  }
  if (size < 1) {
    fail(directive, fmt::format("{} is no size of an object", size));
  }
  if (symbols_.is_defined(name)) {
    fail(directive.statement, name, fmt::format("{} is defined already", name));
  }
  reserve(directive, size, 1);
  Symbol& symbol = symbols_.get(name);
  symbol.common = true;
  symbol.defined = source_.in_file(directive.statement);
  const bool local = lower_case(directive.name) == ".lcomm";
  ir::Object object;
  object.name = name;
  object.section = ".bss";
  object.binding = local ? symbol.binding : ir::Binding::global;
  object.align = static_cast<std::uint32_t>(align);
  object.size = static_cast<std::uint32_t>(size);
  object.written = symbol.defined;
  common_.emplace(std::string(name), std::move(object));
}

// --- sections ---

void Assembler::enter_section(const std::string& name) {
  const auto [found, added] = section_numbers_.try_emplace(name, sections_.size());
  if (added) {
    ir::Piece piece;
    piece.name = stem_ + name;
    piece.align = kSectionAlign;
    sections_.emplace_back(std::move(piece));
  }
  previous_section_ = current_section_;
  current_section_ = found->second;
}

// The name alone: what its flags say shows in what is put there.
std::string Assembler::take_section_name(Directive& directive) {
  const std::string_view rest = directive.rest;
  std::size_t end = 0;
  if (rest.starts_with('"')) {
    end = end_of_quoted(rest, 0);
    return std::string(rest.substr(1, end < 2 ? 0 : end - 2));
  }
  while (end < rest.size() && rest[end] != ',' && !is_blank(rest[end])) {
    ++end;
  }
  if (end == 0) {
    fail(directive, fmt::format("{} wants a name", directive.name));
  }
  return std::string(rest.substr(0, end));
}

void Assembler::read_section(Directive& directive) { enter_section(take_section_name(directive)); }

// .data, .data 2: a numbered part is a section of its own.
void Assembler::read_plain_section(Directive& directive) {
  const std::int64_t part = directive.at_end() ? 0 : read_number(directive, "a number");
  expect_end(directive);
  const std::string name = lower_case(directive.name);
  enter_section(part == 0 ? name : fmt::format("{}.{}", name, part));
}

void Assembler::read_push_section(Directive& directive) {
  if (section_stack_.size() >= SourceStack::kDeepest) {
    fail(directive, "too many .pushsection without .popsection");
  }
  section_stack_.emplace_back(current_section_, previous_section_);
  read_section(directive);
}

void Assembler::read_pop_section(Directive& directive) {
  if (section_stack_.empty()) {
    fail(directive, ".popsection without .pushsection");
  }
  std::tie(current_section_, previous_section_) = section_stack_.back();
  section_stack_.pop_back();
}

void Assembler::read_previous(Directive&) { std::swap(current_section_, previous_section_); }

// --- places in other sources ---

int Assembler::source_file(const std::string& name) {
  const std::string plain = std::filesystem::path(name).filename().string();
  const auto [found, added] =
      source_numbers_.try_emplace(plain, static_cast<int>(program_.source_files.size()));
  if (added) {
    program_.source_files.push_back(plain);
  }
  return found->second;
}

// .file "name", which says nothing; .file N "name", .file N "folder" "name", for .loc
void Assembler::read_file(Directive& directive) {
  if (directive.at_end() || directive.tokens[0].kind == TokenKind::text) {
    return;
  }
  const std::int64_t number = read_number(directive, "a file number");
  std::string name = read_text(directive);
  if (!directive.at_end() && directive.tokens[directive.position].kind == TokenKind::text) {
    name += "/" + read_text(directive);
  }
  const auto [found, added] =
      source_numbers_.try_emplace(name, static_cast<int>(program_.source_files.size()));
  if (added) {
    program_.source_files.push_back(name);
  }
  file_numbers_[number] = found->second;
}

// .loc N line ...
void Assembler::read_line(Directive& directive) {
  const std::int64_t number = read_number(directive, "a file number");
  const auto found = file_numbers_.find(number);
  if (found == file_numbers_.end()) {
    fail(directive.statement, directive.rest,
         fmt::format("file {} is not declared: write `.file {} \"name\"` before", number, number));
  }
  loc_file_ = found->second;
  loc_line_ = static_cast<int>(read_number(directive, "a line number"));
}

}  // namespace finback::assembler
