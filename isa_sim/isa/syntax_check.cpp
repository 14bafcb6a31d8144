// The table's own test: every entry prints to text that reads back as the same entry.
#include <algorithm>
#include <fmt/format.h>
#include <set>

#include <common/error.hpp>
#include <isa_sim/isa/registers.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {
namespace {

std::vector<OperandValue> numbers(const std::vector<std::int32_t>& values) {
  std::vector<OperandValue> result;
  result.reserve(values.size());
  for (const std::int32_t value : values) {
    result.push_back({value, {}});
  }
  return result;
}

std::vector<OperandValue> sample_registers(OperandKind kind) {
  switch (kind) {
    case OperandKind::data:
    case OperandKind::data_low:
    case OperandKind::data_byte:
      return numbers({R0, R3, R7});
    case OperandKind::data_even:
      return numbers({R0, R2, R6});
    case OperandKind::data_odd:
      return numbers({R1, R5, R7});
    case OperandKind::data_high:
      return numbers({R0 | kHighHalf, R4 | kHighHalf, R7 | kHighHalf});
    case OperandKind::data_half:
      return numbers({R0, R0 | kHighHalf, R5, R7 | kHighHalf});
    case OperandKind::pointer:
      return numbers({P0, P5, SP, FP});
    case OperandKind::index:
      return numbers({I0, I1, I2, I3});
    case OperandKind::modify:
      return numbers({M0, M1, M2, M3});
    case OperandKind::address:
      return numbers({I0, M3, B1, L2});
    case OperandKind::pointer_low:
      return numbers({P0, FP, I1, L3});
    case OperandKind::pointer_high:
      return numbers({P0 | kHighHalf, SP | kHighHalf, M2 | kHighHalf, B3 | kHighHalf});
    case OperandKind::any:
      return numbers({R0, P1, SP, I0, L3, LC0, LB1, RETS, SEQSTAT, A0X, ASTAT});
    case OperandKind::system:
      return numbers({I0, M1, B2, L3, LC0, LT1, RETS, CYCLES, A1W, ASTAT});
    case OperandKind::data_pair:
      return numbers({0, 2});
    case OperandKind::data_list:
      return numbers({7, 4, 0});
    default:
      return numbers({5, 3, 0});
  }
}

// Operand sets to try: each operand walks through its samples together with the others, then alone.
std::vector<ParsedInstruction> sample_instructions(int entry, const OperandRoles& roles) {
  std::vector<std::vector<OperandValue>> samples;
  std::size_t most = 1;
  for (const OperandRole& role : roles) {
    samples.push_back(sample_values(role.kind));
    most = std::max(most, samples.back().size());
  }
  std::vector<ParsedInstruction> result;
  for (std::size_t round = 0; round < most; ++round) {
    ParsedInstruction instruction{.instruction = entry, .operand = {}};
    for (std::size_t i = 0; i < samples.size(); ++i) {
      instruction.operand[i] = samples[i][(round + i) % samples[i].size()];
    }
    result.push_back(instruction);
  }
  for (std::size_t varied = 0; varied < samples.size(); ++varied) {
    ParsedInstruction instruction{.instruction = entry, .operand = {}};
    for (std::size_t i = 0; i < samples.size(); ++i) {
      instruction.operand[i] = samples[i].back();
    }
    for (const OperandValue& value : samples[varied]) {
      instruction.operand[varied] = value;
      result.push_back(instruction);
    }
  }
  return result;
}

std::string check_form(const Instruction& entry) {
  if (entry.length != 2 && entry.length != 4) {
    return "an instruction takes 2 or 4 bytes";
  }
  if (entry.slot == Slot::dsp && entry.length != 4) {
    return "slot 0 of a packet takes 32-bit instructions";
  }
  if (entry.slot != Slot::dsp && entry.slot != Slot::alone && entry.length != 2) {
    return "slots 1 and 2 of a packet take 16-bit instructions";
  }
  return "";
}

}  // namespace

std::vector<OperandValue> sample_values(OperandKind kind) {
  if (is_code_address(kind)) {
    return {{0, "_function"}, {0, ".Lloop0"}, {4, "_function"}, {-2, "_function"}};
  }
  if (is_register(kind)) {
    return sample_registers(kind);
  }
  if (is_choice(kind)) {
    std::vector<OperandValue> result;
    for (const Spelling& spelling : spellings(kind)) {
      result.push_back({spelling.value, {}});
    }
    return result;
  }
  const ImmediateRange range = *immediate_range(kind);
  std::set<std::int32_t> values = {range.minimum, range.maximum, range.minimum + range.scale,
                                   range.maximum - range.scale};
  for (const std::int32_t value : {0, range.scale, -range.scale, 8 * range.scale}) {
    if (value >= range.minimum && value <= range.maximum) {
      values.insert(value);
    }
  }
  std::vector<OperandValue> result = numbers({values.begin(), values.end()});
  if (kind == OperandKind::any16) {
    result.push_back({0, "_object"});
    result.push_back({12, "_object"});
  }
  return result;
}

std::vector<std::string> Syntax::check_table() const {
  std::vector<std::string> problems;
  for (const auto& [first, second] : same_syntax()) {
    problems.push_back(fmt::format("'{}' and '{}' have the same syntax",
                                   table_[static_cast<std::size_t>(first)].syntax,
                                   table_[static_cast<std::size_t>(second)].syntax));
  }
  for (int entry = 0; entry < static_cast<int>(table_.size()); ++entry) {
    const Instruction& row = table_[static_cast<std::size_t>(entry)];
    if (const std::string problem = check_form(row); !problem.empty()) {
      problems.push_back(fmt::format("'{}': {}", row.syntax, problem));
    }
    bool reached = false;
    for (const ParsedInstruction& sample : sample_instructions(entry, roles(entry))) {
      const std::string text = print(sample);
      const std::vector<Token> tokens = tokenize(text);
      const auto read = match(tokens);
      if (!read) {
        problems.push_back(
            fmt::format("'{}': '{}': {}", row.syntax, text, explain(tokens).message));
      } else if (read->instruction > entry || print(*read) != text ||
                 (read->instruction == entry && *read != sample)) {
        problems.push_back(fmt::format("'{}': '{}' reads as '{}'", row.syntax, text,
                                       table_[static_cast<std::size_t>(read->instruction)].syntax));
      }
      reached = reached || (read && read->instruction == entry);
    }
    if (!reached) {
      problems.push_back(fmt::format("'{}': entries before it read all of its forms", row.syntax));
    }
  }
  return problems;
}

}  // namespace finback::isa
