// The shifter: shifts, rotations, bit fields, exponents, parity (Programming Reference chapters 13
// and 14). Flags of the saturating, half-register and vector forms as the GNU simulator has them,
// which was held against the chip.
#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/dsp_form.hpp>
#include <isa_sim/isa/multiplier.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u16 = std::uint16_t;
using u32 = std::uint32_t;
using std::int32_t;
using std::int64_t;

// The field descriptor of EXTRACT and DEPOSIT: length in bits 0-4, position in bits 8-12.
template <bool sign_extend>
constexpr auto kExtract = [](ExecutionState& s, const Operation& o) {
  const u32 field = reg(s, register_of(o[2]));
  const u32 length = field & 0x1f;
  const u32 position = field >> 8 & 0x1f;
  const u32 mask = (u32{1} << length) - 1;
  u32 result = reg(s, o[1]) >> position & mask;
  if (sign_extend && length != 0 && (result >> (length - 1) & 1) != 0) {
    result |= ~mask;
  }
  reg(s, o[0]) = result;
  set_logic_flags(s, result);
};

constexpr auto kOnes = [](ExecutionState& s, const Operation& o) {
  set_half(s, register_of(o[0]), static_cast<u16>(std::popcount(reg(s, o[1]))));
};
// ---- shifts by value, with their flags: of 16 or 32 bits
// ---------------------------------------------------------------------------------------------------

void set_shift_flags(ExecutionState& s, u32 result, int bits) {
  s.az = result == 0;
  s.an = static_cast<std::uint8_t>(result >> (bits - 1) & 1);
}

u32 mask_of(int bits) { return bits == 32 ? ~u32{0} : (u32{1} << bits) - 1; }

// What a shift to the left does about bits that it loses: anything but zeros, or ones above a
// negative result.
enum class Lost : std::uint8_t {
  ignored,   // V is cleared
  flagged,   // V tells
  or_sign,   // V tells, and of a change of sign as well
  saturate,  // the same, and the result is the nearest that fits
};
u32 shift_left(ExecutionState& s, u32 value, int count, int bits, Lost lost_bits) {
  const std::uint64_t wide = std::uint64_t{value} << count;
  u32 result = static_cast<u32>(wide) & mask_of(bits);
  const std::uint64_t lost = wide >> bits;
  const bool was_negative = (value >> (bits - 1) & 1) != 0;
  const bool is_negative = (result >> (bits - 1) & 1) != 0;
  bool overflow = lost != 0 && !(lost == (std::uint64_t{1} << count) - 1 && is_negative);
  overflow |= lost_bits >= Lost::or_sign && was_negative != is_negative;
  if (lost_bits == Lost::saturate && overflow) {
    result = was_negative ? u32{1} << (bits - 1) : mask_of(bits - 1);
  }
  set_shift_flags(s, result, bits);
  set_overflow(s, overflow && lost_bits != Lost::ignored);
  return result;
}

u32 shift_right(ExecutionState& s, u32 value, int count, int bits, bool arithmetic) {
  const int amount = std::min(count, bits - 1);
  const auto wide = static_cast<int32_t>(value << (32 - bits)) >> (32 - bits);
  const u32 result = arithmetic      ? static_cast<u32>(wide >> amount) & mask_of(bits)
                     : count >= bits ? 0
                                     : value >> count;
  set_shift_flags(s, result, bits);
  s.v = 0;
  return result;
}

// Left when the amount is positive.
u32 shift_by(ExecutionState& s, u32 value, int amount, int bits, bool arithmetic, Lost lost) {
  return amount > 0 ? shift_left(s, value, amount, bits, lost)
                    : shift_right(s, value, -amount, bits, arithmetic);
}

// Both halves by the same amount; a flag is set when either half sets it.
u32 shift_halves(ExecutionState& s, u32 value, int amount, bool arithmetic, Lost lost) {
  const u32 low = shift_by(s, value & 0xffff, amount, 16, arithmetic, lost);
  const std::uint8_t az = s.az;
  const std::uint8_t an = s.an;
  const std::uint8_t v = s.v;
  const u32 high = shift_by(s, value >> 16, amount, 16, arithmetic, lost);
  s.az |= az;
  s.an |= an;
  s.v |= v;
  return high << 16 | low;
}

