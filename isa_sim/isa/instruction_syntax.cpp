// The syntax of the one instruction table; apart from syntax.cpp so that other tables need not link
// it.
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa {

const Syntax& instruction_syntax() {
  static const Syntax syntax(instruction_table());
  return syntax;
}

const OperandRoles& roles_of(int instruction) { return instruction_syntax().roles(instruction); }

std::string disassemble(int instruction, const std::array<std::int32_t, kMaxOperands>& operand) {
  ParsedInstruction parsed{.instruction = instruction, .operand = {}};
  for (std::size_t i = 0; i < operand.size(); ++i) {
    parsed.operand[i].number = operand[i];
  }
  return instruction_syntax().print(parsed);
}

}  // namespace finback::isa
