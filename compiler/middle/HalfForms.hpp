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
  // negated and amount saturate; distance is that of two.
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
    distance
  };
  Kind kind = none;
  unsigned code = 0;  // of the operation, the shift, or the intrinsic
  unsigned by = 0;    // of a shift
  llvm::SmallVector<llvm::Value*, 2> operands;
  llvm::SmallVector<const llvm::Instruction*, 2> within;  // what else the form stands for
};

/// The form of a value of 16 or 32 bits; none where it has no such form.
[[nodiscard]] HalfForm form_of(llvm::Value* value, const llvm::Loop& loop);

}  // namespace finback::compiler