// Where the amount stands: an immediate to the left or to the right, or a half register.
enum class Amount : std::uint8_t { left, right, in_register };
template <Amount where>
int amount_of(ExecutionState& s, const Operation& o) {
  return where == Amount::left    ? o[2]
         : where == Amount::right ? -o[2]
                                  : shift_amount(reg(s, register_of(o[2])));
}

template <Amount where, bool arithmetic, Lost lost>
constexpr auto kShiftHalf = [](ExecutionState& s, const Operation& o) {
  set_half(
      s, o[0],
      static_cast<u16>(shift_by(s, half(s, o[1]), amount_of<where>(s, o), 16, arithmetic, lost)));
};
template <Amount where, bool arithmetic, Lost lost>
constexpr auto kShiftWord = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = shift_by(s, reg(s, o[1]), amount_of<where>(s, o), 32, arithmetic, lost);
};
template <Amount where, bool arithmetic, Lost lost>
constexpr auto kShiftHalves = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = shift_halves(s, reg(s, o[1]), amount_of<where>(s, o), arithmetic, lost);
};

// To the right by an immediate nothing is lost.
template <bool arithmetic>
constexpr auto kShiftRight = [](ExecutionState& s, const Operation& o) {
  const u32 value = reg(s, o[1]);
  const u32 result =
      arithmetic ? static_cast<u32>(static_cast<int32_t>(value) >> o[2]) : value >> o[2];
  reg(s, o[0]) = result;
  set_az_an(s, result);
  s.v = 0;
};

// ---- rotation through CC
// ---------------------------------------------------------------------------------------------------

// `value` of `bits` bits with CC above it, as a ring; to the left when `amount` is positive.
std::uint64_t rotate(ExecutionState& s, std::uint64_t value, int amount, int bits) {
  const int ring = bits + 1;
  const int left = (amount % ring + ring) % ring;
  if (left == 0) {
    return value;
  }
  const std::uint64_t whole = std::uint64_t{s.cc} << bits | value;
  const std::uint64_t turned =
      (whole << left | whole >> (ring - left)) & ((std::uint64_t{1} << ring) - 1);
  s.cc = static_cast<std::uint8_t>(turned >> bits);
  return turned & ((std::uint64_t{1} << bits) - 1);
}

template <bool by_register>
constexpr auto kRotate = [](ExecutionState& s, const Operation& o) {
  const int amount = by_register ? shift_amount(reg(s, register_of(o[2]))) : o[2];
  reg(s, o[0]) = static_cast<u32>(rotate(s, reg(s, o[1]), amount, 32));
};
template <int accumulator, bool by_register>
constexpr auto kRotateAccumulator = [](ExecutionState& s, const Operation& o) {
  const int amount = by_register ? shift_amount(reg(s, register_of(o[0]))) : o[0];
  int64_t& a = s.accumulator[accumulator];
  a = accumulator_of(rotate(s, bits40(a), amount, 40));
};

// ---- bit fields, exponents, parity
// ---------------------------------------------------------------------------------------------------

// The foreground's high half holds the field, its low half length (bits 0-4, at most 16) and
// position (bits 8-12).
template <bool sign_extend>
constexpr auto kDeposit = [](ExecutionState& s, const Operation& o) {
  const u32 foreground = reg(s, o[2]);
  const u32 length = std::min<u32>(foreground & 0x1f, 16);
  const u32 position = foreground >> 8 & 0x1f;
  u32 mask = (u32{1} << length) - 1;
  u32 field = foreground >> 16 & mask;
  if (sign_extend) {
    field |= length != 0 && (field >> (length - 1) & 1) != 0 ? ~mask : 0;
    mask = ~u32{0};
  }
  const u32 result = (reg(s, o[1]) & ~(mask << position)) | field << position;
  reg(s, o[0]) = result;
  set_logic_flags(s, result);
};

