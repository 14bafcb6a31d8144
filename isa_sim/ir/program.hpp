// A program before it is placed: functions of packets of instructions, data objects, and the pieces
// of assembler files; all symbolic, no addresses yet.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::ir {

using isa::OperandValue;
using isa::ParsedInstruction;

// One to three instructions that issue together: the DSP instruction first, then the accesses in
// the order of the text.
struct Packet {
  std::vector<ParsedInstruction> slots;
  int file = 0;         // index into Program::source_files, 0: none (from .file/.loc)
  int line = 0;         // of the C source
  SourcePlace written;  // where it stands in the BIR text
};

// How far a symbol is seen. A weak definition gives way to a global one of the same name.
enum class Binding : std::uint8_t { local, global, weak };

struct Function {
  std::string name;  // as in the text, with the leading underscore of C names
  Binding binding = Binding::local;
  std::uint32_t align = 2;  // bytes, a power of two
  std::string section;
  std::vector<Packet> packets;
  std::map<std::string, std::size_t>
      labels;  // local label -> packet index (== packets.size(): the end)
  SourcePlace written;
};

// `bytes` bytes at `offset` of an object take the address symbol + addend.
struct Relocation {
  std::uint32_t offset = 0;
  int bytes = 4;
  std::string symbol;
  std::int32_t addend = 0;
  SourcePlace written = {};  // of an assembler file; does not count in a comparison
  bool operator==(const Relocation& other) const {
    return offset == other.offset && bytes == other.bytes && symbol == other.symbol &&
           addend == other.addend;
  }
};

struct Object {
  std::string name;
  Binding binding = Binding::local;
  std::uint32_t align = 1;  // bytes, a power of two
  std::uint32_t size = 0;
  std::string section;                // ".data", ".bss", ".rodata", or as named
  std::vector<std::uint8_t> initial;  // shorter than `size`: the rest is zero
  std::vector<Relocation> relocations;
  SourcePlace written;
};

// A place in a piece that has a name.
struct PieceLabel {
  std::string name;
  Binding binding = Binding::local;
  std::uint32_t offset = 0;  // bytes from the piece's start, up to its size
  bool begins = false;       // a function or an object, in profiles and reports
  SourcePlace written;
};

struct PiecePacket {
  std::uint32_t offset = 0;
  Packet packet;
};

// A section of an assembler file: instructions and bytes in the order of the text, placed as one,
// so that neighbours in the text are neighbours in memory.
struct Piece {
  std::string name;  // "boot.text": the file's name without its ending, then the section's
  std::uint32_t align = 1;
  std::uint32_t size = 0;
  bool code = false;                  // placed where instructions go
  std::vector<PiecePacket> packets;   // ordered by offset
  std::vector<std::uint8_t> initial;  // zero where instructions lie; shorter than `size`: zeros
  std::vector<Relocation> relocations;
  std::vector<PieceLabel> labels;  // ordered by offset
  SourcePlace written;
};

// A symbol that is a number (`.set`).
struct Constant {
  std::string name;
  Binding binding = Binding::local;
  std::uint32_t value = 0;
};

// What a BIR file says, in functions and objects; or an assembler file, in pieces and constants.
struct Program {
  std::string path;                       // the file, for messages
  std::vector<std::string> source_files;  // [0] is "", .file N is [N]
  std::vector<Function> functions;        // in the order of the text
  std::vector<Object> objects;
  std::vector<Piece> pieces;
  std::vector<Constant> constants;
};

// Whether code begins at this symbol: a function, or a label of a piece with instructions.
[[nodiscard]] bool defines_code(const Program& program, std::string_view symbol);

// Whether two BIR programs say the same; where they are written does not count.
[[nodiscard]] bool same_program(const Program& one, const Program& other);

// A symbol as C spells it: without one leading underscore.
[[nodiscard]] inline std::string c_name(const std::string& symbol) {
  return symbol.starts_with('_') ? symbol.substr(1) : symbol;
}

// Puts a packet's instructions into the canonical order, which is that of the issue slots.
void order_slots(Packet& packet, std::span<const isa::Instruction> table);

// Bytes that a packet takes: its instruction's 2 or 4, or 8 when several issue together.
[[nodiscard]] inline std::uint32_t packet_length(const Packet& packet,
                                                 std::span<const isa::Instruction> table) {
  return packet.slots.size() > 1
             ? 8
             : static_cast<std::uint32_t>(
                   table[static_cast<std::size_t>(packet.slots[0].instruction)].length);
}

}  // namespace finback::ir
