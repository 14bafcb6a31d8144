// Phis in the head of a loop that is entered from one place: two ways in, from before and around.
#pragma once

#include <llvm/CodeGen/MachineInstr.h>

namespace llvm {

/// The operand of such a phi that holds its value when control comes from `block`.
inline unsigned incoming_operand(const MachineInstr& phi, const MachineBasicBlock& block) {
  return phi.getOperand(2).getMBB() == &block ? 1 : 3;
}

}  // namespace llvm
