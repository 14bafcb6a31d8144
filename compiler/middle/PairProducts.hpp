// Loops of sums of products two rounds at a time, so that both multipliers are busy: halves come
// two in a word, and each of two sums takes two products a round. A single sum is split in the sum
// of the even and that of the odd products. What the accumulators need, that exact sums fit 40
// bits, is seen to here: the loop's sums begin at 0 and end after 511 products at most, unless C's
// own sums must not overflow and are not split.
//
// Words must lie at multiples of 4: the caller knows of the addresses, or asks at run time.
#pragma once

#include "ProductLoop.hpp"

namespace finback::compiler {

/// How a loop's products are paired.
enum class Pairing {
  kLanes,    ///< one sum, both factors go by halves: even and odd products
  kColumns,  ///< two sums share a factor; the others are neighbours: two in a word
  kSliding,  ///< the same, and they go by halves: the second is the first's next
};

struct PairPlan {
  ProductLoop products;
  Pairing pairing;
  Factor shared;                                    // of both sums; the lanes' first factor
  Factor own;                                       // of the first sum; the lanes' second factor
  bool shared_in_words;                             // two halves of `shared` are loaded as one word
  llvm::SmallVector<const llvm::SCEV*, 4> aligned;  // what must be multiples of 4
};

/// How a loop can be paired, if it can: as it stands.
[[nodiscard]] std::optional<PairPlan> plan_pairs(const ProductLoop& products,
                                                 llvm::ScalarEvolution& scev);

/// Two pairs: whoever runs them can have the second one begin before the first has ended.
inline constexpr unsigned kLeastPairedRounds = 4;

/// What write_pairs leaves: the sums at the end of a block that has no terminator yet.
struct PairedSums {
  llvm::BasicBlock* end;
  llvm::SmallVector<llvm::Value*, 2> values;
};

/// Writes the paired loop behind `before`, which has no terminator yet. There are at least
/// kLeastPairedRounds.
[[nodiscard]] PairedSums write_pairs(const PairPlan& plan, llvm::ScalarEvolution& scev,
                                     llvm::BasicBlock* before);

}  // namespace finback::compiler
