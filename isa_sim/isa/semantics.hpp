// Building blocks for the meanings in the instruction table: memory, flags, arithmetic.
//
// Every meaning is a captureless lambda or a template here, wrapped into an Execute. A meaning that
// touches memory does so before it changes any register, so that it can be repeated from the start
// when the engine sends it back. Source: Blackfin Programming Reference, chapters 5 to 15, by
// instruction.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <isa_sim/isa/instruction.hpp>

namespace finback::isa {

// ---- wrapping
// ----------------------------------------------------------------------------------------------------

// An operation that always goes on to the next one.
template <auto body>
const Operation* plain(ExecutionState& s, const Operation* o) {
  body(s, *o);
  return o + 1;
}

// An operation that ends its block; it sets next_address itself where control does not fall
// through.
template <auto body>
const Operation* ending(ExecutionState& s, const Operation* o) {
  body(s, *o);
  return nullptr;
}

// ---- registers
// ---------------------------------------------------------------------------------------------------

[[nodiscard]] inline std::uint32_t& reg(ExecutionState& s, std::int32_t operand) {
  return s.reg[static_cast<std::size_t>(operand)];
}
[[nodiscard]] inline std::int32_t signed_reg(ExecutionState& s, std::int32_t operand) {
  return static_cast<std::int32_t>(reg(s, operand));
}

// A half register operand (`reg | kHighHalf`).
[[nodiscard]] inline std::uint16_t half(ExecutionState& s, std::int32_t operand) {
  const std::uint32_t word = reg(s, register_of(operand));
  return static_cast<std::uint16_t>(is_high_half(operand) ? word >> 16 : word);
}
[[nodiscard]] inline std::int16_t signed_half(ExecutionState& s, std::int32_t operand) {
  return static_cast<std::int16_t>(half(s, operand));
}
inline void set_half(ExecutionState& s, std::int32_t operand, std::uint16_t value) {
  std::uint32_t& word = reg(s, register_of(operand));
  word = is_high_half(operand) ? (word & 0xffff) | std::uint32_t{value} << 16
                               : (word & 0xffff0000) | value;
}
inline void set_low(ExecutionState& s, std::int32_t operand, std::uint16_t value) {
  set_half(s, register_of(operand), value);
}
inline void set_high(ExecutionState& s, std::int32_t operand, std::uint16_t value) {
  set_half(s, register_of(operand) | kHighHalf, value);
}

inline void system(ExecutionState& s, const Operation& o, SystemAction action,
                   std::uint32_t value = 0) {
  s.hooks->system(s, o, action, value);
}

// A register of the kind `any`: parts of the accumulators, ASTAT and the cycle counter are gathered
// when read and taken apart when written. The engine is asked where a register is the supervisor's
// and told of writes that change what it does. Throws before anything is changed.
[[nodiscard]] inline std::uint32_t read_any(ExecutionState& s, const Operation& o,
                                            std::int32_t number) {
  switch (number) {
    case ASTAT:
      return s.astat();
    case CYCLES:
      system(s, o, SystemAction::read_cycles);
      return s.reg[CYCLES];
    case A0X:
    case A1X:
      return static_cast<std::uint32_t>(s.accumulator[number == A1X] >> 32);
    case A0W:
    case A1W:
      return static_cast<std::uint32_t>(s.accumulator[number == A1W]);
    case USP:
    case SEQSTAT:
    case SYSCFG:
    case RETI:
    case RETX:
    case RETN:
    case RETE:
      system(s, o, SystemAction::privileged);
      return reg(s, number);
    default:
      return reg(s, number);
  }
}
inline void write_any(ExecutionState& s, const Operation& o, std::int32_t number,
                      std::uint32_t value) {
  switch (number) {
    case ASTAT:
      s.set_astat(value);
      break;
    case A0X:
    case A1X: {
      std::int64_t& a = s.accumulator[number == A1X];
      a = std::int64_t{static_cast<std::int8_t>(value)} * (std::int64_t{1} << 32) |
          (a & 0xffffffff);
      break;
    }
    case A0W:
    case A1W: {
      std::int64_t& a = s.accumulator[number == A1W];
      a = (a & ~std::int64_t{0xffffffff}) | std::int64_t{value};
      break;
    }
    case LT0:
    case LT1:
      reg(s, number) = value & ~1U;  // the lowest bit is always 0
      break;
    case LB0:
    case LB1:
      reg(s, number) = value;
      system(s, o, SystemAction::loop_bottom, value);
      break;
    case CYCLES:
      system(s, o, SystemAction::write_cycles, value);
      break;
    case CYCLES2:
      system(s, o, SystemAction::write_cycles2, value);
      break;
    case SEQSTAT:
      system(s, o, SystemAction::privileged);  // read-only: the value is lost
      break;
    case SYSCFG:
      system(s, o, SystemAction::privileged);
      reg(s, number) = value;
      system(s, o, SystemAction::configure);
      break;
    case USP:
    case RETI:
    case RETX:
    case RETN:
    case RETE:
      system(s, o, SystemAction::privileged);
      reg(s, number) = value;
      break;
    default:
      reg(s, number) = value;
      break;
  }
}

// Adds to an index register, wrapping inside its circular buffer. The comparisons look at one carry
// or one sign only, as the address generator does: sums beyond 2^32 compare as it has them.
[[nodiscard]] inline std::uint32_t wrapped(std::uint32_t index, std::int32_t step,
                                           std::uint32_t base, std::uint32_t length) {
  const std::uint64_t sum = std::uint64_t{index} + static_cast<std::uint32_t>(step);
  const auto next = static_cast<std::uint32_t>(sum);
  if (step < 0) {
    const bool plain = (index >> 31) != 0 || (sum >> 32) != 0;
    return (next < base) == plain ? next + length : next;
  }
  const std::uint64_t end = std::uint64_t{base} + length;
  const bool same = (sum >> 32) == (end >> 32);
  return (next < static_cast<std::uint32_t>(end)) == same ? next : next - length;
}
inline void advance_index(ExecutionState& s, std::int32_t index, std::int32_t step) {
  const auto number = static_cast<std::size_t>(index - I0);
  const std::uint32_t length = s.reg[L0 + number];
  std::uint32_t& value = reg(s, index);
  value = length == 0 ? value + static_cast<std::uint32_t>(step)
                      : wrapped(value, step, s.reg[B0 + number], length);
}
// Subtracts; by nothing at all, an index below its buffer comes in and one above stays.
inline void retreat_index(ExecutionState& s, std::int32_t index, std::int32_t step) {
  if (step != 0) {
    advance_index(s, index, -step);
    return;
  }
  const auto number = static_cast<std::size_t>(index - I0);
  if (reg(s, index) < s.reg[B0 + number]) {
    reg(s, index) += s.reg[L0 + number];
  }
}
// Addition with the carry running to the right, for the order of an FFT's results.
[[nodiscard]] inline std::uint32_t add_reversed(std::uint32_t a, std::uint32_t b) {
  const auto reverse = [](std::uint32_t word) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit) {
      result = result << 1 | (word >> bit & 1);
    }
    return result;
  };
  return reverse(reverse(a) + reverse(b));
}

