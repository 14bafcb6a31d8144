// The ALUs: sums of words, halves and lanes, extremes, signs, rounding, SEARCH (Programming
// Reference chapters 15 and 19). Slot 0 of a packet.
#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/dsp_form.hpp>
#include <isa_sim/isa/multiplier.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using s16 = std::int16_t;
using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using std::int32_t;
using std::int64_t;

// ---- words and halves
// ---------------------------------------------------------------------------------------------------

template <bool subtract, bool saturate>
constexpr auto kAdd = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  reg(s, o[0]) = subtract ? subtract32(s, a, b, saturate) : add32(s, a, b, saturate);
};
template <bool subtract>
constexpr auto kAddHalf = [](ExecutionState& s, const Operation& o) {
  set_half(s, o[0], add_half(s, half(s, o[1]), half(s, o[2]), subtract, o[3] != 0));
};
// A flag is set when either result sets it.
constexpr auto kSumAndDifference = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  const bool saturate = o[4] != 0;
  const u32 sum = add32(s, a, b, saturate);
  const u8 az = s.az;
  const u8 an = s.an;
  const u8 v = s.v;
  const u8 carry = s.ac0;
  reg(s, o[3]) = subtract32(s, a, b, saturate);
  reg(s, o[0]) = sum;
  s.az |= az;
  s.an |= an;
  s.v |= v;
  s.ac0 |= carry;
};
template <bool saturate>
constexpr auto kNegate = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = subtract32(s, 0, reg(s, o[1]), saturate);
};

// ---- lanes: two halves of a register
// ---------------------------------------------------------------------------------------------------

// Flags gathered over lanes.
struct LaneFlags {
  bool zero = false;
  bool negative = false;
  bool overflow = false;

  u32 note(int32_t exact, bool saturate) {
    bool out_of_range = false;
    const u16 result = clip16(exact, saturate, out_of_range);
    overflow |= out_of_range;
    zero |= result == 0;
    negative |= (result & 0x8000) != 0;
    return result;
  }
  void store(ExecutionState& s) const {
    s.az = zero;
    s.an = negative;
    set_overflow(s, overflow);
  }
};

template <int32_t lanes, int32_t mode>
constexpr auto kAddLanes = [](ExecutionState& s, const Operation& o) {
  const u32 result = add_lanes(s, reg(s, o[1]), reg(s, o[2]), (lanes & kSubtractHigh) != 0,
                               (lanes & kSubtractLow) != 0, (mode & kSaturate) != 0);
  reg(s, o[0]) = (mode & kCross) != 0 ? result << 16 | result >> 16 : result;
};
template <int32_t lanes>
constexpr std::array<Execute, 4> kAddLanesByMode = {
    plain<kAddLanes<lanes, 0>>, plain<kAddLanes<lanes, kSaturate>>, plain<kAddLanes<lanes, kCross>>,
    plain<kAddLanes<lanes, kSaturate | kCross>>};
void prepare_lanes(const OperandNumbers& operand, Operation& operation) {
  static constexpr std::array<std::array<Execute, 4>, 4> kMeanings = {
      kAddLanesByMode<0>, kAddLanesByMode<kSubtractLow>, kAddLanesByMode<kSubtractHigh>,
      kAddLanesByMode<kSubtractHigh | kSubtractLow>};
  operation.execute =
      kMeanings.at(static_cast<std::size_t>(operand[2])).at(static_cast<std::size_t>(operand[4]));
  operation.operand = {operand[0], operand[1], operand[3]};
}

// Sums and differences of both lanes at once, halved or doubled on request; in the `crossed` form
// the high lane is added first and the low lane subtracted, then the other way.
template <bool crossed>
constexpr auto kQuad = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  const int32_t mode = o[4];
  LaneFlags flags;
  const auto lane = [&](int shift, bool subtract) {
    const int32_t left = s16(a >> shift);
    const int32_t right = s16(b >> shift);
    int32_t exact = subtract ? left - right : left + right;
    exact = (mode & kHalve) != 0 ? exact >> 1 : (mode & kDouble) != 0 ? exact * 2 : exact;
    return flags.note(exact, (mode & kSaturate) != 0);
  };
  const u32 first = lane(16, false) << 16 | lane(0, crossed);
  const u32 high = lane(16, true);
  const u32 low = lane(0, !crossed);
  reg(s, o[0]) = first;
  reg(s, o[3]) = (mode & kCross) != 0 ? low << 16 | high : high << 16 | low;
  flags.store(s);
};
template <auto pick>
constexpr auto kByLane = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  LaneFlags flags;
  const u32 high = flags.note(pick(s16(a >> 16), s16(b >> 16)), true);
  reg(s, o[0]) = high << 16 | flags.note(pick(s16(a), s16(b)), true);
  flags.store(s);
};
// The same with one source; its result saturates.
template <auto change>
constexpr auto kEachLane = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  LaneFlags flags;
  const u32 high = flags.note(change(s16(a >> 16)), true);
  reg(s, o[0]) = high << 16 | flags.note(change(s16(a)), true);
  flags.store(s);
};
constexpr auto kLarger = [](int32_t a, int32_t b) { return std::max(a, b); };
constexpr auto kSmaller = [](int32_t a, int32_t b) { return std::min(a, b); };
constexpr auto kPositive = [](int32_t a) { return a < 0 ? -a : a; };
constexpr auto kOpposite = [](int32_t a) { return -a; };
constexpr auto kNegateLanes = [](ExecutionState& s, const Operation& o) {
  const u32 value = reg(s, o[1]);
  kEachLane<kOpposite>(s, o);
  s.ac0 = (value & 0xffff) == 0;
  s.ac1 = value >> 16 == 0;
};

