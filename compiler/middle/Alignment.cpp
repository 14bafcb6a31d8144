#include "Alignment.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Scalar/IndVarSimplify.h>
#include <llvm/Transforms/Scalar/LoopPassManager.h>
#include <llvm/Transforms/Scalar/SimpleLoopUnswitch.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

namespace finback::compiler {

using namespace llvm;

bool is_aligned(const SCEV* value, ScalarEvolution& scev) {
  return scev.getMinTrailingZeros(value) >= 2;
}

void align_objects(ArrayRef<const SCEV*> values, ScalarEvolution& scev) {
  const Align word(4);
  for (const SCEV* value : values) {
    if (!value->getType()->isPointerTy())
      continue;
    const auto* base = dyn_cast<SCEVUnknown>(scev.getPointerBase(value));
    Value* object = base == nullptr ? nullptr : base->getValue();
    auto* global = dyn_cast_or_null<GlobalVariable>(object);
    auto* local = dyn_cast_or_null<AllocaInst>(object);
    if (global != nullptr && global->getAlign().valueOrOne() < word &&
        global->canIncreaseAlignment())
      global->setAlignment(word);
    if (local != nullptr && local->getAlign() < word)
      local->setAlignment(word);
  }
}

bool can_expand(ArrayRef<const SCEV*> values, ScalarEvolution& scev, Instruction* at) {
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "test");
  return all_of(values, [&](const SCEV* value) { return expander.isSafeToExpandAt(value, at); });
}

Value* write_alignment_test(ArrayRef<const SCEV*> values, ScalarEvolution& scev, Instruction* at) {
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "test");
  IRBuilder<> builder(at);
  Value* bits = builder.getInt32(0);
  for (const SCEV* value : values) {
    // Whole words further in each round of a loop around: the first address answers for all.
    while (const auto* steps = dyn_cast<SCEVAddRecExpr>(value)) {
      if (!is_aligned(steps->getStepRecurrence(scev), scev))
        break;
      value = steps->getStart();
    }
    if (is_aligned(value, scev))
      continue;
    Value* number = expander.expandCodeFor(value, value->getType(), at);
    bits = builder.CreateOr(bits, builder.CreatePtrToInt(number, builder.getInt32Ty()));
  }
  Value* rest = builder.CreateAnd(bits, builder.getInt32(3));
  return builder.CreateICmpEQ(rest, builder.getInt32(0));
}

Value* write_test(const SCEV* rounds, unsigned least, ArrayRef<const SCEV*> values,
                  ScalarEvolution& scev, Instruction* at) {
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "test");
  IRBuilder<> builder(at);
  Value* test = builder.getTrue();
  if (!scev.isKnownPredicate(CmpInst::ICMP_UGE, rounds, scev.getConstant(rounds->getType(), least)))
    test = builder.CreateICmpUGE(expander.expandCodeFor(rounds, rounds->getType(), at),
                                 builder.getInt32(least));
  return builder.CreateAnd(test, write_alignment_test(values, scev, at));
}

void ask_once(Function& function, FunctionAnalysisManager& manager) {
  for (Loop* loop : manager.getResult<LoopAnalysis>(function).getLoopsInPreorder())
    for (BasicBlock* block : loop->blocks())
      if (auto* branch = dyn_cast<BranchInst>(block->getTerminator());
          branch != nullptr && branch->isConditional()) {
        bool moved = false;
        loop->makeLoopInvariant(branch->getCondition(), moved);
      }
  LoopPassManager passes;
  passes.addPass(SimpleLoopUnswitchPass(/*NonTrivial=*/true));
  passes.addPass(IndVarSimplifyPass());  // counts that only code behind the loop wants
  createFunctionToLoopPassAdaptor(std::move(passes)).run(function, manager);
}

}  // namespace finback::compiler
