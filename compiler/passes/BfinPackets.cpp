// The last schedule: after allocation, each straight piece of code is ordered anew, cycle by cycle,
// and a DSP operation issues together with a short load or store (hardware.md 1.3). All slots of a
// packet read before any writes, so a packet may hold a read and a later write of one register, but
// no result and its use. Several tie-breaking rules are tried on each piece; the shortest order
// wins.
#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineInstrBundle.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/CodeGen/ScheduleDAGInstrs.h>
#include <llvm/InitializePasses.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

/// The DSP form of a two-byte operation, 0 where there is none.
unsigned dsp_form(unsigned opcode) {
  switch (opcode) {
    case Bfin::ADD:
      return Bfin::ADDNS;
    case Bfin::SUB:
      return Bfin::SUBNS;
    default:
      return 0;
  }
}

bool can_fill_dsp_slot(const MachineInstr& inst) {
  return BfinII::getSlot(inst.getDesc()) == BfinII::kDspSlot || dsp_form(inst.getOpcode()) != 0;
}

bool can_fill_access_slot(const MachineInstr& inst, const BfinInstrInfo& tii) {
  return BfinII::getSlot(inst.getDesc()) == BfinII::kMemSlot && tii.getInstSizeInBytes(inst) == 2;
}

bool is_shift_by_number(const MachineInstr& inst) {
  unsigned opcode = inst.getOpcode();
  return opcode == Bfin::SHLI || opcode == Bfin::SRLI || opcode == Bfin::SRAI;
}

/// Anomaly 05000074: no immediate shift beside a store of a pointer register.
bool is_anomalous(const MachineInstr& dsp, const MachineInstr& access) {
  return is_shift_by_number(dsp) && access.mayStore() &&
         any_of(access.explicit_uses(), [&](const MachineOperand& operand) {
           return operand.isReg() && Bfin::PRegClass.contains(operand.getReg()) &&
                  (access.getOpcode() == Bfin::STW ? &operand == &access.getOperand(0)
                                                   : &operand == &access.getOperand(1));
         });
}

/// How candidates of one cycle are ranked.
struct Rule {
  unsigned penalty;   // for issuing alone what could share a packet, in cycles of height
  bool source_order;  // ties go to what comes first in the source, else to what comes last
};
constexpr Rule kRules[] = {{0, true}, {1, true}, {2, true}, {4, true}, {1, false}, {3, false}};

struct Order {
  std::vector<std::vector<SUnit*>> packets;
  unsigned cycles = 0;
};

class PacketDag : public ScheduleDAGInstrs {
 public:
  PacketDag(MachineFunction& function, const MachineLoopInfo* loops, AAResults* aliases)
      : ScheduleDAGInstrs(function, loops, /*RemoveKillFlags=*/true),
        aliases_(aliases),
        tii_(*function.getSubtarget<BfinSubtarget>().getInstrInfo()) {}

  void schedule() override;
  void run(MachineBasicBlock& block);

 private:
  Order order_by(const Rule& rule);
  void apply(const Order& order);
  SUnit* best(const std::vector<SUnit*>& ready, const Rule& rule, unsigned cycle,
              const SUnit* beside) const;
  bool has_partner(const SUnit& unit, const std::vector<SUnit*>& ready, unsigned cycle) const;
  bool may_share(const SUnit& first, const SUnit& second) const;
  void issue(SUnit& unit, unsigned cycle, std::vector<SUnit*>& ready);

  AAResults* aliases_;
  const BfinInstrInfo& tii_;
  std::vector<unsigned> waiting_;   // unscheduled predecessors
  std::vector<unsigned> earliest_;  // first cycle at which operands are ready
  std::vector<std::pair<MachineInstr*, MachineInstr*>> bundles_;
};

bool PacketDag::may_share(const SUnit& first, const SUnit& second) const {
  const MachineInstr& a = *first.getInstr();
  const MachineInstr& b = *second.getInstr();
  const MachineInstr* dsp = can_fill_dsp_slot(a) ? &a : &b;
  const MachineInstr* access = dsp == &a ? &b : &a;
  if (!can_fill_dsp_slot(*dsp) || !can_fill_access_slot(*access, tii_) ||
      is_anomalous(*dsp, *access))
    return false;
  // The second was ready behind the first alone by reading what the first overwrites, or the other
  // way round; anything else between them forbids a packet.
  return none_of(second.Preds, [&](const SDep& dependency) {
    return dependency.getSUnit() == &first && dependency.getKind() != SDep::Anti;
  });
}

