// What a loop of sums of products of 16-bit integers is: one block that adds to each sum, of which
// there are one or two, one product of two loaded halves a round, and does nothing else. Analysis
// only; PairProducts and JamProducts change such loops.
#pragma once

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/Instructions.h>
#include <optional>

namespace finback::compiler {

/// A half that is loaded in each round, from an address that goes on by `step` bytes.
struct Factor {
  llvm::LoadInst* load;
  const llvm::SCEV* start;
  const llvm::SCEV* step;
};

struct ProductSum {
  llvm::PHINode* phi;
  llvm::BinaryOperator* next;
  Factor factors[2];

  /// What the sum begins with.
  [[nodiscard]] llvm::Value* start() const;
};

struct ProductLoop {
  llvm::Loop* loop;
  llvm::SmallVector<ProductSum, 2> sums;
  const llvm::SCEV* rounds;  // 32 bits; at least 1
};

[[nodiscard]] std::optional<ProductLoop> match_product_loop(llvm::Loop& loop,
                                                            llvm::ScalarEvolution& scev);

/// Does the address go on by one half a round?
[[nodiscard]] bool goes_by_halves(const Factor& factor);

}  // namespace finback::compiler
