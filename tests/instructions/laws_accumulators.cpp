// The 40-bit accumulators: moves, sums, signs, comparisons, shifts.
#include "laws.hpp"

namespace finback::isa::laws {

namespace {

constexpr Exact kMask40 = (Exact{1} << 40) - 1;

Exact sum_of(const Trial& t, int unit) {
  return t.before.accumulator[static_cast<std::size_t>(unit)];
}
void set_sum(Trial& t, int unit, Exact value) {
  t.after.accumulator[static_cast<std::size_t>(unit)] = wrap(value, 40);
}
// Saturated to 40 bits, with AV.
Exact limited40(Trial& t, int unit, Exact exact) {
  t.accumulator_overflow(unit, !fits(exact, 40));
  return nearest(exact, 40);
}

template <int unit>
void clear(Trial& t) {
  set_sum(t, unit, 0);
}
template <int unit>
void from_other(Trial& t) {
  set_sum(t, unit, sum_of(t, 1 - unit));
}
template <int unit>
void from_register(Trial& t) {
  set_sum(t, unit, t.value(0));
}
template <int unit, int lowest>
void from_half(Trial& t) {
  const Exact kept = sum_of(t, unit) & ~(Exact{0xffff} << lowest);
  set_sum(t, unit, kept + (t.unsigned_half(0) << lowest));
}
template <int unit>
void guard(Trial& t) {
  t.set_half(0, wrap(sum_of(t, unit) >> 32, 8));
}

Exact added(Trial& t) {
  t.after.ac0 = (sum_of(t, 0) & kMask40) + (sum_of(t, 1) & kMask40) > kMask40;
  return limited40(t, 0, sum_of(t, 0) + sum_of(t, 1));
}
void add_in_place(Trial& t) {
  Exact result = added(t);
  result = t.number(0) != 0 ? nearest(result, 32) : result;
  set_sum(t, 0, result);
  t.zero_negative(result);
}
void subtract_in_place(Trial& t) {
  t.after.ac0 = (sum_of(t, 1) & kMask40) <= (sum_of(t, 0) & kMask40);
  Exact result = limited40(t, 0, sum_of(t, 0) - sum_of(t, 1));
  result = t.number(0) != 0 ? nearest(result, 32) : result;
  set_sum(t, 0, result);
  t.zero_negative(result);
}
template <int from>
void sum_and_difference(Trial& t) {
  const Exact sum = sum_of(t, 0) + sum_of(t, 1);
  const Exact difference = sum_of(t, from) - sum_of(t, 1 - from);
  t.after.ac1 = (sum_of(t, 0) & kMask40) + (sum_of(t, 1) & kMask40) > kMask40;
  t.after.ac0 = (sum_of(t, 1 - from) & kMask40) <= (sum_of(t, from) & kMask40);
  t.overflow(!fits(sum, 32) || !fits(difference, 32));
  const auto result = [&](Exact exact) {
    return t.number(2) != 0 ? nearest(exact, 32) : wrap(exact, 32);
  };
  t.after.az = result(sum) == 0 || result(difference) == 0;
  t.after.an = result(sum) < 0 || result(difference) < 0;
  t.set(0, result(sum));
  t.set(1, result(difference));
}

template <int to, int from>
void absolute(Trial& t) {
  const Exact value = sum_of(t, from);
  const Exact result = limited40(t, to, value < 0 ? -value : value);
  set_sum(t, to, result);
  t.zero_negative(result);
}
template <int to, int from>
void negate(Trial& t) {
  const Exact result = limited40(t, to, -sum_of(t, from));
  set_sum(t, to, result);
  (to == 0 ? t.after.ac0 : t.after.ac1) = sum_of(t, from) == 0;
  t.zero_negative(result);
}
template <int unit>
void saturate(Trial& t) {
  const Exact result = nearest(sum_of(t, unit), 32);
  t.accumulator_overflow(unit, result != sum_of(t, unit));
  set_sum(t, unit, result);
  t.zero_negative(result);
}
// Both at once: a flag is set when either sets it.
template <auto first, auto second>
void both(Trial& t) {
  first(t);
  const bool zero = t.after.az != 0;
  const bool negative = t.after.an != 0;
  second(t);
  t.after.az |= static_cast<std::uint8_t>(zero);
  t.after.an |= static_cast<std::uint8_t>(negative);
}

void compare(Trial& t, bool result) {
  t.after.cc = result;
  t.zero_negative(sum_of(t, 0) - sum_of(t, 1));
  t.after.ac0 = (sum_of(t, 1) & kMask40) <= (sum_of(t, 0) & kMask40);
}

// Left when the amount is positive; the register forms take the low six bits, signed.
template <int unit, bool arithmetic>
void shift_by(Trial& t, Exact amount) {
  Exact value = arithmetic ? sum_of(t, unit) : sum_of(t, unit) & kMask40;
  for (; amount > 0; --amount) {
    value = (value * 2) & kMask40;
  }
  for (; amount < 0; ++amount) {
    value >>= 1;
  }
  set_sum(t, unit, value);
  (unit == 0 ? t.after.av0 : t.after.av1) = 0;
  t.zero_negative(wrap(value, 40));
}
template <int unit, bool arithmetic>
void shift_register(Trial& t) {
  shift_by<unit, arithmetic>(t, wrap(t.word(0), 6));
}

// Six bits: -32 to 31 to the left.
Exact down_to_32(Exact right) { return right > 32 ? 64 - right : -right; }

constexpr Law kLaws[] = {
    {"A0 = 0", clear<0>},
    {"A1 = 0", clear<1>},
    {"A1 = A0 = 0", both<clear<0>, clear<1>>},
    {"A0 = A1", from_other<0>},
    {"A1 = A0", from_other<1>},
    {"A0 = {D}", from_register<0>},
    {"A1 = {D}", from_register<1>},
    {"A0.L = {Dl}", from_half<0, 0>},
    {"A0.H = {Dh}", from_half<0, 16>},
    {"A0.X = {Dl}", from_half<0, 32>},
    {"A1.L = {Dl}", from_half<1, 0>},
    {"A1.H = {Dh}", from_half<1, 16>},
    {"A1.X = {Dl}", from_half<1, 32>},
    {"{Dl!} = A0.X", guard<0>},
    {"{Dl!} = A1.X", guard<1>},
    {"A0 += A1{w32}", add_in_place},
    {"A0 -= A1{w32}", subtract_in_place},
    {"{D!} = (A0 += A1)",
     [](Trial& t) {
       const Exact exact = added(t);
       set_sum(t, 0, exact);
       t.set(0, nearest(exact, 32));
       t.zero_negative(nearest(exact, 32));
       t.overflow(!fits(exact, 32));
     }},
    {"{Dx!} = (A0 += A1)",
     [](Trial& t) {
       const Exact exact = added(t);
       set_sum(t, 0, exact);
       const bool biased = (t.before.astat() >> 8 & 1) != 0;
       const bool to_even = !biased && (exact & 0xffff) == 0x8000 && (exact & 0x10000) == 0;
       const Exact rounded = (exact + 0x8000 - (to_even ? 1 : 0)) >> 16;
       t.set_half(0, nearest(rounded, 16));
       t.zero_negative(nearest(rounded, 16));
       t.overflow(!fits(rounded, 16));
     }},
    {"{D!} = A1 + A0, {D!} = A1 - A0{ns}", sum_and_difference<1>},
    {"{D!} = A0 + A1, {D!} = A0 - A1{ns}", sum_and_difference<0>},
    {"{D!} = A1.L + A1.H, {D!} = A0.L + A0.H",
     [](Trial& t) {
       t.set(0, wrap(sum_of(t, 1), 16) + wrap(sum_of(t, 1) >> 16, 16));
       t.set(1, wrap(sum_of(t, 0), 16) + wrap(sum_of(t, 0) >> 16, 16));
     }},
    {"A0 = ABS A0", absolute<0, 0>},
    {"A0 = ABS A1", absolute<0, 1>},
    {"A1 = ABS A0", absolute<1, 0>},
    {"A1 = ABS A1", absolute<1, 1>},
    {"A1 = ABS A1, A0 = ABS A0", both<absolute<0, 0>, absolute<1, 1>>},
    {"A0 = -A0", negate<0, 0>},
    {"A0 = -A1", negate<0, 1>},
    {"A1 = -A0", negate<1, 0>},
    {"A1 = -A1", negate<1, 1>},
    {"A1 = -A1, A0 = -A0", both<negate<0, 0>, negate<1, 1>>},
    {"A0 = A0 (S)", saturate<0>},
    {"A1 = A1 (S)", saturate<1>},
    {"A1 = A1 (S), A0 = A0 (S)", both<saturate<0>, saturate<1>>},
    {"CC = A0 == A1", [](Trial& t) { compare(t, sum_of(t, 0) == sum_of(t, 1)); }},
    {"CC = A0 < A1", [](Trial& t) { compare(t, sum_of(t, 0) < sum_of(t, 1)); }},
    {"CC = A0 <= A1", [](Trial& t) { compare(t, sum_of(t, 0) <= sum_of(t, 1)); }},
    {"A0 = A0 << {uimm5}", [](Trial& t) { shift_by<0, false>(t, t.number(0)); }},
    {"A0 = A0 >> {uimm6}", [](Trial& t) { shift_by<0, false>(t, down_to_32(t.number(0))); }},
    {"A0 = A0 >>> {uimm5}", [](Trial& t) { shift_by<0, true>(t, -t.number(0)); }},
    {"A1 = A1 << {uimm5}", [](Trial& t) { shift_by<1, false>(t, t.number(0)); }},
    {"A1 = A1 >> {uimm6}", [](Trial& t) { shift_by<1, false>(t, down_to_32(t.number(0))); }},
    {"A1 = A1 >>> {uimm5}", [](Trial& t) { shift_by<1, true>(t, -t.number(0)); }},
    {"A0 = ASHIFT A0 BY {Dl}", shift_register<0, true>},
    {"A0 = LSHIFT A0 BY {Dl}", shift_register<0, false>},
    {"A1 = ASHIFT A1 BY {Dl}", shift_register<1, true>},
    {"A1 = LSHIFT A1 BY {Dl}", shift_register<1, false>},
};

}  // namespace

std::span<const Law> accumulator_laws() { return kLaws; }

}  // namespace finback::isa::laws
