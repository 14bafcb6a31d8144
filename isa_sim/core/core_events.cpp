// Events as the core takes them: levels entered and left, modes and their stack pointers, what
// instructions ask of the system.
#include <fmt/format.h>
#include <utility>

#include <common/error.hpp>
#include <isa_sim/core/core.hpp>
#include <isa_sim/core/placed.hpp>
#include <isa_sim/core/trap.hpp>

namespace finback::core {

using isa::Operation;
using isa::SystemAction;

namespace {

isa::Register return_register(int event) {
  switch (event) {
    case kEmulation:
      return isa::RETE;
    case kNonMaskable:
      return isa::RETN;
    case kException:
      return isa::RETX;
    default:
      return isa::RETI;
  }
}

struct Return {
  std::string_view name;
  int from;  // the level that it leaves; kUser: that of an interrupt or reset
};

Return return_of(SystemAction action) {
  switch (action) {
    case SystemAction::return_from_exception:
      return {"RTX", kException};
    case SystemAction::return_from_nmi:
      return {"RTN", kNonMaskable};
    case SystemAction::return_from_emulation:
      return {"RTE", kEmulation};
    default:
      return {"RTI", kUser};
  }
}

}  // namespace

// Between blocks: whatever shall happen before the next one.
void Core::take_due_events() {
  if (timer_.next_event() != kNever) {
    check_timer(state_.time);
  }
  if (exception_due_ >= 0) {
    enter_exception(std::exchange(exception_due_, -1), current_->address);
  } else if (step_due_ && events_.level() > kException) {
    enter_exception(kSingleStep, current_->address);
  }
  const int event = events_.pending_event(state_.interrupt_mask);
  if (event >= 0) {
    enter(event, current_->address);
  }
  if (protection_.guards_fetch()) {
    turn_.horizon = 0;
    if (const int cause = protection_.check_fetch(current_->address, !events_.user_mode())) {
      if (events_.handler(kException) == 0 || events_.level() <= kException) {
        throw GuestFault(fmt::format("{}: the fetch at {} is exception {:#x}", name_of(id_),
                                     place(current_->first_packet), cause));
      }
      enter_exception(cause, current_->address);
    }
  }
  step_due_ = single_step_ && events_.level() > kException;
  if (step_due_) {
    turn_.horizon = 0;
  }
  if (timer_.next_event() != kNever) {
    stop_at_timer();
  }
}

void Core::check_timer(Cycles at) {
  while (timer_.next_event() <= at) {
    timer_.expire();
    events_.raise(kCoreTimer);
  }
}

// Close to the timer's next request the blocks run one by one, and the one in which it comes ends
// there.
void Core::stop_at_timer() {
  uproot();
  const Cycles wait = timer_.next_event() - state_.time;
  if (wait > kTimerMargin) {
    return;
  }
  turn_.horizon = 0;
  if (wait < current_->cycles) {
    const Operation* last = current_->operations.get();
    for (const Operation* o = last; o->execute != BlockBuilder::leave(); ++o) {
      if (o->cycle >= wait) {
        break;
      }
      last = o;
    }
    end_block_after(*last);
  }
}

Cycles Core::next_event_time() const {
  const bool wakes = sleeping_ && !halted_ && clock_stopped_at_ == kNever &&
                     (state_.interrupt_mask >> kCoreTimer & 1U) != 0;
  return wakes ? timer_.next_event() : kNever;
}

void Core::advance(Cycles now) {
  check_timer(now);
  if (sleeping_ && events_.wants_attention(state_.interrupt_mask)) {
    wake(now);
  }
}

void Core::enter(int event, Address back) {
  const int from = events_.level();
  if (event == kReset) {
    port_.halt(number_, 0, "", state_.time);
    throw Trap{.kind = Trap::Kind::halted};
  }
  auto& reg = state_.reg;
  if (from == kUser) {
    // A loop of the user's does not reach into the supervisor's code.
    reg[isa::LB0] |= 1U;
    reg[isa::LB1] |= 1U;
    reg[isa::USP] = std::exchange(reg[isa::SP], kernel_sp_);
  }
  const Address handler = events_.enter(event);
  reg[return_register(event)] = back | (event == from ? 1U : 0U);
  if (builder_.packet_at(handler) == BlockBuilder::kNoPacket) {
    if (event > kException && handler != 0 && events_.handler(kException) != 0) {
      enter_exception(kUndefinedInstruction, handler);
      return;
    }
    throw GuestFault(fmt::format(
        "{}: interrupt {} at {}, but EVT{} holds {:#010x}, where no instruction is", name_of(id_),
        event_name(event), place(current_->first_packet), event, handler));
  }
  current_ = block_at(handler, PipelineStates::kRefilled);
  calls_.enter_interrupt(current_->function, back, state_.time);
  if (memory_.observer() != nullptr) {
    port_.interrupt_taken(number_);
  }
  pass(TraceRecord::Kind::entry, current_->first_packet, Cause::interrupt_entry,
       cycles_of(parameters_.interrupt_entry));
}

void Core::enter_exception(int cause, Address back) {
  if (cause != kFetchMiss && cause != kFetchProtection && cause != kFetchMultipleHits) {
    protection_.note_instruction(back, !events_.user_mode());
  }
  std::uint32_t& status = state_.reg[isa::SEQSTAT];
  status = (status & ~kExceptionCauseBits) | static_cast<std::uint32_t>(cause);
  enter(kException, back);
}

void Core::leave_event(const Operation& operation, SystemAction action) {
  const Return instruction = return_of(action);
  const int level = events_.level();
  const bool from_interrupt = level == kReset || (level >= kHardwareError && level < kUser);
  if (instruction.from == kUser ? !from_interrupt : level != instruction.from) {
    raise_exception(operation, kSupervisorResource,
                    level == kUser ? fmt::format("{} in user mode", instruction.name)
                                   : fmt::format("{} in the handler of {}", instruction.name,
                                                 event_name(level)));
  }
  const bool keep = (state_.next_address & 1U) != 0;
  state_.next_address &= ~1U;
  events_.leave(keep);
  if (events_.user_mode()) {
    auto& reg = state_.reg;
    reg[isa::LB0] &= ~1U;
    reg[isa::LB1] &= ~1U;
    kernel_sp_ = std::exchange(reg[isa::SP], reg[isa::USP]);
  }
  turn_.horizon = 0;
}

void Core::require_supervisor(const Operation& operation, const char* what) const {
  if (events_.user_mode()) {
    raise_exception(operation, kSupervisorResource, fmt::format("{} in user mode", what));
  }
}

// The chip tells of an access to no memory by a hardware error, some time after it.
std::uint8_t* Core::no_memory(const Operation& operation, const std::string& what) {
  if (events_.handler(kHardwareError) == 0) {
    fault(operation, what);
  }
  set_hardware_error(kExternalAddress);
  look_for_events(operation);
  nowhere_ = 0;
  return reinterpret_cast<std::uint8_t*>(&nowhere_);
}

void Core::set_hardware_error(std::uint32_t cause) {
  std::uint32_t& status = state_.reg[isa::SEQSTAT];
  status = (status & ~kHardwareCauseBits) | cause << kHardwareCauseShift;
  events_.raise(kHardwareError);
}

void Core::look_for_events(const Operation& operation) {
  if (events_.pending_event(state_.interrupt_mask) >= 0) {
    turn_.horizon = 0;
    end_block_after(operation);
  }
}

void Core::raise(const Operation& operation, int event) {
  require_supervisor(operation, "RAISE");
  if (event == kHardwareError) {
    set_hardware_error(kRaised);
  } else if (event != kEmulation && event != kGlobalDisable) {
    events_.raise(event);
  }
  turn_.horizon = 0;
}

// EXCPT: its handler runs after this block, which it ends.
void Core::except(const Operation& operation, int cause) {
  if (events_.handler(kException) != 0) {
    if (events_.level() <= kException) {
      fault(operation, fmt::format("double fault: EXCPT {} in the handler of {}", cause,
                                   event_name(events_.level())));
    }
    exception_due_ = cause;
    turn_.horizon = 0;
    return;
  }
  if (wait_for_turn(operation)) {
    return;
  }
  SystemPort::HostCall call = SystemPort::HostCall::none;
  if (cause == 0) {
    memory_.show_cache(number_);
    call = port_.host_call(number_, state_, now(operation));
    memory_.update_cache(number_);
  }
  if (call == SystemPort::HostCall::none) {
    fault(operation,
          fmt::format("EXCPT {}, but EVT3 is 0: no exception handler is installed", cause));
  }
  if (call == SystemPort::HostCall::ended) {
    throw Trap{.kind = Trap::Kind::halted, .operation = &operation};
  }
}

void Core::configure(const Operation& operation) {
  const std::uint32_t config = state_.reg[isa::SYSCFG];
  events_.set_self_nesting((config & kSelfNestingEnable) != 0);
  const bool run = (config & kCycleCounterEnable) != 0;
  if (run != cycles_run_) {
    const Cycles count = cycle_count(operation);
    cycles_run_ = run;
    set_cycle_count(operation, count);
  }
  single_step_ = (config & kSingleStepEnable) != 0;
  choose_block_style(operation);
  look_for_events(operation);
}

// Single steps and checked fetches need blocks of one packet, exceptions packets that can be
// undone.
void Core::choose_block_style(const Operation& operation) {
  const bool save = events_.handler(kException) != 0;
  const bool one_by_one = single_step_ || protection_.guards_fetch();
  const std::uint32_t packets = one_by_one ? 1 : BlockBuilder::kMaxPackets;
  if (builder_.set_style(packets, save ? save_packet : nullptr)) {
    unchain_blocks();
    turn_.horizon = 0;
    end_block_after(operation);
  }
}

void Core::set_cycle_count(const Operation& operation, Cycles count) {
  cycle_base_ = cycles_run_ ? now(operation) - count : count;
}

void Core::fall_asleep(const Operation& operation) {
  require_supervisor(operation, "IDLE");
  if (!wake_line_ && !events_.wants_attention(state_.interrupt_mask)) {
    sleeping_ = true;
    idle_packet_ = operation.site;
    turn_.horizon = 0;
  }
}

void Core::drain_writes(const Operation& operation) {
  const Cycles drained =
      std::max(memory_.writes_drained_at(number_), port_.device_writes_drained_at(number_));
  if (drained > now(operation)) {
    add_stall(operation, Cause::device, drained - now(operation));
  }
}

void Core::act(const Operation& operation, SystemAction action, std::uint32_t value) {
  switch (action) {
    case SystemAction::idle:
      fall_asleep(operation);
      break;
    case SystemAction::core_sync:
      break;
    case SystemAction::disable_interrupts:
      require_supervisor(operation, "CLI");
      break;
    case SystemAction::system_sync:
      drain_writes(operation);
      break;
    case SystemAction::enable_interrupts:
      require_supervisor(operation, "STI");
      turn_.horizon = 0;
      break;
    case SystemAction::raise:
      raise(operation, static_cast<int>(value));
      break;
    case SystemAction::exception:
      except(operation, static_cast<int>(value));
      break;
    case SystemAction::return_from_interrupt:
    case SystemAction::return_from_exception:
    case SystemAction::return_from_nmi:
    case SystemAction::return_from_emulation:
      leave_event(operation, action);
      break;
    case SystemAction::loop_bottom:
      if (builder_.add_loop_bottom(value)) {
        forget_blocks();
        end_block_after(operation);
      }
      break;
    case SystemAction::privileged:
      require_supervisor(operation, "a supervisor's register");
      break;
    case SystemAction::pop_usp:
      if (events_.user_mode()) {
        raise_exception(operation, kIllegalCombination, "a pop of USP in user mode");
      }
      break;
    case SystemAction::configure:
      configure(operation);
      break;
    case SystemAction::read_cycles: {
      const Cycles count = cycle_count(operation);
      state_.reg[isa::CYCLES] = static_cast<std::uint32_t>(count);
      state_.reg[isa::CYCLES2] = static_cast<std::uint32_t>(count >> 32);
      break;
    }
    case SystemAction::write_cycles:
      set_cycle_count(operation, (cycle_count(operation) & ~Cycles{0xFFFFFFFF}) | value);
      break;
    case SystemAction::write_cycles2:
      set_cycle_count(operation, (cycle_count(operation) & 0xFFFFFFFF) | Cycles{value} << 32);
      break;
    case SystemAction::saved_return:
      events_.hold_interrupts(false);
      look_for_events(operation);
      break;
    case SystemAction::loaded_return:
      events_.hold_interrupts(true);
      break;
    case SystemAction::prefetch_line:
    case SystemAction::flush_line:
    case SystemAction::flush_invalidate_line:
      move_line(operation, action, value);
      break;
    case SystemAction::flush_code_line:
      memory_.forget_code(number_, value);
      break;
    case SystemAction::assertion_failed:
    case SystemAction::print_register:
    case SystemAction::print_registers:
    case SystemAction::print_halves:
    case SystemAction::print_character:
    case SystemAction::halt:
    case SystemAction::emulation:
      debug(operation, action, value);
      break;
  }
}

}  // namespace finback::core
