// What is known of the upper halves of data registers after allocation: whether anybody reads one,
// and whether it is zero all through a loop of one block.
#pragma once

#include <llvm/CodeGen/MachineInstr.h>

namespace llvm {

/// Whether of what `def` leaves in `reg` only the low half is ever read.
bool only_low_half_is_read(const MachineInstr& def, MCPhysReg reg);
/// Whether the upper half of `reg` is zero behind everything that writes it in the loop `block`,
/// and when the loop is entered from `before`, if something is in it then.
bool stays_a_half(const MachineBasicBlock& block, const MachineBasicBlock& before, MCPhysReg reg);

}  // namespace llvm
