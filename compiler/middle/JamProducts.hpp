// Two rounds of an outer loop at a time, where the loop within it is one sum of products that
// shares a factor with the next round's: then each word that is loaded serves both sums. The nest
// is doubled under run-time tests; LLVM's own unroll-and-jam does the rest. Nests that store what
// they load from memory that may be the same are left alone.
#pragma once

#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/DependenceAnalysis.h>
#include <llvm/Analysis/OptimizationRemarkEmitter.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/Dominators.h>

#include "ProductLoop.hpp"

namespace finback::compiler {

struct NestAnalyses {
  llvm::LoopInfo& loops;
  llvm::ScalarEvolution& scev;
  llvm::DominatorTree& dominators;
  llvm::AssumptionCache& assumptions;
  llvm::AAResults& aliases;
  llvm::DependenceInfo& dependences;
  const llvm::TargetTransformInfo& target;
  llvm::OptimizationRemarkEmitter& remarks;
};

/// A nest of which the fast copy has been jammed.
struct JammedNest {
  llvm::Loop* inner;  // of the fast copy: two sums, at least two rounds
  llvm::SmallVector<const llvm::SCEV*, 4> aligned;  // known to be multiples of 4 in the fast copy
};

/// Nothing, and nothing was done, where the nest around these products cannot be jammed or little
/// would be won.
[[nodiscard]] std::optional<JammedNest> jam_products(const ProductLoop& products,
                                                     const NestAnalyses& analyses);

}  // namespace finback::compiler
