// Questions that the timing and the engines ask of a placed instruction.
#pragma once

#include <algorithm>
#include <optional>

#include <isa_sim/core/core_parameters.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::core {

[[nodiscard]] inline const isa::Instruction& info_of(const ir::PlacedInstruction& instruction) {
  return isa::instruction_table()[static_cast<std::size_t>(instruction.instruction)];
}

// The operation that carries out `instruction` within `packet`: its meaning and its operands.
[[nodiscard]] inline isa::Operation operation_of(const ir::PlacedInstruction& instruction,
                                                 const ir::PlacedPacket& packet) {
  const isa::Instruction& info = info_of(instruction);
  isa::Operation operation;
  operation.execute = info.execute;
  std::copy_n(instruction.operand.begin(), isa::kOperationOperands, operation.operand.begin());
  if (info.prepare != nullptr) {
    info.prepare(instruction.operand, operation);
  }
  if (info.execute_aligned != nullptr && info_of(packet.slots[0]).aligns) {
    operation.execute = info.execute_aligned;
  }
  operation.length = packet.length;
  operation.address = packet.address;
  return operation;
}

[[nodiscard]] inline Cycles cycles_of(const IntegerParameter& parameter) {
  return static_cast<Cycles>(std::int64_t{parameter});
}

// Calls `visit(role, value)` for each operand.
template <class Visit>
void for_each_operand(const ir::PlacedInstruction& instruction, const Visit& visit) {
  std::size_t index = 0;
  for (const isa::OperandRole& role : isa::roles_of(instruction.instruction)) {
    visit(role, instruction.operand[index++]);
  }
}

// Calls `visit(reg)` for each register that an operand stands for: a list stands for several, an
// immediate for none.
template <class Visit>
void for_each_register(const isa::OperandRole& role, std::int32_t value, const Visit& visit) {
  const auto range = [&visit](int first, int last) {
    for (int reg = first; reg <= last; ++reg) {
      visit(reg);
    }
  };
  if (role.kind == isa::OperandKind::data_list) {
    range(isa::R0 + value, isa::R7);
  } else if (role.kind == isa::OperandKind::pointer_list) {
    range(isa::P0 + value, isa::P5);
  } else if (role.kind == isa::OperandKind::data_pair) {
    range(value, value + 1);
  } else if (isa::is_register(role.kind)) {
    visit(isa::register_of(value));
  }
}

// Where an access goes before any step of its base register: base + offset.
struct AccessAddress {
  std::int32_t base = 0;
  std::int32_t offset = 0;
};

// Nothing for what does not access memory through a register of its syntax.
[[nodiscard]] inline std::optional<AccessAddress> access_address(
    const ir::PlacedInstruction& instruction) {
  std::optional<AccessAddress> address;
  if (info_of(instruction).memory == isa::MemoryUse::none) {
    return address;
  }
  bool next_is_offset = false;
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    if (!address && role.address_stage) {
      address = AccessAddress{value, 0};
      next_is_offset = true;
    } else if (next_is_offset) {
      address->offset = isa::is_register(role.kind) ? 0 : value;
      next_is_offset = false;
    }
  });
  return address;
}

// Registers that a push or pop multiple moves.
[[nodiscard]] inline std::uint32_t listed_registers(const ir::PlacedInstruction& instruction) {
  std::uint32_t count = 0;
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    for_each_register(role, value, [&](int) { ++count; });
  });
  return count;
}

// Bytes that one execution moves to or from memory.
[[nodiscard]] inline std::uint32_t access_bytes(const ir::PlacedInstruction& instruction) {
  const isa::Instruction& info = info_of(instruction);
  return info.issue == isa::Issue::register_list ? info.access_bytes * listed_registers(instruction)
                                                 : info.access_bytes;
}

// A move between address registers happens in stage AC and makes nobody wait (hardware.md 6.1).
[[nodiscard]] inline bool reads_address_register(const ir::PlacedInstruction& instruction) {
  bool reads = false;
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    reads |= role.read && !role.written && isa::is_register(role.kind) &&
             isa::is_address_register(isa::register_of(value));
  });
  return reads;
}

}  // namespace finback::core
