#include <fmt/format.h>
#include <utility>

#include <common/error.hpp>
#include <isa_sim/core/core.hpp>
#include <isa_sim/core/placed.hpp>
#include <isa_sim/core/trap.hpp>

namespace finback::core {

using isa::ExecutionState;
using isa::Operation;
using isa::SystemAction;

namespace {

constexpr Address kCoreRegisters = 0xFFE00000;

}  // namespace

// The instructions' way into the core.
struct Core::Hooks {
  static Core& core(ExecutionState& state) { return *static_cast<Core*>(state.engine); }

  static std::uint8_t* slow_access(ExecutionState& state, const Operation& o, Address address,
                                   int bytes, bool write, bool continued) {
    Core& c = core(state);
    memory::Span* span = c.memory_.find_span(c.number_, address);
    const bool guarded = c.protection_.guards_data();
    if ((address & static_cast<Address>(bytes - 1)) != 0 ||
        (guarded && !c.protection_.allows(address, write, !c.events_.user_mode()))) {
      c.check_access(o, address, bytes, write);
    }
    if (span == nullptr || c.memory_.refuses(*span, write)) {
      return c.no_memory(o, c.memory_.core_fault(c.number_, address, bytes, write));
    }
    if (MemoryWindow* window = memory::MemorySystem::window(c.number_, span)) {
      if (!c.store_buffer_.stalls() && !c.watched() &&
          (!guarded || c.protection_.open(span->base, span->size))) {
        o.window = window;
      }
      c.tell_access(o, address, bytes, write);
      if (c.memory_.dma_in_the_way(c.number_, address, c.now(o))) {
        c.add_stall(o, Cause::sub_bank, cycles_of(c.parameters_.sub_bank_dma), address);
      }
      if (c.store_buffer_.stalls()) {
        c.add_stall(o, Cause::store_buffer, c.store_buffer_.access(address, bytes, write, c.now(o)),
                    address);
      }
      ++(write ? window->writes : window->reads)[static_cast<std::size_t>(bytes / 2)];
      return span->at(address);
    }
    if (c.memory_.data_cache_on(c.number_)) {
      const memory::CachePolicy policy = c.cache_policy(span->level, address);
      if (policy != memory::CachePolicy::uncached) {
        return c.cached_access(o, span, address, bytes, write, continued, policy);
      }
    }
    return far_access(c, o, span, address, bytes, write, continued);
  }

  // To L2 or L3, past the data cache.
  static std::uint8_t* far_access(Core& c, const Operation& o, memory::Span* span, Address address,
                                  int bytes, bool write, bool continued) {
    const bool far = span->level == memory::Level::l3;
    if (!continued &&
        (c.wait_for_turn(o) || (far && !write && c.give_way(o, span, address, Cause::l3_read)))) {
      return nullptr;
    }
    c.tell_access(o, address, bytes, write);
    if (c.memory_.watching()) {
      const auto size = static_cast<std::uint32_t>(bytes);
      write ? c.memory_.note_write(address, size, c.accessor(o))
            : c.memory_.note_read(address, size, c.accessor(o), c.now(o));
    }
    c.add_far_bytes(o, static_cast<std::size_t>(span->level), bytes);
    if (write) {
      c.add_stall(o, far ? Cause::l3_write : Cause::l2_write,
                  c.memory_.core_write(c.number_, span, address, bytes, c.now(o)), address);
    } else {
      c.add_stall(o, far ? Cause::l3_read : Cause::l2_read,
                  c.memory_.core_read(c.number_, span, address, bytes, c.now(o)), address);
    }
    return span->at(address);
  }

  static bool device_read(ExecutionState& state, const Operation& o, Address address, int bytes,
                          std::uint32_t& value) {
    Core& c = core(state);
    if (c.wait_for_turn(o)) {
      return false;
    }
    c.check_access(o, address, bytes, false);
    c.tell_device_access(o, address, false);
    if (address >= kCoreRegisters) {
      if (!c.read_register(o, address, bytes, value)) {
        c.no_register(o, address, bytes, false);
      }
      c.add_far_bytes(o, kDeviceBytes, bytes);
      c.add_stall(o, Cause::device, c.core_register_stall_, address);
      return true;
    }
    c.guarded(o, [&] {
      const SystemPort::Read read = c.port_.device_read(c.number_, address, bytes, c.now(o));
      value = read.value;
      c.add_stall(o, Cause::device, read.stall, address);
    });
    c.add_far_bytes(o, kDeviceBytes, bytes);
    return true;
  }

