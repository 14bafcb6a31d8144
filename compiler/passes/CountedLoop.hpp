// Loops of one block on a loop counter: what stands before and behind them, and the LSETUP.
#pragma once

#include <llvm/CodeGen/MachineBasicBlock.h>
#include <llvm/CodeGen/MachineInstr.h>

#include "../target/BfinInstrInfo.hpp"

namespace llvm {

struct CountedLoop {
  MachineBasicBlock* block = nullptr;
  MachineBasicBlock* before = nullptr;  // goes nowhere else
  MachineBasicBlock* after = nullptr;
  MachineInstr* setup = nullptr;

  /// Whether `candidate` is such a loop; the rest is filled in then.
  bool find(MachineBasicBlock& candidate) {
    const auto end = candidate.getFirstTerminator();
    if (end == candidate.end() || end->getOpcode() != Bfin::ENDLOOP ||
        end->getOperand(0).getMBB() != &candidate || candidate.succ_size() != 2 ||
        candidate.pred_size() != 2)
      return false;
    const auto is_other = [&](const MachineBasicBlock* other) { return other != &candidate; };
    block = &candidate;
    before = *find_if(candidate.predecessors(), is_other);
    after = *find_if(candidate.successors(), is_other);
    for (MachineInstr& inst : before->terminators())
      if (inst.getOpcode() == Bfin::LOOPSETUP)
        setup = &inst;
    return setup != nullptr && before->succ_size() == 1;
  }
};

}  // namespace llvm
