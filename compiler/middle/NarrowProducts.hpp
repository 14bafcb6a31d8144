// Products of words of which only the low half is wanted, as a mixture of pixels has them, are
// taken from the low halves of their factors: one cycle instead of three. At the end of the middle
// end: the optimiser does not know what the product has become.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class NarrowProductsPass : public llvm::PassInfoMixin<NarrowProductsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
};

}  // namespace finback::compiler
