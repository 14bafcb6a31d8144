#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

#include <common/parameter.hpp>
#include <isa_sim/ir/parser_state.hpp>

namespace finback::ir {

using isa::Token;
using isa::TokenKind;

namespace {

constexpr std::int64_t kLargestAlign = 1 << 20;
constexpr std::int64_t kLargestFileNumber = 65535;

// Directives that say nothing to us: debug frames, visibility, notes of the compiler.
constexpr std::array<std::string_view, 10> kHarmless = {
    ".ident",   ".hidden",      ".internal",     ".protected", ".extern",
    ".addrsig", ".addrsig_sym", ".sectionflags", ".line",      ".version"};

}  // namespace

void Parser::read_directive(const Token& token) {
  const Arguments arguments = read_arguments();
  const auto& all = directives();
  const auto found = std::ranges::find(all, token.text, &Directive::name);
  if (found != all.end()) {
    (this->*found->handler)(token, arguments);
    return;
  }
  if (token.text.starts_with(".cfi_") || std::ranges::count(kHarmless, token.text) > 0) {
    return;
  }
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const Directive& directive : all) {
    known.emplace_back(directive.name);
  }
  const std::string nearest = nearest_name(token.text, known);
  fail(token, fmt::format("unknown directive {}{}", token.text,
                          nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest)));
}

const std::vector<Parser::Directive>& Parser::directives() {
  static const std::vector<Directive> all = {{".bir", &Parser::repeat_heading},
                                             {".file", &Parser::read_file},
                                             {".loc", &Parser::read_loc},
                                             {".text", &Parser::enter_named_section},
                                             {".data", &Parser::enter_named_section},
                                             {".bss", &Parser::enter_named_section},
                                             {".rodata", &Parser::enter_named_section},
                                             {".section", &Parser::read_section},
                                             {".global", &Parser::read_global},
                                             {".globl", &Parser::read_global},
                                             {".weak", &Parser::read_weak},
                                             {".local", &Parser::read_local},
                                             {".type", &Parser::read_type},
                                             {".size", &Parser::read_size},
                                             {".align", &Parser::read_align},
                                             {".balign", &Parser::read_align},
                                             {".p2align", &Parser::read_p2align},
                                             {".comm", &Parser::read_common},
                                             {".lcomm", &Parser::read_common},
                                             {".byte", &Parser::read_data},
                                             {".byte2", &Parser::read_data},
                                             {".short", &Parser::read_data},
                                             {".hword", &Parser::read_data},
                                             {".2byte", &Parser::read_data},
                                             {".byte4", &Parser::read_data},
                                             {".long", &Parser::read_data},
                                             {".int", &Parser::read_data},
                                             {".4byte", &Parser::read_data},
                                             {".quad", &Parser::read_data},
                                             {".8byte", &Parser::read_data},
                                             {".word", &Parser::refuse_word},
                                             {".space", &Parser::read_space},
                                             {".zero", &Parser::read_space},
                                             {".skip", &Parser::read_space},
                                             {".ascii", &Parser::read_strings},
                                             {".asciz", &Parser::read_strings},
                                             {".string", &Parser::read_strings}};
  return all;
}

std::int64_t Parser::bytes_of(std::string_view directive) {
  if (directive == ".byte") {
    return 1;
  }
  if (directive == ".byte4" || directive == ".long" || directive == ".int" ||
      directive == ".4byte") {
    return 4;
  }
  return directive == ".quad" || directive == ".8byte" ? 8 : 2;
}

void Parser::repeat_heading(const Token& directive, Arguments) {
  fail(directive, ".bir stands once, at the head of the file");
}

void Parser::refuse_word(const Token& directive, Arguments) {
  fail(directive, ".word has 2 or 4 bytes, depending on the assembler: write .byte2 or .byte4");
}

void Parser::expect_end(Arguments arguments, std::size_t count) const {
  if (arguments.size() > count) {
    fail(arguments[count], fmt::format("'{}' is too much here", arguments[count].text));
  }
}

const Token& Parser::expect(const Token& directive, Arguments arguments, std::size_t index,
                            TokenKind kind, std::string_view wanted) const {
  if (index >= arguments.size()) {
    fail(directive, fmt::format("{} wants {}", directive.text, wanted));
  }
  if (arguments[index].kind != kind) {
    fail(arguments[index],
         fmt::format("{} wants {}, not '{}'", directive.text, wanted, arguments[index].text));
  }
  return arguments[index];
}

