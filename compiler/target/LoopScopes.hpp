// What `restrict` of inlined functions says of a loop of one block in all of its passes. A promise
// that is made anew inside the loop holds for one pass only and is left out. Does not look at the
// restrict of the function's own arguments, which their objects stand for.
#pragma once

#include <llvm/ADT/SmallPtrSet.h>
#include <llvm/CodeGen/MachineBasicBlock.h>
#include <llvm/IR/Metadata.h>

namespace llvm {

class LoopScopes {
 public:
  explicit LoopScopes(const MachineBasicBlock& block);

  /// Of an access's promises, those that hold from pass to pass.
  [[nodiscard]] AAMDNodes in_every_pass(const AAMDNodes& promises) const;

 private:
  SmallPtrSet<const Metadata*, 8> outside_;  // scopes that begin outside of the loop
};

/// What is promised of an access by its metadata; nothing where there are several places, or an
/// order.
[[nodiscard]] AAMDNodes promises_of(const MachineInstr& access);
/// Do the promises say that two accesses lie apart?
[[nodiscard]] bool lie_apart(const AAMDNodes& a, const AAMDNodes& b);

}  // namespace llvm