// One bit from each register into A0, from its top (ASR) or its bottom (ASL).
constexpr auto kBitMultiplexDown = [](ExecutionState& s, const Operation& o) {
  u32& first = reg(s, o[0]);
  u32& second = reg(s, o[1]);
  s.accumulator[0] = accumulator_of(bits40(s.accumulator[0]) >> 2 | std::uint64_t{first & 1} << 38 |
                                    std::uint64_t{second & 1} << 39);
  first >>= 1;
  second >>= 1;
};
constexpr auto kBitMultiplexUp = [](ExecutionState& s, const Operation& o) {
  u32& first = reg(s, o[0]);
  u32& second = reg(s, o[1]);
  s.accumulator[0] =
      accumulator_of(bits40(s.accumulator[0]) << 2 | first >> 31 | (second >> 31) << 1);
  first <<= 1;
  second <<= 1;
};

std::uint8_t parity(std::uint64_t bits) { return std::popcount(bits) & 1; }

template <bool shift>
constexpr auto kParityOfRegister = [](ExecutionState& s, const Operation& o) {
  std::uint64_t a = bits40(s.accumulator[0]);
  if (shift) {
    a = a << 1 & kAllBits40;
    s.accumulator[0] = accumulator_of(a);
  }
  s.cc = parity(a & reg(s, o[1]));
  set_half(s, register_of(o[0]), s.cc);
};
constexpr auto kParityOfAccumulator = [](ExecutionState& s, const Operation& o) {
  s.cc ^= parity(bits40(s.accumulator[0]) & bits40(s.accumulator[1]));
  set_half(s, register_of(o[0]), s.cc);
};
constexpr auto kParityShift = [](ExecutionState& s, const Operation&) {
  const std::uint64_t a = bits40(s.accumulator[0]);
  const int bit = s.cc ^ parity(a & bits40(s.accumulator[1]));
  s.accumulator[0] = accumulator_of(a << 1 | static_cast<std::uint64_t>(bit));
};

// Sign bits beyond the first, of the low `bits` bits.
int sign_bits(std::uint64_t value, int bits) {
  const std::uint64_t top = value << (64 - bits);
  const int count = (top >> 63) != 0 ? std::countl_one(top) : std::countl_zero(top);
  return std::min(count, bits) - 1;
}

constexpr auto kSignBits = [](ExecutionState& s, const Operation& o) {
  set_half(s, register_of(o[0]), static_cast<u16>(sign_bits(reg(s, o[1]), 32)));
};
constexpr auto kSignBitsOfHalf = [](ExecutionState& s, const Operation& o) {
  set_half(s, register_of(o[0]), static_cast<u16>(sign_bits(half(s, o[1]), 16)));
};
// As of a 32-bit number: a value in the guard bits counts below zero.
template <int accumulator>
constexpr auto kSignBitsOfAccumulator = [](ExecutionState& s, const Operation& o) {
  set_half(s, register_of(o[0]),
           static_cast<u16>(sign_bits(bits40(s.accumulator[accumulator]), 40) - 8));
};

// The smaller of a value's exponent and the one so far; what is kept is compared by its low bits.
constexpr auto kExponentOfWord = [](ExecutionState& s, const Operation& o) {
  const auto found = static_cast<u16>(sign_bits(reg(s, o[1]), 32));
  const u16 so_far = half(s, o[2]);
  set_half(s, register_of(o[0]), (found & 0x1f) < (so_far & 0x1f) ? found : so_far);
};
u16 smaller_exponent(u16 found, u16 so_far) {
  return (found & 0xf) < (so_far & 0xf) ? found : so_far;
}
constexpr auto kExponentOfHalf = [](ExecutionState& s, const Operation& o) {
  set_half(s, register_of(o[0]),
           smaller_exponent(static_cast<u16>(sign_bits(half(s, o[1]), 16)), half(s, o[2])));
};
constexpr auto kExponentOfHalves = [](ExecutionState& s, const Operation& o) {
  const u32 value = reg(s, o[1]);
  const u16 low = smaller_exponent(static_cast<u16>(sign_bits(value & 0xffff, 16)), half(s, o[2]));
  set_half(s, register_of(o[0]),
           smaller_exponent(static_cast<u16>(sign_bits(value >> 16, 16)), low));
};

