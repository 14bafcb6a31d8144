#include <algorithm>

#include <isa_sim/core/block_builder.hpp>
#include <isa_sim/core/placed.hpp>

namespace finback::core {

using isa::Flow;
using isa::Instruction;
using isa::MemoryUse;
using isa::Operation;

namespace {

bool is_nop(const Instruction& info) {
  return info.energy == isa::Energy::nop &&
         (info.slot == isa::Slot::nop || info.slot == isa::Slot::dsp);
}

// In a packet everybody reads before anybody writes. Run one after the other that holds in this
// order: the DSP slot reads and writes data registers, loads only write them and read memory,
// stores write memory, and a step of an index register comes after the access that goes through it
// (no two slots write the same register). What a store reads is saved first where another slot
// writes it.
int order_in_packet(const Instruction& info) {
  switch (info.memory) {
    case MemoryUse::load:
    case MemoryUse::load_store:
      return 1;
    case MemoryUse::store:
      return 2;
    case MemoryUse::none:
      break;
  }
  return info.slot == isa::Slot::access ? 3 : 0;
}

bool writes_register(const ir::PlacedInstruction& instruction, int reg) {
  bool writes = false;
  for_each_operand(instruction, [&](const isa::OperandRole& role, std::int32_t value) {
    for_each_register(role, value, [&](int other) { writes |= role.written && other == reg; });
  });
  return writes;
}

// Index of the operand that a store takes its value from: its last.
std::size_t stored_operand(const ir::PlacedInstruction& store) {
  return static_cast<std::size_t>(isa::roles_of(store.instruction).count - 1);
}

const Operation* save_stored(isa::ExecutionState& state, const Operation* operation) {
  state.reg[isa::kScratchRegister] = state.reg[static_cast<std::size_t>((*operation)[0])];
  return operation + 1;
}

Flow flow_of(const ir::PlacedPacket& packet) { return info_of(packet.slots[0]).flow; }

bool ends_block(Flow flow) { return flow != Flow::none && flow != Flow::loop_setup; }

// Stands before a change of flow at the bottom of a loop and carries it out: where control leaves,
// the pass counts, but does not lead to the top. What is called from there returns to where the
// pass would have led.
template <bool call>
const Operation* leave_bottom(isa::ExecutionState& state, const Operation* operation) {
  const Operation* flow = operation + 1;
  flow->execute(state, flow);
  if (state.retry != nullptr || state.next_address == flow->address + flow->length) {
    return nullptr;
  }
  auto& reg = state.reg;
  for (const std::size_t loop : {std::size_t{1}, std::size_t{0}}) {
    if (reg[isa::LC0 + loop] == 0 || reg[isa::LB0 + loop] != flow->address) {
      continue;
    }
    if (--reg[isa::LC0 + loop] != 0) {
      if (call) {
        reg[isa::RETS] = reg[isa::LT0 + loop];
      }
      break;
    }
  }
  return nullptr;
}

// Control leaves anyway, be it to the very next packet.
void refill_always(Block& block, Cycles cycles) {
  block.taken_extra = cycles;
  block.fall_extra = cycles;
  block.fall_cause = Cause::branch_taken;
}

const Operation* leave_block(isa::ExecutionState&, const Operation*) { return nullptr; }

}  // namespace

MemoryWindow* no_window() {
  static MemoryWindow window;
  return &window;
}

isa::Execute BlockBuilder::leave() { return leave_block; }

struct BlockBuilder::Draft {
  std::unique_ptr<Block> block;
  std::vector<Operation> operations;
  PipelineState state;
  Address fetched_to = 0;  // end of the last line fetched
};

BlockBuilder::BlockBuilder(const ir::CoreImage& image, const CoreParameters& parameters,
                           const memory::MemorySystem& memory, isa::Execute conflict,
                           isa::Execute fetch)
    : image_(image),
      parameters_(parameters),
      memory_(memory),
      conflict_(conflict),
      fetch_(fetch),
      pipeline_(parameters) {
  packet_index_.reserve(image.packets.size());
  for (std::uint32_t index = 0; index < image.packets.size(); ++index) {
    const ir::PlacedPacket& packet = image.packets[index];
    packet_index_.emplace(packet.address, index);
    if (flow_of(packet) == Flow::loop_setup) {
      loop_bottoms_.insert(static_cast<Address>(packet.slots[0].operand[1]));
    }
  }
}

std::uint32_t BlockBuilder::packet_at(Address address) const {
  const auto found = packet_index_.find(address);
  return found == packet_index_.end() ? kNoPacket : found->second;
}

std::uint32_t BlockBuilder::entry_state(Address address, std::uint32_t state) {
  const std::uint32_t index = packet_at(address);
  if (!states_.state(state).refilled() ||
      (index != kNoPacket && pipeline_.target_stall(image_.packets[index]) > 0)) {
    return state;
  }
  PipelineState same = states_.state(state);
  same.set_refilled(false);
  return states_.number_of(same);
}

std::unique_ptr<Block> BlockBuilder::build(Address address, std::uint32_t state,
                                           std::uint32_t packets) {
  const std::uint32_t first = packet_at(address);
  if (first == kNoPacket) {
    return nullptr;
  }
  Draft draft{std::make_unique<Block>(), {}, states_.state(state), 0};
  Block& block = *draft.block;
  block.address = address;
  block.entry_state = state;
  block.first_packet = first;
  block.function = image_.packets[first].function;
  const ir::PlacedPacket* last = nullptr;
  const bool natural = packets == 0;
  const std::uint32_t end = first + (natural ? max_packets_ : packets);
  for (std::uint32_t index = first; index < image_.packets.size() && index < end; ++index) {
    const ir::PlacedPacket& packet = image_.packets[index];
    if (last != nullptr &&
        (packet.function != block.function || packet.address != last->address + last->length)) {
      break;
    }
    add_packet(draft, index);
    last = &packet;
    if (natural && (ends_block(flow_of(packet)) || loop_bottoms_.contains(packet.address))) {
      break;
    }
  }
  block.last_packet_address = last->address;
  block.end = last->address + last->length;
  block.may_end_loop = loop_bottoms_.contains(last->address);
  const bool refills = set_exit(block, *last);
  if (block.may_end_loop && block.ends != BlockEnd::falls_through) {
    Operation bottom = draft.operations.back();
    bottom.execute = block.ends == BlockEnd::call ? leave_bottom<true> : leave_bottom<false>;
    draft.operations.insert(draft.operations.end() - 1, bottom);
  }
  draft.state.advance(block.fall_extra);
  draft.state.set_refilled(refills);
  block.exit_state = states_.number_of(draft.state);
  Operation leave;
  leave.execute = leave_block;
  draft.operations.push_back(leave);
  block.operations = std::make_unique<Operation[]>(draft.operations.size());
  std::ranges::copy(draft.operations, block.operations.get());
  return std::move(draft.block);
}

void BlockBuilder::add_packet(Draft& draft, std::uint32_t index) const {
  const ir::PlacedPacket& packet = image_.packets[index];
  Block& block = *draft.block;
  ++block.packet_count;
  add_fetch(draft, packet, index);
  const PacketCost cost = pipeline_.issue(packet, draft.state);
  if (cost.stall > 0) {
    block.costs.push_back(
        {index, cost.stall_cause, static_cast<std::uint32_t>(cost.stall), cost.stall_register});
  }
  block.costs.push_back({index, Cause::issue, 1});
  if (cost.issue > 1) {
    block.costs.push_back({index, Cause::multi_cycle, static_cast<std::uint32_t>(cost.issue - 1)});
  }
  block.cycles += cost.stall;
  add_operations(draft, packet, index, block.cycles);
  block.cycles += cost.issue;
}

void BlockBuilder::add_fetch(Draft& draft, const ir::PlacedPacket& packet,
                             std::uint32_t index) const {
  const bool led_to = draft.state.refilled();
  draft.state.set_refilled(false);
  const memory::Region* region = memory_.map().find(packet.address);
  if (region == nullptr || region->level == memory::Level::l1) {
    if (const Cycles stall = led_to ? pipeline_.target_stall(packet) : 0; stall > 0) {
      draft.block->cycles += stall;
      draft.block->costs.push_back({index, Cause::fetch, static_cast<std::uint32_t>(stall)});
      draft.state.advance(stall);
    }
    return;
  }
  const auto bytes = static_cast<Address>(std::int64_t{parameters_.fetch_bytes});
  const Address from = std::max(packet.address / bytes * bytes, draft.fetched_to);
  const Address to = (packet.address + packet.length + bytes - 1) / bytes * bytes;
  if (to <= from) {
    return;
  }
  draft.fetched_to = to;
  Operation fetch;
  fetch.execute = fetch_;
  fetch.operand = {static_cast<std::int32_t>(from), static_cast<std::int32_t>((to - from) / bytes),
                   static_cast<std::int32_t>(region->level)};
  fetch.window = no_window();
  fetch.site = index;
  fetch.cycle = static_cast<std::uint16_t>(draft.block->cycles);
  fetch.address = packet.address;
  draft.operations.push_back(fetch);
}

void BlockBuilder::add_operations(Draft& draft, const ir::PlacedPacket& packet, std::uint32_t index,
                                  Cycles cycle) const {
  Block& block = *draft.block;
  std::array<const ir::PlacedInstruction*, 3> order{};
  std::size_t count = 0;
  int accesses = 0;
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    const Instruction& info = info_of(packet.slots[slot]);
    ++block.by_energy_class[static_cast<std::size_t>(info.energy)];
    if (packet.count > 1 && is_nop(info)) {
      continue;
    }
    ++block.instructions;
    accesses += info.memory != MemoryUse::none;
    order[count++] = &packet.slots[slot];
  }
  std::stable_sort(order.begin(), order.begin() + count, [](const auto* left, const auto* right) {
    return order_in_packet(info_of(*left)) < order_in_packet(info_of(*right));
  });
  if (save_ != nullptr && may_be_undone(packet)) {
    Operation save;
    save.execute = save_;
    save.site = index;
    save.address = packet.address;
    draft.operations.push_back(save);
  }
  if (accesses > 1) {
    add_conflict_check(draft, packet, index, cycle);
  }
  for (std::size_t i = 0; i < count; ++i) {
    Operation operation = operation_of(*order[i], packet);
    operation.window = no_window();
    operation.site = index;
    operation.cycle = static_cast<std::uint16_t>(cycle);
    operation.access_bytes = static_cast<std::uint8_t>(access_bytes(*order[i]));
    if (i > 0 && info_of(*order[i]).memory == MemoryUse::store) {
      save_store_source(draft, std::span(order).first(count), *order[i], operation);
    }
    draft.operations.push_back(operation);
  }
}

