#include "BfinTargetTransformInfo.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/IR/IntrinsicInst.h>

#include "BfinNamedInstructions.hpp"

namespace llvm {

using TTI = TargetTransformInfo;

InstructionCost BfinTTIImpl::getIntImmCost(const APInt& value, Type* type,
                                           TTI::TargetCostKind) const {
  if (!type->isIntegerTy() || value.getBitWidth() > 32)
    return InstructionCost(TTI::TCC_Basic) * 2;
  int64_t number = value.getSExtValue();
  bool one_instruction = isInt<16>(number) || isUInt<16>(number & 0xffffffff);
  return InstructionCost(TTI::TCC_Basic) * (one_instruction ? 1 : 2);
}

InstructionCost BfinTTIImpl::getIntImmCostInst(unsigned opcode, unsigned index, const APInt& value,
                                               Type* type, TTI::TargetCostKind kind,
                                               Instruction*) const {
  switch (opcode) {
    case Instruction::GetElementPtr:
      return TTI::TCC_Free;  // folded into the access's displacement
    case Instruction::Add:
    case Instruction::Sub:
      if (index == 1 && value.isSignedIntN(7))
        return TTI::TCC_Free;
      break;
    case Instruction::ICmp:
      if (index == 1 && value.isSignedIntN(3))
        return TTI::TCC_Free;
      break;
    case Instruction::Shl:
    case Instruction::LShr:
    case Instruction::AShr:
      if (index == 1)
        return TTI::TCC_Free;
      break;
    case Instruction::And:
    case Instruction::Or:
    case Instruction::Xor:
      if (value.isPowerOf2() || (~value).isPowerOf2() || value == 255 || value == 65535)
        return TTI::TCC_Free;
      break;
    case Instruction::PHI:
    case Instruction::Call:
    case Instruction::Ret:
      return TTI::TCC_Free;
    default:
      break;
  }
  InstructionCost cost = getIntImmCost(value, type, kind);
  // What one instruction makes is not worth a register across blocks.
  return cost <= TTI::TCC_Basic ? InstructionCost(TTI::TCC_Free) : cost;
}

/// Values that pass from name to name, as neighbours in a window do, cost a move a round; two
/// rounds at once cost none.
static bool hands_values_on(const Loop& loop) {
  const BasicBlock* latch = loop.getLoopLatch();
  return loop.getNumBlocks() == 1 && latch != nullptr &&
         any_of(loop.getHeader()->phis(), [&](const PHINode& phi) {
           const auto* next = dyn_cast<PHINode>(phi.getIncomingValueForBlock(latch));
           return next != nullptr && next != &phi && next->getParent() == loop.getHeader();
         });
}

void BfinTTIImpl::getUnrollingPreferences(Loop* loop, ScalarEvolution& scev,
                                          TTI::UnrollingPreferences& prefs,
                                          OptimizationRemarkEmitter* remarks) {
  Base::getUnrollingPreferences(loop, scev, prefs, remarks);
  // Hardware loops cost nothing a round; unrolling only spends the eight data registers.
  prefs.Partial = false;
  prefs.Runtime = false;
  prefs.UpperBound = false;
  prefs.Threshold = 60;
  prefs.FullUnrollMaxCount = 8;
  if (hands_values_on(*loop)) {
    prefs.Partial = true;
    prefs.Count = 2;
  }
}

bool BfinTTIImpl::isLoweredToCall(const Function* function) const {
  return !isNamedInstruction(function) && Base::isLoweredToCall(function);
}

/// Does the loop's body contain a call that will remain one?
static bool has_real_call(const Loop& loop) {
  for (const BasicBlock* block : loop.blocks())
    for (const Instruction& inst : *block) {
      const auto* call = dyn_cast<CallBase>(&inst);
      if (call == nullptr)
        continue;
      if (isNamedInstruction(call->getCalledFunction()))
        continue;
      if (!isa<IntrinsicInst>(call) || isa<MemIntrinsic>(call))
        return true;
    }
  return false;
}

bool BfinTTIImpl::isHardwareLoopProfitable(Loop* loop, ScalarEvolution& scev, AssumptionCache&,
                                           TargetLibraryInfo*, HardwareLoopInfo& info) const {
  BasicBlock* latch = loop->getLoopLatch();
  if (latch == nullptr || !loop->isLoopExiting(latch) ||
      !scev.hasLoopInvariantBackedgeTakenCount(loop))
    return false;
  if (isa<SCEVCouldNotCompute>(scev.getExitCount(loop, latch)) || has_real_call(*loop))
    return false;
  LLVMContext& context = loop->getHeader()->getContext();
  info.CounterInReg = true;
  info.IsNestingLegal = true;
  info.PerformEntryTest = false;
  info.CountType = Type::getInt32Ty(context);
  info.LoopDecrement = ConstantInt::get(info.CountType, 1);
  return true;
}

bool BfinTTIImpl::canSaveCmp(Loop* loop, BranchInst** branch, ScalarEvolution* scev,
                             LoopInfo* loops, DominatorTree* dominators,
                             AssumptionCache* assumptions, TargetLibraryInfo* library) const {
  HardwareLoopInfo info(loop);
  if (!info.canAnalyze(*loops) ||
      !isHardwareLoopProfitable(loop, *scev, *assumptions, library, info) ||
      !info.isHardwareLoopCandidate(*scev, *loops, *dominators))
    return false;
  *branch = info.ExitBranch;
  return true;
}

}  // namespace llvm
