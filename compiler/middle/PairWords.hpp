// Vectors of two halves as words, and what is done with them by the machine's instructions for
// pairs. What it has none for stays a vector, which selection takes apart.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/PassManager.h>

namespace finback::compiler {

/// The mean of two halves, rounded down, in 16 bits: a shape that the pass knows again.
llvm::Value* write_mean(llvm::Value* a, llvm::Value* b, llvm::IRBuilder<>& builder);

class PairWordsPass : public llvm::PassInfoMixin<PairWordsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
};

}  // namespace finback::compiler
