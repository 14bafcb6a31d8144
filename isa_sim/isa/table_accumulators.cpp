// The 40-bit accumulators beside the multipliers: moves, sums, signs, comparisons, shifts
// (Programming Reference chapters 9, 11, 14 and 15). Slot 0 of a packet, but for comparisons.
#include <isa_sim/isa/dsp_form.hpp>
#include <isa_sim/isa/multiplier.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using std::int64_t;

constexpr std::uint32_t reads(int unit) { return unit == 0 ? kReadsA0 : kReadsA1; }
constexpr std::uint32_t changes(int unit) { return unit == 0 ? kWritesA0 : kWritesA1; }
constexpr std::uint32_t kBothRead = kReadsA0 | kReadsA1;

// AV and its sticky twin.
void set_accumulator_overflow(ExecutionState& s, int unit, bool overflow) {
  (unit == 0 ? s.av0 : s.av1) = overflow;
  (unit == 0 ? s.av0s : s.av1s) |= static_cast<u8>(overflow);
}

// Saturated to 40 bits, with AV.
int64_t clip40(ExecutionState& s, int unit, int64_t exact) {
  const int64_t clipped = std::clamp(exact, -kMaximum40 - 1, kMaximum40);
  set_accumulator_overflow(s, unit, clipped != exact);
  return clipped;
}
int64_t clip32(int64_t exact) { return std::clamp(exact, -kMaximum32 - 1, kMaximum32); }

// ---- moves
// ---------------------------------------------------------------------------------------------------

template <int unit>
constexpr auto kClear = [](ExecutionState& s, const Operation&) { s.accumulator[unit] = 0; };
constexpr auto kClearBoth = [](ExecutionState& s, const Operation&) { s.accumulator = {0, 0}; };
template <int to>
constexpr auto kCopy =
    [](ExecutionState& s, const Operation&) { s.accumulator[to] = s.accumulator[1 - to]; };
template <int unit>
constexpr auto kFromRegister =
    [](ExecutionState& s, const Operation& o) { s.accumulator[unit] = signed_reg(s, o[0]); };
// Bits 0-15, 16-31 or 32-39 from a half register; the others stay.
template <int unit, int lowest>
constexpr auto kFromHalf = [](ExecutionState& s, const Operation& o) {
  const std::uint64_t mask = std::uint64_t{0xffff} << lowest;
  s.accumulator[unit] = accumulator_of((bits40(s.accumulator[unit]) & ~mask) |
                                       std::uint64_t{half(s, o[0])} << lowest);
};
template <int unit>
constexpr auto kGuardToHalf = [](ExecutionState& s, const Operation& o) {
  set_half(s, o[0], static_cast<u16>(s.accumulator[unit] >> 32));
};

// ---- sums
// ---------------------------------------------------------------------------------------------------

bool carries40(int64_t a, int64_t b) { return bits40(a) + bits40(b) > kAllBits40; }

void add_accumulators(ExecutionState& s, bool narrow) {
  const auto [a, b] = s.accumulator;
  s.ac0 = carries40(a, b);
  s.accumulator[0] = clip40(s, 0, a + b);
  if (narrow) {
    s.accumulator[0] = clip32(s.accumulator[0]);
  }
}
void set_accumulator_flags(ExecutionState& s, int64_t value) {
  s.az = value == 0;
  s.an = value < 0;
}

