// LLVM IR to BIR: the middle end at the asked level, then this target's code generator.
#pragma once

#include <llvm/IR/Module.h>
#include <string>

#include "options.hpp"

namespace finback::compiler {

/// Marks interrupt handlers; to be called before anything else sees the module.
void prepare(llvm::Module& module);

/// The BIR text of a prepared module.
std::string generate(llvm::Module& module, const Options& options);

}  // namespace finback::compiler