bool PacketDag::has_partner(const SUnit& unit, const std::vector<SUnit*>& ready,
                            unsigned cycle) const {
  return any_of(ready, [&](const SUnit* other) {
    return other != &unit && earliest_[other->NodeNum] <= cycle && may_share(unit, *other);
  });
}

SUnit* PacketDag::best(const std::vector<SUnit*>& ready, const Rule& rule, unsigned cycle,
                       const SUnit* beside) const {
  SUnit* chosen = nullptr;
  int chosen_rank = 0;
  for (SUnit* unit : ready) {
    if (earliest_[unit->NodeNum] > cycle || (beside != nullptr && !may_share(*beside, *unit)))
      continue;
    const MachineInstr& inst = *unit->getInstr();
    bool shareable = can_fill_dsp_slot(inst) || can_fill_access_slot(inst, tii_);
    auto rank = static_cast<int>(unit->getHeight());
    if (beside == nullptr && shareable && !has_partner(*unit, ready, cycle))
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
    if (next->isBoundaryNode())
      continue;
    unsigned latency =
        dependency.getKind() == SDep::Anti ? 0 : std::max(1U, dependency.getLatency());
    earliest_[next->NodeNum] = std::max(earliest_[next->NodeNum], cycle + latency);
    if (--waiting_[next->NodeNum] == 0)
      ready.push_back(next);
  }
}

Order PacketDag::order_by(const Rule& rule) {
  Order order;
  std::vector<SUnit*> ready;
  waiting_.assign(SUnits.size(), 0);
  earliest_.assign(SUnits.size(), 0);
  for (SUnit& unit : SUnits) {
    for (const SDep& dependency : unit.Preds)
      waiting_[unit.NodeNum] += dependency.getSUnit()->isBoundaryNode() ? 0 : 1;
    if (waiting_[unit.NodeNum] == 0)
      ready.push_back(&unit);
  }
  for (unsigned cycle = 0; !ready.empty(); ++cycle) {
    SUnit* first = best(ready, rule, cycle, nullptr);
    if (first == nullptr)
      continue;  // a stall
    order.packets.push_back({first});
    issue(*first, cycle, ready);
    if (SUnit* second = best(ready, rule, cycle, first)) {
      order.packets.back().push_back(second);
      issue(*second, cycle, ready);
    }
    order.cycles = cycle + 1;
  }
  return order;
}

void PacketDag::apply(const Order& order) {
  RegionBegin = RegionEnd;
  bool first_placed = false;
  for (const std::vector<SUnit*>& packet : order.packets)
    for (SUnit* unit : packet) {
      MachineInstr* inst = unit->getInstr();
      BB->splice(RegionEnd, BB, inst);
      if (!first_placed)
        RegionBegin = inst;
      first_placed = true;
    }
  for (const std::vector<SUnit*>& packet : order.packets)
    if (packet.size() == 2)
      bundles_.emplace_back(packet[0]->getInstr(), packet[1]->getInstr());
}

void PacketDag::schedule() {
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
  apply(shortest);
}

bool is_boundary(const MachineInstr& inst) {
  return inst.isCall() || inst.isTerminator() || inst.isPosition() || inst.isInlineAsm() ||
         inst.hasUnmodeledSideEffects() || inst.modifiesRegister(Bfin::SP, nullptr);
}

void PacketDag::run(MachineBasicBlock& block) {
  startBlock(&block);
  bundles_.clear();
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
    if (count > 1)
      schedule();
    exitRegion();
    end = RegionBegin;
  }
  finishBlock();
  fixupKills(block);
  for (auto [first, second] : bundles_) {
    for (MachineInstr* inst : {first, second})
      if (unsigned form = dsp_form(inst->getOpcode()))
        inst->setDesc(tii_.get(form));
    finalizeBundle(block, first->getIterator(), std::next(second->getIterator()));
  }
}

class BfinPackets : public MachineFunctionPass {
 public:
  static char ID;
  BfinPackets() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin packets"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<AAResultsWrapperPass>();
    usage.addRequired<MachineLoopInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override {
    PacketDag dag(function, &getAnalysis<MachineLoopInfoWrapperPass>().getLI(),
                  &getAnalysis<AAResultsWrapperPass>().getAAResults());
    for (MachineBasicBlock& block : function)
      dag.run(block);
    return true;
  }
};

char BfinPackets::ID = 0;

}  // namespace

FunctionPass* createBfinPackets() { return new BfinPackets(); }

}  // namespace llvm
