// Instructions: copies, spills, branches, sizes, addresses.
#pragma once

#include <llvm/CodeGen/TargetInstrInfo.h>

#include "BfinMCTargetDesc.hpp"
#include "BfinRegisterInfo.hpp"

#define GET_INSTRINFO_HEADER
#include "BfinGenInstrInfo.inc"

namespace llvm {

class BfinInstrInfo : public BfinGenInstrInfo {
 public:
  BfinInstrInfo();

  const BfinRegisterInfo& getRegisterInfo() const { return registers_; }

  void copyPhysReg(MachineBasicBlock& block, MachineBasicBlock::iterator at, const DebugLoc& loc,
                   MCRegister to, MCRegister from, bool kill) const override;
  void storeRegToStackSlot(MachineBasicBlock& block, MachineBasicBlock::iterator at, Register reg,
                           bool kill, int index, const TargetRegisterClass* rc,
                           const TargetRegisterInfo* tri, Register) const override;
  void loadRegFromStackSlot(MachineBasicBlock& block, MachineBasicBlock::iterator at, Register reg,
                            int index, const TargetRegisterClass* rc, const TargetRegisterInfo* tri,
                            Register) const override;
  Register isLoadFromStackSlot(const MachineInstr& inst, int& index) const override;
  Register isStoreToStackSlot(const MachineInstr& inst, int& index) const override;
  bool expandPostRAPseudo(MachineInstr& inst) const override;
  // Where sums live in an accumulator (BfinAccumulators), nothing moves in that writes it.
  bool shouldSink(const MachineInstr& inst) const override { return leavesAccumulators(inst); }
  bool shouldHoist(const MachineInstr& inst, const MachineLoop*) const override {
    return leavesAccumulators(inst);
  }

  // Branches. The condition is one operand: the sense of CC, or two for a hardware loop's end.
  bool analyzeBranch(MachineBasicBlock& block, MachineBasicBlock*& taken,
                     MachineBasicBlock*& not_taken, SmallVectorImpl<MachineOperand>& condition,
                     bool allow_modify) const override;
  unsigned removeBranch(MachineBasicBlock& block, int* bytes) const override;
  unsigned insertBranch(MachineBasicBlock& block, MachineBasicBlock* taken,
                        MachineBasicBlock* not_taken, ArrayRef<MachineOperand> condition,
                        const DebugLoc& loc, int* bytes) const override;
  bool reverseBranchCondition(SmallVectorImpl<MachineOperand>& condition) const override;
  /// Different objects lie apart, in whatever pass of a loop.
  bool areMemAccessesTriviallyDisjoint(const MachineInstr& a, const MachineInstr& b) const override;
  bool isSchedulingBoundary(const MachineInstr& inst, const MachineBasicBlock* block,
                            const MachineFunction& function) const override;
  bool isBranchOffsetInRange(unsigned opcode, int64_t offset) const override;
  MachineBasicBlock* getBranchDestBlock(const MachineInstr& inst) const override;
  /// Bytes; for jumps and calls, whose form the linker picks, the longer form.
  unsigned getInstSizeInBytes(const MachineInstr& inst) const override;

  /// Can a load or store of this opcode reach `offset` from its base?
  bool isLegalDisplacement(unsigned opcode, int64_t offset) const;
  /// to = base + offset, to being a P register other than base.
  void buildAddress(MachineBasicBlock& block, MachineBasicBlock::iterator at, const DebugLoc& loc,
                    Register to, Register base, int64_t offset) const;
  /// to = value, by the shortest instructions.
  void buildConstant(MachineBasicBlock& block, MachineBasicBlock::iterator at, const DebugLoc& loc,
                     Register to, int64_t value) const;

 private:
  static bool leavesAccumulators(const MachineInstr& inst);
  /// BfinSequences.cpp.
  bool expandSequence(MachineInstr& inst) const;

  BfinRegisterInfo registers_;
};

}  // namespace llvm
