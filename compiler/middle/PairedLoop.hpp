// A loop over pairs of halves as LLVM's vectoriser wrote it, made fit for this machine: passed by
// where there are few elements or words are not aligned, a pointer an array, and the element that
// an odd count leaves over behind it. What it cannot ask or does not know stays as it is: loads and
// stores of single halves.
#pragma once

#include <llvm/Analysis/ScalarEvolution.h>

namespace finback::compiler {

/// A loop of one block, straight from the vectoriser; others are left alone. True: something was
/// changed, and what was known of the function is out of date.
bool finish_paired_loop(const llvm::Loop& loop, llvm::ScalarEvolution& scev);

}  // namespace finback::compiler
