#include <algorithm>

#include <isa_sim/core/pipeline.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::core {

using isa::OperandKind;
using isa::OperandRole;
using isa::register_of;

namespace {

const isa::Instruction& info_of(const ir::PlacedInstruction& instruction) {
  return isa::instruction_table()[static_cast<std::size_t>(instruction.instruction)];
}

// Calls `visit` with each register that an operand stands for (a list stands for several).
template <class Visit>
void for_each_register(OperandKind kind, std::int32_t value, const Visit& visit) {
  switch (kind) {
    case OperandKind::data_list:
      for (int reg = isa::R0 + value; reg <= isa::R7; ++reg) {
        visit(reg);
      }
      break;
    case OperandKind::pointer_list:
      for (int reg = isa::P0 + value; reg <= isa::P5; ++reg) {
        visit(reg);
      }
      break;
    case OperandKind::data_pair:
      visit(value);
      visit(value + 1);
      break;
    default:
      visit(register_of(value));
  }
}

// A move or pop into LC, LT or LB refills the pipeline; LSETUP does not.
bool writes_loop_register(const ir::PlacedInstruction& instruction) {
  int index = 0;
  for (const OperandRole& role : isa::roles_of(instruction.instruction)) {
    const std::int32_t value = instruction.operand[static_cast<std::size_t>(index++)];
    if (role.kind == OperandKind::any && role.written && value >= isa::LC0 && value <= isa::LB1) {
      return true;
    }
  }
  return false;
}

}  // namespace

void PipelineState::advance(Cycles cycles) {
  const auto step = static_cast<std::uint8_t>(std::min<Cycles>(cycles, 255));
  for (Wait& wait : waits_) {
    wait.address_stage = wait.address_stage > step ? wait.address_stage - step : 0;
    wait.ex1 = wait.ex1 > step ? wait.ex1 - step : 0;
  }
}

Cycles Pipeline::issue_cycles(const ir::PlacedInstruction& instruction) const {
  const auto cycles = [](const IntegerParameter& parameter) {
    return static_cast<Cycles>(std::int64_t{parameter});
  };
  switch (info_of(instruction).issue) {
    case isa::Issue::one:
      return writes_loop_register(instruction) ? cycles(parameters_.loop_register) : 1;
    case isa::Issue::multiply32:
      return cycles(parameters_.multiply32);
    case isa::Issue::link:
      return cycles(parameters_.link);
    case isa::Issue::unlink:
      return cycles(parameters_.unlink);
    case isa::Issue::core_sync:
      return cycles(parameters_.core_sync);
    case isa::Issue::system_sync:
      return cycles(parameters_.system_sync);
    case isa::Issue::event:
      return cycles(parameters_.event);
    case isa::Issue::test_and_set:
      return cycles(parameters_.test_and_set);
    case isa::Issue::register_list: {
      Cycles count = 0;
      int index = 0;
      for (const OperandRole& role : isa::roles_of(instruction.instruction)) {
        for_each_register(role.kind, instruction.operand[static_cast<std::size_t>(index++)],
                          [&](int) { ++count; });
      }
      return count;
    }
  }
  return 1;
}

PacketCost Pipeline::issue(const ir::PlacedPacket& packet, PipelineState& state) const {
  PacketCost cost;
  cost.issue = 1;
  const auto need = [&](Cycles wait, Cause cause) {
    if (wait > cost.stall) {
      cost.stall = wait;
      cost.stall_cause = cause;
    }
  };
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    const ir::PlacedInstruction& instruction = packet.slots[slot];
    const isa::Instruction& info = info_of(instruction);
    cost.issue = std::max(cost.issue, issue_cycles(instruction));
    std::size_t index = 0;
    for (const OperandRole& role : isa::roles_of(instruction.instruction)) {
      const std::int32_t value = instruction.operand[index++];
      if (!role.read || !isa::is_register(role.kind)) {
        continue;
      }
      for_each_register(role.kind, value, [&](int reg) {
        if (reg > isa::L3) {
          return;
        }
        if (role.address_stage) {
          need(state.wait(reg).address_stage, Cause::hazard_address);
        } else if (info.needs == isa::Needs::ex1) {
          need(state.wait(reg).ex1, Cause::hazard_ex1);
        }
      });
    }
    if ((info.implicit & isa::kReadsSp) != 0) {
      need(state.wait(isa::SP).address_stage, Cause::hazard_address);
    }
    if ((info.implicit & isa::kReadsFp) != 0) {
      need(state.wait(isa::FP).address_stage, Cause::hazard_address);
    }
  }
  state.advance(cost.stall + cost.issue);
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    note_results(packet.slots[slot], state);
  }
  return cost;
}

void Pipeline::note_results(const ir::PlacedInstruction& instruction, PipelineState& state) const {
  const isa::Instruction& info = info_of(instruction);
  const isa::OperandRoles& roles = isa::roles_of(instruction.instruction);
  const auto load_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.load_to_address});
  const auto move_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.move_to_address});
  const auto alu_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.alu_to_ex1});

  // A move between address registers happens in AC and makes nobody wait (hardware.md 6.1).
  bool moves_from_address_register = false;
  for (int i = 0; i < roles.count; ++i) {
    moves_from_address_register |=
        roles[i].read && !roles[i].written && isa::is_register(roles[i].kind) &&
        isa::is_address_register(register_of(instruction.operand[static_cast<std::size_t>(i)]));
  }
  const auto written = [&](int reg, bool stepped) {
    if (reg > isa::L3) {
      return;
    }
    PipelineState::Wait wait;
    if (isa::is_data_register(reg)) {
      wait.ex1 = info.result == isa::Result::load ? 0 : alu_wait;
    } else if (!stepped && info.result == isa::Result::load) {
      wait.address_stage = load_wait;
    } else if (!stepped && info.result == isa::Result::move && !moves_from_address_register) {
      wait.address_stage = move_wait;
    }
    state.set(reg, wait);
  };
  for (int i = 0; i < roles.count; ++i) {
    const OperandRole& role = roles[i];
    if (role.written && isa::is_register(role.kind)) {
      for_each_register(role.kind, instruction.operand[static_cast<std::size_t>(i)],
                        [&](int reg) { written(reg, role.address_stage); });
    }
  }
  if ((info.implicit & isa::kWritesSp) != 0) {
    written(isa::SP, true);
  }
  if ((info.implicit & isa::kWritesFp) != 0) {
    written(isa::FP, info.result == isa::Result::pointer);
  }
}

std::uint32_t PipelineStates::number_of(const PipelineState& state) {
  const auto [entry, added] = numbers_.emplace(state, static_cast<std::uint32_t>(states_.size()));
  if (added) {
    states_.push_back(&entry->first);
  }
  return entry->second;
}

}  // namespace finback::core
