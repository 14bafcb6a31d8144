// The last schedule of a straight piece of code: ordered anew, cycle by cycle, in packets
// (hardware.md 1.3). BfinPackets writes it down; others only ask how many cycles it takes.
// Looks at one block at a time: what is still under way when a block begins is not known.
#pragma once

#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/CodeGen/ScheduleDAGInstrs.h>

#include "../target/BfinInstrInfo.hpp"

namespace llvm {

class PacketDag : public ScheduleDAGInstrs {
 public:
  PacketDag(MachineFunction& function, const MachineLoopInfo* loops, AAResults* aliases);

  void schedule() override;
  /// Orders the block and binds its packets.
  void run(MachineBasicBlock& block);
  /// The cycles of the block as run() would order it.
  unsigned cycles(MachineBasicBlock& block);

 private:
  /// How candidates of one cycle are ranked.
  struct Rule {
    unsigned penalty;   // for issuing alone what could share a packet, in cycles of height
    bool source_order;  // ties go to what comes first in the source, else to what comes last
    bool by_height;     // else in the order of the source alone
  };
  using Packet = SmallVector<SUnit*, 3>;
  struct Order {
    std::vector<Packet> packets;
    unsigned cycles = 0;
  };
  static const Rule kRules[];

  template <typename Visit>
  void visit_regions(MachineBasicBlock& block, Visit&& visit);
  Order shortest_order();
  Order order_by(const Rule& rule);
  void apply(const Order& order);
  SUnit* best(const std::vector<SUnit*>& ready, const Rule& rule, unsigned cycle,
              const Packet& packet) const;
  bool has_partner(const SUnit& unit, const std::vector<SUnit*>& ready, unsigned cycle) const;
  bool may_join(const Packet& packet, const SUnit& unit) const;
  bool slots_allow(const Packet& packet, const SUnit& unit) const;
  void issue(SUnit& unit, unsigned cycle, std::vector<SUnit*>& ready);

  AAResults* aliases_;
  const BfinInstrInfo& tii_;
  std::vector<unsigned> waiting_;   // unscheduled predecessors
  std::vector<unsigned> earliest_;  // first cycle at which operands are ready
  unsigned end_ = 0;  // the cycle from which what comes behind the region has what it reads
  std::vector<SmallVector<MachineInstr*, 3>> bundles_;
};

}  // namespace llvm
