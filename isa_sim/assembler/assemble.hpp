// Assembler files (`.s`) -> program: the GNU assembler's dialect of hand-written Blackfin code.
//
// Reads macros, conditionals, repetitions, includes, expressions, numbered labels and the GNU
// spellings of data; instructions are those of the instruction table, as in BIR. A section of a
// file becomes one piece, in the order of the text. Does not run the C preprocessor, knows no
// encodings (data among code cannot be executed) and no relocations but addresses of 4 bytes.
// Source: GNU as manual, "Pseudo Ops", "Expressions" and "Blackfin Dependent". docs/assembler.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isa_sim/ir/program.hpp>

namespace finback::assembler {

struct Options {
  std::vector<std::filesystem::path> include_folders;         // after the file's own folder
  std::vector<std::pair<std::string, std::int64_t>> defines;  // symbols that are numbers
  std::function<void(const std::string& message)> note;       // .print, .warning; may be empty
};

// `file` names the text in messages; files that it includes are looked for beside it. Throws
// InputError "file:line:column: what, mend" at the first thing that cannot be read, with the macro
// it stands in; and for texts that would take too long or too much memory.
[[nodiscard]] ir::Program assemble(std::string_view text, const std::string& file,
                                   const Options& options = {});
[[nodiscard]] ir::Program assemble_file(const std::filesystem::path& path,
                                        const Options& options = {});

// Whether a file is for this assembler, by its name's ending: ".s", ".S" or ".asm".
[[nodiscard]] bool is_assembler_file(const std::filesystem::path& path);

}  // namespace finback::assembler
