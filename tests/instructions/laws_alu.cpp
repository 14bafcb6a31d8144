// The ALUs: words, halves, lanes, rounding, SEARCH.
#include <algorithm>

#include "laws.hpp"
#include <isa_sim/isa/choice.hpp>

namespace finback::isa::laws {

namespace {

// 16 bits of each lane as unsigned numbers, for carries.
Exact lane_bits(std::uint32_t word, int lane) { return word >> (16 * lane) & 0xffff; }
Exact lane_value(std::uint32_t word, int lane) { return wrap(lane_bits(word, lane), 16); }

bool carries(Exact a, Exact b, bool subtract, int bits) {
  const Exact mask = (Exact{1} << bits) - 1;
  return subtract ? (b & mask) <= (a & mask) : (a & mask) + (b & mask) > mask;
}

struct Result {
  Exact value = 0;
  bool overflow = false;
};
Result limited(Exact exact, int bits, bool saturate) {
  return {saturate ? nearest(exact, bits) : wrap(exact, bits), !fits(exact, bits)};
}

template <bool subtract, bool saturate>
void sum(Trial& t) {
  const Result r =
      limited(subtract ? t.value(1) - t.value(2) : t.value(1) + t.value(2), 32, saturate);
  t.set(0, r.value);
  t.zero_negative(r.value);
  t.overflow(r.overflow);
  t.after.ac0 = carries(t.value(1), t.value(2), subtract, 32);
}
void sum_and_difference(Trial& t) {
  const bool saturate = t.number(4) != 0;
  const Result plus = limited(t.value(1) + t.value(2), 32, saturate);
  const Result minus = limited(t.value(1) - t.value(2), 32, saturate);
  t.after.az = plus.value == 0 || minus.value == 0;
  t.after.an = plus.value < 0 || minus.value < 0;
  t.overflow(plus.overflow || minus.overflow);
  t.after.ac0 =
      carries(t.value(1), t.value(2), false, 32) || carries(t.value(1), t.value(2), true, 32);
  t.set(0, plus.value);
  t.set(3, minus.value);
}
template <bool saturate>
void negate(Trial& t) {
  const Result r = limited(-t.value(1), 32, saturate);
  t.set(0, r.value);
  t.zero_negative(r.value);
  t.overflow(r.overflow);
  t.after.ac0 = t.word(1) == 0;
}
template <bool subtract>
void half_sum(Trial& t) {
  const Result r =
      limited(subtract ? t.half(1) - t.half(2) : t.half(1) + t.half(2), 16, t.number(3) != 0);
  t.after.ac0 = carries(t.half(1), t.half(2), subtract, 16);
  t.set_half(0, r.value);
  t.zero_negative(r.value);
  t.overflow(r.overflow);
}

// The high half of a number of 32 bits, saturated.
void rounded(Trial& t, Exact exact) {
  const Result r = limited(exact, 32, true);
  const Exact result = r.value >> 16;
  t.set_half(0, result);
  t.zero_negative(result);
  t.overflow(r.overflow);
}
// A result begins at bit `bit` of the sum, rounded up from half.
template <int bit, bool subtract>
void rounded_sum(Trial& t) {
  const Exact exact = subtract ? t.value(1) - t.value(2) : t.value(1) + t.value(2);
  const Exact result = (exact + (Exact{1} << (bit - 1))) >> bit;
  const Result r = limited(result, 16, true);
  t.set_half(0, r.value);
  t.zero_negative(r.value);
  t.overflow(r.overflow);
}

// Lane 1 is the high one.
struct LaneResults {
  Result high;
  Result low;
};
void lane_flags(Trial& t, std::initializer_list<Result> results) {
  const auto any = [&](auto test) { return std::ranges::any_of(results, test); };
  t.after.az = any([](const Result& r) { return r.value == 0; });
  t.after.an = any([](const Result& r) { return r.value < 0; });
  t.overflow(any([](const Result& r) { return r.overflow; }));
}
Exact joined(Exact high, Exact low) { return high * 0x10000 + (low & 0xffff); }

void lanes_law(Trial& t) {
  const std::uint32_t a = t.word(1);
  const std::uint32_t b = t.word(3);
  const auto lane = [&](int which, bool subtract) {
    const Exact exact = subtract ? lane_value(a, which) - lane_value(b, which)
                                 : lane_value(a, which) + lane_value(b, which);
    return limited(exact, 16, (t.number(4) & kSaturate) != 0);
  };
  const bool high_minus = (t.number(2) & kSubtractHigh) != 0;
  const bool low_minus = (t.number(2) & kSubtractLow) != 0;
  const Result high = lane(1, high_minus);
  const Result low = lane(0, low_minus);
  lane_flags(t, {high, low});
  t.after.ac1 = carries(lane_value(a, 1), lane_value(b, 1), high_minus, 16);
  t.after.ac0 = carries(lane_value(a, 0), lane_value(b, 0), low_minus, 16);
  t.set(0, (t.number(4) & kCross) != 0 ? joined(low.value, high.value)
                                       : joined(high.value, low.value));
}

template <bool crossed>
void quad_law(Trial& t) {
  const std::uint32_t a = t.word(1);
  const std::uint32_t b = t.word(2);
  const std::int32_t mode = t.number(4);
  const auto lane = [&](int which, bool subtract) {
    Exact exact = lane_value(a, which) + (subtract ? -1 : 1) * lane_value(b, which);
    if ((mode & kHalve) != 0) {
      exact = (exact - (exact & 1)) / 2;
    } else if ((mode & kDouble) != 0) {
      exact *= 2;
    }
    return limited(exact, 16, (mode & kSaturate) != 0);
  };
  const Result first_high = lane(1, false);
  const Result first_low = lane(0, crossed);
  const Result second_high = lane(1, true);
  const Result second_low = lane(0, !crossed);
  lane_flags(t, {first_high, first_low, second_high, second_low});
  t.set(0, joined(first_high.value, first_low.value));
  t.set(3, (mode & kCross) != 0 ? joined(second_low.value, second_high.value)
                                : joined(second_high.value, second_low.value));
}

template <auto pick>
void by_lane(Trial& t) {
  const Result high = limited(pick(t.high(1), t.high(2)), 16, true);
  const Result low = limited(pick(t.low(1), t.low(2)), 16, true);
  lane_flags(t, {high, low});
  t.set(0, joined(high.value, low.value));
}
template <auto change>
void each_lane(Trial& t) {
  const Result high = limited(change(t.high(1)), 16, true);
  const Result low = limited(change(t.low(1)), 16, true);
  lane_flags(t, {high, low});
  t.set(0, joined(high.value, low.value));
}
constexpr auto kMaximum = [](Exact a, Exact b) { return a < b ? b : a; };
constexpr auto kMinimum = [](Exact a, Exact b) { return b < a ? b : a; };
constexpr auto kAbsolute = [](Exact a) { return a < 0 ? -a : a; };
constexpr auto kOpposite = [](Exact a) { return -a; };
template <auto pick>
void extreme(Trial& t) {
  const Exact result = pick(t.value(1), t.value(2));
  t.set(0, result);
  t.zero_negative(result);
  t.after.v = 0;
}

void search(Trial& t) {
  const auto better = [&](Exact value, Exact best) {
    const bool results[] = {value > best, value >= best, value < best, value <= best};
    return results[t.number(3)];
  };
  const auto lane = [&](std::size_t unit, Exact value, int target) {
    const Exact best = wrap(t.before.accumulator[unit], 16);
    const bool found = better(value, best);
    t.after.accumulator[unit] = found ? value : best;
    if (found) {
      t.set(target, t.before.reg[P0]);
    }
  };
  lane(1, t.high(2), 0);
  lane(0, t.low(2), 1);
}

template <int bytes>
void align(Trial& t) {
  const std::uint64_t both = std::uint64_t{t.word(1)} << 32 | t.word(2);
  t.set(0, static_cast<Exact>(both >> (8 * bytes)));
}

constexpr Law kLaws[] = {
    {"{D!} = {D} + {D} (NS)", sum<false, false>},
    {"{D!} = {D} - {D} (NS)", sum<true, false>},
    {"{D!} = {D} + {D} (S)", sum<false, true>},
    {"{D!} = {D} - {D} (S)", sum<true, true>},
    {"{D!} = {D} + {D}, {D!} = {=1} - {=2}{ns}", sum_and_difference},
    {"{D!} = -{D} (NS)", negate<false>},
    {"{D!} = -{D} (S)", negate<true>},
    {"{D!} = MAX({D}, {D})", extreme<kMaximum>},
    {"{D!} = MIN({D}, {D})", extreme<kMinimum>},
    {"{D!} = ABS {D}",
     [](Trial& t) {
       const Result r = limited(kAbsolute(t.value(1)), 32, true);
       t.set(0, r.value);
       t.zero_negative(r.value);
       t.overflow(r.overflow);
     }},
    {"{Dx!} = {Dx} + {Dx}{ns}", half_sum<false>},
    {"{Dx!} = {Dx} - {Dx}{ns}", half_sum<true>},
    {"{Dx!} = {D} (RND)", [](Trial& t) { rounded(t, t.value(1) + 0x8000); }},
    {"{Dx!} = {D} + {D} (RND12)", rounded_sum<12, false>},
    {"{Dx!} = {D} - {D} (RND12)", rounded_sum<12, true>},
    {"{Dx!} = {D} + {D} (RND20)", rounded_sum<20, false>},
    {"{Dx!} = {D} - {D} (RND20)", rounded_sum<20, true>},
    {"{Dx!} = {Dx!} = SIGN({Dx}) * {Dx} + SIGN({Dx}) * {Dx}",
     [](Trial& t) {
       const auto term = [&](int sign, int value) {
         return t.half(sign) < 0 ? -t.half(value) : t.half(value);
       };
       const Exact sum = term(2, 3) + term(4, 5);
       t.set_half(0, sum);
       t.set_half(1, sum);
     }},
    {"{D!} = {D} {lanes} {D}{sco}", lanes_law},
    {"{D!} = {D} +|+ {D}, {D!} = {=1} -|- {=2}{sco_sft}", quad_law<false>},
    {"{D!} = {D} +|- {D}, {D!} = {=1} -|+ {=2}{sco_sft}", quad_law<true>},
    {"{D!} = MAX({D}, {D}) (V)", by_lane<kMaximum>},
    {"{D!} = MIN({D}, {D}) (V)", by_lane<kMinimum>},
    {"{D!} = ABS {D} (V)", each_lane<kAbsolute>},
    {"{D!} = -{D} (V)",
     [](Trial& t) {
       each_lane<kOpposite>(t);
       t.after.ac0 = t.low(1) == 0;
       t.after.ac1 = t.high(1) == 0;
     }},
    {"({D+}, {D+}) = SEARCH {D}{rel}", search},
    {"{D!} = PACK({Dx}, {Dx})", [](Trial& t) { t.set(0, joined(t.half(1), t.half(2))); }},
    {"{D!} = ALIGN8({D}, {D})", align<1>},
    {"{D!} = ALIGN16({D}, {D})", align<2>},
    {"{D!} = ALIGN24({D}, {D})", align<3>},
    {"MNOP", [](Trial&) {}},
};

}  // namespace

std::span<const Law> alu_laws() { return kLaws; }

}  // namespace finback::isa::laws
