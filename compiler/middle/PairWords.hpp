// Vectors of two halves as words, and what is done with them by the machine's instructions for
// pairs. What it has none for stays a vector, which selection takes apart.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class PairWordsPass : public llvm::PassInfoMixin<PairWordsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
};

}  // namespace finback::compiler