void Parser::read_file(const Token& directive, Arguments arguments) {
  if (!arguments.empty() && arguments[0].kind == TokenKind::text) {
    return;  // `.file "x.c"`: the name of the unit, which says nothing about lines
  }
  const Token& number = expect(directive, arguments, 0, TokenKind::number, "a file number");
  std::string name =
      unescape(expect(directive, arguments, 1, TokenKind::text, "a file name between quotes"));
  if (arguments.size() > 2 && arguments[2].kind == TokenKind::text) {  // folder, then name
    const std::string base = unescape(arguments[2]);
    name = base.starts_with('/') ? base : name + "/" + base;
  } else {
    expect_end(arguments, 2);
  }
  if (number.number == 0) {
    return;  // the unit's own name
  }
  if (number.number > kLargestFileNumber) {
    fail(number, fmt::format("a file number is at most {}", kLargestFileNumber));
  }
  const auto index = static_cast<std::size_t>(number.number);
  if (program_.source_files.size() <= index) {
    program_.source_files.resize(index + 1);
  }
  if (!program_.source_files[index].empty() && program_.source_files[index] != name) {
    fail(number, fmt::format("file {} is {} already", index, program_.source_files[index]));
  }
  program_.source_files[index] = name;
}

void Parser::read_loc(const Token& directive, Arguments arguments) {
  const Token& file = expect(directive, arguments, 0, TokenKind::number, "a file number");
  const Token& line = expect(directive, arguments, 1, TokenKind::number, "a line number");
  const bool known =
      file.number == 0 || (file.number < static_cast<std::int64_t>(program_.source_files.size()) &&
                           !program_.source_files[static_cast<std::size_t>(file.number)].empty());
  if (!known) {
    fail(file, fmt::format("file {} is not declared: write `.file {} \"name\"` before", file.number,
                           file.number));
  }
  if (line.number > std::numeric_limits<int>::max()) {
    fail(line, "this is no line number");
  }
  source_file_ = static_cast<int>(file.number);
  source_line_ = file.number == 0 ? 0 : static_cast<int>(line.number);
}

void Parser::enter_section(const std::string& name, bool code) {
  end_object();
  section_ = {name, code};
  align_.reset();
}

void Parser::enter_named_section(const Token& directive, Arguments arguments) {
  expect_end(arguments, 0);
  enter_section(std::string(directive.text), directive.text == ".text");
}

void Parser::read_section(const Token& directive, Arguments arguments) {
  std::string name;
  std::size_t index = 0;
  for (; index < arguments.size() && !arguments[index].is(","); ++index) {
    name += arguments[index].text;
  }
  if (name.empty()) {
    fail(directive, ".section wants a name");
  }
  const bool flagged = index + 1 < arguments.size() && arguments[index + 1].kind == TokenKind::text;
  const bool code = flagged ? arguments[index + 1].text.find('x') != std::string_view::npos
                            : name.starts_with(".text");
  enter_section(name, code);
}

void Parser::read_names(const Token& directive, Arguments arguments, Binding binding) {
  for (std::size_t index = 0;; index += 2) {
    const Token& name = expect(directive, arguments, index, TokenKind::name, "a symbol");
    bindings_[std::string(name.text)] = {binding, &name};
    if (index + 1 == arguments.size()) {
      return;
    }
    if (!arguments[index + 1].is(",")) {
      fail(arguments[index + 1], "symbols are separated by ','");
    }
  }
}

void Parser::read_global(const Token& directive, Arguments arguments) {
  read_names(directive, arguments, Binding::global);
}

void Parser::read_weak(const Token& directive, Arguments arguments) {
  read_names(directive, arguments, Binding::weak);
}

void Parser::read_local(const Token& directive, Arguments arguments) {
  read_names(directive, arguments, Binding::local);
}

void Parser::expect_comma(const Token& directive, Arguments arguments, std::size_t index) const {
  if (index >= arguments.size() || !arguments[index].is(",")) {
    fail(index < arguments.size() ? arguments[index] : directive,
         fmt::format("{} wants ',' after '{}'", directive.text, arguments[index - 1].text));
  }
}

