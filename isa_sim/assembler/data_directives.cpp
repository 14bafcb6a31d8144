// Bytes: values, texts, room, alignment; and the table of all directives.
#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/assembler/assembler.hpp>
#include <isa_sim/ir/object_builder.hpp>

namespace finback::assembler {

using isa::TokenKind;

namespace {

constexpr std::int64_t kLargestAlign = 1 << 20;

// How many bytes a value of a directive has.
int bytes_of(std::string_view name) {
  static const std::map<std::string_view, int> kSizes = {
      {".byte", 1},  {".db", 1},    {".1byte", 1}, {".short", 2}, {".hword", 2}, {".dw", 2},
      {".byte2", 2}, {".2byte", 2}, {".word", 2},  {".long", 4},  {".int", 4},   {".dd", 4},
      {".byte4", 4}, {".4byte", 4}, {".quad", 8},  {".8byte", 8}};
  return kSizes.at(name);
}

}  // namespace

void Assembler::reserve(const Directive& directive, std::int64_t count, std::int64_t each) {
  const std::uint64_t left = kMostBytes - bytes_;
  if (count < 0 || (each > 0 && static_cast<std::uint64_t>(count) > left / each)) {
    fail(directive.statement, directive.name,
         count < 0
             ? fmt::format("{} is no number of bytes", count)
             : fmt::format(
                   "a file has at most {} MB, but this takes {} more bytes", kMostBytes >> 20,
                   static_cast<unsigned long long>(count) * static_cast<unsigned long long>(each)));
  }
  bytes_ += static_cast<std::uint64_t>(count * each);
}

void Assembler::read_data(Directive& directive) {
  const int bytes = bytes_of(lower_case(directive.name));
  if (directive.at_end()) {
    return;
  }
  do {
    reserve(directive, 1, bytes);
    const std::size_t start = directive.position;
    const ExpressionPointer value = read_expression(directive, "a value");
    put_value(directive.statement, directive.tokens[start].text, value, bytes);
  } while (take_comma(directive));
}

void Assembler::put_value(const Statement& statement, std::string_view at,
                          const ExpressionPointer& expression, int bytes) {
  const Value value = evaluate(*expression);
  if (!value.is_number()) {
    later_values_.push_back({expression, current_section_, section().location(), bytes,
                             place_of(statement, at), source_.context()});
    section().number(0, bytes);
    return;
  }
  const std::int64_t limit = bytes == 8 ? 0 : std::int64_t{1} << (8 * bytes);
  if (bytes < 8 && (value.number >= limit || value.number < -limit / 2)) {
    warn(statement, at,
         fmt::format("{:#x} does not fit into {} byte{}: {:#x} is taken", value.number, bytes,
                     bytes == 1 ? "" : "s", value.number & (limit - 1)));
  }
  section().number(value.number, bytes);
}

void Assembler::finish_data() {
  for (const LaterValue& later : later_values_) {
    const Value value = evaluate(*later.expression);
    Section& section = sections_[later.section];
    if (!value.problem.empty()) {
      throw InputError(later.place, value.problem + later.context);
    }
    if (value.is_number()) {
      section.patch(later.offset, value.number, later.bytes);
    } else if (later.bytes == 4) {
      section.relocate({later.offset, 4, value.symbol->name,
                        static_cast<std::int32_t>(value.number), later.place});
    } else {
      throw InputError(later.place, fmt::format("the address of {} takes 4 bytes, not {}{}",
                                                value.symbol->name, later.bytes, later.context));
    }
  }
}

std::string Assembler::read_text(Directive& directive) {
  if (directive.at_end() || directive.tokens[directive.position].kind != TokenKind::text) {
    fail(directive, fmt::format("{} wants text between quotes", directive.name));
  }
  std::string bytes;
  const std::string problem = ir::unescape_text(directive.tokens[directive.position].text, bytes);
  if (!problem.empty()) {
    fail(directive, problem);
  }
  ++directive.position;
  return bytes;
}

void Assembler::read_strings(Directive& directive) {
  const bool ends_in_zero = lower_case(directive.name) != ".ascii";
  do {
    const std::string text = read_text(directive) + (ends_in_zero ? std::string(1, '\0') : "");
    reserve(directive, static_cast<std::int64_t>(text.size()), 1);
    for (const char c : text) {
      section().number(static_cast<unsigned char>(c), 1);
    }
  } while (take_comma(directive));
}

// .space count[, byte]
void Assembler::read_space(Directive& directive) {
  const std::int64_t count = read_number(directive, "a number of bytes");
  const std::int64_t value = take_comma(directive) ? read_number(directive, "a byte") : 0;
  expect_end(directive);
  reserve(directive, count, 1);
  fill(directive.statement, static_cast<std::uint32_t>(count), static_cast<std::uint8_t>(value));
}

// Zeros behind an instruction are NOPs, within reason.
void Assembler::fill(const Statement& statement, std::uint32_t count, std::uint8_t value) {
  constexpr std::uint32_t kNopBytes = 2;
  constexpr std::uint32_t kMostNops = 2048;
  const std::uint32_t nops = count / kNopBytes;
  if (value == 0 && section().ends_in_code() && nops <= kMostNops &&
      packets_ + nops <= kMostPackets) {
    packets_ += nops;
    section().nops(nops, syntax_, source_.in_file(statement));
    count -= nops * kNopBytes;
  }
  section().fill(count, value);
}

// .fill count[, bytes[, value]]
void Assembler::read_fill(Directive& directive) {
  const std::int64_t count = read_number(directive, "a number");
  std::int64_t bytes = 1;
  std::int64_t value = 0;
  if (take_comma(directive)) {
    bytes = read_number(directive, "a number of bytes");
    value = take_comma(directive) ? read_number(directive, "a value") : 0;
  }
  expect_end(directive);
  if (bytes < 0 || bytes > 8) {
    fail(directive, fmt::format("a value has 0 to 8 bytes, not {}", bytes));
  }
  reserve(directive, count, bytes);
  if (value == 0) {
    section().fill(static_cast<std::uint32_t>(count * bytes), 0);
    return;
  }
  for (std::int64_t i = 0; i < count; ++i) {
    section().number(value, static_cast<int>(bytes));
  }
}

// .align bytes[, byte[, most]], .p2align power[, byte[, most]]
void Assembler::read_align(Directive& directive) {
  const bool power = lower_case(directive.name).starts_with(".p2");
  std::int64_t bytes = read_number(directive, power ? "a power of two" : "a number of bytes");
  bytes = !power ? bytes : bytes < 0 || bytes > 20 ? -1 : std::int64_t{1} << bytes;
  bytes = bytes == 0 ? 1 : bytes;
  std::int64_t value = 0;
  std::int64_t most = bytes;
  if (take_comma(directive)) {
    const bool given = !directive.at_end() && !directive.tokens[directive.position].is(",");
    value = given ? read_number(directive, "a byte") : 0;
    most = take_comma(directive) ? read_number(directive, "a number of bytes") : bytes;
  }
  expect_end(directive);
  if (bytes < 1 || bytes > kLargestAlign || (bytes & (bytes - 1)) != 0) {
    fail(directive.statement, directive.rest,
         fmt::format("an alignment is a power of two up to {} bytes", kLargestAlign));
  }
  const std::uint32_t at = section().location();
  const std::int64_t padding = (bytes - at % bytes) % bytes;
  if (padding > most) {
    return;
  }
  reserve(directive, padding, 1);
  section().keep_aligned(static_cast<std::uint32_t>(bytes));
  fill(directive.statement, static_cast<std::uint32_t>(padding), static_cast<std::uint8_t>(value));
}

// .org place[, byte]
void Assembler::read_origin(Directive& directive) {
  const ExpressionPointer expression = read_expression(directive, "an offset in the section");
  const std::int64_t value = take_comma(directive) ? read_number(directive, "a byte") : 0;
  expect_end(directive);
  move_to(directive.statement, directive.rest, *expression, static_cast<std::uint8_t>(value));
}

void Assembler::move_to(const Statement& statement, std::string_view at,
                        const Expression& expression, std::uint8_t value) {
  const Value place = evaluate(expression);
  const bool label = place.is_address() && place.symbol->kind == Symbol::Kind::label &&
                     place.symbol->section == current_section_;
  if (!label && !place.is_number()) {
    fail(statement, at,
         place.problem.empty() ? fmt::format("{} is no place in this section", place.symbol->name)
                               : place.problem);
  }
  const std::int64_t to = place.number + (label ? place.symbol->offset : 0);
  const std::int64_t here = section().location();
  if (to < here) {
    fail(statement, at, fmt::format("{:#x} lies behind: the section is at {:#x}", to, here));
  }
  if (static_cast<std::uint64_t>(to - here) > kMostBytes - bytes_) {
    fail(statement, at, fmt::format("a file has at most {} MB", kMostBytes >> 20));
  }
  bytes_ += static_cast<std::uint64_t>(to - here);
  fill(statement, static_cast<std::uint32_t>(to - here), value);
}

}  // namespace finback::assembler
