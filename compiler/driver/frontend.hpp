// C and C++ to LLVM IR: clang-19 as a subprocess, in the guise of the one target that lowers
// nothing of its own (llvm csky: little-endian ILP32, words for small structs).
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <memory>
#include <string>

#include "options.hpp"

namespace finback::compiler {

/// The module of one C or C++ file, with this target's data layout. Empty when clang reported
/// errors (it has printed them itself). Throws std::runtime_error when clang cannot be run.
std::unique_ptr<llvm::Module> compile_c(const std::string& input, const Options& options,
                                        const std::string& include_dir, llvm::LLVMContext& context);

}  // namespace finback::compiler
