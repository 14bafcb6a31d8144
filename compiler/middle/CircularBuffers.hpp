// Circular buffers of loops without calls: an index (CircularIndex says which) that only says where
// the loop loads and stores, or such a pointer, becomes the address in a ring, which the index
// registers step (passes/BfinRings). At most two rings a loop. Where C does not say that the index
// begins within the circle it is asked in front of the loop, which stays as it was for the answer
// no; not at -Os.
// What remains of circindex and circptr becomes additions and selections: at all levels, and at the
// end of the middle end, since the optimiser does not know what rings are.
#pragma once

#include <llvm/IR/PassManager.h>

namespace finback::compiler {

class CircularBuffersPass : public llvm::PassInfoMixin<CircularBuffersPass> {
 public:
  llvm::PreservedAnalyses run(llvm::Function& function, llvm::FunctionAnalysisManager& manager);
  static bool isRequired() { return true; }  // also of functions that are not optimised
};

}  // namespace finback::compiler