constexpr auto kAddOther = [](ExecutionState& s, const Operation& o) {
  add_accumulators(s, o[0] != 0);
  set_accumulator_flags(s, s.accumulator[0]);
};
constexpr auto kSubtractOther = [](ExecutionState& s, const Operation& o) {
  const auto [a, b] = s.accumulator;
  s.ac0 = bits40(b) <= bits40(a);
  int64_t result = clip40(s, 0, a - b);
  if (o[0] != 0) {
    result = clip32(result);
  }
  s.accumulator[0] = result;
  set_accumulator_flags(s, result);
};
constexpr auto kAddToRegister = [](ExecutionState& s, const Operation& o) {
  add_accumulators(s, false);
  reg(s, o[0]) = saturate32(s, s.accumulator[0]);
};
constexpr auto kAddToHalf = [](ExecutionState& s, const Operation& o) {
  add_accumulators(s, false);
  const Extracted sum = extract_half(s.accumulator[0], {}, s.rnd_mod != 0);
  set_half(s, o[0], static_cast<u16>(sum.value));
  set_overflow(s, sum.overflow);
  s.az = sum.value == 0;
  s.an = static_cast<u8>(sum.value >> 15);
};
// The sum and the difference of both; `from` is what the other is subtracted from.
template <int from>
constexpr auto kSumAndDifference = [](ExecutionState& s, const Operation& o) {
  const auto [a0, a1] = s.accumulator;
  const int64_t sum = a0 + a1;
  const int64_t difference = from == 0 ? a0 - a1 : a1 - a0;
  const auto result = [saturate = o[2] != 0](int64_t value) {
    return static_cast<u32>(saturate ? clip32(value) : value);
  };
  set_overflow(s, clip32(sum) != sum || clip32(difference) != difference);
  s.ac1 = carries40(a0, a1);
  s.ac0 = bits40(s.accumulator[1 - from]) <= bits40(s.accumulator[from]);
  const u32 first = result(sum);
  const u32 second = result(difference);
  s.az = first == 0 || second == 0;
  s.an = static_cast<u8>((first | second) >> 31);
  reg(s, o[0]) = first;
  reg(s, o[1]) = second;
};
// Each accumulator's two signed halves added.
constexpr auto kHalfSums = [](ExecutionState& s, const Operation& o) {
  const auto sum = [&s](std::size_t unit) {
    const auto word = static_cast<u32>(s.accumulator[unit]);
    return static_cast<u32>(std::int16_t(word >> 16) + std::int16_t(word));
  };
  const u32 one = sum(1);
  const u32 zero = sum(0);
  reg(s, o[0]) = one;
  reg(s, o[1]) = zero;
};

// ---- sign
// ---------------------------------------------------------------------------------------------------

template <int to, int from>
constexpr auto kAbsolute = [](ExecutionState& s, const Operation&) {
  const int64_t value = s.accumulator[from];
  s.accumulator[to] = clip40(s, to, value < 0 ? -value : value);
  set_accumulator_flags(s, s.accumulator[to]);
};
constexpr auto kAbsoluteBoth = [](ExecutionState& s, const Operation& o) {
  kAbsolute<0, 0>(s, o);
  const u8 zero = s.az;
  kAbsolute<1, 1>(s, o);
  s.az |= zero;
};
template <int to, int from>
constexpr auto kNegate = [](ExecutionState& s, const Operation&) {
  const int64_t value = s.accumulator[from];
  s.accumulator[to] = clip40(s, to, -value);
  (to == 0 ? s.ac0 : s.ac1) = value == 0;
  set_accumulator_flags(s, s.accumulator[to]);
};
constexpr auto kNegateBoth = [](ExecutionState& s, const Operation& o) {
  kNegate<0, 0>(s, o);
  const u8 zero = s.az;
  const u8 negative = s.an;
  kNegate<1, 1>(s, o);
  s.az |= zero;
  s.an |= negative;
};
template <int unit>
constexpr auto kSaturate32 = [](ExecutionState& s, const Operation&) {
  int64_t& a = s.accumulator[unit];
  const int64_t clipped = clip32(a);
  set_accumulator_overflow(s, unit, clipped != a);
  a = clipped;
  set_accumulator_flags(s, a);
};
constexpr auto kSaturateBoth = [](ExecutionState& s, const Operation& o) {
  kSaturate32<0>(s, o);
  const u8 zero = s.az;
  const u8 negative = s.an;
  kSaturate32<1>(s, o);
  s.az |= zero;
  s.an |= negative;
};

// ---- comparison: flags as of A0 - A1
// ---------------------------------------------------------------------------------------------------