void Parser::read_type(const Token& directive, Arguments arguments) {
  const Token& name = expect(directive, arguments, 0, TokenKind::name, "a symbol");
  expect_comma(directive, arguments, 1);
  std::size_t index = 2;
  if (index < arguments.size() && (arguments[index].is("@") || arguments[index].is("%"))) {
    ++index;
  }
  const std::string_view type = index < arguments.size() ? arguments[index].text : "";
  expect_end(arguments, index + 1);
  if (type == "function" || type == "STT_FUNC") {
    types_[std::string(name.text)] = SymbolType::function;
  } else if (type == "object" || type == "STT_OBJECT") {
    types_[std::string(name.text)] = SymbolType::object;
  } else if (type != "notype" && type != "STT_NOTYPE") {
    fail(index < arguments.size() ? arguments[index] : directive,
         fmt::format("a symbol's type is @function or @object, not '{}'", type));
  }
}

void Parser::read_size(const Token& directive, Arguments arguments) {
  const Token& name = expect(directive, arguments, 0, TokenKind::name, "a symbol");
  expect_comma(directive, arguments, 1);
  if (in_function_ && program_.functions.back().name == name.text) {
    in_function_ = false;  // `.-_name` or `.Lend-_name`: the function ends
    return;
  }
  Object* object = find_object(name.text);
  if (object == nullptr) {
    fail(name, fmt::format("{} is no function or object before this line", name.text));
  }
  if (arguments.size() > 2 && arguments[2].kind == TokenKind::name) {
    return;  // `.-_name`: what stands there
  }
  const Token& size = expect(directive, arguments, 2, TokenKind::number, "a number of bytes");
  expect_end(arguments, 3);
  const std::int64_t present = object->size;
  if (size.number < present || size.number > ObjectBuilder::kLargestObject) {
    fail(size, fmt::format("{} has {} bytes already: its size cannot be {}", name.text, present,
                           size.number));
  }
  object->size = static_cast<std::uint32_t>(size.number);
}

Object* Parser::find_object(std::string_view name) {
  if (object_ && object_->object().name == name) {
    return &object_->object();
  }
  const auto found = std::ranges::find(program_.objects, name, &Object::name);
  return found == program_.objects.end() ? nullptr : &*found;
}

void Parser::read_align(const Token& directive, Arguments arguments) {
  const Token& bytes = expect(directive, arguments, 0, TokenKind::number, "a number of bytes");
  set_align(bytes, bytes.number);
}

void Parser::read_p2align(const Token& directive, Arguments arguments) {
  const Token& power = expect(directive, arguments, 0, TokenKind::number, "a power of two");
  set_align(power, power.number > 20 ? 0 : std::int64_t{1} << power.number);
}

void Parser::set_align(const Token& token, std::int64_t bytes) {
  if (bytes < 1 || bytes > kLargestAlign || (bytes & (bytes - 1)) != 0) {
    fail(token, fmt::format("an alignment is a power of two up to {} bytes", kLargestAlign));
  }
  align_ = std::max(align_.value_or(1), static_cast<std::uint32_t>(bytes));
}

void Parser::read_common(const Token& directive, Arguments arguments) {
  const Token& name = expect(directive, arguments, 0, TokenKind::name, "a symbol");
  expect_comma(directive, arguments, 1);
  const Token& size = expect(directive, arguments, 2, TokenKind::number, "a number of bytes");
  std::uint32_t align = 4;
  if (arguments.size() > 3) {
    expect_comma(directive, arguments, 3);
    const Token& bytes = expect(directive, arguments, 4, TokenKind::number, "an alignment");
    expect_end(arguments, 5);
    set_align(bytes, bytes.number);
    align = *std::exchange(align_, std::nullopt);
  }
  if (size.number < 1 || size.number > ObjectBuilder::kLargestObject) {
    fail(size, "an object has 1 byte to 256 MB");
  }
  end_object();
  Object object;
  object.name = name.text;
  object.section = ".bss";
  object.align = align;
  object.size = static_cast<std::uint32_t>(size.number);
  object.written = place(name);
  program_.objects.push_back(std::move(object));
  if (directive.text == ".comm") {
    bindings_.try_emplace(std::string(name.text), Binding::global, &name);
  }
}

