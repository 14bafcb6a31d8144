// Every entry of the instruction table, walked: it prints, reads back and is complete.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <isa_sim/isa/registers.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {
namespace {

using testing::IsEmpty;

TEST(InstructionTable, EveryEntryPrintsAndReadsBack) {
  ASSERT_FALSE(instruction_table().empty());
  EXPECT_THAT(instruction_syntax().check_table(), IsEmpty());
}

TEST(InstructionTable, EveryEntryHasAMeaning) {
  for (const Instruction& entry : instruction_table()) {
    EXPECT_NE(entry.execute, nullptr) << entry.syntax;
  }
}

// Only loads, stores and pushes touch memory through brackets, and they say so; cache control does
// not.
TEST(InstructionTable, BracketsAreMemory) {
  for (const Instruction& entry : instruction_table()) {
    if (entry.syntax.find("FLUSH") != std::string_view::npos ||
        entry.syntax.starts_with("PREFETCH")) {
      EXPECT_EQ(entry.memory, MemoryUse::none) << entry.syntax;
      continue;
    }
    const bool brackets = entry.syntax.find('[') != std::string_view::npos;
    if (brackets) {
      EXPECT_NE(entry.memory, MemoryUse::none) << entry.syntax;
    }
    const std::size_t equals = entry.syntax.find('=');
    const std::size_t bracket = entry.syntax.find('[');
    if (brackets && equals != std::string_view::npos) {
      EXPECT_EQ(entry.memory, bracket < equals ? MemoryUse::store : MemoryUse::load)
          << entry.syntax;
    }
  }
}

// Registers in brackets are read by the address generators.
TEST(InstructionTable, AddressesAreReadInStageAc) {
  for (const Instruction& entry : instruction_table()) {
    const std::size_t open = entry.syntax.find('[');
    const std::size_t close = entry.syntax.find(']');
    if (open == std::string_view::npos || close == std::string_view::npos) {
      continue;
    }
    const std::string_view inside = entry.syntax.substr(open, close - open);
    for (std::size_t at = inside.find('{'); at != std::string_view::npos;
         at = inside.find('{', at + 1)) {
      const std::string_view operand = inside.substr(at, inside.find('}', at) - at);
      const bool is_register =
          operand.starts_with("{P") || operand.starts_with("{I") || operand.starts_with("{M");
      EXPECT_TRUE(!is_register || operand.find('@') != std::string_view::npos) << entry.syntax;
    }
  }
}

TEST(InstructionTable, CodeAddressesAreOfTransfersOfControl) {
  for (int i = 0; i < static_cast<int>(instruction_table().size()); ++i) {
    const Instruction& entry = instruction_table()[static_cast<std::size_t>(i)];
    const OperandRoles& roles = roles_of(i);
    const bool has_target = std::ranges::any_of(
        roles, [](const OperandRole& role) { return is_code_address(role.kind); });
    const bool transfers = entry.flow == Flow::jump || entry.flow == Flow::call ||
                           entry.flow == Flow::branch || entry.flow == Flow::branch_predicted ||
                           entry.flow == Flow::loop_setup;
    EXPECT_EQ(has_target, transfers) << entry.syntax;
  }
}

TEST(Disassemble, PrintsLinkedOperands) {
  const ParsedInstruction load = instruction_syntax().parse("R3 = [P2++]");
  EXPECT_EQ(disassemble(load.instruction, {R3, P2}), "R3 = [P2++]");
  const ParsedInstruction call = instruction_syntax().parse("CALL _f");
  EXPECT_EQ(disassemble(call.instruction, {static_cast<std::int32_t>(0xFFA00010)}),
            "CALL 0xffa00010");
}

// An option that is not closed, or not even begun, is blamed on what is there; of an odd register
// for an even one, that is said.
TEST(Explain, OptionsAndParity) {
  const auto blamed = [](std::string_view text) {
    const std::vector<Token> tokens = tokenize(text);
    const SyntaxProblem problem = instruction_syntax().explain(tokens);
    return problem.token < tokens.size() ? problem.message : "beyond the text";
  };
  EXPECT_TRUE(blamed("R7 = (A1 = R0.H * R7.H) (").starts_with("( cannot stand here: (FU) or"));
  EXPECT_EQ(blamed("R1 = A0"),
            "R1 cannot stand here: an even data register R0, R2, R4 or R6 is wanted");
  EXPECT_TRUE(blamed("R7 = (A1 = R0.H * R7.H) (XX)").starts_with("XX cannot stand here: (FU) or"));
}

TEST(Registers, NamesReadBack) {
  for (int i = 0; i < kRegisterCount; ++i) {
    const auto reg = static_cast<Register>(i);
    std::string name(register_name(reg));
    EXPECT_EQ(register_by_name(name), reg);
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    EXPECT_EQ(register_by_name(name), reg);
  }
  EXPECT_FALSE(register_by_name("R8"));
  EXPECT_FALSE(register_by_name(""));
}

TEST(OperandKinds, NamesReadBack) {
  for (int i = 0; i <= static_cast<int>(OperandKind::loop_bottom); ++i) {
    const auto kind = static_cast<OperandKind>(i);
    EXPECT_EQ(kind_by_name(kind_name(kind)), kind);
    EXPECT_EQ(immediate_range(kind).has_value(), !is_register(kind) && !is_choice(kind));
    EXPECT_EQ(spellings(kind).empty(), !is_choice(kind));
  }
  EXPECT_FALSE(kind_by_name("imm99"));
}

}  // namespace
}  // namespace finback::isa