// Saves the value that `store` writes before the packet's first operation, when another slot
// changes its register; the store's operation then takes it from the scratch register.
void BlockBuilder::save_store_source(Draft& draft, std::span<const ir::PlacedInstruction*> packet,
                                     const ir::PlacedInstruction& store, Operation& operation) {
  std::int32_t& source = operation.operand[stored_operand(store)];
  const int reg = isa::register_of(source);
  std::size_t before = 0;  // operations of this packet that already stand in the draft
  bool changed = false;
  for (const ir::PlacedInstruction* other : packet) {
    if (other == &store) {
      break;
    }
    ++before;
    changed |= writes_register(*other, reg);
  }
  if (!changed) {
    return;
  }
  Operation save;
  save.execute = save_stored;
  save.operand[0] = reg;
  draft.operations.insert(draft.operations.end() - static_cast<std::ptrdiff_t>(before), save);
  source = isa::kScratchRegister | (source & isa::kHighHalf);
}

// Its operations may have changed registers when a later access, or the fetch of where it calls,
// turns out to be an exception.
bool BlockBuilder::may_be_undone(const ir::PlacedPacket& packet) {
  const Instruction& first = info_of(packet.slots[0]);
  return packet.count > 1 || first.issue == isa::Issue::register_list ||
         first.flow == Flow::call_indirect;
}

