// The multipliers: 16 x 16 products into registers, multiply-accumulate, both units at once
// (Programming Reference chapters 15 and 18). Slot 0 of a packet.
#include <isa_sim/isa/multiplier.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u16 = std::uint16_t;
using u32 = std::uint32_t;
using u8 = std::uint8_t;
using std::int32_t;
using std::int64_t;

// What one unit does in an instruction.
enum class Part : u8 {
  none,
  accumulate,    // A0 += x * y
  half,          // R.L = (A0 += x * y)
  half_of_sum,   // R.L = A0
  word,          // R = (A0 += x * y)
  word_of_sum,   // R = A0
  half_product,  // R.L = x * y
  word_product,  // R = x * y
};
constexpr bool multiplies(Part part) {
  return part != Part::none && part != Part::half_of_sum && part != Part::word_of_sum;
}
constexpr bool sums(Part part) {
  return part == Part::accumulate || part == Part::half || part == Part::word;
}
constexpr bool writes(Part part) { return part != Part::none && part != Part::accumulate; }
constexpr bool is_word(Part part) {
  return part == Part::word || part == Part::word_of_sum || part == Part::word_product;
}
constexpr bool moves_sum(Part part) {
  return part == Part::half_of_sum || part == Part::word_of_sum;
}

// The operation's operands: 0 the destination of unit 1, 1 that of unit 0, 2 the control word, and
// two halves in one operand for each unit.
constexpr std::size_t kControl = 2;
constexpr std::size_t kFactors = 3;  // of unit 1; unit 0's follow
// Control word: the option, then how unit 1 and unit 0 accumulate.
constexpr int kHow1 = 8;
constexpr int kHow0 = 10;
// A pair of half registers in one operand.
constexpr int kSecondFactor = 8;

struct Outcome {
  u32 value = 0;
  bool overflow = false;
};

// One unit; reads registers and its accumulator, writes the accumulator with its flags.
template <Part part, int unit>
Outcome run_unit(ExecutionState& s, const Operation& o, MultiplyOption option) {
  int64_t& a = s.accumulator[unit];
  int64_t result = 0;
  bool overflow = false;
  if constexpr (multiplies(part)) {
    const int32_t factors = o[static_cast<int>(kFactors) + 1 - unit];
    const Product product =
        multiply(half(s, factors & 0xff), half(s, factors >> kSecondFactor), option);
    result = product.value;
    overflow = product.saturated && !sums(part);
    if constexpr (sums(part)) {
      const int32_t how = o[kControl] >> (unit == 1 ? kHow1 : kHow0) & 3;
      const int64_t old = is_signed(option) ? a : static_cast<int64_t>(bits40(a));
      const int64_t exact = how == kSet ? result : how == kAdd ? old + result : old - result;
      const Accumulated sum = accumulate(exact, option);
      const bool saturated =
          sum.saturated || (product.saturated && option.mode == MultiplyMode::w32);
      a = sum.value;
      (unit == 0 ? s.av0 : s.av1) = saturated;
      (unit == 0 ? s.av0s : s.av1s) |= static_cast<u8>(saturated);
      if constexpr (writes(part)) {
        overflow =
            saturated && (is_word(part) || extract_half(exact, option, s.rnd_mod != 0).overflow);
      }
    }
  }
  if constexpr (!writes(part)) {
    return {};
  }
  if constexpr (part != Part::half_product && part != Part::word_product) {
    result = is_signed(option) ? a : static_cast<int64_t>(bits40(a));
  }
  const Extracted extracted =
      is_word(part) ? extract_word(result, option) : extract_half(result, option, s.rnd_mod != 0);
  return {extracted.value, overflow || extracted.overflow};
}

template <Part part1, Part part0>
constexpr auto kUnits = [](ExecutionState& s, const Operation& o) {
  const MultiplyOption option = multiply_option(o[kControl]);
  const Outcome one = run_unit<part1, 1>(s, o, option);
  const Outcome zero = run_unit<part0, 0>(s, o, {option.mode, option.mixed && part1 == Part::none});
  if constexpr (writes(part1)) {
    is_word(part1) ? void(reg(s, o[0]) = one.value)
                   : set_high(s, o[0], static_cast<u16>(one.value));
  }
  if constexpr (writes(part0)) {
    is_word(part0) ? void(reg(s, o[1]) = zero.value)
                   : set_low(s, o[1], static_cast<u16>(zero.value));
  }
  if constexpr (writes(part1) || writes(part0)) {
    set_overflow(s, one.overflow || zero.overflow);
  }
  if constexpr (moves_sum(part1) || moves_sum(part0)) {
    const auto sign = [](Part part, u32 value) {
      return moves_sum(part) && (value >> (is_word(part) ? 31 : 15) & 1) != 0;
    };
    s.az = (moves_sum(part1) && one.value == 0) || (moves_sum(part0) && zero.value == 0);
    s.an = sign(part1, one.value) || sign(part0, zero.value);
  }
};

