// Blocks that end before their end: exceptions, interrupts let in half-way, the end of a program.
//
// The packets that were completed are counted as a block of their own, which stands for the
// beginning of the one that ran, so that every sum of the profile stays exact.
#include <fmt/format.h>
#include <utility>

#include <common/error.hpp>
#include <isa_sim/core/core.hpp>
#include <isa_sim/core/placed.hpp>
#include <isa_sim/core/trap.hpp>

namespace finback::core {

using isa::Operation;

// Planted where a block shall end early.
const Operation* Core::stop_here(isa::ExecutionState&, const Operation* operation) {
  throw Trap{.kind = Trap::Kind::boundary, .operation = operation};
}

// Before a packet that may have to be undone.
const Operation* Core::save_packet(isa::ExecutionState& state, const Operation* operation) {
  Core& core = *static_cast<Core*>(state.engine);
  core.saved_ = state;
  core.saved_packet_ = operation->site;
  return operation + 1;
}

void Core::handle(const Trap& trap) {
  uproot();
  state_.retry = nullptr;
  if (trap.operation == nullptr) {
    if (trap.kind == Trap::Kind::fetch) {
      handle_fetch(trap);
    } else {
      halted_ = true;  // by a reset, between blocks
    }
    return;
  }
  const Operation& operation = *trap.operation;
  switch (trap.kind) {
    case Trap::Kind::exception:
      undo_packet(operation.site);
      cut_block(operation.site, &operation);
      enter_exception(trap.cause, operation.address);
      break;
    case Trap::Kind::boundary: {
      const std::uint32_t state = cut_block(operation.site, nullptr);
      current_ = block_at(operation.address, state);
      break;
    }
    case Trap::Kind::halted:
      cut_block(operation.site + 1, nullptr);
      halted_ = true;
      break;
    case Trap::Kind::fetch:
      break;
  }
}

// The block was counted whole. A misaligned target is the fault of the instruction that goes there;
// anything else is found at the target.
void Core::handle_fetch(const Trap& trap) {
  const Address target = trap.address;
  Block& block = *current_;
  const std::uint32_t last = block.first_packet + block.packet_count - 1;
  if (events_.handler(kException) == 0 || events_.level() <= kException) {
    throw GuestFault(fmt::format("{}: jump to {:#010x}, where no instruction is from {}",
                                 name_of(id_), target, place(last)));
  }
  if ((target & 1U) != 0) {
    --block.executions;
    --block.taken;
    state_.time -= block.cycles + block.taken_extra;
    if (trace_) {
      trace_->retract();
    }
    undo_packet(last);
    cut_block(last, nullptr);
    enter_exception(kMisalignedFetch, block.last_packet_address);
    return;
  }
  if (block.ends >= BlockEnd::call) {
    note_call_or_return(block, target);
  }
  if (exception_due_ >= 0) {
    enter_exception(std::exchange(exception_due_, -1), target);
    return;
  }
  const memory::Region* region = memory_.map().find(target);
  const bool data_only = region != nullptr && !region->code;
  enter_exception(target >= isa::kDeviceBase ? kFetchMiss
                  : data_only                ? kFetchProtection
                                             : kUndefinedInstruction,
                  target);
}

// Counts the packets of the running block before `end_packet`. `unfinished`: the operation that was
// not completed. Returns the pipeline state after them.
std::uint32_t Core::cut_block(std::uint32_t end_packet, const Operation* unfinished) {
  if (unfinished != nullptr) {
    for (const Operation* o = current_->operations.get(); o != unfinished; ++o) {
      if (o->site == unfinished->site && o->access_bytes != 0) {
        killed_bytes_[o->site] += o->access_bytes;
      }
    }
  }
  const std::uint32_t packets = end_packet - current_->first_packet;
  std::uint32_t state = current_->entry_state;
  if (packets > 0) {
    Block* part = part_of(*current_, packets);
    ++part->executions;
    state_.time += part->cycles;
    state = part->exit_state;
    if (trace_) {
      trace_->part(*part);
    }
  }
  if (trace_ && unfinished != nullptr) {
    trace_->undone(unfinished->site);
  }
  return state;
}

Block* Core::part_of(const Block& block, std::uint32_t packets) {
  Block*& part = parts_[{&block, packets}];
  if (part == nullptr) {
    blocks_.push_back(builder_.build(block.address, block.entry_state, packets));
    part = blocks_.back().get();
    // Nobody ever leaves it: what its last packet would cost then is not its own.
    part->fall_extra = 0;
    part->taken_extra = 0;
  }
  return part;
}

// Lets the running block end after the packet of `operation`.
void Core::end_block_after(const Operation& operation) {
  const std::uint32_t last = current_->first_packet + current_->packet_count - 1;
  if (operation.site == last) {
    return;
  }
  uproot();  // it stands further on
  Operation* next = current_->operations.get() + (&operation - current_->operations.get());
  while (next->site == operation.site) {
    ++next;
  }
  planted_ = next;
  uprooted_ = std::exchange(next->execute, stop_here);
}

void Core::uproot() {
  if (planted_ != nullptr) {
    std::exchange(planted_, nullptr)->execute = uprooted_;
  }
}

void Core::undo_packet(std::uint32_t packet) {
  if (saved_packet_ == packet) {
    saved_.time = state_.time;
    state_ = saved_;
  }
}

// So that they are decoded anew. Those that were run stay for their counts.
void Core::forget_blocks() {
  block_index_.clear();
  unchain_blocks();
}

// So that each looks its successors up again.
void Core::unchain_blocks() {
  for (const auto& block : blocks_) {
    block->exits = {};
  }
}

void Core::raise_exception(const Operation& operation, int cause, const std::string& what) const {
  if (events_.handler(kException) == 0) {
    fault(operation, what);
  }
  if (events_.level() <= kException) {
    fault(operation, fmt::format("double fault: exception {:#x} in the handler of {}: {}", cause,
                                 event_name(events_.level()), what));
  }
  throw Trap{.kind = Trap::Kind::exception, .operation = &operation, .cause = cause};
}

}  // namespace finback::core
