// What the back end cannot do is said up front, at its line, in clang's form.
#pragma once

#include <llvm/IR/Module.h>
#include <string>
#include <vector>

namespace finback::compiler {

/// One message for each construct without a lowering: "file:line:col: error: what".
std::vector<std::string> unsupported_constructs(const llvm::Module& module,
                                                const std::string& input);

}  // namespace finback::compiler