enum class Order : u8 { equal, less, less_equal };
template <Order order>
constexpr auto kCompare = [](ExecutionState& s, const Operation&) {
  const auto [a, b] = s.accumulator;
  s.cc = order == Order::equal ? a == b : order == Order::less ? a < b : a <= b;
  s.az = a == b;
  s.an = a < b;
  s.ac0 = bits40(b) <= bits40(a);
};
template <Order order>
constexpr Instruction compare_form(std::string_view syntax) {
  return {.syntax = syntax,
          .length = 2,
          .implicit = kBothRead | kWritesCc,
          .execute = plain<kCompare<order>>};
}

// ---- shifts: AV of the accumulator is cleared; more than 32 to the right is a shift to the left
// by the rest to 64, as the shifter reads its six bits
// ---------------------------------------------------------------------------------------------------

// Left when the amount is positive; bits that leave are lost.
int64_t shift40(int64_t value, int amount, bool arithmetic) {
  if (amount >= 0) {
    return amount > 39 ? 0 : accumulator_of(static_cast<std::uint64_t>(value) << amount);
  }
  const int right = std::min(-amount, 40);
  return arithmetic ? value >> std::min(right, 39) : accumulator_of(bits40(value) >> right);
}

enum class Amount : u8 { left, right, in_register };
template <int unit, Amount where, bool arithmetic>
constexpr auto kShift = [](ExecutionState& s, const Operation& o) {
  const int amount = where == Amount::left    ? o[0]
                     : where == Amount::right ? (o[0] > 32 ? 64 - o[0] : -o[0])
                                              : shift_amount(reg(s, register_of(o[0])));
  int64_t& a = s.accumulator[unit];
  a = shift40(a, amount, arithmetic);
  (unit == 0 ? s.av0 : s.av1) = 0;
  set_accumulator_flags(s, a);
};

template <int unit>
constexpr Instruction update_form(std::string_view syntax, Execute execute,
                                  std::string_view meaning = {}) {
  return with_implicit(dsp_form(syntax, execute, meaning), reads(unit) | changes(unit));
}
template <int unit>
constexpr Instruction early_update_form(std::string_view syntax, Execute execute) {
  return with_implicit(early_dsp_form(syntax, execute, "left when the amount is positive"),
                       reads(unit) | changes(unit));
}
constexpr Instruction implicit_form(std::string_view syntax, std::uint32_t implicit,
                                    Execute execute, std::string_view meaning = {}) {
  return with_implicit(dsp_form(syntax, execute, meaning), implicit);
}

constexpr const char* kGuard = "bits 32 to 39";