// Products that need no rounding and no saturation, which most C code uses.
template <bool as_signed>
constexpr auto kIntegerProduct = [](ExecutionState& s, const Operation& o) {
  const int32_t factors = o[static_cast<int>(kFactors)];
  const u16 a = half(s, factors & 0xff);
  const u16 b = half(s, factors >> kSecondFactor);
  reg(s, o[0]) =
      as_signed
          ? static_cast<u32>(int32_t{static_cast<std::int16_t>(a)} * static_cast<std::int16_t>(b))
          : u32{a} * b;
  s.v = 0;
};

// Chooses the short way of a product whose option needs no more.
void prepare_integer_product(Operation& operation, int32_t option, std::size_t unit) {
  const bool as_signed = option == static_cast<int32_t>(MultiplyMode::is);
  if (as_signed || option == static_cast<int32_t>(MultiplyMode::fu)) {
    operation.execute = as_signed ? plain<kIntegerProduct<true>> : plain<kIntegerProduct<false>>;
    operation.operand[0] = operation.operand[1 - unit];
    operation.operand[kFactors] = operation.operand[kFactors + 1 - unit];
  }
}

// Reads one unit's operands as its pattern has them: destination, `{acc}`, two factors.
template <Part part, int unit>
int read_part(const OperandNumbers& operand, int next, Operation& operation) {
  const auto at = [&operand](int index) { return operand[static_cast<std::size_t>(index)]; };
  if constexpr (writes(part)) {
    operation.operand[1 - unit] = register_of(at(next++));
  }
  if constexpr (sums(part)) {
    operation.operand[kControl] |= at(next++) << (unit == 1 ? kHow1 : kHow0);
  }
  if constexpr (multiplies(part)) {
    operation.operand[kFactors + 1 - unit] = at(next) | at(next + 1) << kSecondFactor;
    next += 2;
  }
  return next;
}

template <Part part1, Part part0>
void prepare(const OperandNumbers& operand, Operation& operation) {
  operation.operand = {};
  int next = read_part<part1, 1>(operand, 0, operation);
  if constexpr (part1 != Part::none && part0 != Part::none) {
    operation.operand[kControl] |= operand[static_cast<std::size_t>(next++)];  // {m}
  }
  next = read_part<part0, 0>(operand, next, operation);
  const int32_t option = operand[static_cast<std::size_t>(next)];
  operation.operand[kControl] |= option;
  constexpr bool kOneProduct = (part1 == Part::none && part0 == Part::word_product) ||
                               (part1 == Part::word_product && part0 == Part::none);
  if constexpr (kOneProduct) {
    prepare_integer_product(operation, option, part1 == Part::none ? 0 : 1);
  }
}

// Both units take their factors from the same two registers, and write one register's halves or two
// neighbours.
template <Part part1, Part part0>
std::string_view check(const OperandNumbers& operand) {
  Operation o;
  prepare<part1, part0>(operand, o);
  if constexpr (writes(part1) && writes(part0)) {
    if (o[0] - o[1] != (is_word(part1) ? 1 : 0)) {
      return is_word(part1) ? "the two results go to neighbours, such as R1 and R0"
                            : "the two results go to the halves of one register";
    }
  }
  if constexpr (multiplies(part1) && multiplies(part0)) {
    const auto factor = [&](std::size_t which, int shift) {
      return register_of(o.operand[which] >> shift & 0xff);
    };
    const int a1 = factor(kFactors, 0);
    const int b1 = factor(kFactors, kSecondFactor);
    const int a0 = factor(kFactors + 1, 0);
    const int b0 = factor(kFactors + 1, kSecondFactor);
    if ((a1 != a0 || b1 != b0) && (a1 != b0 || b1 != a0)) {
      return "both products take their halves from the same two registers";
    }
  }
  return "";
}

constexpr std::uint32_t sum_of(Part part, int unit) {
  const std::uint32_t reads = unit == 0 ? kReadsA0 : kReadsA1;
  const std::uint32_t changes = unit == 0 ? kWritesA0 : kWritesA1;
  return (sums(part) || moves_sum(part) ? reads : 0U) | (sums(part) ? changes : 0U);
}

