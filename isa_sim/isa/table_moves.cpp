// Moves: registers, immediates, halves and bytes, conditional moves, CC (Programming Reference
// chapters 9 and 11).
#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

constexpr Instruction form(std::string_view syntax, int length, Result result, Execute execute) {
  return {.syntax = syntax, .length = length, .result = result, .execute = execute};
}
constexpr Instruction writes_cc(std::string_view syntax, Execute execute) {
  return {.syntax = syntax, .length = 2, .implicit = kWritesCc, .execute = execute};
}
constexpr Instruction reads_cc(std::string_view syntax, Result result, Execute execute) {
  return {
      .syntax = syntax, .length = 2, .result = result, .implicit = kReadsCc, .execute = execute};
}

constexpr auto kCopy = [](ExecutionState& s, const Operation& o) { reg(s, o[0]) = reg(s, o[1]); };
constexpr auto kCopyAny = [](ExecutionState& s, const Operation& o) {
  write_any(s, o, o[0], read_any(s, o, o[1]));
};
constexpr auto kImmediate = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = static_cast<std::uint32_t>(o[1]);
};
constexpr auto kLowHalf = [](ExecutionState& s, const Operation& o) {
  set_low(s, o[0], static_cast<std::uint16_t>(o[1]));
};
constexpr auto kHighHalfOf = [](ExecutionState& s, const Operation& o) {
  set_high(s, o[0], static_cast<std::uint16_t>(o[1]));
};

// Extends the low part of a data register: T's own sign decides how.
template <class T>
constexpr auto kExtend = [](ExecutionState& s, const Operation& o) {
  const auto value = static_cast<std::uint32_t>(static_cast<T>(reg(s, register_of(o[1]))));
  reg(s, o[0]) = value;
  set_logic_flags(s, value);
};

template <bool when>
constexpr auto kConditional = [](ExecutionState& s, const Operation& o) {
  if ((s.cc != 0) == when) {
    reg(s, o[0]) = reg(s, o[1]);
  }
};

// Which registers a move joins: one is a data or pointer register, or both are of the address
// generators; parts of accumulators go anywhere but to each other's kind.
constexpr bool is_part(std::int32_t number) { return number >= A0X && number <= A1W; }
std::string_view check_move(const OperandNumbers& operand) {
  const std::int32_t to = operand[0];
  const std::int32_t from = operand[1];
  const bool free = to <= FP || from <= FP || is_part(from) || from == USP;
  return free || (from <= L3 && (to <= L3 || is_part(to)))
             ? ""
             : "no move joins these two: go by way of a data register";
}

bool update_flag(std::int32_t how, bool old, bool with) {
  switch (how) {
    case kFlagOr:
      return old || with;
    case kFlagAnd:
      return old && with;
    case kFlagXor:
      return old != with;
    default:
      return with;
  }
}
constexpr auto kCcFromFlag = [](ExecutionState& s, const Operation& o) {
  s.cc = update_flag(o[0], s.cc != 0, s.flag(o[1]));
};
constexpr auto kFlagFromCc = [](ExecutionState& s, const Operation& o) {
  const std::uint32_t bit = std::uint32_t{1} << o[0];
  const bool flag = update_flag(o[1], s.flag(o[0]), s.cc != 0);
  s.set_astat((s.astat() & ~bit) | (flag ? bit : 0));
};

enum class Order : std::uint8_t { equal, less, less_equal };

// CC = a REL b; T is the signed or unsigned 32-bit type. Of data registers AZ, AN and AC0 tell
// whether a equals b, is less, is no less as unsigned.
template <class T, Order order, bool immediate, bool flags>
constexpr auto kCompare = [](ExecutionState& s, const Operation& o) {
  const std::uint32_t left = reg(s, o[0]);
  const std::uint32_t right = immediate ? static_cast<std::uint32_t>(o[1]) : reg(s, o[1]);
  const T a = static_cast<T>(left);
  const T b = static_cast<T>(right);
  s.cc = order == Order::equal ? a == b : order == Order::less ? a < b : a <= b;
  if (flags) {
    s.az = left == right;
    s.an = a < b;
    s.ac0 = left >= right;
  }
};
using S = std::int32_t;
using U = std::uint32_t;

// CC = the bit equals `wanted`.
template <std::uint32_t wanted>
constexpr auto kTestBit =
    [](ExecutionState& s, const Operation& o) { s.cc = (reg(s, o[0]) >> o[1] & 1) == wanted; };

