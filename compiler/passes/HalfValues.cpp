// Follows a register from where it is written, forward to its reads and backward to what wrote it.
// Knows the instructions that read low halves alone and those that leave a zero in the upper half;
// all others are taken to read, or to write, the whole.
#include "HalfValues.hpp"

#include <llvm/ADT/SmallPtrSet.h>
#include <llvm/CodeGen/MachineBasicBlock.h>
#include <llvm/CodeGen/MachineFunction.h>

#include "../target/BfinSubtarget.hpp"
#include "IndexForms.hpp"

namespace llvm {
namespace {

/// Whether `inst` writes the low half and leaves the upper one.
bool keeps_upper_half(const MachineInstr& inst) {
  switch (inst.getOpcode()) {
    case Bfin::ONES:
    case Bfin::LDLI:
    case Bfin::LDLIInc:
    case Bfin::LDLIDec:
    case Bfin::LDLOStride:
      return true;
    default:
      return false;
  }
}

bool leaves_zero(const MachineInstr& inst) {
  switch (inst.getOpcode()) {
    case Bfin::LDHZ:
    case Bfin::LDHZInc:
    case Bfin::LDHZDec:
    case Bfin::LDBZ:
    case Bfin::LDBZInc:
    case Bfin::LDBZDec:
    case Bfin::ZXH:
    case Bfin::ZXB:
    case Bfin::FROMCC:
      return true;
    case Bfin::MOVI:
      return isUInt<15>(inst.getOperand(1).getImm());
    case Bfin::MOVU:
      return true;
    default:
      return keeps_upper_half(inst);
  }
}

enum class Fate { kLives, kDead, kRead };

/// What becomes of the upper half of `reg` from `begin` to the end of the block.
Fate follow(MachineBasicBlock::const_instr_iterator begin, const MachineBasicBlock& block,
            MCPhysReg reg, const TargetRegisterInfo& tri) {
  for (const MachineInstr& inst : make_range(begin, block.instr_end())) {
    if (inst.isDebugInstr())
      continue;
    const bool passes_on = keeps_upper_half(inst) && inst.getOperand(0).getReg() == reg;
    // The counted or shifted source of such an instruction is read as a whole.
    const auto reads = count_if(inst.all_uses(), [&](const MachineOperand& use) {
      return !use.isUndef() && tri.regsOverlap(use.getReg(), reg) &&
             reads_upper_half(inst, inst.getOperandNo(&use));
    });
    if (reads > (passes_on ? 1 : 0))
      return Fate::kRead;
    if (!passes_on && inst.modifiesRegister(reg, &tri))
      return Fate::kDead;
  }
  return Fate::kLives;
}

}  // namespace

bool only_low_half_is_read(const MachineInstr& def, MCPhysReg reg) {
  const TargetRegisterInfo& tri = *def.getMF()->getSubtarget().getRegisterInfo();
  SmallPtrSet<const MachineBasicBlock*, 8> seen;
  SmallVector<const MachineBasicBlock*, 8> to_do;
  const auto enter_followers = [&](const MachineBasicBlock& block) {
    for (const MachineBasicBlock* next : block.successors())
      if (next->isLiveIn(reg) && seen.insert(next).second)
        to_do.push_back(next);
  };
  const Fate fate = follow(std::next(def.getIterator()), *def.getParent(), reg, tri);
  if (fate == Fate::kLives)
    enter_followers(*def.getParent());
  bool read = fate == Fate::kRead;
  while (!read && !to_do.empty()) {
    const MachineBasicBlock* block = to_do.pop_back_val();
    const Fate there = follow(block->instr_begin(), *block, reg, tri);
    read = there == Fate::kRead;
    if (there == Fate::kLives)
      enter_followers(*block);
  }
  return !read;
}

bool stays_a_half(const MachineBasicBlock& block, const MachineBasicBlock& before, MCPhysReg reg) {
  const TargetRegisterInfo& tri = *block.getParent()->getSubtarget().getRegisterInfo();
  const auto writes = [&](const MachineInstr& inst) { return inst.modifiesRegister(reg, &tri); };
  if (!all_of(block, [&](const MachineInstr& inst) { return !writes(inst) || leaves_zero(inst); }))
    return false;
  if (!block.isLiveIn(reg))
    return true;
  const auto last = find_if(reverse(before), writes);
  return last != before.rend() && leaves_zero(*last) && !keeps_upper_half(*last);
}

}  // namespace llvm