// ---- flags
// -------------------------------------------------------------------------------------------------------

inline void set_az_an(ExecutionState& s, std::uint32_t result) {
  s.az = result == 0;
  s.an = static_cast<std::uint8_t>(result >> 31);
}
// Logic and bit operations: AZ and AN by the result, AC0 and V cleared.
inline void set_logic_flags(ExecutionState& s, std::uint32_t result) {
  set_az_an(s, result);
  s.ac0 = 0;
  s.v = 0;
}
inline void set_overflow(ExecutionState& s, bool overflow) {
  s.v = overflow;
  s.vs |= static_cast<std::uint8_t>(overflow);
}

// ---- arithmetic
// --------------------------------------------------------------------------------------------------

[[nodiscard]] inline std::uint32_t add32(ExecutionState& s, std::uint32_t a, std::uint32_t b,
                                         bool saturate = false) {
  std::uint32_t result = a + b;
  const bool overflow = ((~(a ^ b) & (a ^ result)) >> 31) != 0;
  s.ac0 = result < a;
  set_overflow(s, overflow);
  if (saturate && overflow) {
    result = (a >> 31) != 0 ? 0x80000000u : 0x7fffffffu;
  }
  set_az_an(s, result);
  return result;
}
[[nodiscard]] inline std::uint32_t subtract32(ExecutionState& s, std::uint32_t a, std::uint32_t b,
                                              bool saturate = false) {
  std::uint32_t result = a - b;
  const bool overflow = (((a ^ b) & (a ^ result)) >> 31) != 0;
  s.ac0 = a >= b;  // Blackfin: carry set means "no borrow"
  set_overflow(s, overflow);
  if (saturate && overflow) {
    result = (a >> 31) != 0 ? 0x80000000u : 0x7fffffffu;
  }
  set_az_an(s, result);
  return result;
}