constexpr Instruction kTable[] = {
    // registers
    form("{D!} = {D}", 2, Result::alu, plain<kCopy>),
    form("{P!} = {P@}", 2, Result::pointer, plain<kCopy>),
    form("{D!} = {P}", 2, Result::alu, plain<kCopy>),
    form("{P!} = {D}", 2, Result::move, plain<kCopy>),
    {.syntax = "{G!} = {G}",
     .length = 2,
     .result = Result::move,
     .execute = plain<kCopyAny>,
     .check = check_move,
     .meaning = "move between any registers; LC, LT and LB refill the pipeline"},
    // immediates, short first
    form("{D!} = {imm7} {?(X)}", 2, Result::alu, plain<kImmediate>),
    form("{P!} = {imm7} {?(X)}", 2, Result::pointer, plain<kImmediate>),
    form("{D!} = {imm16} {?(X)}", 4, Result::alu, plain<kImmediate>),
    form("{P!} = {imm16} {?(X)}", 4, Result::pointer, plain<kImmediate>),
    form("{D!} = {uimm16} (Z)", 4, Result::alu, plain<kImmediate>),
    form("{P!} = {uimm16} (Z)", 4, Result::pointer, plain<kImmediate>),
    form("{IMBL!} = {imm16} {?(X)}", 4, Result::pointer, plain<kImmediate>),
    form("{IMBL!} = {uimm16} (Z)", 4, Result::pointer, plain<kImmediate>),
    form("{Dl!} = {any16}", 4, Result::alu, plain<kLowHalf>),
    form("{Dh!} = {any16}", 4, Result::alu, plain<kHighHalfOf>),
    form("{Pl!} = {any16}", 4, Result::pointer, plain<kLowHalf>),
    form("{Ph!} = {any16}", 4, Result::pointer, plain<kHighHalfOf>),
    // parts of data registers
    form("{D!} = {Dl} {?(Z)}", 2, Result::alu, plain<kExtend<std::uint16_t>>),
    form("{D!} = {Dl} (X)", 2, Result::alu, plain<kExtend<std::int16_t>>),
    form("{D!} = {Db} {?(Z)}", 2, Result::alu, plain<kExtend<std::uint8_t>>),
    form("{D!} = {Db} (X)", 2, Result::alu, plain<kExtend<std::int8_t>>),
    // conditional moves: the destination keeps its value otherwise, so it is read too
    reads_cc("IF CC {D+} = {D}", Result::alu, plain<kConditional<true>>),
    reads_cc("IF !CC {D+} = {D}", Result::alu, plain<kConditional<false>>),
    reads_cc("IF CC {D+} = {P}", Result::alu, plain<kConditional<true>>),
    reads_cc("IF !CC {D+} = {P}", Result::alu, plain<kConditional<false>>),
    reads_cc("IF CC {P+} = {D}", Result::move, plain<kConditional<true>>),
    reads_cc("IF !CC {P+} = {D}", Result::move, plain<kConditional<false>>),
    reads_cc("IF CC {P+} = {P}", Result::move, plain<kConditional<true>>),
    reads_cc("IF !CC {P+} = {P}", Result::move, plain<kConditional<false>>),

    // comparisons
    writes_cc("CC = {D} == {D}", plain<kCompare<S, Order::equal, false, true>>),
    writes_cc("CC = {D} == {imm3}", plain<kCompare<S, Order::equal, true, true>>),
    writes_cc("CC = {D} < {D}", plain<kCompare<S, Order::less, false, true>>),
    writes_cc("CC = {D} < {imm3}", plain<kCompare<S, Order::less, true, true>>),
    writes_cc("CC = {D} <= {D}", plain<kCompare<S, Order::less_equal, false, true>>),
    writes_cc("CC = {D} <= {imm3}", plain<kCompare<S, Order::less_equal, true, true>>),
    writes_cc("CC = {D} < {D} (IU)", plain<kCompare<U, Order::less, false, true>>),
    writes_cc("CC = {D} < {uimm3} (IU)", plain<kCompare<U, Order::less, true, true>>),
    writes_cc("CC = {D} <= {D} (IU)", plain<kCompare<U, Order::less_equal, false, true>>),
    writes_cc("CC = {D} <= {uimm3} (IU)", plain<kCompare<U, Order::less_equal, true, true>>),
    writes_cc("CC = {P} == {P}", plain<kCompare<S, Order::equal, false, false>>),
    writes_cc("CC = {P} == {imm3}", plain<kCompare<S, Order::equal, true, false>>),
    writes_cc("CC = {P} < {P}", plain<kCompare<S, Order::less, false, false>>),
    writes_cc("CC = {P} < {imm3}", plain<kCompare<S, Order::less, true, false>>),
    writes_cc("CC = {P} <= {P}", plain<kCompare<S, Order::less_equal, false, false>>),
    writes_cc("CC = {P} <= {imm3}", plain<kCompare<S, Order::less_equal, true, false>>),
    writes_cc("CC = {P} < {P} (IU)", plain<kCompare<U, Order::less, false, false>>),
    writes_cc("CC = {P} < {uimm3} (IU)", plain<kCompare<U, Order::less, true, false>>),
    writes_cc("CC = {P} <= {P} (IU)", plain<kCompare<U, Order::less_equal, false, false>>),
    writes_cc("CC = {P} <= {uimm3} (IU)", plain<kCompare<U, Order::less_equal, true, false>>),

    // CC and the other flags
    reads_cc("{D!} = CC", Result::alu,
             plain<[](ExecutionState& s, const Operation& o) { reg(s, o[0]) = s.cc; }>),
    writes_cc("CC = {D}",
              plain<[](ExecutionState& s, const Operation& o) { s.cc = reg(s, o[0]) != 0; }>),
    writes_cc("CC = !CC", plain<[](ExecutionState& s, const Operation&) { s.cc ^= 1; }>),
    {.syntax = "CC {upd} {flag}",
     .length = 2,
     .implicit = kReadsCc | kWritesCc,
     .execute = plain<kCcFromFlag>},
    {.syntax = "{flag} {upd} CC", .length = 2, .implicit = kReadsCc, .execute = plain<kFlagFromCc>},
    writes_cc("CC = BITTST({D}, {uimm5})", plain<kTestBit<1>>),
    writes_cc("CC = !BITTST({D}, {uimm5})", plain<kTestBit<0>>),
};

}  // namespace

std::span<const Instruction> move_instructions() { return kTable; }

}  // namespace finback::isa
