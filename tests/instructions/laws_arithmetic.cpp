// The short arithmetic, logic, shift and bit instructions, and pointer arithmetic.
#include "laws.hpp"

namespace finback::isa::laws {

namespace {

// A 32-bit sum or difference with its flags; the carry of a difference says that nothing was
// borrowed.
void sum_law(Trial& t, int target, Exact a, Exact b, bool subtract) {
  const Exact exact = subtract ? a - b : a + b;
  t.set(target, exact);
  t.zero_negative(wrap(exact, 32));
  t.overflow(!fits(exact, 32));
  const Exact left = a & 0xffffffff;
  const Exact right = b & 0xffffffff;
  t.after.ac0 = subtract ? right <= left : left + right > 0xffffffff;
}

template <auto operation>
void logic(Trial& t) {
  const std::uint32_t result = operation(t.word(1), t.word(2));
  t.set(0, result);
  t.logic_flags(result);
}
// One bit of operand 0.
template <auto operation>
void bit(Trial& t) {
  const std::uint32_t result = operation(t.word(0), std::uint32_t{1} << t.number(1));
  t.set(0, result);
  t.logic_flags(result);
}

// In place, by whole amounts: 32 and more shift everything out.
void shift_law(Trial& t, Exact amount, bool left, bool arithmetic) {
  const Exact value = arithmetic ? t.value(0) : Exact{t.word(0)};
  Exact result = 0;
  if (left) {
    result = amount < 32 ? value << amount : 0;
  } else {
    result = amount < 32 ? value >> amount : (value < 0 ? -1 : 0);
  }
  t.set(0, result);
  t.zero_negative(wrap(result, 32));
  t.after.v = 0;
}

template <int shift>
void add_and_shift(Trial& t) {
  const Exact exact = (t.value(0) + t.value(1)) << shift;
  t.set(0, exact);
  t.zero_negative(wrap(exact, 32));
  t.overflow(!fits(exact, 32));
}

// DIVS: the quotient's sign; DIVQ: the divisor is added or taken away as AQ says, AQ becomes the
// signs' difference, and its opposite enters the quotient from below.
void divide_sign(Trial& t) {
  const bool differ = ((t.word(0) >> 31) ^ (t.word(1) >> 15 & 1)) != 0;
  t.after.aq = differ;
  t.set(0, (t.word(0) & 0xffff0000) * 2 + (t.word(0) & 0xffff) * 2 + differ);
}
void divide_quotient(Trial& t) {
  const Exact divisor = t.low(1);
  const Exact part = wrap(t.high(0) + (t.before.aq != 0 ? divisor : -divisor), 16);
  const bool differ = (part < 0) != (divisor < 0);
  t.after.aq = differ;
  t.set(0, part * 0x20000 + (t.word(0) & 0xffff) * 2 + (differ ? 0 : 1));
}

template <int shift>
void pointer_add(Trial& t) {
  t.set(0, Exact{t.word(1)} + (Exact{t.word(2)} << shift));
}
template <int shift>
void pointer_add_and_shift(Trial& t) {
  t.set(0, (Exact{t.word(0)} + t.word(1)) << shift);
}

// Bit by bit from the top, the carry going down.
Exact add_reversed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t result = 0;
  std::uint32_t carry = 0;
  for (int i = 31; i >= 0; --i) {
    const std::uint32_t sum = (a >> i & 1) + (b >> i & 1) + carry;
    result |= (sum & 1) << i;
    carry = sum >> 1;
  }
  return result;
}

// A step of an index register. A buffer that fits into 32 bits wraps once; others are the address
// generator's secret, and these trials have none.
void step(Trial& t, Exact by) {
  const auto number = static_cast<std::size_t>(t.reg(0) - I0);
  const Exact length = t.before.reg[L0 + number];
  const Exact base = t.before.reg[B0 + number];
  Exact next = Exact{t.word(0)} + by;
  if (length != 0) {
    next += by >= 0 && next >= base + length ? -length : by < 0 && next < base ? length : 0;
  }
  t.set(0, next);
}

constexpr auto kAnd = [](std::uint32_t a, std::uint32_t b) { return a & b; };
constexpr auto kOr = [](std::uint32_t a, std::uint32_t b) { return a | b; };
constexpr auto kXor = [](std::uint32_t a, std::uint32_t b) { return a ^ b; };
constexpr auto kAndNot = [](std::uint32_t a, std::uint32_t b) { return a & ~b; };

constexpr Law kLaws[] = {
    {"{D!} = {D} + {D}", [](Trial& t) { sum_law(t, 0, t.value(1), t.value(2), false); }},
    {"{D!} = {D} - {D}", [](Trial& t) { sum_law(t, 0, t.value(1), t.value(2), true); }},
    {"{D!} = {D} & {D}", logic<kAnd>},
    {"{D!} = {D} | {D}", logic<kOr>},
    {"{D!} = {D} ^ {D}", logic<kXor>},
    {"{D+} += {imm7}", [](Trial& t) { sum_law(t, 0, t.value(0), t.number(1), false); }},
    {"{D!} = -{D}", [](Trial& t) { sum_law(t, 0, 0, t.value(1), true); }},
    {"{D!} = ~{D}",
     [](Trial& t) {
       t.set(0, ~t.word(1));
       t.logic_flags(~t.word(1));
     }},
    {"{D+} *= {D}",
     [](Trial& t) { t.set_register(t.reg(0), static_cast<Exact>(t.word(0) * t.word(1))); }},
    {"{D+} = ({=0} + {D}) << 1", add_and_shift<1>},
    {"{D+} = ({=0} + {D}) << 2", add_and_shift<2>},
    {"{D+} <<= {uimm5}", [](Trial& t) { shift_law(t, t.number(1), true, false); }},
    {"{D+} >>= {uimm5}", [](Trial& t) { shift_law(t, t.number(1), false, false); }},
    {"{D+} >>>= {uimm5}", [](Trial& t) { shift_law(t, t.number(1), false, true); }},
    {"{D+} <<= {D}", [](Trial& t) { shift_law(t, t.word(1), true, false); }},
    {"{D+} >>= {D}", [](Trial& t) { shift_law(t, t.word(1), false, false); }},
    {"{D+} >>>= {D}", [](Trial& t) { shift_law(t, t.word(1), false, true); }},
    {"BITSET({D+}, {uimm5})", bit<kOr>},
    {"BITCLR({D+}, {uimm5})", bit<kAndNot>},
    {"BITTGL({D+}, {uimm5})", bit<kXor>},
    {"DIVS({D+}, {D})", divide_sign},
    {"DIVQ({D+}, {D})", divide_quotient},

    {"{P!} = {P@} + {P@}", pointer_add<0>},
    {"{P!} = {P@} + ({P@} << 1)", pointer_add<1>},
    {"{P!} = {P@} + ({P@} << 2)", pointer_add<2>},
    {"{P@+} = ({=0} + {P@}) << 1", pointer_add_and_shift<1>},
    {"{P@+} = ({=0} + {P@}) << 2", pointer_add_and_shift<2>},
    {"{P!} = {P@} << 1", [](Trial& t) { t.set(0, Exact{t.word(1)} * 2); }},
    {"{P!} = {P@} << 2", [](Trial& t) { t.set(0, Exact{t.word(1)} * 4); }},
    {"{P!} = {P@} >> 1", [](Trial& t) { t.set(0, t.word(1) / 2); }},
    {"{P!} = {P@} >> 2", [](Trial& t) { t.set(0, t.word(1) / 4); }},
    {"{P@+} += {imm7}", [](Trial& t) { t.set(0, t.value(0) + t.number(1)); }},
    {"{P@+} -= {P@}", [](Trial& t) { t.set(0, t.value(0) - t.value(1)); }},
    {"{P@+} += {P@} (BREV)", [](Trial& t) { t.set(0, add_reversed(t.word(0), t.word(1))); }},
    {"{I@+} += {M@}", [](Trial& t) { step(t, t.value(1)); }},
    {"{I@+} += {M@} (BREV)", [](Trial& t) { t.set(0, add_reversed(t.word(0), t.word(1))); }},
    {"{I@+} -= {M@}", [](Trial& t) { step(t, -t.value(1)); }},
    {"{I@+} += 2", [](Trial& t) { step(t, 2); }},
    {"{I@+} += 4", [](Trial& t) { step(t, 4); }},
    {"{I@+} -= 2", [](Trial& t) { step(t, -2); }},
    {"{I@+} -= 4", [](Trial& t) { step(t, -4); }},
};

}  // namespace

std::span<const Law> arithmetic_laws() { return kLaws; }

}  // namespace finback::isa::laws
