// Shifts, rotations, bit fields, exponents, parity, add-compare-select. Shifts by pattern: width,
// direction, amount and option are read from the text; the work is done bit by bit.
#include <bit>

#include "laws.hpp"
#include <isa_sim/isa/choice.hpp>

namespace finback::isa::laws {

namespace {

// One value of `bits` bits, one place at a time to the left; notes what is lost on the way.
struct Shifted {
  Exact value = 0;
  bool lost = false;  // a bit that is not a copy of the result's sign
  bool sign_changed = false;
};
Shifted left(Exact value, Exact amount, int bits) {
  const Exact exact = amount > 40 ? 0 : value * (Exact{1} << amount);
  Shifted result{wrap(exact, bits), false, false};
  result.sign_changed = (result.value < 0) != (value < 0);
  // The bits above the result, of the value taken as unsigned: none, or ones above a negative one.
  const Exact bits_of = (value & ((Exact{1} << bits) - 1)) << amount;
  const Exact above = bits_of >> bits;
  const bool all_ones = above == (Exact{1} << amount) - 1 && amount > 0;
  result.lost = above != 0 && !(all_ones && result.value < 0);
  return result;
}

enum class OnLoss { ignore, flag, flag_sign, saturate };

Exact shifted(Trial& t, Exact value, Exact amount, int bits, bool arithmetic, OnLoss rule,
              bool& zero, bool& negative, bool& overflow) {
  Exact result = 0;
  if (amount > 0) {
    const Shifted up = left(value, amount, bits);
    const bool bad = up.lost || (rule >= OnLoss::flag_sign && up.sign_changed);
    result = rule == OnLoss::saturate && bad ? nearest(value < 0 ? INT64_MIN : INT64_MAX, bits)
                                             : up.value;
    overflow |= bad && rule != OnLoss::ignore;
  } else {
    const Exact down = arithmetic ? value : value & ((Exact{1} << bits) - 1);
    result = wrap(-amount > 40 ? (down < 0 ? -1 : 0) : down >> -amount, bits);
  }
  zero |= result == 0;
  negative |= result < 0;
  static_cast<void>(t);
  return result;
}

// "{D!} = ASHIFT {D} BY {Dl} (V, S)", "{Dx!} = {Dx} >>> {uimm4}" and their kin.
void shift_law(Trial& t) {
  const std::string_view s = t.syntax;
  const bool by_register = has(s, "BY");
  const bool lanes = has(s, "(V");
  const bool halves = s.starts_with("{Dx!}");
  const bool saturates = has(s, "S)");
  const bool to_right = has(s, ">>");
  const bool arithmetic = has(s, "ASHIFT") || has(s, ">>>") || (saturates && !by_register);
  Exact amount = by_register ? wrap(t.word(2), 6) : to_right ? -t.number(2) : t.number(2);
  if (has(s, "uimm5") && (halves || lanes)) {
    amount = amount < -16 ? amount + 32 : amount >= 16 ? amount - 32 : amount;  // five bits
  }
  OnLoss rule = saturates ? OnLoss::saturate : OnLoss::flag;
  if (to_right && (!saturates || lanes)) {
    rule = OnLoss::flag_sign;
  }
  if (by_register && !saturates) {
    const bool whole = !lanes && !halves;
    rule = has(s, "ASHIFT") || whole ? OnLoss::flag_sign : OnLoss::ignore;
  }
  bool zero = false;
  bool negative = false;
  bool overflow = false;
  const auto one = [&](Exact value, int bits) {
    return shifted(t, value, amount, bits, arithmetic, rule, zero, negative, overflow);
  };
  if (halves) {
    t.set_half(0, one(t.half(1), 16));
  } else if (lanes) {
    const Exact high = one(t.high(1), 16);
    const Exact low = one(t.low(1), 16);
    t.set(0, high * 0x10000 + (low & 0xffff));
  } else {
    t.set(0, one(t.value(1), 32));
  }
  t.after.az = zero;
  t.after.an = negative;
  t.overflow(overflow);
}

// CC and the value turn as one ring, one place at a time.
std::uint64_t rotated(Trial& t, std::uint64_t value, Exact amount, int bits) {
  std::uint64_t cc = t.before.cc;
  for (; amount > 0; --amount) {
    const std::uint64_t out = value >> (bits - 1) & 1;
    value = (value << 1 | cc) & ((std::uint64_t{1} << bits) - 1);
    cc = out;
  }
  for (; amount < 0; ++amount) {
    const std::uint64_t out = value & 1;
    value = value >> 1 | cc << (bits - 1);
    cc = out;
  }
  t.after.cc = static_cast<std::uint8_t>(cc);
  return value;
}
std::uint64_t bits40(const Trial& t, std::size_t unit) {
  return static_cast<std::uint64_t>(t.before.accumulator[unit]) & 0xffffffffffU;
}
void set40(Trial& t, std::size_t unit, std::uint64_t bits) {
  t.after.accumulator[unit] = wrap(static_cast<Exact>(bits), 40);
}
template <int unit>
void rotate_sum(Trial& t) {
  const Exact amount = has(t.syntax, "{Dl}") ? wrap(t.word(0), 6) : t.number(0);
  set40(t, unit, rotated(t, bits40(t, unit), amount, 40));
}

// The field that a pattern describes: length in bits 0-4, position in bits 8-12.
template <bool sign>
void extract(Trial& t) {
  const int length = static_cast<int>(t.word(2) & 31);
  const Exact field = (Exact{t.word(1)} >> (t.word(2) >> 8 & 31)) & ((Exact{1} << length) - 1);
  const Exact result = sign && length > 0 ? wrap(field, length) : field;
  t.set(0, result);
  t.logic_flags(static_cast<std::uint32_t>(result));
}
template <bool sign>
void deposit(Trial& t) {
  const int length = static_cast<int>(std::min<std::uint32_t>(t.word(2) & 31, 16));
  const int position = static_cast<int>(t.word(2) >> 8 & 31);
  const Exact field = (t.word(2) >> 16) & ((Exact{1} << length) - 1);
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i) {
    const int from = i - position;
    const bool inside = from >= 0 && from < length;
    const bool beyond = from >= length && sign;
    const Exact top = length > 0 ? field >> (length - 1) & 1 : 0;
    const Exact bit = inside ? field >> from & 1 : beyond ? top : t.word(1) >> i & 1;
    result |= static_cast<std::uint32_t>(bit) << i;
  }
  t.set(0, result);
  t.logic_flags(result);
}

// How often a value can be doubled.
int redundant_signs(Exact value, int bits) {
  int count = 0;
  while (count < bits - 1 && fits(value * 2, bits)) {
    value *= 2;
    ++count;
  }
  return count;
}
void set_low_half(Trial& t, Exact value) {
  t.set(0, (t.after.reg[static_cast<std::size_t>(t.reg(0))] & 0xffff0000) + (value & 0xffff));
}
template <int unit>
void signs_of_sum(Trial& t) {
  set_low_half(t, redundant_signs(t.before.accumulator[unit], 40) - 8);
}
void smallest(Trial& t, std::initializer_list<int> exponents, std::uint32_t mask) {
  std::uint32_t best = t.word(2) & 0xffff;
  for (const int exponent : exponents) {
    if ((static_cast<std::uint32_t>(exponent) & mask) < (best & mask)) {
      best = static_cast<std::uint32_t>(exponent);
    }
  }
  set_low_half(t, best);
}

std::uint8_t parity(std::uint64_t bits) {
  return static_cast<std::uint8_t>(std::popcount(bits) & 1);
}

void bit_multiplex(Trial& t, bool to_right) {
  const std::uint64_t a = bits40(t, 0);
  const std::uint64_t first = t.word(0);
  const std::uint64_t second = t.word(1);
  if (to_right) {
    set40(t, 0, a >> 2 | (first & 1) << 38 | (second & 1) << 39);
    t.set(0, static_cast<Exact>(first >> 1));
    t.set(1, static_cast<Exact>(second >> 1));
  } else {
    set40(t, 0, (a << 2 & 0xffffffffffU) | first >> 31 | second >> 31 << 1);
    t.set(0, static_cast<Exact>(first << 1));
    t.set(1, static_cast<Exact>(second << 1));
  }
}

// The larger half as numbers that wrap: high - low is not negative.
bool high_is_larger(const Trial& t, int i) { return wrap(t.high(i) - t.low(i), 16) >= 0; }
Exact larger(const Trial& t, int i) { return high_is_larger(t, i) ? t.high(i) : t.low(i); }
void viterbi(Trial& t) {
  const std::uint64_t a = bits40(t, 0);
  const std::uint64_t bit = high_is_larger(t, 1) ? 1 : 0;
  const std::uint64_t mask = std::uint64_t{1} << 31;
  set40(t, 0,
        t.number(2) == kToLeft ? (a * 2 | bit) & 0xffffffffffU : (a / 2 & ~mask) + bit * mask);
  set_low_half(t, larger(t, 1));
}
void viterbi_pair(Trial& t) {
  const std::uint64_t one = high_is_larger(t, 1) ? 1 : 0;
  const std::uint64_t two = high_is_larger(t, 2) ? 1 : 0;
  if (t.number(3) == kToLeft) {
    set40(t, 0, (bits40(t, 0) * 4 + two * 2 + one) & 0xffffffffffU);
  } else {
    set40(t, 0,
          (static_cast<std::uint64_t>(t.before.accumulator[0] >> 2) | one << 31 | two << 30) &
              0xffffffffffU);
  }
  t.set(0, larger(t, 1) * 0x10000 + (larger(t, 2) & 0xffff));
}

constexpr Law kLaws[] = {
    {"{D!} = EXTRACT({D}, {Dl}) {?(Z)}", extract<false>},
    {"{D!} = EXTRACT({D}, {Dl}) (X)", extract<true>},
    {"{Dl!} = ONES {D}",
     [](Trial& t) {
       int ones = 0;
       for (int i = 0; i < 32; ++i) {
         ones += static_cast<int>(t.word(1) >> i & 1);
       }
       set_low_half(t, ones);
     }},
    {"{Dl!} = SIGNBITS {D}", [](Trial& t) { set_low_half(t, redundant_signs(t.value(1), 32)); }},
    {"{Dl!} = SIGNBITS {Dx}", [](Trial& t) { set_low_half(t, redundant_signs(t.half(1), 16)); }},
    {"{Dl!} = SIGNBITS A0", signs_of_sum<0>},
    {"{Dl!} = SIGNBITS A1", signs_of_sum<1>},
    {"{Dl!} = EXPADJ({D}, {Dl})",
     [](Trial& t) { smallest(t, {redundant_signs(t.value(1), 32)}, 0x1f); }},
    {"{Dl!} = EXPADJ({Dx}, {Dl})",
     [](Trial& t) { smallest(t, {redundant_signs(t.half(1), 16)}, 0xf); }},
    {"{Dl!} = EXPADJ({D}, {Dl}) (V)",
     [](Trial& t) {
       smallest(t, {redundant_signs(t.low(1), 16), redundant_signs(t.high(1), 16)}, 0xf);
     }},
    {"{D!} = DEPOSIT({D}, {D})", deposit<false>},
    {"{D!} = DEPOSIT({D}, {D}) (X)", deposit<true>},
    {"BITMUX({D+}, {D+}, A0) (ASR)", [](Trial& t) { bit_multiplex(t, true); }},
    {"BITMUX({D+}, {D+}, A0) (ASL)", [](Trial& t) { bit_multiplex(t, false); }},
    {"{Dl!} = CC = BXORSHIFT(A0, {D})",
     [](Trial& t) {
       const std::uint64_t a = bits40(t, 0) << 1 & 0xffffffffffU;
       set40(t, 0, a);
       t.after.cc = parity(a & t.word(1));
       set_low_half(t, t.after.cc);
     }},
    {"{Dl!} = CC = BXOR(A0, {D})",
     [](Trial& t) {
       t.after.cc = parity(bits40(t, 0) & t.word(1));
       set_low_half(t, t.after.cc);
     }},
    {"{Dl!} = CC = BXOR(A0, A1, CC)",
     [](Trial& t) {
       t.after.cc = (t.before.cc + parity(bits40(t, 0) & bits40(t, 1))) % 2;
       set_low_half(t, t.after.cc);
     }},
    {"A0 = BXORSHIFT(A0, A1, CC)",
     [](Trial& t) {
       const std::uint64_t bit = (t.before.cc + parity(bits40(t, 0) & bits40(t, 1))) % 2;
       set40(t, 0, (bits40(t, 0) << 1 & 0xffffffffffU) + bit);
     }},
    {"{Dl!} = VIT_MAX({D}){side}", viterbi},
    {"{D!} = VIT_MAX({D}, {D}){side}", viterbi_pair},
    {"{D!} = ROT {D} BY {imm6}",
     [](Trial& t) { t.set(0, static_cast<Exact>(rotated(t, t.word(1), t.number(2), 32))); }},
    {"{D!} = ROT {D} BY {Dl}",
     [](Trial& t) { t.set(0, static_cast<Exact>(rotated(t, t.word(1), wrap(t.word(2), 6), 32))); }},
    {"A0 = ROT A0 BY {imm6}", rotate_sum<0>},
    {"A0 = ROT A0 BY {Dl}", rotate_sum<0>},
    {"A1 = ROT A1 BY {imm6}", rotate_sum<1>},
    {"A1 = ROT A1 BY {Dl}", rotate_sum<1>},
};

}  // namespace

std::span<const Law> shift_laws() { return kLaws; }

void (*shift_law_of(std::string_view syntax))(Trial&) {
  const bool data = syntax.starts_with("{D!} = ") || syntax.starts_with("{Dx!} = ");
  const bool shifts = has(syntax, "} << {uimm") || has(syntax, "} >> {uimm") ||
                      has(syntax, "} >>> {uimm") || has(syntax, "SHIFT {D");
  return data && shifts ? shift_law : nullptr;
}

}  // namespace finback::isa::laws