// Add-compare-select: the larger of two halves, modulo 2^16, and a bit of A0 that tells which.
bool takes_high(u32 pair) { return (((pair >> 16) - pair) & 0x8000) == 0; }
u32 larger_half(u32 pair) { return takes_high(pair) ? pair >> 16 : pair & 0xffff; }
constexpr auto kViterbi = [](ExecutionState& s, const Operation& o) {
  const u32 pair = reg(s, o[1]);
  const std::uint64_t choice = takes_high(pair) ? 1 : 0;
  const std::uint64_t a = bits40(s.accumulator[0]);
  s.accumulator[0] = accumulator_of(
      o[2] == kToLeft ? a << 1 | choice : (a >> 1 & ~(std::uint64_t{1} << 31)) | choice << 31);
  set_half(s, o[0], static_cast<u16>(larger_half(pair)));
};
constexpr auto kViterbiPair = [](ExecutionState& s, const Operation& o) {
  const u32 first = reg(s, o[1]);
  const u32 second = reg(s, o[2]);
  const u32 one = takes_high(first) ? 1 : 0;
  const u32 two = takes_high(second) ? 1 : 0;
  const int64_t a = s.accumulator[0];
  s.accumulator[0] =
      o[3] == kToLeft
          ? accumulator_of(bits40(a) << 2 | (two << 1 | one))
          : accumulator_of(static_cast<std::uint64_t>(a >> 2) | (one << 31 | two << 30));
  reg(s, o[0]) = larger_half(first) << 16 | larger_half(second);
};

constexpr const char* kLeft = "left when the amount is positive";
constexpr const char* kRing = "through CC, left when the amount is positive";

// The amount is a signed number of five bits in the shifter: more than 16 to the right is a shift
// to the left by the rest to 32, and 16 or more to the left one to the right.
void right_to_left(const OperandNumbers& operand, Operation& operation) {
  operation.operand[2] = operand[2] > 16 ? operand[2] - 32 : operand[2];
}
void left_to_right(const OperandNumbers& operand, Operation& operation) {
  operation.operand[2] = operand[2] >= 16 ? operand[2] - 32 : operand[2];
}
template <Prepare fold>
constexpr Instruction folded(Instruction form) {
  form.prepare = fold;
  return form;
}

constexpr Instruction rotate_form(Instruction form, std::uint32_t accumulator = kNothing) {
  return with_implicit(form, kReadsCc | kWritesCc | accumulator);
}

