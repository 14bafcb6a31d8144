#include "LoopCopy.hpp"

#include <llvm/IR/Instructions.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/Cloning.h>
#include <llvm/Transforms/Utils/LoopUtils.h>

namespace finback::compiler {

using namespace llvm;

LoopCopy copy_beside(Loop& loop, const char* suffix, LoopInfo& loops, DominatorTree& dominators,
                     ValueToValueMapTy& map) {
  BasicBlock* before = loop.getLoopPreheader();
  BasicBlock* exiting = loop.getExitingBlock();
  BasicBlock* exit = loop.getExitBlock();
  BasicBlock* preheader = SplitBlock(before, before->getTerminator(), &dominators, &loops);
  SmallVector<BasicBlock*, 8> blocks;
  Loop* copy =
      cloneLoopWithPreheader(preheader, before, &loop, map, suffix, &loops, &dominators, blocks);
  remapInstructionsInBlocks(blocks, map);
  for (PHINode& phi : exit->phis()) {
    Value* value = phi.getIncomingValueForBlock(exiting);
    const auto mapped = map.find(value);
    phi.addIncoming(mapped == map.end() ? value : &*mapped->second,
                    cast<BasicBlock>(&*map[exiting]));
  }
  return {copy, cast<BasicBlock>(&*map[preheader]), preheader, before->getTerminator()};
}

}  // namespace finback::compiler