ObjectBuilder& Parser::data_object(const Token& directive) {
  if (!object_) {
    fail(directive, fmt::format("{} stands in no object: write a label before it, in .data, "
                                ".bss or .rodata",
                                directive.text));
  }
  if (align_) {
    object_->align(*std::exchange(align_, std::nullopt));
  }
  return *object_;
}

void Parser::read_data(const Token& directive, Arguments arguments) {
  ObjectBuilder& object = data_object(directive);
  const auto bytes = static_cast<int>(bytes_of(directive.text));
  std::size_t index = 0;
  while (true) {
    index = read_value(directive, arguments, index, bytes, object);
    if (index == arguments.size()) {
      return;
    }
    if (!arguments[index].is(",")) {
      fail(arguments[index], "values are separated by ','");
    }
    ++index;
  }
}

std::size_t Parser::read_value(const Token& directive, Arguments arguments, std::size_t index,
                               int bytes, ObjectBuilder& object) {
  if (index >= arguments.size()) {
    fail(directive, fmt::format("{} wants a value", directive.text));
  }
  const Token& first = arguments[index];
  const bool negative = first.is("-");
  if (negative || first.is("+")) {
    ++index;
  }
  if (first.kind == TokenKind::name) {
    return read_address(arguments, index, bytes, object);
  }
  const Token& number = expect(directive, arguments, index, TokenKind::number, "a number");
  const std::int64_t value = negative ? -number.number : number.number;
  const std::int64_t limit = bytes == 8 ? 0 : std::int64_t{1} << (8 * bytes);
  if (bytes < 8 && (value >= limit || value < -limit / 2)) {
    fail(first, fmt::format("{} does not fit into {} byte{}", value, bytes, bytes == 1 ? "" : "s"));
  }
  object.number(value, bytes);
  return index + 1;
}

std::size_t Parser::read_address(Arguments arguments, std::size_t index, int bytes,
                                 ObjectBuilder& object) {
  const Token& symbol = arguments[index++];
  if (bytes != 4) {
    fail(symbol, "an address takes 4 bytes: write .byte4");
  }
  std::int64_t addend = 0;
  if (index < arguments.size() && (arguments[index].is("+") || arguments[index].is("-"))) {
    const bool negative = arguments[index].is("-");
    if (index + 1 == arguments.size() || arguments[index + 1].kind != TokenKind::number ||
        arguments[index + 1].number > std::numeric_limits<std::int32_t>::max()) {
      fail(arguments[index], "after a symbol, only + or - a number can stand");
    }
    addend = negative ? -arguments[index + 1].number : arguments[index + 1].number;
    index += 2;
  }
  object.address(std::string(symbol.text), static_cast<std::int32_t>(addend));
  return index;
}

void Parser::read_space(const Token& directive, Arguments arguments) {
  ObjectBuilder& object = data_object(directive);
  const Token& count = expect(directive, arguments, 0, TokenKind::number, "a number of bytes");
  std::int64_t fill = 0;
  if (arguments.size() > 1) {
    expect_comma(directive, arguments, 1);
    fill = expect(directive, arguments, 2, TokenKind::number, "a byte").number;
    expect_end(arguments, 3);
  }
  if (fill > 255 || count.number > ObjectBuilder::kLargestObject - object.object().size) {
    fail(count, fill > 255 ? "a byte is 0..255" : "an object has at most 256 MB");
  }
  object.fill(static_cast<std::uint32_t>(count.number), static_cast<std::uint8_t>(fill));
}

void Parser::read_strings(const Token& directive, Arguments arguments) {
  ObjectBuilder& object = data_object(directive);
  for (std::size_t index = 0;; index += 2) {
    const Token& token =
        expect(directive, arguments, index, TokenKind::text, "text between quotes");
    for (const char c : unescape(token)) {
      object.number(static_cast<unsigned char>(c), 1);
    }
    if (directive.text != ".ascii") {
      object.number(0, 1);
    }
    if (index + 1 == arguments.size()) {
      return;
    }
    expect_comma(directive, arguments, index + 1);
  }
}

std::string Parser::unescape(const Token& token) const {
  std::string bytes;
  if (const std::string problem = unescape_text(token.text, bytes); !problem.empty()) {
    fail(token, problem);
  }
  return bytes;
}

}  // namespace finback::ir