constexpr Instruction kTable[] = {
    // shifts of words
    dsp_form("{D!} = {D} << {uimm5}", plain<kShiftWord<Amount::left, false, Lost::flagged>>),
    dsp_form("{D!} = {D} >> {uimm5}", plain<kShiftRight<false>>),
    also(dsp_form("{D!} = {D} >>> {uimm5}", plain<kShiftRight<true>>),
         "{D!} = {D} >>> {uimm5} (S)"),
    dsp_form("{D!} = {D} << {uimm5} (S)", plain<kShiftWord<Amount::left, true, Lost::saturate>>),
    also(early_dsp_form("{D!} = LSHIFT {D} BY {Dl}",
                        plain<kShiftWord<Amount::in_register, false, Lost::or_sign>>, kLeft),
         "{D!} = SHIFT {D} BY {Dl}"),
    early_dsp_form("{D!} = ASHIFT {D} BY {Dl}",
                   plain<kShiftWord<Amount::in_register, true, Lost::or_sign>>, kLeft),
    early_dsp_form("{D!} = ASHIFT {D} BY {Dl} (S)",
                   plain<kShiftWord<Amount::in_register, true, Lost::saturate>>, kLeft),

    // shifts of both halves
    dsp_form("{D!} = {D} << {uimm4} (V)", plain<kShiftHalves<Amount::left, false, Lost::flagged>>),
    dsp_form("{D!} = {D} >> {uimm4} (V)", plain<kShiftHalves<Amount::right, false, Lost::ignored>>),
    folded<right_to_left>(dsp_form("{D!} = {D} >>> {uimm5} (V)",
                                   plain<kShiftHalves<Amount::right, true, Lost::or_sign>>)),
    folded<left_to_right>(dsp_form("{D!} = {D} << {uimm5} (V, S)",
                                   plain<kShiftHalves<Amount::left, true, Lost::saturate>>)),
    folded<right_to_left>(dsp_form("{D!} = {D} >>> {uimm5} (V, S)",
                                   plain<kShiftHalves<Amount::right, true, Lost::or_sign>>)),
    early_dsp_form("{D!} = LSHIFT {D} BY {Dl} (V)",
                   plain<kShiftHalves<Amount::in_register, false, Lost::ignored>>, kLeft),
    early_dsp_form("{D!} = ASHIFT {D} BY {Dl} (V)",
                   plain<kShiftHalves<Amount::in_register, true, Lost::or_sign>>, kLeft),
    early_dsp_form("{D!} = ASHIFT {D} BY {Dl} (V, S)",
                   plain<kShiftHalves<Amount::in_register, true, Lost::saturate>>, kLeft),

    // shifts of one half
    dsp_form("{Dx!} = {Dx} << {uimm4}", plain<kShiftHalf<Amount::left, false, Lost::flagged>>),
    dsp_form("{Dx!} = {Dx} >> {uimm4}", plain<kShiftHalf<Amount::right, false, Lost::ignored>>),
    folded<right_to_left>(dsp_form("{Dx!} = {Dx} >>> {uimm5}",
                                   plain<kShiftHalf<Amount::right, true, Lost::or_sign>>)),
    dsp_form("{Dx!} = {Dx} << {uimm4} (S)", plain<kShiftHalf<Amount::left, true, Lost::saturate>>),
    folded<right_to_left>(dsp_form("{Dx!} = {Dx} >>> {uimm5} (S)",
                                   plain<kShiftHalf<Amount::right, true, Lost::saturate>>)),
    early_dsp_form("{Dx!} = LSHIFT {Dx} BY {Dl}",
                   plain<kShiftHalf<Amount::in_register, false, Lost::ignored>>, kLeft),
    early_dsp_form("{Dx!} = ASHIFT {Dx} BY {Dl}",
                   plain<kShiftHalf<Amount::in_register, true, Lost::or_sign>>, kLeft),
    early_dsp_form("{Dx!} = ASHIFT {Dx} BY {Dl} (S)",
                   plain<kShiftHalf<Amount::in_register, true, Lost::saturate>>, kLeft),

    // bits
    early_dsp_form("{D!} = EXTRACT({D}, {Dl}) {?(Z)}", plain<kExtract<false>>,
                   "field: length in bits 0-4, position in 8-12"),
    early_dsp_form("{D!} = EXTRACT({D}, {Dl}) (X)", plain<kExtract<true>>,
                   "field: length in bits 0-4, position in 8-12"),
    early_dsp_form("{Dl!} = ONES {D}", plain<kOnes>, "population count"),
    early_dsp_form("{Dl!} = SIGNBITS {D}", plain<kSignBits>, "redundant sign bits"),
    early_dsp_form("{Dl!} = SIGNBITS {Dx}", plain<kSignBitsOfHalf>, "redundant sign bits"),
    with_implicit(early_dsp_form("{Dl!} = SIGNBITS A0", plain<kSignBitsOfAccumulator<0>>,
                                 "as of 32 bits: -8 to 31"),
                  kReadsA0),
    with_implicit(early_dsp_form("{Dl!} = SIGNBITS A1", plain<kSignBitsOfAccumulator<1>>,
                                 "as of 32 bits: -8 to 31"),
                  kReadsA1),
    early_dsp_form("{Dl!} = EXPADJ({D}, {Dl})", plain<kExponentOfWord>,
                   "the smaller of the sign bits and the exponent so far"),
    early_dsp_form("{Dl!} = EXPADJ({Dx}, {Dl})", plain<kExponentOfHalf>,
                   "the smaller of the sign bits and the exponent so far"),
    early_dsp_form("{Dl!} = EXPADJ({D}, {Dl}) (V)", plain<kExponentOfHalves>,
                   "the smallest of both halves' sign bits and the exponent so far"),
    early_dsp_form("{D!} = DEPOSIT({D}, {D})", plain<kDeposit<false>>,
                   "second operand: field in bits 16-31, position in 8-12, length in 0-4"),
    early_dsp_form("{D!} = DEPOSIT({D}, {D}) (X)", plain<kDeposit<true>>,
                   "the same, the field's sign extended to the left"),
    with_implicit(early_dsp_form("BITMUX({D+}, {D+}, A0) (ASR)", plain<kBitMultiplexDown>,
                                 "the low bit of each into A0 from its top"),
                  kReadsA0 | kWritesA0),
    with_implicit(early_dsp_form("BITMUX({D+}, {D+}, A0) (ASL)", plain<kBitMultiplexUp>,
                                 "the high bit of each into A0 from its bottom"),
                  kReadsA0 | kWritesA0),
    with_implicit(early_dsp_form("{Dl!} = CC = BXORSHIFT(A0, {D})", plain<kParityOfRegister<true>>,
                                 "A0 <<= 1, then the parity of A0 & D"),
                  kReadsA0 | kWritesA0 | kWritesCc),
    with_implicit(early_dsp_form("{Dl!} = CC = BXOR(A0, {D})", plain<kParityOfRegister<false>>,
                                 "the parity of A0 & D"),
                  kReadsA0 | kWritesCc),
    with_implicit(early_dsp_form("{Dl!} = CC = BXOR(A0, A1, CC)", plain<kParityOfAccumulator>,
                                 "CC ^ the parity of A0 & A1"),
                  kReadsA0 | kReadsA1 | kReadsCc | kWritesCc),
    with_implicit(early_dsp_form("A0 = BXORSHIFT(A0, A1, CC)", plain<kParityShift>,
                                 "A0 << 1, and below CC ^ the parity of A0 & A1"),
                  kReadsA0 | kWritesA0 | kReadsA1 | kReadsCc),

    with_implicit(early_dsp_form("{Dl!} = VIT_MAX({D}){side}", plain<kViterbi>,
                                 "the larger half; a bit of A0 tells which"),
                  kReadsA0 | kWritesA0),
    with_implicit(early_dsp_form("{D!} = VIT_MAX({D}, {D}){side}", plain<kViterbiPair>,
                                 "the larger half of each; two bits of A0 tell which"),
                  kReadsA0 | kWritesA0),

    // rotation through CC
    rotate_form(dsp_form("{D!} = ROT {D} BY {imm6}", plain<kRotate<false>>, kRing)),
    rotate_form(early_dsp_form("{D!} = ROT {D} BY {Dl}", plain<kRotate<true>>, kRing)),
    rotate_form(dsp_form("A0 = ROT A0 BY {imm6}", plain<kRotateAccumulator<0, false>>, kRing),
                kReadsA0 | kWritesA0),
    rotate_form(early_dsp_form("A0 = ROT A0 BY {Dl}", plain<kRotateAccumulator<0, true>>, kRing),
                kReadsA0 | kWritesA0),
    rotate_form(dsp_form("A1 = ROT A1 BY {imm6}", plain<kRotateAccumulator<1, false>>, kRing),
                kReadsA1 | kWritesA1),
    rotate_form(early_dsp_form("A1 = ROT A1 BY {Dl}", plain<kRotateAccumulator<1, true>>, kRing),
                kReadsA1 | kWritesA1),
};

}  // namespace

std::span<const Instruction> shift_instructions() { return kTable; }

}  // namespace finback::isa
