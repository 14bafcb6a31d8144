// Tests at run time of what a faster form of a loop takes for granted.
#pragma once

#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/PassManager.h>

namespace finback::compiler {

/// Is it known to be a multiple of 4?
[[nodiscard]] bool is_aligned(const llvm::SCEV* value, llvm::ScalarEvolution& scev);

/// Objects of this module at whose addresses `values` begin are laid at multiples of 4, where
/// nothing forbids. To be called before anybody asks for these values' alignment.
void align_objects(llvm::ArrayRef<const llvm::SCEV*> values, llvm::ScalarEvolution& scev);

/// Can all of them be computed before `at`?
[[nodiscard]] bool can_expand(llvm::ArrayRef<const llvm::SCEV*> values, llvm::ScalarEvolution& scev,
                              llvm::Instruction* at);

/// Whether each of `values` is a multiple of 4, computed before `at`.
[[nodiscard]] llvm::Value* write_alignment_test(llvm::ArrayRef<const llvm::SCEV*> values,
                                                llvm::ScalarEvolution& scev, llvm::Instruction* at);

/// Whether there are `least` rounds and each of `values` is a multiple of 4, computed before `at`.
[[nodiscard]] llvm::Value* write_test(const llvm::SCEV* rounds, unsigned least,
                                      llvm::ArrayRef<const llvm::SCEV*> values,
                                      llvm::ScalarEvolution& scev, llvm::Instruction* at);

/// Is a word aligned, is a count odd? What all rounds of a loop answer alike is asked in front of
/// it.
void ask_once(llvm::Function& function, llvm::FunctionAnalysisManager& manager);

}  // namespace finback::compiler
