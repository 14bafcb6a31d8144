// Shifts to the right into 16 bits that saturate, rounded or not, as fixed-point code in plain C
// says them: a shift to the left that saturates brings the 16 bits into the upper half, from which
// RND takes them rounded. Does not look at other widths, nor at sums that wrap.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class SaturatedShiftsPass : public llvm::PassInfoMixin<SaturatedShiftsPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
};

}  // namespace finback::compiler