template <auto pick>
constexpr auto kExtreme = [](ExecutionState& s, const Operation& o) {
  const auto result = static_cast<u32>(pick(signed_reg(s, o[1]), signed_reg(s, o[2])));
  reg(s, o[0]) = result;
  set_az_an(s, result);
  s.v = 0;
};
constexpr auto kAbs = [](ExecutionState& s, const Operation& o) {
  const int64_t value = signed_reg(s, o[1]);
  reg(s, o[0]) = saturate32(s, value < 0 ? -value : value);
};

// ---- rounding to the high half of a word
// ---------------------------------------------------------------------------------------------------

// Saturates `exact` to 32 bits and takes its high half.
void set_rounded(ExecutionState& s, const Operation& o, int64_t exact) {
  const Extracted word = clip(exact, true, 32);
  const auto result = static_cast<u16>(word.value >> 16);
  set_half(s, o[0], result);
  s.az = result == 0;
  s.an = static_cast<u8>(result >> 15);
  set_overflow(s, word.overflow);
}
constexpr auto kRound = [](ExecutionState& s, const Operation& o) {
  set_rounded(s, o, int64_t{signed_reg(s, o[1])} + 0x8000);
};
// Of the sum at bit 12, which the result begins at.
template <bool subtract>
constexpr auto kRound12 = [](ExecutionState& s, const Operation& o) {
  const int64_t a = signed_reg(s, o[1]);
  const int64_t b = signed_reg(s, o[2]);
  set_rounded(s, o, ((subtract ? a - b : a + b) + 0x800) * 16);
};
// Of the sum at bit 20: cannot overflow.
template <bool subtract>
constexpr auto kRound20 = [](ExecutionState& s, const Operation& o) {
  const int64_t a = signed_reg(s, o[1]);
  const int64_t b = signed_reg(s, o[2]);
  const auto result = static_cast<u16>(((subtract ? a - b : a + b) + 0x80000) >> 20);
  set_half(s, o[0], result);
  s.az = result == 0;
  s.an = static_cast<u8>(result >> 15);
  s.v = 0;
};

// ---- halves and bytes put together
// ---------------------------------------------------------------------------------------------------

constexpr auto kPack = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = u32{half(s, o[1])} << 16 | half(s, o[2]);
};
template <int bytes>
constexpr auto kAlign = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = reg(s, o[1]) << (32 - 8 * bytes) | reg(s, o[2]) >> (8 * bytes);
};
// The second source's halves, each with its sign turned where the first's is negative, added.
constexpr auto kSignedSum = [](ExecutionState& s, const Operation& o) {
  const u32 signs = reg(s, register_of(o[2]));
  const u32 values = reg(s, register_of(o[3]));
  const auto lane = [&](int shift) {
    const int32_t value = s16(values >> shift);
    return s16(signs >> shift) < 0 ? -value : value;
  };
  const auto sum = static_cast<u16>(lane(16) + lane(0));
  reg(s, register_of(o[0])) = u32{sum} << 16 | sum;
};
std::string_view check_signed_sum(const OperandNumbers& operand) {
  const auto both_halves = [&](std::size_t one, std::size_t other) {
    return (operand[one] ^ operand[other]) == kHighHalf;
  };
  return both_halves(0, 1) && both_halves(2, 4) && both_halves(3, 5) &&
                 is_high_half(operand[2]) == is_high_half(operand[3])
             ? ""
             : "it works on both halves of three registers";
}

// The accumulators keep the best half so far of each lane, the results where it was met (P0).
constexpr auto kSearch = [](ExecutionState& s, const Operation& o) {
  const u32 source = reg(s, o[2]);
  const auto better = [relation = o[3]](s16 value, s16 best) {
    switch (relation) {
      case kGreater:
        return value > best;
      case kGreaterEqual:
        return value >= best;
      case kLess:
        return value < best;
      default:
        return value <= best;
    }
  };
  const auto lane = [&](std::size_t unit, s16 value, int32_t result) {
    const auto best = static_cast<s16>(s.accumulator[unit]);
    const bool found = better(value, best);
    s.accumulator[unit] = found ? value : best;
    if (found) {
      reg(s, result) = s.reg[P0];
    }
  };
  lane(1, static_cast<s16>(source >> 16), o[0]);
  lane(0, static_cast<s16>(source), o[1]);
};

