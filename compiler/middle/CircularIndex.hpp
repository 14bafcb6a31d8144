// Indices and pointers of a loop that go round in circles, as C has it:
//
//   i = circindex(i, s, n);   p = circptr(p, s, base, bytes);
//   i = (i + s) % n;          i = (i + s) & (n - 1);
//   if (++i == n) i = 0;      i = i == 0 ? n - 1 : i - 1;
//   x[(head + k) & (n - 1)]
//
// with what comes of these on the way through the middle end. Does not ask whether the start lies
// within the circle, nor what the index is used for.
#pragma once

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/IR/Instructions.h>
#include <optional>

namespace finback::compiler {

/// Beyond that many elements a circle is none: its bytes might not fit a word.
constexpr uint32_t kLargestCircle = 1U << 28;

struct CircularIndex {
  llvm::Value* value = nullptr;  ///< in a round: a phi of the loop's head, or what is masked there
  llvm::PHINode* phi = nullptr;  ///< that goes with it; null of a masked sum
  llvm::Value* next = nullptr;   ///< what the phi is in the next round
  const llvm::SCEV* start = nullptr;  ///< of what is masked: any number
  /// A count of elements, or of bytes for a pointer: `size`, or where that is null the value
  /// `size_less_one` and one.
  llvm::Value* size = nullptr;
  llvm::Value* size_less_one = nullptr;
  llvm::Value* step = nullptr;  ///< in the same units, |step| <= size
  llvm::Value* base = nullptr;  ///< of a pointer; null for an index
  bool vouched = false;         ///< by the caller of circindex or circptr: the start lies within
  /// What makes `next` of the phi and of what the loop does not change, in order.
  llvm::SmallVector<llvm::Instruction*, 4> chain;
};

/// The phi, of the head of a loop with one latch and one way in, as a circular index; nothing
/// where it is none.
std::optional<CircularIndex> match_circular_index(llvm::PHINode& phi, const llvm::Loop& loop);
/// The same for `sum & (n - 1)` in the loop, n a power of two. Where the sum is the value before
/// and a step, that is the phi's next value; other sums are of no phi of the circle's.
std::optional<CircularIndex> match_masked_index(llvm::Instruction& masked, const llvm::Loop& loop,
                                                llvm::ScalarEvolution& scev);

}  // namespace finback::compiler
