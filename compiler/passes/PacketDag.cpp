// A list scheduler that fills packets: a 32-bit DSP operation, a short load or store, and a second
// one through an I register issue together. All slots of a packet read before any writes, so a
// packet may hold a read and a later write of one register, but no result and its use. Several
// tie-breaking rules are tried on each piece; the shortest order wins.
#include "PacketDag.hpp"

#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineInstrBundle.h>

#include "../target/BfinSubtarget.hpp"
#include "PacketSlots.hpp"

namespace llvm {
namespace {

/// All slots read before any writes: a packet may hold what reads a register and what then
/// overwrites it, and a load and the store behind it.
bool may_share(const SUnit& first, const SDep& dependency, const SUnit& second) {
  return dependency.getKind() == SDep::Anti ||
         (dependency.isNormalMemory() && !first.getInstr()->mayStore() &&
          !second.getInstr()->mayLoad());
}

}  // namespace

const PacketDag::Rule PacketDag::kRules[] = {{0, true, true}, {1, true, true},  {2, true, true},
                                             {4, true, true}, {1, false, true}, {3, false, true},
                                             {0, true, false}};

PacketDag::PacketDag(MachineFunction& function, const MachineLoopInfo* loops, AAResults* aliases)
    : ScheduleDAGInstrs(function, loops, /*RemoveKillFlags=*/true),
      aliases_(aliases),
      tii_(*function.getSubtarget<BfinSubtarget>().getInstrInfo()) {}

bool PacketDag::slots_allow(const Packet& packet, const SUnit& unit) const {
  PacketSlots slots;
  const auto add = [&](const SUnit& one) {
    return slots.add(*one.getInstr(), slot_of(*one.getInstr(), tii_));
  };
  return all_of(packet, [&](const SUnit* one) { return add(*one); }) && add(unit);
}

/// The unit is ready behind the packet's members alone, by reading what one overwrites or by
/// overwriting what one reads.
bool PacketDag::may_join(const Packet& packet, const SUnit& unit) const {
  return slots_allow(packet, unit) && none_of(unit.Preds, [&](const SDep& dependency) {
           return is_contained(packet, dependency.getSUnit()) &&
                  !may_share(*dependency.getSUnit(), dependency, unit);
         });
}

bool PacketDag::has_partner(const SUnit& unit, const std::vector<SUnit*>& ready,
                            unsigned cycle) const {
  return any_of(ready, [&](SUnit* other) {
    return other != &unit && earliest_[other->NodeNum] <= cycle && may_join({other}, unit);
  });
}

SUnit* PacketDag::best(const std::vector<SUnit*>& ready, const Rule& rule, unsigned cycle,
                       const Packet& packet) const {
  SUnit* chosen = nullptr;
  int chosen_rank = 0;
  for (SUnit* unit : ready) {
    if (earliest_[unit->NodeNum] > cycle || (!packet.empty() && !may_join(packet, *unit)))
      continue;
    auto rank = rule.by_height ? static_cast<int>(unit->getHeight()) : 0;
    if (packet.empty() && slot_of(*unit->getInstr(), tii_) != BfinII::kAlone &&
        !has_partner(*unit, ready, cycle))
      rank -= static_cast<int>(rule.penalty);
    bool wins_tie = chosen != nullptr && rank == chosen_rank &&
                    (unit->NodeNum < chosen->NodeNum) == rule.source_order;
    if (chosen == nullptr || rank > chosen_rank || wins_tie) {
      chosen = unit;
      chosen_rank = rank;
    }
  }
  return chosen;
}

void PacketDag::issue(SUnit& unit, unsigned cycle, std::vector<SUnit*>& ready) {
  llvm::erase(ready, &unit);
  for (const SDep& dependency : unit.Succs) {
    SUnit* next = dependency.getSUnit();
    if (next->isBoundaryNode()) {
      end_ = std::max(end_, cycle + dependency.getLatency());
      continue;
    }
    unsigned latency =
        may_share(unit, dependency, *next) ? 0 : std::max(1U, dependency.getLatency());
    earliest_[next->NodeNum] = std::max(earliest_[next->NodeNum], cycle + latency);
    if (--waiting_[next->NodeNum] == 0)
      ready.push_back(next);
  }
}

PacketDag::Order PacketDag::order_by(const Rule& rule) {
  Order order;
  std::vector<SUnit*> ready;
  waiting_.assign(SUnits.size(), 0);
  earliest_.assign(SUnits.size(), 0);
  end_ = 0;
  for (SUnit& unit : SUnits) {
    for (const SDep& dependency : unit.Preds)
      waiting_[unit.NodeNum] += dependency.getSUnit()->isBoundaryNode() ? 0 : 1;
    if (waiting_[unit.NodeNum] == 0)
      ready.push_back(&unit);
  }
  for (unsigned cycle = 0; !ready.empty(); ++cycle) {
    Packet packet;
    while (SUnit* next = best(ready, rule, cycle, packet)) {
      packet.push_back(next);
      issue(*next, cycle, ready);
    }
    if (packet.empty())
      continue;  // a stall
    order.packets.push_back(std::move(packet));
    order.cycles = cycle + 1;
  }
  order.cycles = std::max(order.cycles, end_);
  return order;
}

PacketDag::Order PacketDag::shortest_order() {
  buildSchedGraph(aliases_);
  Order shortest;
  for (const Rule& rule : kRules) {
    Order order = order_by(rule);
    bool better =
        shortest.packets.empty() || order.cycles < shortest.cycles ||
        (order.cycles == shortest.cycles && order.packets.size() < shortest.packets.size());
    if (better)
      shortest = std::move(order);
  }
  return shortest;
}

void PacketDag::apply(const Order& order) {
  RegionBegin = RegionEnd;
  bool first_placed = false;
  for (const Packet& packet : order.packets) {
    for (SUnit* unit : packet) {
      MachineInstr* inst = unit->getInstr();
      BB->splice(RegionEnd, BB, inst);
      if (!first_placed)
        RegionBegin = inst;
      first_placed = true;
    }
    if (packet.size() == 1)
      continue;
    bundles_.emplace_back();
    for (SUnit* unit : packet)
      bundles_.back().push_back(unit->getInstr());
  }
}

void PacketDag::schedule() { apply(shortest_order()); }

static bool is_boundary(const MachineInstr& inst) {
  return inst.isCall() || inst.isTerminator() || inst.isPosition() || inst.isInlineAsm() ||
         inst.hasUnmodeledSideEffects() || inst.modifiesRegister(Bfin::SP, nullptr);
}

/// Calls `visit` with each piece between boundaries entered, the last first, and its length.
template <typename Visit>
void PacketDag::visit_regions(MachineBasicBlock& block, Visit&& visit) {
  startBlock(&block);
  for (auto end = block.end(); end != block.begin();) {
    if (is_boundary(*std::prev(end))) {
      --end;
      continue;
    }
    auto begin = end;
    unsigned count = 0;
    while (begin != block.begin() && !is_boundary(*std::prev(begin))) {
      --begin;
      ++count;
    }
    enterRegion(&block, begin, end, count);
    visit(count);
    exitRegion();
    end = RegionBegin;
  }
  finishBlock();
}

unsigned PacketDag::cycles(MachineBasicBlock& block) {
  auto total = static_cast<unsigned>(count_if(block, [](const MachineInstr& inst) {
    return is_boundary(inst) && !inst.isMetaInstruction() && inst.getDesc().getSize() != 0;
  }));
  visit_regions(block, [&](unsigned) { total += shortest_order().cycles; });
  return total;
}

void PacketDag::run(MachineBasicBlock& block) {
  bundles_.clear();
  visit_regions(block, [&](unsigned count) {
    if (count > 1)
      schedule();
  });
  fixupKills(block);
  for (const auto& bundle : bundles_) {
    for (MachineInstr* inst : bundle)
      if (unsigned form = dsp_form(inst->getOpcode()))
        inst->setDesc(tii_.get(form));
    finalizeBundle(block, bundle.front()->getIterator(), std::next(bundle.back()->getIterator()));
  }
}

}  // namespace llvm
