// What the middle end asks: costs of constants, unrolling, hardware loops, addressing.
#pragma once

#include <llvm/CodeGen/BasicTTIImpl.h>

#include "BfinTargetMachine.hpp"

namespace llvm {

class BfinTTIImpl : public BasicTTIImplBase<BfinTTIImpl> {
  using Base = BasicTTIImplBase<BfinTTIImpl>;
  using TTI = TargetTransformInfo;
  friend Base;

 public:
  BfinTTIImpl(const BfinTargetMachine* machine, const Function& function)
      : Base(machine, function.getDataLayout()),
        subtarget_(machine->getSubtargetImpl(function)),
        lowering_(subtarget_->getTargetLowering()) {}

  TTI::PopcntSupportKind getPopcntSupport(unsigned bits) const {
    return bits == 32 ? TTI::PSK_FastHardware : TTI::PSK_Software;
  }
  /// Class 1 is that of vectors: pairs of halves live in data registers.
  unsigned getNumberOfRegisters(unsigned register_class) const {
    return register_class == 0 ? 12 : 8;
  }
  TTI::AddressingModeKind getPreferredAddressingMode(const Loop*, ScalarEvolution*) const {
    return TTI::AMK_PostIndexed;
  }
  bool isIndexedLoadLegal(TTI::MemIndexedMode mode, Type*, const DataLayout&) const {
    return mode == TTI::MIM_PostInc || mode == TTI::MIM_PostDec;
  }
  bool isIndexedStoreLegal(TTI::MemIndexedMode mode, Type*, const DataLayout&) const {
    return mode == TTI::MIM_PostInc || mode == TTI::MIM_PostDec;
  }
  InstructionCost getIntImmCost(const APInt& value, Type* type, TTI::TargetCostKind kind) const;
  InstructionCost getIntImmCostInst(unsigned opcode, unsigned index, const APInt& value, Type* type,
                                    TTI::TargetCostKind kind, Instruction* inst = nullptr) const;
  /// The functions that are instructions are not.
  bool isLoweredToCall(const Function* function) const;
  void getUnrollingPreferences(Loop* loop, ScalarEvolution& scev, TTI::UnrollingPreferences& prefs,
                               OptimizationRemarkEmitter* remarks);
  bool isHardwareLoopProfitable(Loop* loop, ScalarEvolution& scev, AssumptionCache& assumptions,
                                TargetLibraryInfo* library, HardwareLoopInfo& info) const;
  bool canSaveCmp(Loop* loop, BranchInst** branch, ScalarEvolution* scev, LoopInfo* loops,
                  DominatorTree* dominators, AssumptionCache* assumptions,
                  TargetLibraryInfo* library) const;

 private:
  const BfinSubtarget* getST() const { return subtarget_; }
  const BfinTargetLowering* getTLI() const { return lowering_; }

  const BfinSubtarget* subtarget_;
  const BfinTargetLowering* lowering_;
};

}  // namespace llvm
