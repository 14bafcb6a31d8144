#include <algorithm>

#include <isa_sim/core/pipeline.hpp>
#include <isa_sim/core/placed.hpp>

namespace finback::core {

using isa::OperandKind;
using isa::OperandRole;

namespace {

// A move or pop into LC, LT or LB refills the pipeline; LSETUP does not.
bool writes_loop_register(const ir::PlacedInstruction& instruction) {
  bool writes = false;
  for_each_operand(instruction, [&](const OperandRole& role, std::int32_t value) {
    writes |=
        role.kind == OperandKind::any && role.written && value >= isa::LC0 && value <= isa::LB1;
  });
  return writes;
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
  switch (info_of(instruction).issue) {
    case isa::Issue::one:
      return writes_loop_register(instruction) ? cycles_of(parameters_.loop_register) : 1;
    case isa::Issue::multiply32:
      return cycles_of(parameters_.multiply32);
    case isa::Issue::link:
      return cycles_of(parameters_.link);
    case isa::Issue::unlink:
      return cycles_of(parameters_.unlink);
    case isa::Issue::core_sync:
      return cycles_of(parameters_.core_sync);
    case isa::Issue::system_sync:
      return cycles_of(parameters_.system_sync);
    case isa::Issue::event:
      return cycles_of(parameters_.event);
    case isa::Issue::test_and_set:
      return cycles_of(parameters_.test_and_set);
    case isa::Issue::register_list:
      return listed_registers(instruction);
  }
  return 1;
}

PacketCost Pipeline::issue(const ir::PlacedPacket& packet, PipelineState& state) const {
  PacketCost cost;
  cost.issue = 1;
  const auto need = [&](Cycles wait, Cause cause, int reg) {
    if (wait > cost.stall) {
      cost.stall = wait;
      cost.stall_cause = cause;
      cost.stall_register = reg;
    }
  };
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    const ir::PlacedInstruction& instruction = packet.slots[slot];
    const isa::Instruction& info = info_of(instruction);
    cost.issue = std::max(cost.issue, issue_cycles(instruction));
    for_each_operand(instruction, [&](const OperandRole& role, std::int32_t value) {
      for_each_register(role, value, [&](int reg) {
        if (!role.read || reg > isa::L3) {
          return;
        }
        if (role.address_stage) {
          need(state.wait(reg).address_stage, Cause::hazard_address, reg);
        } else if (info.needs == isa::Needs::ex1) {
          need(state.wait(reg).ex1, Cause::hazard_ex1, reg);
        }
      });
    });
    if ((info.implicit & isa::kReadsSp) != 0) {
      need(state.wait(isa::SP).address_stage, Cause::hazard_address, isa::SP);
    }
    if ((info.implicit & isa::kReadsFp) != 0) {
      need(state.wait(isa::FP).address_stage, Cause::hazard_address, isa::FP);
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
  const auto load_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.load_to_address});
  const auto move_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.move_to_address});
  const auto alu_wait = static_cast<std::uint8_t>(std::int64_t{parameters_.alu_to_ex1});

  const bool from_address_register = reads_address_register(instruction);
  const auto written = [&](int reg, bool stepped) {
    if (reg > isa::L3) {
      return;
    }
    PipelineState::Wait wait;
    if (isa::is_data_register(reg)) {
      wait.ex1 = info.result == isa::Result::load ? 0 : alu_wait;
    } else if (!stepped && info.result == isa::Result::load) {
      wait.address_stage = load_wait;
    } else if (!stepped && info.result == isa::Result::move && !from_address_register) {
      wait.address_stage = move_wait;
    }
    state.set(reg, wait);
  };
  for_each_operand(instruction, [&](const OperandRole& role, std::int32_t value) {
    if (role.written) {
      for_each_register(role, value, [&](int reg) { written(reg, role.address_stage); });
    }
  });
  if ((info.implicit & isa::kWritesSp) != 0) {
    written(isa::SP, true);
  }
  if ((info.implicit & isa::kWritesFp) != 0) {
    written(isa::FP, info.result == isa::Result::pointer);
  }
}

PipelineStates::PipelineStates() {
  PipelineState state;
  static_cast<void>(number_of(state));
  state.set_refilled(true);
  static_cast<void>(number_of(state));
}

std::uint32_t PipelineStates::number_of(const PipelineState& state) {
  const auto [entry, added] = numbers_.emplace(state, static_cast<std::uint32_t>(states_.size()));
  if (added) {
    states_.push_back(&entry->first);
  }
  return entry->second;
}

}  // namespace finback::core
