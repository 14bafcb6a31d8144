// Loops over 16-bit arrays, two elements at a time: HalfLoops finds them, LLVM's vectoriser proves
// that their arrays are apart (or asks it at run time) and writes them, and where words are not
// known to be aligned, that is asked, too. PairWords makes words and instructions of the vectors.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class VectorLoopsPass : public llvm::PassInfoMixin<VectorLoopsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
};

}  // namespace finback::compiler