  static bool device_write(ExecutionState& state, const Operation& o, Address address, int bytes,
                           std::uint32_t value) {
    Core& c = core(state);
    if (c.wait_for_turn(o)) {
      return false;
    }
    c.check_access(o, address, bytes, true);
    c.tell_device_access(o, address, true);
    if (address >= kCoreRegisters) {
      if (!c.write_register(o, address, bytes, value)) {
        c.no_register(o, address, bytes, true);
      }
      c.add_far_bytes(o, kDeviceBytes, bytes);
      c.add_stall(o, Cause::device, c.core_register_stall_, address);
      c.turn_.horizon = 0;
      return true;
    }
    c.device_write_packet_ = o.site;
    c.guarded(o, [&] {
      c.add_stall(o, Cause::device,
                  c.port_.device_write(c.number_, address, bytes, value, c.now(o)), address);
    });
    c.add_far_bytes(o, kDeviceBytes, bytes);
    return true;
  }

  static bool test_and_set(ExecutionState& state, const Operation& o, Address address,
                           std::uint8_t& old) {
    Core& c = core(state);
    memory::Span* span = c.memory_.find_span(c.number_, address);
    if (span == nullptr) {
      c.fault(o, c.memory_.core_fault(c.number_, address, 1, true));
    }
    if (MemoryWindow* window = memory::MemorySystem::window(c.number_, span)) {
      // Nobody else sees the core's own memory: there it needs no lock.
      ++window->reads[0];
      ++window->writes[0];
      old = std::exchange(*span->at(address), static_cast<std::uint8_t>(*span->at(address) | 0x80));
      return true;
    }
    if (c.wait_for_turn(o)) {
      return false;
    }
    if (c.watched()) {
      c.memory_.observer()->core_lock(c.number_, o.site, address, c.now(o));
    }
    c.guarded(o, [&] {
      const bool far = span->level == memory::Level::l3;
      c.add_stall(o, far ? Cause::l3_read : Cause::l2_read,
                  c.memory_.core_test_and_set(c.number_, span, address, c.now(o)), address);
    });
    if (c.memory_.watching()) {
      c.memory_.note_read(address, 1, c.accessor(o), c.now(o));
      c.memory_.note_write(address, 1, c.accessor(o));
    }
    c.add_far_bytes(o, static_cast<std::size_t>(span->level), 2);
    std::uint8_t& byte = *span->at(address);
    old = byte;
    byte |= 0x80;
    return true;
  }

  static void system(ExecutionState& state, const Operation& o, SystemAction action,
                     std::uint32_t value) {
    core(state).act(o, action, value);
  }

  // Operands {address, fetches, level}.
  static const Operation* fetch(ExecutionState& state, const Operation* o) {
    return core(state).fetch_code(*o) ? o + 1 : nullptr;
  }