[[nodiscard]] inline std::uint16_t clip16(std::int32_t exact, bool saturate, bool& overflow) {
  overflow = exact > 32767 || exact < -32768;
  if (overflow && saturate) {
    exact = std::clamp(exact, -32768, 32767);
  }
  return static_cast<std::uint16_t>(exact);
}
// 16-bit add or subtract with the flags of the half-register forms.
[[nodiscard]] inline std::uint16_t add_half(ExecutionState& s, std::uint16_t a, std::uint16_t b,
                                            bool subtract, bool saturate) {
  const std::int32_t exact =
      subtract ? std::int16_t(a) - std::int16_t(b) : std::int16_t(a) + std::int16_t(b);
  bool overflow = false;
  const std::uint16_t result = clip16(exact, saturate, overflow);
  s.ac0 = subtract ? a >= b : static_cast<std::uint16_t>(a + b) < a;
  set_overflow(s, overflow);
  s.az = result == 0;
  s.an = static_cast<std::uint8_t>(result >> 15);
  return result;
}
// Two 16-bit lanes at once: high and low each added or subtracted.
[[nodiscard]] inline std::uint32_t add_lanes(ExecutionState& s, std::uint32_t a, std::uint32_t b,
                                             bool subtract_high, bool subtract_low, bool saturate) {
  const std::uint16_t low = add_half(s, std::uint16_t(a), std::uint16_t(b), subtract_low, saturate);
  const std::uint8_t az = s.az, an = s.an, v = s.v, carry = s.ac0;
  const std::uint16_t high =
      add_half(s, std::uint16_t(a >> 16), std::uint16_t(b >> 16), subtract_high, saturate);
  s.ac1 = s.ac0;
  s.ac0 = carry;
  s.az |= az;
  s.an |= an;
  s.v |= v;
  return std::uint32_t{high} << 16 | low;
}

// Shift by a signed amount (left when positive), as LSHIFT does with a register: -32..31 from its
// low 6 bits.
[[nodiscard]] inline std::int32_t shift_amount(std::uint32_t value) {
  const auto low = static_cast<std::int32_t>(value & 0x3f);
  return low >= 32 ? low - 64 : low;
}
[[nodiscard]] inline std::uint32_t logical_shift(std::uint32_t value, std::int32_t left) {
  if (left >= 32 || left <= -32) {
    return 0;
  }
  return left >= 0 ? value << left : value >> -left;
}
[[nodiscard]] inline std::uint32_t arithmetic_shift(std::uint32_t value, std::int32_t left) {
  if (left >= 0) {
    return logical_shift(value, left);
  }
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> std::min(-left, 31));
}

