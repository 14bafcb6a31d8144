// Sums of products of 16-bit integers for both multipliers: loops of them are paired
// (PairProducts), where run-time tests allow, and the neighbours of an outer loop's round are
// summed up together (JamProducts). The loop as C wrote it stays for what the tests turn away.
// Function pass, for late in the middle end.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class ProductsPass : public llvm::PassInfoMixin<ProductsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& analyses);
};

}  // namespace finback::compiler
