// 32-bit DSP instructions, slot 0 of a packet: ALU, multiplier, bytes (Programming Reference
// chapters 13 to 19). The shifter: table_shifts.cpp.
#include <isa_sim/isa/dsp_form.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u16 = std::uint16_t;
using u32 = std::uint32_t;
using std::int32_t;
using std::int64_t;

constexpr Instruction multiply_form(std::string_view syntax, std::uint32_t implicit,
                                    Execute execute) {
  return {.syntax = syntax,
          .length = 4,
          .slot = Slot::dsp,
          .needs = Needs::ex1,
          .energy = Energy::mac,
          .implicit = implicit,
          .execute = execute};
}

template <bool subtract, bool saturate>
constexpr auto kAdd = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  reg(s, o[0]) = subtract ? subtract32(s, a, b, saturate) : add32(s, a, b, saturate);
};
template <bool subtract, bool saturate>
constexpr auto kAddHalf = [](ExecutionState& s, const Operation& o) {
  set_half(s, o[0], add_half(s, half(s, o[1]), half(s, o[2]), subtract, saturate));
};
template <bool subtract_high, bool subtract_low, bool saturate>
constexpr auto kAddLanes = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = add_lanes(s, reg(s, o[1]), reg(s, o[2]), subtract_high, subtract_low, saturate);
};

template <bool maximum>
constexpr auto kExtreme = [](ExecutionState& s, const Operation& o) {
  const int32_t a = signed_reg(s, o[1]);
  const int32_t b = signed_reg(s, o[2]);
  const auto result = static_cast<u32>(maximum ? std::max(a, b) : std::min(a, b));
  reg(s, o[0]) = result;
  set_az_an(s, result);
  s.v = 0;
};
// Lane by lane, for 16-bit lanes: result lane = pick(a, b).
template <auto pick>
u32 lanes(u32 a, u32 b) {
  const auto lane = [&](int shift) {
    return static_cast<u32>(static_cast<u16>(
        pick(static_cast<std::int16_t>(a >> shift), static_cast<std::int16_t>(b >> shift))));
  };
  return lane(16) << 16 | lane(0);
}
template <auto pick>
constexpr auto kExtremeLanes = [](ExecutionState& s, const Operation& o) {
  const u32 result = lanes<pick>(reg(s, o[1]), reg(s, o[2]));
  reg(s, o[0]) = result;
  s.az = (result & 0xffff) == 0 || result >> 16 == 0;
  s.an = (result & 0x80008000) != 0;
  s.v = 0;
};
constexpr auto kMax16 = [](std::int16_t a, std::int16_t b) { return std::max(a, b); };
constexpr auto kMin16 = [](std::int16_t a, std::int16_t b) { return std::min(a, b); };

constexpr auto kAbs = [](ExecutionState& s, const Operation& o) {
  const u32 value = reg(s, o[1]);
  const bool overflow = value == 0x80000000;
  const u32 result = overflow ? 0x7fffffff : (value >> 31) != 0 ? 0 - value : value;
  reg(s, o[0]) = result;
  set_az_an(s, result);
  set_overflow(s, overflow);
};

constexpr auto kPack = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = u32{half(s, o[1])} << 16 | half(s, o[2]);
};
template <int bytes>
constexpr auto kAlign = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = reg(s, o[1]) << (32 - 8 * bytes) | reg(s, o[2]) >> (8 * bytes);
};

template <MultiplyMode mode>
constexpr auto kMultiply = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = static_cast<u32>(multiply_halves(half(s, o[1]), half(s, o[2]), mode));
};
enum class Accumulate : std::uint8_t { set, add, subtract };
template <int accumulator, Accumulate how, MultiplyMode mode>
constexpr auto kMac = [](ExecutionState& s, const Operation& o) {
  const int64_t product = multiply_halves(half(s, o[0]), half(s, o[1]), mode);
  int64_t& a = s.accumulator[accumulator];
  const int64_t exact = how == Accumulate::set   ? product
                        : how == Accumulate::add ? a + product
                                                 : a - product;
  a = saturate40(exact);
  std::uint8_t& overflow = accumulator == 0 ? s.av0 : s.av1;
  overflow = a != exact;
  (accumulator == 0 ? s.av0s : s.av1s) |= overflow;
};

using M = MultiplyMode;
constexpr auto kFraction = M::signed_fraction;
constexpr auto kInteger = M::signed_integer;
constexpr auto kUnsigned = M::unsigned_fraction;

constexpr std::uint32_t uses(int accumulator) {
  return accumulator == 0 ? kReadsA0 | kWritesA0 : kReadsA1 | kWritesA1;
}
constexpr std::uint32_t sets(int accumulator) { return accumulator == 0 ? kWritesA0 : kWritesA1; }