void BlockBuilder::add_conflict_check(Draft& draft, const ir::PlacedPacket& packet,
                                      std::uint32_t index, Cycles cycle) const {
  Operation check;
  check.execute = conflict_;
  check.site = index;
  check.cycle = static_cast<std::uint16_t>(cycle);
  check.address = packet.address;
  std::size_t filled = 0;
  for (std::size_t slot = 0; slot < packet.count; ++slot) {
    if (const auto access = access_address(packet.slots[slot])) {
      check.operand[filled] = access->base;
      check.operand[filled + 1] = access->offset;
      filled += 2;
    }
  }
  if (filled == 4) {
    draft.operations.push_back(check);
  }
}

bool BlockBuilder::set_exit(Block& block, const ir::PlacedPacket& last) const {
  const Cycles taken = cycles_of(parameters_.branch_taken) - 1;
  const Cycles mispredicted = cycles_of(parameters_.branch_mispredicted) - 1;
  switch (flow_of(last)) {
    case Flow::none:
    case Flow::loop_setup:
    case Flow::idle:
    case Flow::event:
      return false;
    case Flow::jump:
    case Flow::jump_indirect:
      block.ends = BlockEnd::jump;
      refill_always(block, taken);
      return true;
    case Flow::call:
    case Flow::call_indirect:
      block.ends = BlockEnd::call;
      refill_always(block, taken);
      return true;
    case Flow::ret:
      block.ends = BlockEnd::ret;
      refill_always(block, taken);
      return true;
    case Flow::ret_event:
      block.ends = BlockEnd::ret_event;
      refill_always(block, taken);
      return true;
    case Flow::branch:
      block.ends = BlockEnd::branch;
      block.taken_extra = mispredicted;
      block.taken_cause = Cause::branch_mispredict;
      return false;
    case Flow::branch_predicted:
      block.ends = BlockEnd::branch;
      block.taken_extra = taken;
      block.fall_extra = mispredicted;
      return true;
  }
  return false;
}

}  // namespace finback::core
