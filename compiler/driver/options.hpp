// What the command line asks for.
#pragma once

#include <string>
#include <vector>

namespace finback::compiler {

struct Options {
  std::vector<std::string> inputs;
  std::string output;  // empty: NAME.bir beside nothing, in the working directory
  char level = '2';    // 0, 1, 2, 3 or s
  std::vector<std::string> clang_arguments;  // -I, -D, -U, -include, -W..., in their order
  bool emit_llvm = false;                    // LLVM IR after the middle end, for the curious
  bool verify = false;                       // run the machine verifier between passes
};

}  // namespace finback::compiler