constexpr Instruction kTable[] = {
    // 32-bit and 16-bit addition
    dsp_form("{D!} = {D} + {D} (NS)", plain<kAdd<false, false>>),
    dsp_form("{D!} = {D} - {D} (NS)", plain<kAdd<true, false>>),
    dsp_form("{D!} = {D} + {D} (S)", plain<kAdd<false, true>>),
    dsp_form("{D!} = {D} - {D} (S)", plain<kAdd<true, true>>),
    dsp_form("{Dx!} = {Dx} + {Dx} (NS)", plain<kAddHalf<false, false>>),
    dsp_form("{Dx!} = {Dx} - {Dx} (NS)", plain<kAddHalf<true, false>>),
    dsp_form("{Dx!} = {Dx} + {Dx} (S)", plain<kAddHalf<false, true>>),
    dsp_form("{Dx!} = {Dx} - {Dx} (S)", plain<kAddHalf<true, true>>),
    dsp_form("{D!} = {D} +|+ {D}", plain<kAddLanes<false, false, false>>),
    dsp_form("{D!} = {D} +|- {D}", plain<kAddLanes<false, true, false>>),
    dsp_form("{D!} = {D} -|+ {D}", plain<kAddLanes<true, false, false>>),
    dsp_form("{D!} = {D} -|- {D}", plain<kAddLanes<true, true, false>>),
    dsp_form("{D!} = {D} +|+ {D} (S)", plain<kAddLanes<false, false, true>>),
    dsp_form("{D!} = {D} -|- {D} (S)", plain<kAddLanes<true, true, true>>),
    dsp_form("{D!} = MAX({D}, {D})", plain<kExtreme<true>>),
    dsp_form("{D!} = MIN({D}, {D})", plain<kExtreme<false>>),
    dsp_form("{D!} = MAX({D}, {D}) (V)", plain<kExtremeLanes<kMax16>>),
    dsp_form("{D!} = MIN({D}, {D}) (V)", plain<kExtremeLanes<kMin16>>),
    dsp_form("{D!} = ABS {D}", plain<kAbs>, "the most negative value becomes the most positive"),

    // bytes and halves
    dsp_form("{D!} = PACK({Dx}, {Dx})", plain<kPack>),
    early_dsp_form("{D!} = ALIGN8({D}, {D})", plain<kAlign<1>>),
    early_dsp_form("{D!} = ALIGN16({D}, {D})", plain<kAlign<2>>),
    early_dsp_form("{D!} = ALIGN24({D}, {D})", plain<kAlign<3>>),

    // 16 x 16 multiply and multiply-accumulate
    multiply_form("{D!} = {Dx} * {Dx}", kNothing, plain<kMultiply<kFraction>>),
    multiply_form("{D!} = {Dx} * {Dx} (IS)", kNothing, plain<kMultiply<kInteger>>),
    multiply_form("{D!} = {Dx} * {Dx} (FU)", kNothing, plain<kMultiply<kUnsigned>>),
    multiply_form("A0 = {Dx} * {Dx} (IS)", sets(0), plain<kMac<0, Accumulate::set, kInteger>>),
    multiply_form("A0 += {Dx} * {Dx} (IS)", uses(0), plain<kMac<0, Accumulate::add, kInteger>>),
    multiply_form("A0 -= {Dx} * {Dx} (IS)", uses(0),
                  plain<kMac<0, Accumulate::subtract, kInteger>>),
    multiply_form("A0 = {Dx} * {Dx} (FU)", sets(0), plain<kMac<0, Accumulate::set, kUnsigned>>),
    multiply_form("A0 += {Dx} * {Dx} (FU)", uses(0), plain<kMac<0, Accumulate::add, kUnsigned>>),
    multiply_form("A0 = {Dx} * {Dx}", sets(0), plain<kMac<0, Accumulate::set, kFraction>>),
    multiply_form("A0 += {Dx} * {Dx}", uses(0), plain<kMac<0, Accumulate::add, kFraction>>),
    multiply_form("A0 -= {Dx} * {Dx}", uses(0), plain<kMac<0, Accumulate::subtract, kFraction>>),
    multiply_form("A1 = {Dx} * {Dx} (IS)", sets(1), plain<kMac<1, Accumulate::set, kInteger>>),
    multiply_form("A1 += {Dx} * {Dx} (IS)", uses(1), plain<kMac<1, Accumulate::add, kInteger>>),
    multiply_form("A1 -= {Dx} * {Dx} (IS)", uses(1),
                  plain<kMac<1, Accumulate::subtract, kInteger>>),
    multiply_form("A1 = {Dx} * {Dx}", sets(1), plain<kMac<1, Accumulate::set, kFraction>>),
    multiply_form("A1 += {Dx} * {Dx}", uses(1), plain<kMac<1, Accumulate::add, kFraction>>),
    {.syntax = "A0 = 0",
     .length = 4,
     .slot = Slot::dsp,
     .implicit = kWritesA0,
     .execute = plain<[](ExecutionState& s, const Operation&) { s.accumulator[0] = 0; }>},
    {.syntax = "A1 = 0",
     .length = 4,
     .slot = Slot::dsp,
     .implicit = kWritesA1,
     .execute = plain<[](ExecutionState& s, const Operation&) { s.accumulator[1] = 0; }>},
    {.syntax = "A1 = A0 = 0",
     .length = 4,
     .slot = Slot::dsp,
     .implicit = kWritesA0 | kWritesA1,
     .execute = plain<[](ExecutionState& s, const Operation&) {
       s.accumulator = {0, 0};
     }>},
    {.syntax = "{D!} = A0",
     .length = 4,
     .slot = Slot::dsp,
     .implicit = kReadsA0,
     .execute = plain<[](ExecutionState& s, const Operation& o) {
       reg(s, o[0]) = saturate32(s, s.accumulator[0]);
     }>,
     .meaning = "saturated to 32 bits"},
    {.syntax = "{D!} = A1",
     .length = 4,
     .slot = Slot::dsp,
     .implicit = kReadsA1,
     .execute = plain<[](ExecutionState& s, const Operation& o) {
       reg(s, o[0]) = saturate32(s, s.accumulator[1]);
     }>,
     .meaning = "saturated to 32 bits"},

    {.syntax = "MNOP",
     .length = 4,
     .slot = Slot::dsp,
     .energy = Energy::nop,
     .execute = plain<[](ExecutionState&, const Operation&) {}>,
     .meaning = "holds slot 0 of a packet"},
};

}  // namespace

std::span<const Instruction> dsp_instructions() { return kTable; }

}  // namespace finback::isa
