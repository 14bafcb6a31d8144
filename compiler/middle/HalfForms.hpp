// How the low 16 bits of a loop's values come from the low 16 bits of others: what can be computed
// in 16 bits although C has it in int, in operations that the machine has for pairs of halves.
#pragma once

#include <llvm/ADT/SmallVector.h>
#include <llvm/Analysis/LoopInfo.h>

namespace finback::compiler {

constexpr unsigned kHalfBits = 16;

[[nodiscard]] inline bool is_half(const llvm::Value* value) {
  return value->getType()->isIntegerTy(kHalfBits);
}

struct HalfForm {
  // negated and amount saturate; distance and mean (rounded down) are those of two.
  enum Kind {
    none,
    same,
    loaded,
    invariant,
    operation,
    shift,
    intrinsic,
    negated,
    amount,
    distance,
    mean
  };
  Kind kind = none;
  unsigned code = 0;  // of the operation, the shift, or the intrinsic
  unsigned by = 0;    // of a shift, or of one to the right that follows
  llvm::SmallVector<llvm::Value*, 2> operands;
  llvm::SmallVector<const llvm::Instruction*, 2> within;  // what else the form stands for
};

/// Is the value what its low 16 bits are, extended by their sign?
[[nodiscard]] bool fits_signed(const llvm::Value* value, const llvm::DataLayout& layout);

/// May it be -32768? Of two of these the product is 2^30, whose fraction alone passes 32767.
[[nodiscard]] bool may_be_least(const llvm::Value* value);

/// The form of a value of 16 or 32 bits; none where it has no such form.
[[nodiscard]] HalfForm form_of(llvm::Value* value, const llvm::Loop& loop);

}  // namespace finback::compiler
