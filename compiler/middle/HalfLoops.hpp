// Loops of one block that compute 16-bit arrays from 16-bit arrays, in int as C has it, written in
// 16 bits: what LLVM's vectoriser then takes two at a time, in operations that the machine has for
// pairs. Sums, differences, bits, shifts by constants, minima, maxima, amounts, sums and
// differences and fractional products that saturate.
#pragma once

#include <llvm/Analysis/LoopAccessAnalysis.h>
#include <llvm/Analysis/ScalarEvolution.h>

namespace finback::compiler {

/// True: `loop` does nothing else than that, all arrays stepped through upwards without gaps, and
/// is now written in 16 bits. False: nothing was changed.
bool narrow_loop(llvm::Loop& loop, llvm::ScalarEvolution& scev,
                 llvm::LoopAccessInfoManager& accesses);

}  // namespace finback::compiler
