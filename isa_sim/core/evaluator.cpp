#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/core/block_builder.hpp>
#include <isa_sim/core/evaluator.hpp>
#include <isa_sim/core/exception_cause.hpp>
#include <isa_sim/core/pipeline.hpp>
#include <isa_sim/core/placed.hpp>

namespace finback::core {

using isa::ExecutionState;
using isa::Operation;

namespace {

// Whatever the target is, be it the very next packet.
bool always_leaves(isa::Flow flow) {
  return flow == isa::Flow::jump || flow == isa::Flow::jump_indirect || flow == isa::Flow::call ||
         flow == isa::Flow::call_indirect || flow == isa::Flow::ret;
}

}  // namespace

struct Evaluator::Hooks {
  static Evaluator& self(ExecutionState& state) { return *static_cast<Evaluator*>(state.engine); }

  static std::uint8_t* access(ExecutionState& state, const Operation&, Address address, int bytes,
                              bool write, bool) {
    Evaluator& e = self(state);
    memory::Span* span = e.memory_.find_span(e.core_, address);
    if (span == nullptr || (address & static_cast<Address>(bytes - 1)) != 0) {
      throw GuestFault(e.memory_.core_fault(e.core_, address, bytes, write));
    }
    if (span->level != memory::Level::l1) {
      throw GuestFault("the plain evaluator knows only a core's own L1");
    }
    e.stall_ += e.store_buffer_.access(address, bytes, write, state.time + e.stall_);
    return span->at(address);
  }
  static bool device_read(ExecutionState&, const Operation&, Address, int, std::uint32_t&) {
    throw GuestFault("the plain evaluator has no devices");
  }
  static bool device_write(ExecutionState&, const Operation&, Address, int, std::uint32_t) {
    throw GuestFault("the plain evaluator has no devices");
  }
  static bool test_and_set(ExecutionState&, const Operation&, Address, std::uint8_t&) {
    throw GuestFault("the plain evaluator has no shared memory");
  }
  static void system(ExecutionState& state, const Operation&, isa::SystemAction action,
                     std::uint32_t) {
    if (action == isa::SystemAction::read_cycles) {
      state.reg[isa::CYCLES] = static_cast<std::uint32_t>(state.time);
      state.reg[isa::CYCLES2] = static_cast<std::uint32_t>(state.time >> 32);
    }
    self(state).idle_ |= action == isa::SystemAction::idle;
  }
};

Evaluator::Evaluator(int core, const ir::CoreImage& image, const CoreParameters& parameters,
                     memory::MemorySystem& memory)
    : core_(core),
      image_(image),
      parameters_(parameters),
      memory_(memory),
      store_buffer_(parameters),
      hooks_{Hooks::access, Hooks::device_read, Hooks::device_write, Hooks::test_and_set,
             Hooks::system} {
  state_.hooks = &hooks_;
  state_.engine = this;
  state_.reg[isa::SP] = image.stack_top;
  state_.reg[isa::FP] = image.stack_top;
  state_.reg[isa::USP] = image.stack_top;
  state_.reg[isa::SYSCFG] = kCyclesRun;
  state_.next_address = image.entry;
}

const ir::PlacedPacket& Evaluator::packet_at(Address address) const {
  const auto found =
      std::ranges::lower_bound(image_.packets, address, {}, &ir::PlacedPacket::address);
  if (found == image_.packets.end() || found->address != address) {
    throw GuestFault(fmt::format("jump to {:#010x}, where no instruction is", address));
  }
  return *found;
}

bool Evaluator::run(std::uint64_t max_packets) {
  while (!idle_ && packets_ < max_packets) {
    execute(packet_at(state_.next_address));
  }
  return idle_;
}

void Evaluator::execute(const ir::PlacedPacket& packet) {
  ++packets_;
  Cycles length = 1;
  const Pipeline pipeline(parameters_);
  Cycles issue_at = next_issue_ + (refilled_ ? pipeline.target_stall(packet) : 0);
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    stall_for_operands(packet.slots[slot], issue_at);
    length = std::max(length, pipeline.issue_cycles(packet.slots[slot]));
  }
  Cycles end = issue_at + length;
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    note_results(packet.slots[slot], end);
  }
  stall_ = sub_bank_stall(packet);

  // Every slot runs on the state before the packet, loads before stores; what it changes is merged.
  const Address fall_through = packet.address + packet.length;
  const ExecutionState before = state_;
  state_.time = issue_at;
  state_.next_address = fall_through;
  std::vector<const ir::PlacedInstruction*> order;
  for (const bool stores : {false, true}) {
    for (std::size_t slot = 0; slot < packet.count; ++slot) {
      if ((info_of(packet.slots[slot]).memory == isa::MemoryUse::store) == stores) {
        order.push_back(&packet.slots[slot]);
      }
    }
  }
  for (const ir::PlacedInstruction* instruction : order) {
    ExecutionState copy = before;
    copy.next_address = fall_through;
    copy.time = issue_at;
    Operation operation = operation_of(*instruction, packet);
    operation.window = no_window();
    operation.execute(copy, &operation);
    merge(before, copy);
    if (copy.next_address != fall_through) {
      state_.next_address = copy.next_address;
    }
  }

  // The pipeline stands still: results on their way come no nearer.
  end += stall_;
  for (std::size_t reg = 0; reg < address_ready_.size(); ++reg) {
    address_ready_[reg] += stall_;
    ex1_ready_[reg] += stall_;
  }

  const isa::Flow flow = info_of(packet.slots[0]).flow;
  const bool taken = state_.next_address != fall_through;
  const bool conditional = flow == isa::Flow::branch || flow == isa::Flow::branch_predicted;
  const bool mispredicted = conditional && taken != (flow == isa::Flow::branch_predicted);
  refilled_ = mispredicted || taken || always_leaves(flow);
  if (mispredicted) {
    end += cycles_of(parameters_.branch_mispredicted) - 1;
  } else if (refilled_) {
    end += cycles_of(parameters_.branch_taken) - 1;
  }
  end_pass(packet, flow, taken);
  next_issue_ = end;
}

