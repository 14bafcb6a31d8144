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

#include <common/units.hpp>
#include <isa_sim/isa/operand.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::isa {

// A piece of memory that one core reaches without a stall and that no other core does: its bytes
// can be touched directly. Accesses are counted here, by log2 of their size (1, 2, 4 bytes).
struct MemoryWindow {
  Address base = 0;
  std::uint32_t size = 0;  // 0: never matches, every access is slow
  std::uint8_t* bytes = nullptr;
  std::array<std::uint64_t, 3> reads{};
  std::array<std::uint64_t, 3> writes{};
};

struct Operation;
struct ExecutionState;

// Carries out one operation and returns the next to run, or nullptr to leave the block: its end, or
// an access that must wait for the other actors (then `retry` is set).
using Execute = const Operation* (*)(ExecutionState&, const Operation*);

struct Operation {
  Execute execute = nullptr;
  std::array<std::int32_t, kMaxOperands> operand{};
  mutable MemoryWindow* window =
      nullptr;                 // the window hit last by this access site, never null for an access
  std::uint32_t site = 0;      // index of the access site's statistics in the engine
  std::uint16_t cycle = 0;     // static issue cycle within the block
  std::uint8_t length = 0;     // bytes of the whole packet, for return addresses
  bool packet_second = false;  // second access of its packet: checked for a sub-bank conflict
  Address address = 0;         // of the packet

  std::int32_t operator[](int index) const { return operand[static_cast<std::size_t>(index)]; }
};

// The engine's side of memory and control; set once per core.
struct EngineHooks {
  // Finds where `address` lies. Returns the bytes to access, having charged stalls and counted;
  // nullptr with `state.retry` set when the access must be repeated later; throws GuestFault for an
  // illegal one.
  std::uint8_t* (*slow_access)(ExecutionState&, const Operation&, Address address, int bytes,
                               bool write);
  // Device registers: 16 or 32 bits. Same contract for `retry`.
  std::uint32_t (*device_read)(ExecutionState&, const Operation&, Address address, int bytes);
  void (*device_write)(ExecutionState&, const Operation&, Address address, int bytes,
                       std::uint32_t value);
  // Two accesses of one packet in L1: adds the conflict stall when they hit the same sub-bank.
  void (*packet_conflict)(ExecutionState&, const Operation&, Address first, Address second);
  // IDLE, SSYNC, STI, RAISE, EXCPT, RTI and the like; `code` is a SystemAction.
  void (*system)(ExecutionState&, const Operation&, int code, std::uint32_t value);
};

enum SystemAction : int {
  kIdle,
  kCoreSync,
  kSystemSync,
  kDisableInterrupts,
  kEnableInterrupts,
  kRaise,
  kException,
  kReturnFromInterrupt,
};

struct ExecutionState {
  std::array<std::uint32_t, kRegisterCount> reg{};
  std::array<std::int64_t, 2> accumulator{};  // 40 bits, sign-extended
  // Status flags (ASTAT), one byte each so that setting one is one store.
  std::uint8_t cc = 0, az = 0, an = 0, ac0 = 0, ac1 = 0, v = 0, vs = 0, aq = 0;
  std::uint8_t av0 = 0, av0s = 0, av1 = 0, av1s = 0, rnd_mod = 0;

  Address next_address =
      0;  // where control goes after the block; preset to the fall-through address
  const Operation* retry = nullptr;  // the access to repeat when others have caught up
  Address packet_first_address = 0;  // address of the first access of the running packet

  Cycles time = 0;  // at the start of the running block, plus its dynamic stalls so far
  std::uint32_t interrupt_mask = 0;  // IMASK
  const EngineHooks* hooks = nullptr;
  void* engine = nullptr;  // whom the hooks serve

  [[nodiscard]] std::uint32_t astat() const;
  void set_astat(std::uint32_t value);
};

// Addresses from here up are device registers: system MMRs, then core MMRs (hardware.md 2.1).
inline constexpr Address kDeviceBase = 0xFFC00000;

}  // namespace finback::isa
