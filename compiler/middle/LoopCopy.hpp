// A loop in two forms: which of them runs is asked in front of it.
#pragma once

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/Transforms/Utils/ValueMapper.h>

namespace finback::compiler {

struct LoopCopy {
  llvm::Loop* loop;
  llvm::BasicBlock* preheader;
  llvm::BasicBlock* preheader_of_original;
  llvm::Instruction* before_both;  // goes to the original: the choice is to take its place
};

/// Copies a loop that has a preheader and one exit; `map` leads from what is in it to the copy's.
/// Values that are wanted behind the loop come out by phis, of the original or of the copy.
[[nodiscard]] LoopCopy copy_beside(llvm::Loop& loop, const char* suffix, llvm::LoopInfo& loops,
                                   llvm::DominatorTree& dominators, llvm::ValueToValueMapTy& map);

}  // namespace finback::compiler