[[nodiscard]] inline std::uint32_t saturate32(ExecutionState& s, std::int64_t value) {
  const std::int64_t clipped = std::clamp<std::int64_t>(
      value, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
  set_overflow(s, clipped != value);
  const auto result = static_cast<std::uint32_t>(clipped);
  set_az_an(s, result);
  return result;
}

// ---- memory
// ------------------------------------------------------------------------------------------------------

template <class T>
inline constexpr std::size_t kSizeClass = sizeof(T) == 1   ? 0
                                          : sizeof(T) == 2 ? 1
                                                           : 2;

template <class T>
[[nodiscard]] inline bool hits(const MemoryWindow& window, Address address) {
  return std::uint64_t{address - window.base} + sizeof(T) <= window.size &&
         (address & (sizeof(T) - 1)) == 0;
}

// Reads T at `address`; false: the engine sent the access back, leave the operation at once.
template <class T>
[[nodiscard]] inline bool read_memory(ExecutionState& s, const Operation& o, Address address,
                                      T& value, bool continued = false) {
  MemoryWindow& window = *o.window;
  if (hits<T>(window, address)) [[likely]] {
    ++window.reads[kSizeClass<T>];
    std::memcpy(&value, window.bytes + (address - window.base), sizeof(T));
    return true;
  }
  if (address >= kDeviceBase) {
    std::uint32_t word = 0;
    const bool done = s.hooks->device_read(s, o, address, sizeof(T), word);
    value = static_cast<T>(word);
    return done;
  }
  const std::uint8_t* bytes = s.hooks->slow_access(s, o, address, sizeof(T), false, continued);
  if (bytes == nullptr) {
    return false;
  }
  std::memcpy(&value, bytes, sizeof(T));
  return true;
}

template <class T>
[[nodiscard]] inline bool write_memory(ExecutionState& s, const Operation& o, Address address,
                                       T value, bool continued = false) {
  MemoryWindow& window = *o.window;
  if (hits<T>(window, address)) [[likely]] {
    ++window.writes[kSizeClass<T>];
    std::memcpy(window.bytes + (address - window.base), &value, sizeof(T));
    return true;
  }
  if (address >= kDeviceBase) {
    return s.hooks->device_write(s, o, address, sizeof(T), static_cast<std::uint32_t>(value));
  }
  std::uint8_t* bytes = s.hooks->slow_access(s, o, address, sizeof(T), true, continued);
  if (bytes == nullptr) {
    return false;
  }
  std::memcpy(bytes, &value, sizeof(T));
  if (s.store_also != nullptr) {
    std::memcpy(std::exchange(s.store_also, nullptr), &value, sizeof(T));
  }
  return true;
}

// How an access finds its address, and what it does to the base register afterwards.
enum class Walk : std::uint8_t { none, up, down, offset, by_register };

// `base`: index of the base register's operand; an offset or step register is the next operand.
template <Walk walk>
[[nodiscard]] inline Address effective_address(ExecutionState& s, const Operation& o, int base) {
  Address address = reg(s, o[base]);
  if constexpr (walk == Walk::offset) {
    address += static_cast<std::uint32_t>(o[base + 1]);
  }
  return address;
}
template <Walk walk, int bytes>
inline void advance_base(ExecutionState& s, const Operation& o, int base) {
  if constexpr (walk == Walk::up || walk == Walk::down || walk == Walk::by_register) {
    std::int32_t step = walk == Walk::up ? bytes : -bytes;
    if constexpr (walk == Walk::by_register) {
      step = o[base] == o[base + 1] ? 0 : signed_reg(s, o[base + 1]);  // [P0++P0] stays
    }
    if (o[base] >= I0 && o[base] <= I3) {
      advance_index(s, o[base], step);
    } else {
      reg(s, o[base]) += static_cast<std::uint32_t>(step);
    }
  }
}

enum class Into : std::uint8_t { whole, low, high };

// {dest} = T[base ...]: a narrow T is extended by its own sign. `mask`: of the address.
template <class T, Walk walk, Into into = Into::whole, Address mask = ~Address{0}>
const Operation* load(ExecutionState& s, const Operation* o) {
  T value{};
  if (!read_memory(s, *o, effective_address<walk>(s, *o, 1) & mask, value)) {
    return nullptr;
  }
  advance_base<walk, sizeof(T)>(s, *o, 1);
  if constexpr (into == Into::whole) {
    // By way of the signed type, so that a signed T brings its sign along.
    reg(s, (*o)[0]) = static_cast<std::uint32_t>(std::int64_t{value});
  } else if constexpr (into == Into::low) {
    set_low(s, (*o)[0], static_cast<std::uint16_t>(value));
  } else {
    set_high(s, (*o)[0], static_cast<std::uint16_t>(value));
  }
  return o + 1;
}

// T[base ...] = {source}: the low part of the source, or its high half.
template <class T, Walk walk, Into part = Into::whole>
const Operation* store(ExecutionState& s, const Operation* o) {
  constexpr int kSource = walk == Walk::offset || walk == Walk::by_register ? 2 : 1;
  std::uint32_t value = reg(s, register_of((*o)[kSource]));
  if constexpr (part == Into::high) {
    value >>= 16;
  }
  if (!write_memory(s, *o, effective_address<walk>(s, *o, 0), static_cast<T>(value))) {
    return nullptr;
  }
  advance_base<walk, sizeof(T)>(s, *o, 0);
  return o + 1;
}

}  // namespace finback::isa
