// The rules that a program must keep and that need no address: what may issue together, hardware
// loops, symbols of one file.
//
// Distances (pc10, pc12, pc24, loop ranges) are checked by the linker, after layout; names that
// other units define, too. Source: hardware.md 1.3 (issue slots, anomaly 05000074) and 1.4 (loops).
#pragma once

#include <string>
#include <vector>

#include <isa_sim/ir/program.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::ir {

// Every broken rule, "file:line:column: rule", in the order of the text; empty when all is well.
[[nodiscard]] std::vector<std::string> problems(const Program& program, const isa::Syntax& syntax);

// Throws InputError with the first of `problems` and how many more there are.
void verify(const Program& program, const isa::Syntax& syntax);
void verify(const Program& program);

}  // namespace finback::ir
