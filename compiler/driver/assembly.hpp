// Inline assembly on its way through clang, which knows no Blackfin: constraints and clobbers of
// ours are written as some of the front end's own target, and read back in BfinInlineAsm.cpp.
//
// Works on preprocessed text. "d" (data registers) becomes "l", "a" (pointer registers) stays; a
// clobbered register takes the name of a register of the other machine, the same for the same.
#pragma once

#include <string>

namespace finback::compiler {

/// Rewrites every asm statement of `text`; false when it has none. What is no assembly of the known
/// form is left for clang to complain about.
bool rewrite_assembly(std::string& text);

}  // namespace finback::compiler
