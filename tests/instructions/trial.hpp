// One execution of one table entry on chosen registers, for laws that say what it must do.
//
// A law starts from the state before and changes `after` into the state that must result: every
// register, flag and byte that it leaves alone must stay as it was. Laws are written from the
// Programming Reference's definitions in exact integers, apart from the table's own meanings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isa_sim/isa/instruction.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::isa::laws {

using Exact = std::int64_t;

// What the instruction asked of the system around the core.
using Actions = std::vector<std::pair<SystemAction, std::uint32_t>>;

struct Trial {
  // Loads and stores go to these bytes; pointers and index registers point at their middle.
  static constexpr Address kMemory = 0x1000;
  static constexpr std::size_t kMemoryBytes = 1024;
  // Where the instruction stands.
  static constexpr Address kPlace = 0x8000;

  int entry = 0;
  std::string_view syntax;
  OperandNumbers operand{};
  int length = 0;
  ExecutionState before;
  ExecutionState after;
  std::vector<std::uint8_t> memory_before;
  std::vector<std::uint8_t> memory;
  Actions actions;

  // Operand i as it was: the whole register, or the number.
  [[nodiscard]] std::int32_t number(int i) const { return operand[static_cast<std::size_t>(i)]; }
  [[nodiscard]] int reg(int i) const { return register_of(number(i)); }
  [[nodiscard]] std::uint32_t word(int i) const {
    return before.reg[static_cast<std::size_t>(reg(i))];
  }
  [[nodiscard]] Exact value(int i) const { return static_cast<std::int32_t>(word(i)); }
  // A half register as signed or unsigned number.
  [[nodiscard]] Exact half(int i) const { return static_cast<std::int16_t>(unsigned_half(i)); }
  [[nodiscard]] Exact unsigned_half(int i) const {
    return is_high_half(number(i)) ? word(i) >> 16 : word(i) & 0xffff;
  }
  [[nodiscard]] Exact low(int i) const { return static_cast<std::int16_t>(word(i)); }
  [[nodiscard]] Exact high(int i) const { return static_cast<std::int16_t>(word(i) >> 16); }

  // What must result; the low bits of an exact number count.
  void set(int i, Exact result) { set_register(reg(i), result); }
  void set_register(int number, Exact result) {
    after.reg[static_cast<std::size_t>(number)] = static_cast<std::uint32_t>(result);
  }
  void set_half(int i, Exact result);
  void zero_negative(Exact result) {
    after.az = result == 0;
    after.an = result < 0;
  }
  void overflow(bool happened) {
    after.v = happened;
    after.vs |= static_cast<std::uint8_t>(happened);
  }
  void accumulator_overflow(int unit, bool happened) {
    (unit == 0 ? after.av0 : after.av1) = happened;
    (unit == 0 ? after.av0s : after.av1s) |= static_cast<std::uint8_t>(happened);
  }
  // AZ and AN of the result, V and AC0 cleared: logic.
  void logic_flags(std::uint32_t result) {
    zero_negative(static_cast<std::int32_t>(result));
    after.ac0 = after.v = 0;
  }
  void act(SystemAction action, std::uint32_t with = 0) { actions.emplace_back(action, with); }

  // Little-endian memory as it was, and as it must be.
  [[nodiscard]] std::uint32_t load(Address address, int bytes) const;
  void store(Address address, int bytes, std::uint32_t stored);
};

[[nodiscard]] inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// Whether `exact` is a number of so many bits, and the nearest that is.
[[nodiscard]] bool fits(Exact exact, int bits);
[[nodiscard]] Exact nearest(Exact exact, int bits);
// The low bits of a number as a signed number.
[[nodiscard]] Exact wrap(Exact exact, int bits);

// Any register as a move reads it, and what a move into it changes.
[[nodiscard]] std::uint32_t register_value(Trial& trial, int reg);
void set_any_register(Trial& trial, int reg, std::uint32_t value);

// Runs the entry on `trial.before` and compares with what the law makes of it; "" when they agree.
[[nodiscard]] std::string run(Trial& trial, void (*law)(Trial&));

// Legal operands and states of entry `entry`, drawn from edge values; `seed` decides.
class Draws {
 public:
  Draws(int entry, std::uint32_t seed);
  [[nodiscard]] Trial draw();

 private:
  [[nodiscard]] std::uint32_t random() { return state_ = state_ * 1664525U + 1013904223U; }
  [[nodiscard]] std::uint32_t below(std::size_t count) {
    return static_cast<std::uint32_t>((std::uint64_t{random() >> 8} * count) >> 24);
  }
  [[nodiscard]] std::int32_t draw_operand(const OperandRole& role);
  [[nodiscard]] bool legal(const OperandNumbers& operand) const;
  [[nodiscard]] std::uint32_t draw_word();
  void draw_state(ExecutionState& state);

  int entry_;
  std::uint32_t state_;
};

}  // namespace finback::isa::laws
