// What must come before what in a loop of one block, in one pass and from each pass to the next, on
// machine code in SSA form: values, their ends (a register holds one value at a time), physical
// registers, memory.
// Does not look further than one pass ahead; a loop where that is not enough is none to schedule.
#pragma once

#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <map>

#include "../target/BfinInstrInfo.hpp"
#include "LoopScopes.hpp"

namespace llvm {

/// `to` of the pass `distance` later issues at least `latency` cycles after `from`. With latency 0
/// they may share a packet, where everything is read before anything is written.
struct LoopDependence {
  size_t from;
  size_t to;
  int latency;
  int distance;
};

class LoopDependences {
 public:
  /// The instructions of the block without phis and terminators, and what holds between them.
  LoopDependences(MachineBasicBlock& block, AAResults& aliases);

  /// False: something is beyond this description.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] const std::vector<MachineInstr*>& instructions() const { return instructions_; }
  [[nodiscard]] const std::vector<LoopDependence>& all() const { return dependences_; }
  /// What pairs of instructions may stand in one stage only: CC, which nothing carries over.
  [[nodiscard]] const std::vector<std::pair<size_t, size_t>>& same_stage() const {
    return same_stage_;
  }

 private:
  /// Where an access goes: so many bytes behind what the phi of its pointer is in this pass.
  struct Place {
    Register phi;
    int64_t offset = 0;
    int64_t step = 0;  // of the phi, a pass
  };

  void add(size_t from, size_t to, int latency, int distance) {
    dependences_.push_back({from, to, latency, distance});
  }
  void add_values(size_t user);
  void add_physical(size_t first, size_t second);
  void add_memory(size_t first, size_t second);
  bool place_of(const MachineInstr& access, Place& place) const;
  bool follow(Register reg, Register& phi, int64_t& offset) const;
  bool may_meet(size_t first, size_t second, bool next_pass) const;

  MachineBasicBlock& block_;
  MachineRegisterInfo& regs_;
  AAResults& aliases_;
  LoopScopes scopes_;
  bool complete_ = true;
  std::vector<MachineInstr*> instructions_;
  std::map<const MachineInstr*, size_t> numbers_;
  std::vector<LoopDependence> dependences_;
  std::vector<std::pair<size_t, size_t>> same_stage_;
};

/// The same access of any pass of a loop: of the object it goes to nothing is left but its name.
MachineMemOperand* in_any_pass(MachineFunction& function, const MachineMemOperand& access,
                               const LoopScopes& scopes);

}  // namespace llvm
