// Sums of absolute differences of bytes, in one loop or in a nest over rows, become one call of the
// runtime's __absolute_differences (firmware/runtime/absolute_differences.bir), which takes four
// bytes a cycle. Only whole loops: nothing else may happen in them, and nothing but the sum be
// wanted of them. Runs on loops that are rotated and not yet unrolled.
#pragma once

#include <llvm/Transforms/Scalar/LoopPassManager.h>

namespace finback::compiler {

class AbsoluteDifferencesPass : public llvm::PassInfoMixin<AbsoluteDifferencesPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Loop& loop, llvm::LoopAnalysisManager&,
                              llvm::LoopStandardAnalysisResults& analyses, llvm::LPMUpdater&);
};

}  // namespace finback::compiler
