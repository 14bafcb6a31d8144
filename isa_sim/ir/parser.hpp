// BIR text -> program.
//
// Reads what docs/bir.md describes: the GNU assembler's Blackfin dialect, headed by `.bir 1`.
// Does not check packets (verifier.hpp) and does not assign addresses (linker.hpp).
// Source: GNU as manual, "Pseudo Ops" and "Blackfin Dependent".
#pragma once

#include <filesystem>
#include <string_view>

#include <isa_sim/ir/program.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::ir {

// `file` names the text in messages and places. Throws InputError "file:line:column: what, mend" at
// the first thing that cannot be read.
[[nodiscard]] Program parse(std::string_view text, const std::string& file,
                            const isa::Syntax& syntax);
[[nodiscard]] Program parse(std::string_view text, const std::string& file);

// Reads, parses and verifies a file.
[[nodiscard]] Program load_program(const std::filesystem::path& path);

}  // namespace finback::ir
