// Table entries of 32-bit DSP instructions, which stand in slot 0 of a packet.
#pragma once

#include <isa_sim/isa/instruction.hpp>

namespace finback::isa {

constexpr Instruction dsp_form(std::string_view syntax, Execute execute,
                               std::string_view meaning = {}) {
  return {.syntax = syntax, .length = 4, .slot = Slot::dsp, .execute = execute, .meaning = meaning};
}

// Operands needed in EX1: bit fields, counts, amounts of shifts, video.
constexpr Instruction early_dsp_form(std::string_view syntax, Execute execute,
                                     std::string_view meaning = {}) {
  Instruction form = dsp_form(syntax, execute, meaning);
  form.needs = Needs::ex1;
  return form;
}

// With a second way to write it.
constexpr Instruction also(Instruction form, std::string_view spelling) {
  form.also = spelling;
  return form;
}

// With registers that do not stand among the operands.
constexpr Instruction with_implicit(Instruction form, std::uint32_t implicit) {
  form.implicit = implicit;
  return form;
}

// Two results, operands `one` and `other`, which may not go to one register.
template <std::size_t one, std::size_t other>
constexpr Instruction two_results(Instruction form) {
  form.check = [](const OperandNumbers& operand) -> std::string_view {
    return operand[one] == operand[other] ? "the two results go to different registers" : "";
  };
  return form;
}

}  // namespace finback::isa
