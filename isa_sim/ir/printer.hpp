// Program -> canonical BIR text: parse(print(p)) says the same as p, and printing that gives
// identical bytes. Functions come first, then objects, each in the order of the program.
#pragma once

#include <string>

#include <isa_sim/ir/program.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::ir {

[[nodiscard]] std::string print(const Program& program, const isa::Syntax& syntax);
[[nodiscard]] std::string print(const Program& program);
// "R2.L = ONES R2 || R0 = [P0++]", without `;`.
[[nodiscard]] std::string print(const Packet& packet, const isa::Syntax& syntax);

}  // namespace finback::ir
