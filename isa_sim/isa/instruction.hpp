// The form of the instruction table: one entry an instruction, from which assembler, disassembler,
// verifier, interpreter, timing, documentation and tests come. To add an instruction, add an entry
// to one of the files table_*.cpp; nothing else needs to change.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <isa_sim/isa/operation.hpp>

namespace finback::isa {

// Where an instruction may stand in a packet (hardware.md 1.3).
enum class Slot : std::uint8_t {
  alone,   // never in a packet
  dsp,     // slot 0: a 32-bit DSP instruction, or MNOP
  access,  // slot 1: a 16-bit load or store through a P register, or a change of an I register
  index_access,  // slot 1 or 2: a 16-bit load or store through an I register
  nop,           // slot 1 or 2: NOP
};

// How long the instruction holds the pipeline; every value but one cycle is a parameter of the
// core.
enum class Issue : std::uint8_t {
  one,
  multiply32,
  link,
  unlink,
  core_sync,
  system_sync,
  event,  // STI, RAISE, EXCPT
  test_and_set,
  register_list,  // one a register: push and pop multiple
};

// When its result can be used (hardware.md 1.5).
enum class Result : std::uint8_t {
  alu,      // end of EX2
  load,     // start of EX1
  move,     // a move from the data side into a P, I, M, B or L register
  pointer,  // computed in AC: P and I arithmetic, immediates to P
};

// When its data operands are needed.
enum class Needs : std::uint8_t { ex2, ex1 };

enum class Flow : std::uint8_t {
  none,
  jump,  // direct, unconditional
  jump_indirect,
  call,
  call_indirect,
  ret,               // RTS
  ret_event,         // RTI and the like
  branch,            // conditional, predicted not taken
  branch_predicted,  // conditional with (BP)
  loop_setup,
  idle,
  event,  // may change which interrupts are taken: ends a block
};

enum class Energy : std::uint8_t { nop, alu, mac, access, control, idle };

// Bits for registers that are read or written without standing in the syntax.
enum Implicit : std::uint32_t {
  kNothing = 0,
  kReadsCc = 1u << 0,
  kWritesCc = 1u << 1,
  kReadsSp = 1u << 2,
  kWritesSp = 1u << 3,
  kReadsFp = 1u << 4,
  kWritesFp = 1u << 5,
  kReadsRets = 1u << 6,
  kWritesRets = 1u << 7,
  kReadsA0 = 1u << 8,
  kWritesA0 = 1u << 9,
  kReadsA1 = 1u << 10,
  kWritesA1 = 1u << 11,
};

// What an instruction does to memory, for the packet rules and counters.
enum class MemoryUse : std::uint8_t { none, load, store, load_store };

// Further rules for an instruction's operands: what is wrong with them, or "".
using Check = std::string_view (*)(const OperandNumbers& operand);
// Prepares an operation: chooses its meaning by options, packs operands. Without one, the operation
// takes the first operands as they are.
using Prepare = void (*)(const OperandNumbers& operand, Operation& operation);

struct Instruction {
  std::string_view syntax;     // operands by kind and role, see OperandKind
  std::string_view also = {};  // another way to write it, with the same operands; never printed
  int length = 2;              // bytes
  Slot slot = Slot::alone;
  Issue issue = Issue::one;
  Result result = Result::alu;
  Needs needs = Needs::ex2;
  Flow flow = Flow::none;
  MemoryUse memory = MemoryUse::none;
  std::uint8_t access_bytes = 0;  // moved by one execution; of a register list, by each register
  Energy energy = Energy::alu;
  std::uint32_t implicit = kNothing;
  Execute execute = nullptr;
  Check check = nullptr;
  Prepare prepare = nullptr;
  Execute execute_aligned = nullptr;  // beside an instruction that aligns the packet's accesses
  bool aligns = false;                // it does: DISALGNEXCPT and what implies it
  std::string_view meaning = {};      // one line for the manual; "" when the syntax says it all
};

// The whole table. An instruction's index in it is its identity within one version of Finback.
[[nodiscard]] std::span<const Instruction> instruction_table();

}  // namespace finback::isa
