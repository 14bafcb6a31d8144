#include "VectorLoops.hpp"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Vectorize/LoopVectorize.h>

#include "../target/BfinMachineFunctionInfo.hpp"
#include "Alignment.hpp"
#include "HalfLoops.hpp"
#include "PairedLoop.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr const char* kEnable = "llvm.loop.vectorize.enable";

/// Are there loops for the vectoriser? They are marked.
bool mark_loops(Function& function, FunctionAnalysisManager& manager) {
  auto& loops = manager.getResult<LoopAnalysis>(function);
  auto& scev = manager.getResult<ScalarEvolutionAnalysis>(function);
  auto& dominators = manager.getResult<DominatorTreeAnalysis>(function);
  auto& assumptions = manager.getResult<AssumptionAnalysis>(function);
  for (Loop* loop : loops) {
    simplifyLoop(loop, &dominators, &loops, &scev, &assumptions, nullptr, false);
    formLCSSARecursively(*loop, dominators, &loops, &scev);
  }
  auto& accesses = manager.getResult<LoopAccessAnalysis>(function);
  bool any = false;
  for (Loop* loop : loops.getLoopsInPreorder()) {
    if (!narrow_loop(*loop, scev, accesses))
      continue;
    addStringMetadataToLoop(loop, kEnable, 1);
    addStringMetadataToLoop(loop, "llvm.loop.vectorize.width", 2);
    addStringMetadataToLoop(loop, "llvm.loop.interleave.count", 1);
    any = true;
  }
  return any;
}

/// Neither what C asks of the vectoriser is tried (pragmas: it would make vectors that this machine
/// has not) nor, again, what it refused.
void drop_marks(const LoopInfo& loops) {
  for (Loop* loop : loops.getLoopsInPreorder())
    if (MDNode* id = loop->getLoopID(); findOptionMDForLoopID(id, kEnable) != nullptr)
      loop->setLoopID(makePostTransformationMetadata(
          id->getContext(), id, {"llvm.loop.vectorize.", "llvm.loop.interleave."}, {}));
}

/// False: there is none left. `nested`: it stood within another loop.
bool finish_one(Function& function, FunctionAnalysisManager& manager,
                SmallPtrSetImpl<const BasicBlock*>& done, bool& nested) {
  auto& scev = manager.getResult<ScalarEvolutionAnalysis>(function);
  for (const Loop* loop : manager.getResult<LoopAnalysis>(function).getLoopsInPreorder())
    if (loop->isInnermost() && loop->getNumBlocks() == 1 && done.insert(loop->getHeader()).second &&
        finish_paired_loop(*loop, scev)) {
      nested |= loop->getParentLoop() != nullptr;
      return true;
    }
  return false;
}

}  // namespace

PreservedAnalyses VectorLoopsPass::run(Function& function, FunctionAnalysisManager& manager) {
  if (function.hasOptSize() || isInterruptHandler(function) ||
      manager.getResult<LoopAnalysis>(function).empty())
    return PreservedAnalyses::all();
  drop_marks(manager.getResult<LoopAnalysis>(function));
  const bool any = mark_loops(function, manager);
  manager.invalidate(function, PreservedAnalyses::none());
  if (!any)
    return PreservedAnalyses::none();
  LoopVectorizeOptions options;
  options.setVectorizeOnlyWhenForced(true).setInterleaveOnlyWhenForced(true);
  LoopVectorizePass(options).run(function, manager);
  manager.invalidate(function, PreservedAnalyses::none());
  drop_marks(manager.getResult<LoopAnalysis>(function));
  SmallPtrSet<const BasicBlock*, 8> done;
  bool nested = false;
  while (finish_one(function, manager, done, nested))
    manager.invalidate(function, PreservedAnalyses::none());
  if (nested)
    ask_once(function, manager);
  return PreservedAnalyses::none();
}

}  // namespace finback::compiler
