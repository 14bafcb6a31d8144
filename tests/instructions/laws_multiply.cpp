// Products and multiply-accumulates, by what the patterns say: the text is cut at its commas into
// the parts of unit 1 and unit 0, and each part is worked out in exact integers.
#include "laws.hpp"
#include <isa_sim/isa/choice.hpp>

namespace finback::isa::laws {

namespace {

struct Option {
  MultiplyMode mode = MultiplyMode::fraction;
  bool mixed = false;
  [[nodiscard]] bool is(std::initializer_list<MultiplyMode> modes) const {
    for (const MultiplyMode one : modes) {
      if (one == mode) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_signed() const {
    return mixed || !is({MultiplyMode::fu, MultiplyMode::iu, MultiplyMode::tfu});
  }
};
using M = MultiplyMode;

struct Part {
  int unit = 0;
  bool to_half = false;
  bool to_word = false;
  bool sums = false;
  bool multiplies = false;
  bool has_mixed = false;
  int target = 0;  // operand numbers
  int how = 0;
  int factor = 0;
  [[nodiscard]] bool moves() const { return (to_half || to_word) && !sums && !multiplies; }
};

// Reads one part, whose first operand is `next`.
Part read_part(std::string_view text, int& next) {
  Part part;
  part.unit = has(text, "A1") || has(text, "{Dh!}") || has(text, "{Dodd!}") ? 1 : 0;
  part.to_half = has(text, "{Dh!}") || has(text, "{Dl!}");
  part.to_word = has(text, "{Dodd!}") || has(text, "{Deven!}");
  part.sums = has(text, "{acc}");
  part.multiplies = has(text, "*");
  part.has_mixed = has(text, "{m}");
  if (part.to_half || part.to_word) {
    part.target = next++;
  }
  if (part.sums) {
    part.how = next++;
  }
  if (part.multiplies) {
    part.factor = next;
    next += 2;
  }
  return part;
}

// A half in the operands' format; the second factor is unsigned with M.
Exact product_of(const Trial& t, const Part& part, Option option, bool& minus_one_squared) {
  const Exact a = option.is_signed() ? t.half(part.factor) : t.unsigned_half(part.factor);
  const Exact b = option.is_signed() && !option.mixed ? t.half(part.factor + 1)
                                                      : t.unsigned_half(part.factor + 1);
  const bool fraction = !option.mixed && option.is({M::fraction, M::t, M::s2rnd, M::w32});
  minus_one_squared = fraction && a == -0x8000 && b == -0x8000;
  if (minus_one_squared && option.mode == M::w32) {
    return 0x7fffffff;
  }
  return fraction ? 2 * a * b : a * b;
}

// The accumulator's range.
Exact limited(Exact exact, Option option) {
  if (option.is({M::ih, M::w32})) {
    return nearest(exact, 32);
  }
  if (option.mode == M::iu && option.mixed) {
    return wrap(exact, 40);
  }
  if (!option.is_signed()) {
    const Exact top = (Exact{1} << 40) - 1;
    return exact < 0 ? 0 : exact > top ? top : exact;
  }
  return nearest(exact, 40);
}

Exact round_16(Exact value, bool biased) {
  const Exact whole = value >> 16;
  const Exact rest = value - whole * 0x10000;
  const bool up = rest > 0x8000 || (rest == 0x8000 && (biased || (whole & 1) != 0));
  return whole + (up ? 1 : 0);
}

// What the register takes, before it is limited to its bits.
Exact extracted(Exact value, const Part& part, Option option, bool biased) {
  if (option.is({M::s2rnd, M::iss2})) {
    value *= 2;
  }
  if (part.to_word || option.is({M::is, M::iu, M::iss2})) {
    return value;
  }
  return option.is({M::t, M::tfu}) ? value >> 16 : round_16(value, biased);
}
Exact limited_result(Exact exact, const Part& part, Option option) {
  const int bits = part.to_word ? 32 : 16;
  if (option.is_signed()) {
    return nearest(exact, bits);
  }
  const Exact top = (Exact{1} << bits) - 1;
  return exact < 0 ? 0 : exact > top ? top : exact;
}

struct Outcome {
  Exact result = 0;
  bool overflow = false;
};
Outcome work(Trial& t, const Part& part, Option option) {
  const auto unit = static_cast<std::size_t>(part.unit);
  const bool biased = (t.before.astat() >> 8 & 1) != 0;
  Exact value = t.before.accumulator[unit];
  if (!option.is_signed()) {
    value &= (Exact{1} << 40) - 1;
  }
  Outcome outcome;
  if (part.multiplies) {
    bool minus_one_squared = false;
    const Exact product = product_of(t, part, option, minus_one_squared);
    if (part.sums) {
      const std::int32_t how = t.number(part.how);
      const Exact exact = how == kSet ? product : how == kAdd ? value + product : value - product;
      value = limited(exact, option);
      const bool changed = value != exact && !(option.mode == M::iu && option.mixed);
      const bool saturated = changed || (minus_one_squared && option.mode == M::w32);
      t.accumulator_overflow(part.unit, saturated);
      t.after.accumulator[unit] = wrap(value, 40);
      const Exact unlimited = extracted(exact, part, option, biased);
      outcome.overflow =
          saturated && (part.to_word || limited_result(unlimited, part, option) != unlimited);
    } else {
      value = product;
      outcome.overflow = minus_one_squared;
    }
  }
  if (part.to_half || part.to_word) {
    const Exact exact = extracted(value, part, option, biased);
    outcome.result = limited_result(exact, part, option);
    outcome.overflow |= outcome.result != exact;
  } else {
    outcome.overflow = false;
  }
  return outcome;
}

void multiply_law(Trial& t) {
  int next = 0;
  const std::size_t comma = t.syntax.find(", ");
  std::vector<Part> parts = {read_part(t.syntax.substr(0, comma), next)};
  bool mixed = false;
  if (parts[0].has_mixed) {
    mixed = t.number(next++) != 0;
  }
  if (comma != std::string_view::npos) {
    parts.push_back(read_part(t.syntax.substr(comma), next));
  }
  const std::int32_t last = t.number(next);
  const Option option{static_cast<MultiplyMode>(last & 0xf), mixed || (last & kMixed) != 0};
  bool writes = false;
  bool moves = false;
  bool overflow = false;
  bool zero = false;
  bool negative = false;
  for (const Part& part : parts) {
    const Option own{option.mode, option.mixed && (part.unit == 1)};
    const Outcome outcome = work(t, part, own);
    overflow |= outcome.overflow;
    writes |= part.to_half || part.to_word;
    if (part.to_half) {
      t.set_half(part.target, outcome.result);
    } else if (part.to_word) {
      t.set(part.target, outcome.result);
    }
    if (part.moves()) {
      moves = true;
      zero |= outcome.result == 0;
      negative |= wrap(outcome.result, part.to_word ? 32 : 16) < 0;
    }
  }
  if (writes) {
    t.overflow(overflow);
  }
  if (moves) {
    t.after.az = zero;
    t.after.an = negative;
  }
}

constexpr Law kLaws[] = {
    {"{Dl!} = {Dx} * {Dx}{hmode}", multiply_law},
    {"{Dh!} = {Dx} * {Dx}{hmode_m}", multiply_law},
    {"{Deven!} = {Dx} * {Dx}{wmode}", multiply_law},
    {"{Dodd!} = {Dx} * {Dx}{wmode_m}", multiply_law},
    {"{Dh!} = {Dx} * {Dx}{m}, {Dl!} = {Dx} * {Dx}{hmode}", multiply_law},
    {"{Dodd!} = {Dx} * {Dx}{m}, {Deven!} = {Dx} * {Dx}{wmode}", multiply_law},
    {"A0 {acc} {Dx} * {Dx}{amode}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{amode_m}", multiply_law},
    {"{Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}", multiply_law},
    {"{Dh!} = (A1 {acc} {Dx} * {Dx}){hmode_m}", multiply_law},
    {"{Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}", multiply_law},
    {"{Dodd!} = (A1 {acc} {Dx} * {Dx}){wmode_m}", multiply_law},
    {"{Dl!} = A0{hmode}", multiply_law},
    {"{Dh!} = A1{hmode_m}", multiply_law},
    {"{Deven!} = A0{wmode}", multiply_law},
    {"{Dodd!} = A1{wmode_m}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{m}, A0 {acc} {Dx} * {Dx}{amode}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{m}, {Dl!} = A0{hmode}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}", multiply_law},
    {"A1 {acc} {Dx} * {Dx}{m}, {Deven!} = A0{wmode}", multiply_law},
    {"{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, A0 {acc} {Dx} * {Dx}{hmode}", multiply_law},
    {"{Dh!} = A1{m}, A0 {acc} {Dx} * {Dx}{hmode}", multiply_law},
    {"{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, A0 {acc} {Dx} * {Dx}{wmode}", multiply_law},
    {"{Dodd!} = A1{m}, A0 {acc} {Dx} * {Dx}{wmode}", multiply_law},
    {"{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}", multiply_law},
    {"{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, {Dl!} = A0{hmode}", multiply_law},
    {"{Dh!} = A1{m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}", multiply_law},
    {"{Dh!} = A1{m}, {Dl!} = A0{hmode}", multiply_law},
    {"{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}", multiply_law},
    {"{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, {Deven!} = A0{wmode}", multiply_law},
    {"{Dodd!} = A1{m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}", multiply_law},
    {"{Dodd!} = A1{m}, {Deven!} = A0{wmode}", multiply_law},
};

}  // namespace

std::span<const Law> multiply_laws() { return kLaws; }

}  // namespace finback::isa::laws