constexpr Instruction checked(Instruction form, Check check) {
  form.check = check;
  return form;
}
constexpr Instruction prepared(Instruction form, Prepare prepare) {
  form.prepare = prepare;
  return form;
}

constexpr Instruction kTable[] = {
    // words
    dsp_form("{D!} = {D} + {D} (NS)", plain<kAdd<false, false>>),
    dsp_form("{D!} = {D} - {D} (NS)", plain<kAdd<true, false>>),
    dsp_form("{D!} = {D} + {D} (S)", plain<kAdd<false, true>>),
    dsp_form("{D!} = {D} - {D} (S)", plain<kAdd<true, true>>),
    two_results<0, 3>(
        dsp_form("{D!} = {D} + {D}, {D!} = {=1} - {=2}{ns}", plain<kSumAndDifference>)),
    dsp_form("{D!} = -{D} (NS)", plain<kNegate<false>>),
    dsp_form("{D!} = -{D} (S)", plain<kNegate<true>>),
    dsp_form("{D!} = MAX({D}, {D})", plain<kExtreme<kLarger>>),
    dsp_form("{D!} = MIN({D}, {D})", plain<kExtreme<kSmaller>>),
    dsp_form("{D!} = ABS {D}", plain<kAbs>, "the most negative value becomes the most positive"),

    // halves
    dsp_form("{Dx!} = {Dx} + {Dx}{ns}", plain<kAddHalf<false>>),
    dsp_form("{Dx!} = {Dx} - {Dx}{ns}", plain<kAddHalf<true>>),
    dsp_form("{Dx!} = {D} (RND)", plain<kRound>, "the high half, rounded up at bit 15"),
    dsp_form("{Dx!} = {D} + {D} (RND12)", plain<kRound12<false>>,
             "bits 12 to 27 of the sum, rounded"),
    dsp_form("{Dx!} = {D} - {D} (RND12)", plain<kRound12<true>>,
             "bits 12 to 27 of the difference, rounded"),
    dsp_form("{Dx!} = {D} + {D} (RND20)", plain<kRound20<false>>,
             "bits 20 to 31 of the sum, rounded"),
    dsp_form("{Dx!} = {D} - {D} (RND20)", plain<kRound20<true>>,
             "bits 20 to 31 of the difference, rounded"),
    checked(dsp_form("{Dx!} = {Dx!} = SIGN({Dx}) * {Dx} + SIGN({Dx}) * {Dx}", plain<kSignedSum>,
                     "each half with the sign of the other register's, added"),
            check_signed_sum),

    // lanes
    prepared(dsp_form("{D!} = {D} {lanes} {D}{sco}", plain<kAddLanes<0, 0>>), prepare_lanes),
    two_results<0, 3>(dsp_form("{D!} = {D} +|+ {D}, {D!} = {=1} -|- {=2}{sco_sft}",
                               plain<kQuad<false>>, "(CO) crosses the second result")),
    two_results<0, 3>(dsp_form("{D!} = {D} +|- {D}, {D!} = {=1} -|+ {=2}{sco_sft}",
                               plain<kQuad<true>>, "(CO) crosses the second result")),
    dsp_form("{D!} = MAX({D}, {D}) (V)", plain<kByLane<kLarger>>),
    dsp_form("{D!} = MIN({D}, {D}) (V)", plain<kByLane<kSmaller>>),
    dsp_form("{D!} = ABS {D} (V)", plain<kEachLane<kPositive>>, "saturated"),
    dsp_form("{D!} = -{D} (V)", plain<kNegateLanes>, "saturated"),
    two_results<0, 1>(
        with_implicit(dsp_form("({D+}, {D+}) = SEARCH {D}{rel}", plain<kSearch>,
                               "lanes better than A1 and A0 go there, P0 into the results"),
                      kReadsA0 | kWritesA0 | kReadsA1 | kWritesA1)),

    // halves and bytes put together
    dsp_form("{D!} = PACK({Dx}, {Dx})", plain<kPack>),
    early_dsp_form("{D!} = ALIGN8({D}, {D})", plain<kAlign<1>>),
    early_dsp_form("{D!} = ALIGN16({D}, {D})", plain<kAlign<2>>),
    early_dsp_form("{D!} = ALIGN24({D}, {D})", plain<kAlign<3>>),

    {.syntax = "MNOP",
     .length = 4,
     .slot = Slot::dsp,
     .energy = Energy::nop,
     .execute = plain<[](ExecutionState&, const Operation&) {}>,
     .meaning = "holds slot 0 of a packet"},
};

}  // namespace

std::span<const Instruction> alu_instructions() { return kTable; }

}  // namespace finback::isa
