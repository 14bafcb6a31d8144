// Registers: reserved, callee-saved, frame indices.
#pragma once

#include <llvm/CodeGen/TargetRegisterInfo.h>

#define GET_REGINFO_HEADER
#include "BfinGenRegisterInfo.inc"

namespace llvm {

class BfinRegisterInfo : public BfinGenRegisterInfo {
 public:
  BfinRegisterInfo();

  const MCPhysReg* getCalleeSavedRegs(const MachineFunction* function) const override;
  const uint32_t* getCallPreservedMask(const MachineFunction& function,
                                       CallingConv::ID convention) const override;
  BitVector getReservedRegs(const MachineFunction& function) const override;
  /// What may live in either bank and becomes an address goes to the pointer registers first.
  bool getRegAllocationHints(Register value, ArrayRef<MCPhysReg> order,
                             SmallVectorImpl<MCPhysReg>& hints, const MachineFunction& function,
                             const VirtRegMap* map, const LiveRegMatrix* matrix) const override;
  Register getFrameRegister(const MachineFunction& function) const override;
  bool eliminateFrameIndex(MachineBasicBlock::iterator inst, int sp_adjustment, unsigned operand,
                           RegScavenger* scavenger) const override;
  /// A data value may be kept in a free pointer register instead of on the stack, and the reverse.
  const TargetRegisterClass* getLargestLegalSuperClass(const TargetRegisterClass* rc,
                                                       const MachineFunction&) const override;
  const TargetRegisterClass* getPointerRegClass(const MachineFunction& function,
                                                unsigned kind) const override;
  bool requiresRegisterScavenging(const MachineFunction&) const override { return true; }
  bool requiresFrameIndexScavenging(const MachineFunction&) const override { return true; }
};

}  // namespace llvm
