// Short ways to assembled text, its bytes and instructions.
#pragma once

#include <string>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/printer.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::assembler {

// As the file "a.s".
inline ir::Program program(const std::string& text, const Options& options = {}) {
  return assemble(text, "a.s", options);
}

// What the assembler complains of; "" when it does not.
inline std::string error_of(const std::string& text, const Options& options = {}) {
  try {
    (void)program(text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The section "a" + `section`.
inline const ir::Piece& piece(const ir::Program& from, const std::string& section) {
  for (const ir::Piece& candidate : from.pieces) {
    if (candidate.name == "a" + section) {
      return candidate;
    }
  }
  throw InputError("no section " + section);
}

// The bytes of a text that is all data, up to the section's size.
inline std::vector<int> bytes_of(const std::string& text) {
  const ir::Program whole = program(".data\n" + text);
  if (whole.pieces.empty()) {
    return {};
  }
  const ir::Piece& data = piece(whole, ".data");
  std::vector<int> bytes(data.initial.begin(), data.initial.end());
  bytes.resize(data.size);
  return bytes;
}

// The instructions of .text, as they are printed.
inline std::vector<std::string> code_of(const std::string& text, const Options& options = {}) {
  const ir::Program whole = program(text, options);
  std::vector<std::string> printed;
  for (const ir::PiecePacket& at : piece(whole, ".text").packets) {
    printed.push_back(ir::print(at.packet, isa::instruction_syntax()));
  }
  return printed;
}

}  // namespace finback::assembler
