// The table's parts, one per group of instructions; instruction_table() joins them in this order.
// Where two forms can express one text (a 2-byte and a 4-byte immediate), the assembler takes the
// first: short forms stand first.
#pragma once

#include <span>

#include <isa_sim/isa/instruction.hpp>

namespace finback::isa {

[[nodiscard]] std::span<const Instruction> memory_instructions();
[[nodiscard]] std::span<const Instruction> move_instructions();
[[nodiscard]] std::span<const Instruction> arithmetic_instructions();
[[nodiscard]] std::span<const Instruction> alu_instructions();
[[nodiscard]] std::span<const Instruction> multiply_instructions();
[[nodiscard]] std::span<const Instruction> accumulator_instructions();
[[nodiscard]] std::span<const Instruction> video_instructions();
[[nodiscard]] std::span<const Instruction> shift_instructions();
[[nodiscard]] std::span<const Instruction> control_instructions();
[[nodiscard]] std::span<const Instruction> debug_instructions();

}  // namespace finback::isa