constexpr Instruction kTable[] = {
    // moves
    implicit_form("A0 = 0", kWritesA0, plain<kClear<0>>),
    implicit_form("A1 = 0", kWritesA1, plain<kClear<1>>),
    also(implicit_form("A1 = A0 = 0", kWritesA0 | kWritesA1, plain<kClearBoth>), "A0 = A1 = 0"),
    implicit_form("A0 = A1", kReadsA1 | kWritesA0, plain<kCopy<0>>),
    implicit_form("A1 = A0", kReadsA0 | kWritesA1, plain<kCopy<1>>),
    implicit_form("A0 = {D}", kWritesA0, plain<kFromRegister<0>>, "sign-extended"),
    implicit_form("A1 = {D}", kWritesA1, plain<kFromRegister<1>>, "sign-extended"),
    update_form<0>("A0.L = {Dl}", plain<kFromHalf<0, 0>>),
    update_form<0>("A0.H = {Dh}", plain<kFromHalf<0, 16>>),
    update_form<0>("A0.X = {Dl}", plain<kFromHalf<0, 32>>, kGuard),
    update_form<1>("A1.L = {Dl}", plain<kFromHalf<1, 0>>),
    update_form<1>("A1.H = {Dh}", plain<kFromHalf<1, 16>>),
    update_form<1>("A1.X = {Dl}", plain<kFromHalf<1, 32>>, kGuard),
    implicit_form("{Dl!} = A0.X", kReadsA0, plain<kGuardToHalf<0>>, "bits 32 to 39, sign-extended"),
    implicit_form("{Dl!} = A1.X", kReadsA1, plain<kGuardToHalf<1>>, "bits 32 to 39, sign-extended"),

    // sums
    implicit_form("A0 += A1{w32}", kBothRead | kWritesA0, plain<kAddOther>),
    implicit_form("A0 -= A1{w32}", kBothRead | kWritesA0, plain<kSubtractOther>),
    implicit_form("{D!} = (A0 += A1)", kBothRead | kWritesA0, plain<kAddToRegister>,
                  "saturated to 32 bits"),
    implicit_form("{Dx!} = (A0 += A1)", kBothRead | kWritesA0, plain<kAddToHalf>,
                  "rounded and saturated"),
    implicit_form("{D!} = A1 + A0, {D!} = A1 - A0{ns}", kBothRead, plain<kSumAndDifference<1>>),
    implicit_form("{D!} = A0 + A1, {D!} = A0 - A1{ns}", kBothRead, plain<kSumAndDifference<0>>),
    implicit_form("{D!} = A1.L + A1.H, {D!} = A0.L + A0.H", kBothRead, plain<kHalfSums>,
                  "the halves, signed"),

    // signs, saturated
    update_form<0>("A0 = ABS A0", plain<kAbsolute<0, 0>>),
    implicit_form("A0 = ABS A1", kReadsA1 | kWritesA0, plain<kAbsolute<0, 1>>),
    implicit_form("A1 = ABS A0", kReadsA0 | kWritesA1, plain<kAbsolute<1, 0>>),
    update_form<1>("A1 = ABS A1", plain<kAbsolute<1, 1>>),
    implicit_form("A1 = ABS A1, A0 = ABS A0", kBothRead | kWritesA0 | kWritesA1,
                  plain<kAbsoluteBoth>),
    update_form<0>("A0 = -A0", plain<kNegate<0, 0>>),
    implicit_form("A0 = -A1", kReadsA1 | kWritesA0, plain<kNegate<0, 1>>),
    implicit_form("A1 = -A0", kReadsA0 | kWritesA1, plain<kNegate<1, 0>>),
    update_form<1>("A1 = -A1", plain<kNegate<1, 1>>),
    implicit_form("A1 = -A1, A0 = -A0", kBothRead | kWritesA0 | kWritesA1, plain<kNegateBoth>),
    update_form<0>("A0 = A0 (S)", plain<kSaturate32<0>>, "saturated to 32 bits"),
    update_form<1>("A1 = A1 (S)", plain<kSaturate32<1>>, "saturated to 32 bits"),
    implicit_form("A1 = A1 (S), A0 = A0 (S)", kBothRead | kWritesA0 | kWritesA1,
                  plain<kSaturateBoth>, "saturated to 32 bits"),

    compare_form<Order::equal>("CC = A0 == A1"),
    compare_form<Order::less>("CC = A0 < A1"),
    compare_form<Order::less_equal>("CC = A0 <= A1"),

    // shifts
    update_form<0>("A0 = A0 << {uimm5}", plain<kShift<0, Amount::left, false>>),
    update_form<0>("A0 = A0 >> {uimm6}", plain<kShift<0, Amount::right, false>>),
    update_form<0>("A0 = A0 >>> {uimm5}", plain<kShift<0, Amount::right, true>>),
    update_form<1>("A1 = A1 << {uimm5}", plain<kShift<1, Amount::left, false>>),
    update_form<1>("A1 = A1 >> {uimm6}", plain<kShift<1, Amount::right, false>>),
    update_form<1>("A1 = A1 >>> {uimm5}", plain<kShift<1, Amount::right, true>>),
    early_update_form<0>("A0 = ASHIFT A0 BY {Dl}", plain<kShift<0, Amount::in_register, true>>),
    early_update_form<0>("A0 = LSHIFT A0 BY {Dl}", plain<kShift<0, Amount::in_register, false>>),
    early_update_form<1>("A1 = ASHIFT A1 BY {Dl}", plain<kShift<1, Amount::in_register, true>>),
    early_update_form<1>("A1 = LSHIFT A1 BY {Dl}", plain<kShift<1, Amount::in_register, false>>),
};

}  // namespace

std::span<const Instruction> accumulator_instructions() { return kTable; }

}  // namespace finback::isa
