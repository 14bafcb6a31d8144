#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include <isa_sim/isa/pattern.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::isa {
namespace {

[[noreturn]] void malformed(std::string_view syntax, std::string_view why) {
  throw std::logic_error(fmt::format("instruction table: '{}': {}", syntax, why));
}

// Splits "P@+" into kind and marks.
OperandRole read_role(std::string_view syntax, std::string_view inside) {
  const std::size_t end = inside.find_first_of("!+@");
  const std::string_view name = inside.substr(0, end);
  const auto kind = kind_by_name(name);
  if (!kind) {
    malformed(syntax, fmt::format("unknown operand kind '{}'", name));
  }
  OperandRole role{.kind = *kind, .read = true, .written = false, .address_stage = false};
  for (const char mark : inside.substr(name.size())) {
    switch (mark) {
      case '!':
        role.read = false;
        role.written = true;
        break;
      case '+':
        role.read = role.written = true;
        break;
      case '@':
        role.address_stage = true;
        break;
      default:
        malformed(syntax, fmt::format("unknown operand mark '{}'", mark));
    }
  }
  if (!is_register(*kind)) {
    if (role.written || role.address_stage) {
      malformed(syntax, "an immediate is neither written nor an address register");
    }
    role.read = false;
  }
  return role;
}

int read_repeated(std::string_view syntax, std::string_view inside, int count) {
  const int which = inside.size() == 2 ? inside[1] - '0' : -1;
  if (which < 0 || which >= count) {
    malformed(syntax, fmt::format("'{{{}}}' repeats no operand before it", inside));
  }
  return which;
}

void add_literals(std::vector<PatternStep>& steps, std::string_view text) {
  for (const Token& token : tokenize(text)) {
    steps.push_back({.literal = upper_case(token.text)});
  }
}

std::string print_register_kind(OperandKind kind, int value) {
  std::string name(register_name(static_cast<Register>(register_of(value))));
  switch (kind) {
    case OperandKind::data_low:
    case OperandKind::pointer_low:
      return name + ".L";
    case OperandKind::data_high:
    case OperandKind::pointer_high:
      return name + ".H";
    case OperandKind::data_half:
      return name + (is_high_half(value) ? ".H" : ".L");
    case OperandKind::data_byte:
      return name + ".B";
    case OperandKind::data_pair:
      return fmt::format("R{}:{}", value + 1, value);
    case OperandKind::data_list:
      return fmt::format("R7:{}", value);
    case OperandKind::pointer_list:
      return fmt::format("P5:{}", value);
    default:
      return name;
  }
}

// An option stands apart from what it belongs to; other choices have their blanks in the pattern.
std::string print_choice(OperandKind kind, int value) {
  const auto all = spellings(kind);
  const auto found = std::ranges::find(all, value, &Spelling::value);
  if (found == all.end() || found->text.empty()) {
    return "";
  }
  return found->text.starts_with('(') ? fmt::format(" {}", found->text) : std::string(found->text);
}

// "(GT), (GE), (LT) or (LE)"
std::string describe_choice(OperandKind kind) {
  std::string text;
  for (const Spelling& spelling : spellings(kind)) {
    if (!spelling.text.empty()) {
      text += fmt::format("{}{}", text.empty() ? "" : " or ", spelling.text);
    }
  }
  return text;
}

}  // namespace

Pattern compile_pattern(std::string_view syntax) {
  Pattern pattern;
  std::string text;
  std::size_t position = 0;
  while (position < syntax.size()) {
    const std::size_t open = std::min(syntax.find('{', position), syntax.size());
    const std::string_view literal = syntax.substr(position, open - position);
    add_literals(pattern.steps, literal);
    text += literal;
    if (open == syntax.size()) {
      break;
    }
    const std::size_t close = syntax.find('}', open);
    if (close == std::string_view::npos) {
      malformed(syntax, "'{' without '}'");
    }
    const std::string_view inside = syntax.substr(open + 1, close - open - 1);
    position = close + 1;
    if (inside.starts_with('?')) {
      if (position != syntax.size()) {
        malformed(syntax, "what may be left out stands at the end");
      }
      pattern.short_steps = pattern.steps;
      add_literals(pattern.steps, inside.substr(1));
      text += inside.substr(1);
      break;
    }
    OperandRoles& roles = pattern.roles;
    pattern.texts.push_back(std::exchange(text, {}));
    if (inside.starts_with('=')) {
      const int which = read_repeated(syntax, inside, roles.count);
      pattern.steps.push_back({.kind = PatternStep::Kind::repeated,
                               .literal = {},
                               .operand = roles[which].kind,
                               .repeats = which});
      pattern.values.push_back(which);
    } else {
      if (roles.count == kMaxOperands) {
        malformed(syntax, "too many operands");
      }
      const OperandRole role = read_role(syntax, inside);
      pattern.steps.push_back(
          {.kind = PatternStep::Kind::operand, .literal = {}, .operand = role.kind});
      pattern.values.push_back(roles.count);
      roles.role[static_cast<std::size_t>(roles.count++)] = role;
    }
  }
  pattern.texts.push_back(text);
  if (pattern.steps.empty()) {
    malformed(syntax, "it is empty");
  }
  return pattern;
}

std::string print_operand(OperandKind kind, const OperandValue& value) {
  if (!value.symbol.empty()) {
    if (value.number == 0) {
      return value.symbol;
    }
    return fmt::format("{} {} {}", value.symbol, value.number < 0 ? '-' : '+',
                       std::abs(static_cast<std::int64_t>(value.number)));
  }
  if (is_register(kind)) {
    return print_register_kind(kind, value.number);
  }
  if (is_choice(kind)) {
    return print_choice(kind, value.number);
  }
  return is_code_address(kind) ? fmt::format("0x{:x}", static_cast<std::uint32_t>(value.number))
                               : fmt::format("{}", value.number);
}

std::string describe(OperandKind kind) {
  if (is_code_address(kind)) {
    return "a label";
  }
  if (is_choice(kind)) {
    return describe_choice(kind);
  }
  if (const auto range = immediate_range(kind)) {
    return fmt::format("a number {}..{}{}", range->minimum, range->maximum,
                       range->scale == 1 ? "" : fmt::format(", a multiple of {}", range->scale));
  }
  switch (kind) {
    case OperandKind::data:
      return "a data register R0..R7";
    case OperandKind::data_low:
      return "a low half R0.L..R7.L";
    case OperandKind::data_high:
      return "a high half R0.H..R7.H";
    case OperandKind::data_half:
      return "a half register R0.L..R7.H";
    case OperandKind::data_byte:
      return "a byte register R0.B..R7.B";
    case OperandKind::data_even:
      return "an even data register R0, R2, R4 or R6";
    case OperandKind::data_odd:
      return "an odd data register R1, R3, R5 or R7";
    case OperandKind::pointer:
      return "a pointer register P0..P5, SP, FP";
    case OperandKind::index:
      return "an index register I0..I3";
    case OperandKind::modify:
      return "a modify register M0..M3";
    case OperandKind::address:
      return "an address register I0..I3, M0..M3, B0..B3, L0..L3";
    case OperandKind::pointer_low:
      return "a low half P0.L..L3.L of an address register";
    case OperandKind::pointer_high:
      return "a high half P0.H..L3.H of an address register";
    case OperandKind::data_pair:
      return "a register pair R1:0 or R3:2";
    case OperandKind::data_list:
      return "a register list R7:n";
    case OperandKind::pointer_list:
      return "a register list P5:n";
    default:
      return "a register";
  }
}

}  // namespace finback::isa
