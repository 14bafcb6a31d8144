// A BIR program: functions of packets of instructions, and data objects, all symbolic; no addresses
// yet.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
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
  bool operator==(const Relocation&) const = default;
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

struct Program {
  std::string path;                       // the BIR file, for messages
  std::vector<std::string> source_files;  // [0] is "", .file N is [N]
  std::vector<Function> functions;        // in the order of the text
  std::vector<Object> objects;
};

// Whether two programs say the same; where they are written does not count.
[[nodiscard]] bool same_program(const Program& one, const Program& other);

// A symbol as C spells it: without one leading underscore.
[[nodiscard]] inline std::string c_name(const std::string& symbol) {
  return symbol.starts_with('_') ? symbol.substr(1) : symbol;
}

// Bytes that a packet takes: its instruction's 2 or 4, or 8 when several issue together.
[[nodiscard]] inline std::uint32_t packet_length(const Packet& packet,
                                                 std::span<const isa::Instruction> table) {
  return packet.slots.size() > 1
             ? 8
             : static_cast<std::uint32_t>(
                   table[static_cast<std::size_t>(packet.slots[0].instruction)].length);
}

}  // namespace finback::ir
