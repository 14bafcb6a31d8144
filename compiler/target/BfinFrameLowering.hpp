// The frame: multiple push, LINK, locals, outgoing arguments with their twelve-byte home.
//
//   incoming SP ->  home of R0..R2, stack arguments        (the caller's)
//                   saved R7:n, P5:m                        by [--SP] = (...)
//   FP ->           old FP; RETS above it                   by LINK
//                   locals and spills
//   SP ->           home and stack arguments of calls
#pragma once

#include <llvm/CodeGen/TargetFrameLowering.h>

namespace llvm {

class BfinInstrInfo;

class BfinFrameLowering : public TargetFrameLowering {
 public:
  BfinFrameLowering();

  void emitPrologue(MachineFunction& function, MachineBasicBlock& block) const override;
  void emitEpilogue(MachineFunction& function, MachineBasicBlock& block) const override;
  bool hasFP(const MachineFunction& function) const override;
  bool hasReservedCallFrame(const MachineFunction& function) const override;
  StackOffset getFrameIndexReference(const MachineFunction& function, int index,
                                     Register& base) const override;
  MachineBasicBlock::iterator eliminateCallFramePseudoInstr(
      MachineFunction& function, MachineBasicBlock& block,
      MachineBasicBlock::iterator at) const override;
  void determineCalleeSaves(MachineFunction& function, BitVector& saved,
                            RegScavenger* scavenger) const override;
  bool assignCalleeSavedSpillSlots(MachineFunction& function, const TargetRegisterInfo* tri,
                                   std::vector<CalleeSavedInfo>& saved) const override;
  bool spillCalleeSavedRegisters(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                 ArrayRef<CalleeSavedInfo> saved,
                                 const TargetRegisterInfo* tri) const override;
  bool restoreCalleeSavedRegisters(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                   MutableArrayRef<CalleeSavedInfo> saved,
                                   const TargetRegisterInfo* tri) const override;
  void processFunctionBeforeFrameFinalized(MachineFunction& function,
                                           RegScavenger* scavenger) const override;
};

}  // namespace llvm
