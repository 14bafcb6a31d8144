// What an instruction's meaning is written against: the architectural state of a core and a decoded
// operation.
//
// Models the programmer's view of one core: registers, accumulators, flags, and memory through
// windows. It knows nothing of time but carries the counters that the core's engine needs: a load
// or store that touches memory which others share, or a device, goes through the `slow_*` hooks,
// where the engine adds stalls or asks for a retry. Source: Blackfin Programming Reference,
// chapters 2 and 5.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include <common/memory_window.hpp>
#include <common/units.hpp>
#include <isa_sim/isa/operand.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::isa {

struct Operation;
struct ExecutionState;

// Carries out one operation and returns the next to run, or nullptr to leave the block: its end, or
// an access that must wait for the other actors (then `retry` is set).
using Execute = const Operation* (*)(ExecutionState&, const Operation*);

// An instruction's operands, each a number, in the order of its pattern.
using OperandNumbers = std::array<std::int32_t, kMaxOperands>;

// What a meaning works on: fewer operands than the text may have, packed by Instruction::prepare.
inline constexpr std::size_t kOperationOperands = 6;

struct Operation {
  Execute execute = nullptr;
  std::array<std::int32_t, kOperationOperands> operand{};
  mutable MemoryWindow* window =
      nullptr;              // the window hit last by this access site, never null for an access
  std::uint32_t site = 0;   // index of the access site's statistics in the engine
  std::uint16_t cycle = 0;  // static issue cycle within the block
  std::uint8_t length = 0;  // bytes of the whole packet, for return addresses
  std::uint8_t access_bytes = 0;  // that it moves to or from memory
  Address address = 0;            // of the packet

  std::int32_t operator[](int index) const { return operand[static_cast<std::size_t>(index)]; }
};

// What an instruction asks of the system around the core.
enum class SystemAction : std::uint8_t {
  idle,
  core_sync,
  system_sync,
  disable_interrupts,     // CLI; asked before the mask is saved and cleared
  enable_interrupts,      // STI; asked before the mask is set to `value`
  raise,                  // value: the event's number
  exception,              // value: the code
  return_from_interrupt,  // RTI, RTX, RTN, RTE; control was already sent to the return address
  return_from_exception,
  return_from_nmi,
  return_from_emulation,
  loop_bottom,    // LB0 or LB1 was written by a move; value: the address
  privileged,     // asked before a supervisor's register is read or written
  configure,      // SYSCFG was written
  read_cycles,    // CYCLES and CYCLES2 shall hold the time
  write_cycles,   // value: the low word
  write_cycles2,  // value: the high word
  pop_usp,        // asked before USP is popped
  saved_return,   // RETI was pushed: interrupts are let in
  loaded_return,  // RETI was popped: they are held back
  // Of the cache line at the address `value`; all but the last may ask for a retry.
  prefetch_line,
  flush_line,             // written back
  flush_invalidate_line,  // written back and forgotten
  flush_code_line,        // forgotten by the instruction cache
  // The instructions of table_debug.cpp.
  assertion_failed,  // operands: register, expected half; value: kHighHalf or 0
  print_register,    // value: its number, A0 and A1 among them
  print_registers,
  print_halves,     // value: a data register's number
  print_character,  // value: 0..255
  halt,             // value: the program's exit status
  emulation,        // EMUEXCPT
};

// The engine's side of memory and control; set once per core.
struct EngineHooks {
  // Finds where `address` lies. Returns the bytes to access, having charged stalls and counted;
  // nullptr with `state.retry` set when the access must be repeated later; throws GuestFault for an
  // illegal one. A store may have a second place, `state.store_also`. `continued`: a further access
  // of an instruction whose first access was granted, which is never sent back.
  std::uint8_t* (*slow_access)(ExecutionState& state, const Operation& operation, Address address,
                               int bytes, bool write, bool continued);
  // Device registers, 1, 2 or 4 bytes. Both answer false, with `state.retry` set, when the access
  // must be repeated.
  bool (*device_read)(ExecutionState& state, const Operation& operation, Address address, int bytes,
                      std::uint32_t& value);
  bool (*device_write)(ExecutionState& state, const Operation& operation, Address address,
                       int bytes, std::uint32_t value);
  // TESTSET of the byte at `address`; same contract.
  bool (*test_and_set)(ExecutionState& state, const Operation& operation, Address address,
                       std::uint8_t& old);
  void (*system)(ExecutionState& state, const Operation& operation, SystemAction action,
                 std::uint32_t value);
};

// Beyond the architecture: holds what a packet's store is going to write while its other slots
// write the register that it comes from.
inline constexpr int kScratchRegister = kRegisterCount;

struct ExecutionState {
  std::array<std::uint32_t, kRegisterCount + 1> reg{};
  std::array<std::int64_t, 2> accumulator{};  // 40 bits, sign-extended
  // Status flags (ASTAT), one byte each so that setting one is one store. AC0 and V have copies in
  // ASTAT, which differ from them only where a program wrote them so: bit 1 of `ac0` and `v`.
  std::uint8_t cc = 0, az = 0, an = 0, ac0 = 0, ac1 = 0, v = 0, vs = 0, aq = 0;
  std::uint8_t av0 = 0, av0s = 0, av1 = 0, av1s = 0, rnd_mod = 0;
  std::uint32_t astat_reserved = 0;  // bits without a meaning: they keep what is written

  Address next_address =
      0;  // where control goes after the block; preset to the fall-through address
  const Operation* retry = nullptr;    // the access to repeat when others have caught up
  std::uint8_t* store_also = nullptr;  // a cache's copy of what is stored; set for one access

  Cycles time = 0;  // at the start of the running block, plus its dynamic stalls so far
  std::uint32_t interrupt_mask = 0;  // IMASK
  const EngineHooks* hooks = nullptr;
  void* engine = nullptr;  // whom the hooks serve

  [[nodiscard]] std::uint32_t astat() const;
  void set_astat(std::uint32_t value);
  // One bit of ASTAT.
  [[nodiscard]] bool flag(int bit) const;
};

// Addresses from here up are device registers: system MMRs, then core MMRs (hardware.md 2.1).
inline constexpr Address kDeviceBase = 0xFFC00000;

}  // namespace finback::isa
