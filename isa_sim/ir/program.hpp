// A BIR program: functions of packets of instructions, and data objects, all symbolic; no addresses
// yet.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/isa/operand.hpp>

namespace finback::ir {

// The value of an operand before linking: a number, or symbol + number.
struct OperandValue {
  std::int32_t number = 0;
  std::string symbol;  // empty: `number` is the value
  bool operator==(const OperandValue&) const = default;
};

struct ParsedInstruction {
  int instruction = -1;  // index in isa::instruction_table()
  std::array<OperandValue, isa::kMaxOperands> operand;
  bool operator==(const ParsedInstruction&) const = default;
};

// One to three instructions that issue together; slot order as written.
struct Packet {
  std::vector<ParsedInstruction> slots;
  int file = 0;         // index into Program::source_files, 0: none (from .file/.loc)
  int line = 0;         // of the C source
  SourcePlace written;  // where it stands in the BIR text
};

struct Function {
  std::string name;  // as in the text, with the leading underscore of C names
  bool global = false;
  std::uint32_t align = 2;
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
};

struct Object {
  std::string name;
  bool global = false;
  std::uint32_t align = 1;
  std::uint32_t size = 0;
  std::string section;                // ".data", ".bss", ".rodata", or as named
  std::vector<std::uint8_t> initial;  // shorter than `size`: the rest is zero
  std::vector<Relocation> relocations;
  SourcePlace written;
};

struct Program {
  std::vector<std::string> source_files;  // [0] is "", .file N is [N]
  std::vector<Function> functions;        // in the order of the text
  std::vector<Object> objects;
};

}  // namespace finback::ir