template <Part part1, Part part0>
constexpr Instruction units(std::string_view syntax, std::string_view meaning = {}) {
  return {.syntax = syntax,
          .length = 4,
          .slot = Slot::dsp,
          .needs = multiplies(part1) || multiplies(part0) ? Needs::ex1 : Needs::ex2,
          .energy = multiplies(part1) || multiplies(part0) ? Energy::mac : Energy::alu,
          .implicit = sum_of(part1, 1) | sum_of(part0, 0),
          .execute = plain<kUnits<part1, part0>>,
          .check = check<part1, part0>,
          .prepare = prepare<part1, part0>,
          .meaning = meaning};
}

using P = Part;

constexpr Instruction kTable[] = {
    // one product into a register
    units<P::none, P::half_product>("{Dl!} = {Dx} * {Dx}{hmode}"),
    units<P::half_product, P::none>("{Dh!} = {Dx} * {Dx}{hmode_m}"),
    units<P::none, P::word_product>("{Deven!} = {Dx} * {Dx}{wmode}"),
    units<P::word_product, P::none>("{Dodd!} = {Dx} * {Dx}{wmode_m}"),
    // two
    units<P::half_product, P::half_product>("{Dh!} = {Dx} * {Dx}{m}, {Dl!} = {Dx} * {Dx}{hmode}"),
    units<P::word_product, P::word_product>(
        "{Dodd!} = {Dx} * {Dx}{m}, {Deven!} = {Dx} * {Dx}{wmode}"),

    // one accumulator
    units<P::none, P::accumulate>("A0 {acc} {Dx} * {Dx}{amode}"),
    units<P::accumulate, P::none>("A1 {acc} {Dx} * {Dx}{amode_m}"),
    units<P::none, P::half>("{Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}"),
    units<P::half, P::none>("{Dh!} = (A1 {acc} {Dx} * {Dx}){hmode_m}"),
    units<P::none, P::word>("{Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}"),
    units<P::word, P::none>("{Dodd!} = (A1 {acc} {Dx} * {Dx}){wmode_m}"),
    units<P::none, P::half_of_sum>("{Dl!} = A0{hmode}", "rounded and saturated"),
    units<P::half_of_sum, P::none>("{Dh!} = A1{hmode_m}", "rounded and saturated"),
    units<P::none, P::word_of_sum>("{Deven!} = A0{wmode}", "saturated to 32 bits"),
    units<P::word_of_sum, P::none>("{Dodd!} = A1{wmode_m}", "saturated to 32 bits"),

    // both accumulators
    units<P::accumulate, P::accumulate>("A1 {acc} {Dx} * {Dx}{m}, A0 {acc} {Dx} * {Dx}{amode}"),
    units<P::accumulate, P::half>("A1 {acc} {Dx} * {Dx}{m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}"),
    units<P::accumulate, P::half_of_sum>("A1 {acc} {Dx} * {Dx}{m}, {Dl!} = A0{hmode}"),
    units<P::accumulate, P::word>(
        "A1 {acc} {Dx} * {Dx}{m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}"),
    units<P::accumulate, P::word_of_sum>("A1 {acc} {Dx} * {Dx}{m}, {Deven!} = A0{wmode}"),
    units<P::half, P::accumulate>("{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, A0 {acc} {Dx} * {Dx}{hmode}"),
    units<P::half_of_sum, P::accumulate>("{Dh!} = A1{m}, A0 {acc} {Dx} * {Dx}{hmode}"),
    units<P::word, P::accumulate>(
        "{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, A0 {acc} {Dx} * {Dx}{wmode}"),
    units<P::word_of_sum, P::accumulate>("{Dodd!} = A1{m}, A0 {acc} {Dx} * {Dx}{wmode}"),
    units<P::half, P::half>(
        "{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}"),
    units<P::half, P::half_of_sum>("{Dh!} = (A1 {acc} {Dx} * {Dx}){m}, {Dl!} = A0{hmode}"),
    units<P::half_of_sum, P::half>("{Dh!} = A1{m}, {Dl!} = (A0 {acc} {Dx} * {Dx}){hmode}"),
    units<P::half_of_sum, P::half_of_sum>("{Dh!} = A1{m}, {Dl!} = A0{hmode}"),
    units<P::word, P::word>(
        "{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}"),
    units<P::word, P::word_of_sum>("{Dodd!} = (A1 {acc} {Dx} * {Dx}){m}, {Deven!} = A0{wmode}"),
    units<P::word_of_sum, P::word>("{Dodd!} = A1{m}, {Deven!} = (A0 {acc} {Dx} * {Dx}){wmode}"),
    units<P::word_of_sum, P::word_of_sum>("{Dodd!} = A1{m}, {Deven!} = A0{wmode}"),
};

}  // namespace

std::span<const Instruction> multiply_instructions() { return kTable; }

}  // namespace finback::isa