// At the bottom of a loop: the pass counts, and leads to the top unless control goes elsewhere. A
// call from there returns to the top.
void Evaluator::end_pass(const ir::PlacedPacket& packet, isa::Flow flow, bool taken) {
  auto& reg = state_.reg;
  const bool call = flow == isa::Flow::call || flow == isa::Flow::call_indirect;
  const bool leaves = taken || always_leaves(flow);
  for (const std::size_t loop : {std::size_t{1}, std::size_t{0}}) {
    if (reg[isa::LC0 + loop] == 0 || reg[isa::LB0 + loop] != packet.address) {
      continue;
    }
    if (--reg[isa::LC0 + loop] != 0) {
      if (call) {
        reg[isa::RETS] = reg[isa::LT0 + loop];
      } else if (!leaves) {
        state_.next_address = reg[isa::LT0 + loop];
      }
      break;
    }
  }
}

void Evaluator::merge(const ExecutionState& before, const ExecutionState& after) {
  for (std::size_t reg = 0; reg < before.reg.size(); ++reg) {
    if (after.reg[reg] != before.reg[reg]) {
      state_.reg[reg] = after.reg[reg];
    }
  }
  for (std::size_t i = 0; i < before.accumulator.size(); ++i) {
    if (after.accumulator[i] != before.accumulator[i]) {
      state_.accumulator[i] = after.accumulator[i];
    }
  }
  if (after.astat() != before.astat()) {
    state_.set_astat((state_.astat() & ~(before.astat() ^ after.astat())) |
                     (after.astat() & (before.astat() ^ after.astat())));
  }
  if (after.interrupt_mask != before.interrupt_mask) {
    state_.interrupt_mask = after.interrupt_mask;
  }
}

void Evaluator::stall_for_operands(const ir::PlacedInstruction& instruction,
                                   Cycles& issue_at) const {
  const isa::Instruction& info = info_of(instruction);
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    for_each_register(role, value, [&](int reg) {
      if (role.read && role.address_stage) {
        issue_at = std::max(issue_at, address_ready_[static_cast<std::size_t>(reg)]);
      } else if (role.read && info.needs == isa::Needs::ex1) {
        issue_at = std::max(issue_at, ex1_ready_[static_cast<std::size_t>(reg)]);
      }
    });
  });
  if ((info.implicit & isa::kReadsSp) != 0) {
    issue_at = std::max(issue_at, address_ready_[isa::SP]);
  }
  if ((info.implicit & isa::kReadsFp) != 0) {
    issue_at = std::max(issue_at, address_ready_[isa::FP]);
  }
}

void Evaluator::note_results(const ir::PlacedInstruction& instruction, Cycles done) {
  const isa::Instruction& info = info_of(instruction);
  const bool from_address_register = reads_address_register(instruction);
  const auto ready = [&](int reg, bool stepped) {
    const bool data = isa::is_data_register(reg);
    Cycles& address_ready = address_ready_[static_cast<std::size_t>(reg)];
    Cycles& ex1_ready = ex1_ready_[static_cast<std::size_t>(reg)];
    address_ready = done;
    ex1_ready = done;
    if (data && info.result != isa::Result::load) {
      ex1_ready += cycles_of(parameters_.alu_to_ex1);
    } else if (!data && !stepped && info.result == isa::Result::load) {
      address_ready += cycles_of(parameters_.load_to_address);
    } else if (!data && !stepped && info.result == isa::Result::move && !from_address_register) {
      address_ready += cycles_of(parameters_.move_to_address);
    }
  };
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    for_each_register(role, value, [&](int reg) {
      if (role.written) {
        ready(reg, role.address_stage);
      }
    });
  });
  if ((info.implicit & isa::kWritesSp) != 0) {
    ready(isa::SP, true);
  }
  if ((info.implicit & isa::kWritesFp) != 0) {
    ready(isa::FP, info.result == isa::Result::pointer);
  }
}

Cycles Evaluator::sub_bank_stall(const ir::PlacedPacket& packet) const {
  std::vector<Address> accesses;
  for (std::size_t slot = 0; packet.count > 1 && slot < packet.count; ++slot) {
    if (const auto access = access_address(packet.slots[slot])) {
      accesses.push_back(state_.reg[static_cast<std::size_t>(access->base)] +
                         static_cast<Address>(access->offset));
    }
  }
  const Address bank = static_cast<Address>(std::int64_t{parameters_.sub_bank_bytes});
  const bool conflict = accesses.size() == 2 && accesses[0] / bank == accesses[1] / bank &&
                        ((accesses[0] ^ accesses[1]) & 4) == 0;
  return conflict ? cycles_of(parameters_.sub_bank_conflict) : 0;
}

}  // namespace finback::core