  // Two accesses of one packet: operands {register, offset, register, offset}.
  static const Operation* packet_conflict(ExecutionState& state, const Operation* o) {
    Core& c = core(state);
    const auto address = [&](int base) {
      return state.reg[static_cast<std::size_t>((*o)[base])] + static_cast<Address>((*o)[base + 1]);
    };
    const Address first = address(0);
    const Address second = address(2);
    const Address bank_bytes = static_cast<Address>(std::int64_t{c.parameters_.sub_bank_bytes});
    if (((first ^ second) & 4) != 0 ||
        (first / bank_bytes != second / bank_bytes && !c.memory_.data_cache_on(c.number_))) {
      return o + 1;
    }
    const std::optional<Address> one = c.place_in_l1(first);
    const std::optional<Address> other = c.place_in_l1(second);
    if (one && other && *one / bank_bytes == *other / bank_bytes) {
      c.add_stall(*o, Cause::sub_bank, cycles_of(c.parameters_.sub_bank_conflict), second);
    }
    return o + 1;
  }
};

Core::Core(CoreId id, const ir::CoreImage& image, const CoreParameters& parameters,
           Cycles core_register_stall, memory::MemorySystem& memory, SystemPort& port)
    : id_(id),
      number_(static_cast<int>(id)),
      image_(image),
      parameters_(parameters),
      core_register_stall_(core_register_stall),
      memory_(memory),
      port_(port),
      hooks_{Hooks::slow_access, Hooks::device_read, Hooks::device_write, Hooks::test_and_set,
             Hooks::system},
      store_buffer_(parameters),
      calls_(image.functions.size()),
      builder_(image, parameters, memory, Hooks::packet_conflict, Hooks::fetch),
      dynamic_(image.packets.size()),
      far_bytes_(image.packets.size()) {
  state_.hooks = &hooks_;
  state_.engine = this;
  if (parameters.sub_bank_dma > 0) {
    memory.mind_sub_banks(number_,
                          static_cast<std::uint32_t>(std::int64_t{parameters.sub_bank_bytes}));
  }
}

void Core::start(Cycles at, const Start& how) {
  started_ = true;
  started_at_ = at;
  if (const int banks = memory_.default_data_banks(); banks > 0) {
    protection_.set_cache_banks(banks);
    memory_.configure_data_cache(number_, banks, false, {}, at);
  }
  if (memory_.default_code_cache()) {
    protection_.set_code_cache();
    configure_code_cache();
  }
  state_.time = at;
  state_.reg[isa::SP] = image_.stack_top;
  state_.reg[isa::FP] = image_.stack_top;
  state_.reg[isa::USP] = image_.stack_top;
  kernel_sp_ = image_.stack_top;
  state_.reg[isa::SYSCFG] = how.system_config;
  cycles_run_ = (how.system_config & kCycleCounterEnable) != 0;
  events_.start(how.pending);
  if (builder_.packet_at(image_.entry) == BlockBuilder::kNoPacket) {
    throw GuestFault(fmt::format("{}: the program begins at {:#010x}, where no instruction is",
                                 name_of(id_), image_.entry));
  }
  current_ = block_at(image_.entry, PipelineStates::kEmpty);
  calls_.start(current_->function, at);
}

void Core::run(const Turn& turn) {
  turn_ = turn;
  if (timer_.next_event() != kNever) {
    turn_.horizon =
        std::min(turn_.horizon, std::max(timer_.next_event(), kTimerMargin) - kTimerMargin);
  }
  try {
    trace_ ? run_blocks<true>() : run_blocks<false>();
  } catch (const Trap& trap) {
    handle(trap);
  } catch (const FaultAt& fault) {
    if (trace_) {  // what came before it in its block is worth seeing
      cut_block(fault.operation->site, fault.operation);
    }
    throw;
  }
}

template <bool traced>
void Core::run_blocks() {
  const Operation* operation = std::exchange(state_.retry, nullptr);
  if (operation == nullptr) {
    take_due_events();
    if constexpr (traced) {
      trace_->begin(state_.time);
    }
    operation = current_->operations.get();
    state_.next_address = current_->end;
  } else if (events_.pending_event(state_.interrupt_mask) >= 0) {
    turn_.horizon = 0;  // finish the block first
  }
  for (;;) {
    while (operation != nullptr) {
      operation = operation->execute(state_, operation);
    }
    if (state_.retry != nullptr) {
      return;
    }
    finish_block<traced>(*current_);
    if (state_.time >= turn_.horizon) {
      return;
    }
    if constexpr (traced) {
      trace_->begin(state_.time);
    }
    operation = current_->operations.get();
    state_.next_address = current_->end;
  }
}

template <bool traced>
void Core::finish_block(Block& block) {
  ++block.executions;
  Address next = state_.next_address;
  const bool taken = next != block.end;
  if constexpr (traced) {
    trace_->block(block, taken);
  }
  if (taken) {
    ++block.taken;
    state_.time += block.cycles + block.taken_extra;
  } else {
    state_.time += block.cycles + block.fall_extra;
    if (block.may_end_loop && loop_back(block)) {
      next = state_.next_address;
    }
  }
  current_ = successor(block, next, taken);
  if (block.ends >= BlockEnd::call) {
    note_call_or_return(block, next);
  }
}

Block* Core::successor(Block& block, Address next, bool refill) {
  for (Block::Exit& exit : block.exits) {
    if (exit.block != nullptr && exit.address == next) {
      return exit.block;
    }
  }
  Block* found = block_at(next, refill ? PipelineStates::kRefilled : block.exit_state);
  // The newest successor stays; a return's two callers at hand are enough.
  std::swap(block.exits[0], block.exits[1]);
  block.exits[0] = {next, found};
  return found;
}

Block* Core::block_at(Address address, std::uint32_t state) {
  constexpr int kStyleBits = 2;
  state = builder_.entry_state(address, state);
  const std::uint64_t key = (std::uint64_t{state} << kStyleBits | builder_.style()) << 32 | address;
  const auto known = block_index_.find(key);
  if (known != block_index_.end()) {
    return known->second;
  }
  std::unique_ptr<Block> block = builder_.build(address, state);
  if (block == nullptr) {
    throw Trap{.kind = Trap::Kind::fetch, .address = address};
  }
  blocks_.push_back(std::move(block));
  block_index_.emplace(key, blocks_.back().get());
  return blocks_.back().get();
}

// Loop 1 is looked at first, so that the inner of two loops with one bottom is loop 1
// (hardware.md 1.4).
bool Core::loop_back(const Block& block) {
  constexpr std::size_t kLoops = 2;
  auto& reg = state_.reg;
  for (std::size_t loop = kLoops; loop-- > 0;) {
    if (reg[isa::LC0 + loop] != 0 && reg[isa::LB0 + loop] == block.last_packet_address &&
        --reg[isa::LC0 + loop] != 0) {
      state_.next_address = reg[isa::LT0 + loop];
      return true;
    }
  }
  return false;
}

void Core::note_call_or_return(const Block& block, Address next) {
  switch (block.ends) {
    case BlockEnd::call:
      calls_.call(current_->function, state_.reg[isa::RETS], state_.time);
      break;
    case BlockEnd::ret:
      calls_.ret(next, state_.time);
      break;
    case BlockEnd::ret_event:
      calls_.leave_interrupt(state_.time);
      break;
    default:
      break;
  }
}

void Core::shorten_turn(Cycles until) {
  turn_.horizon = std::min(turn_.horizon, until);
  turn_.shared_until = std::min(turn_.shared_until, until);
}

void Core::set_requests(std::uint32_t ivg_lines, bool wake_line, Cycles at) {
  events_.set_requests(ivg_lines);
  wake_line_ = wake_line;
  if (sleeping_ && (wake_line || events_.wants_attention(state_.interrupt_mask))) {
    wake(at);
  }
  turn_.horizon = 0;
}

void Core::latch_request(int event, Cycles at) {
  events_.raise(event);
  if (sleeping_ && (event == kNonMaskable || events_.wants_attention(state_.interrupt_mask))) {
    wake(at);
  }
  turn_.horizon = 0;
}

void Core::wake(Cycles at) {
  settle(at);
  sleeping_ = false;
  pass(TraceRecord::Kind::sleep, idle_packet_, Cause::idle, cycles_of(parameters_.idle_wake));
}

void Core::settle(Cycles at) {
  if (sleeping_ && at > state_.time) {
    pass(TraceRecord::Kind::sleep, idle_packet_, Cause::idle, at - state_.time);
  }
}

void Core::stop_clock(Cycles at) {
  settle(at);
  clock_stopped_at_ = at;
}

void Core::start_clock(Cycles at) {
  const Cycles stood = at - std::exchange(clock_stopped_at_, kNever);
  settle(at);
  timer_.postpone(stood);
  if (cycles_run_) {
    cycle_base_ += stood;
  }
}

void Core::add_stall(const Operation& operation, Cause cause, Cycles cycles, Address address) {
  dynamic_[operation.site][static_cast<std::size_t>(cause)] += cycles;
  state_.time += cycles;
  if (trace_ && cycles > 0) {
    trace_->stall(operation.site, {.cause = cause, .cycles = cycles, .address = address});
  }
}

void Core::tell_access(const Operation& operation, Address address, int bytes, bool write) {
  if (watched()) {
    memory_.observer()->core_access(number_, operation.site, address, bytes,
                                    write ? memory::Direction::write : memory::Direction::read,
                                    now(operation));
  }
}

void Core::tell_device_access(const Operation& operation, Address address, bool write) {
  if (watched() && address < kCoreRegisters) {
    memory_.observer()->device_access(number_, operation.site, address,
                                      write ? memory::Direction::write : memory::Direction::read,
                                      now(operation));
  }
}

void Core::pass(TraceRecord::Kind kind, std::uint32_t packet, Cause cause, Cycles cycles) {
  if (trace_ && cycles > 0) {
    trace_->event(kind, packet, cause, state_.time, cycles);
  }
  dynamic_[packet][static_cast<std::size_t>(cause)] += cycles;
  state_.time += cycles;
}

bool Core::wait_for_turn(const Operation& operation) {
  if (now(operation) < turn_.shared_until) {
    return false;
  }
  state_.retry = &operation;
  return true;
}

std::optional<Address> Core::place_in_l1(Address address) {
  memory::Span* span = memory_.find_span(number_, address);
  if (span == nullptr) {
    return std::nullopt;
  }
  if (memory::MemorySystem::window(number_, span) != nullptr) {
    return address;
  }
  const bool cached = memory_.data_cache_on(number_) &&
                      cache_policy(span->level, address) != memory::CachePolicy::uncached;
  return cached ? std::optional(memory_.place_in_cache(number_, address)) : std::nullopt;
}

std::string Core::place(std::uint32_t packet) const {
  const ir::PlacedPacket& p = image_.packets[packet];
  std::string text = fmt::format("{} ({:#010x}", image_.functions[p.function].name, p.address);
  if (p.line > 0) {
    text += fmt::format(", {}:{}", image_.source_files[static_cast<std::size_t>(p.file)], p.line);
  }
  return text + ")";
}

std::string Core::device_writer() const {
  return fmt::format("{} in {}", name_of(id_), place(device_write_packet_));
}

void Core::fault(const Operation& operation, const std::string& what) const {
  throw FaultAt(fmt::format("{} in {}: {}", name_of(id_), place(operation.site), what), operation);
}

}  // namespace finback::core
