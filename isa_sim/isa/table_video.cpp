// Quad 8-bit operations for video (Programming Reference chapter 18). Slot 0 of a packet; each lets
// the packet's loads through index registers take any address, whose low bits in I0 and I1 then
// choose four bytes out of a register pair.
#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/dsp_form.hpp>
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using s16 = std::int16_t;
using u8 = std::uint8_t;
using u32 = std::uint32_t;
using std::int32_t;

// Four bytes of the pair that begins at register `pair`, from the byte that `index` (I0 or I1)
// points to; `reversed` takes the upper register for the lower.
u32 pick_bytes(ExecutionState& s, int32_t pair, Register index, bool reversed) {
  const std::uint64_t low = reg(s, pair + (reversed ? 1 : 0));
  const std::uint64_t high = reg(s, pair + (reversed ? 0 : 1));
  return static_cast<u32>((high << 32 | low) >> (8 * (s.reg[index] & 3)));
}
constexpr u32 byte_of(u32 word, int number) { return word >> (8 * number) & 0xff; }

// `pair` and `mode`: indices of the operands.
struct Sources {
  u32 first = 0;
  u32 second = 0;
};
Sources sources(ExecutionState& s, const Operation& o, int pair, int mode,
                Register second_index = I1) {
  const bool reversed = (o[mode] & kReverse) != 0;
  return {pick_bytes(s, o[pair], I0, reversed), pick_bytes(s, o[pair + 1], second_index, reversed)};
}

constexpr auto kAverage = [](ExecutionState& s, const Operation& o) {
  const Sources bytes = sources(s, o, 1, 3);
  const u32 a = bytes.first;
  const u32 b = bytes.second;
  const u32 rounding = (o[3] & kTruncate) != 0 ? 0 : 1;
  u32 result = 0;
  for (int i = 0; i < 4; ++i) {
    result |= (byte_of(a, i) + byte_of(b, i) + rounding) >> 1 << (8 * i);
  }
  reg(s, o[0]) = result;
};

constexpr auto kAverageOfFour = [](ExecutionState& s, const Operation& o) {
  const Sources bytes = sources(s, o, 1, 3, I0);
  const u32 a = bytes.first;
  const u32 b = bytes.second;
  const u32 rounding = (o[3] & kTruncate) != 0 ? 0 : 2;
  const int shift = (o[3] & kHigh) != 0 ? 8 : 0;
  const auto average = [&](int first) {
    return (byte_of(a, first) + byte_of(a, first + 1) + byte_of(b, first) + byte_of(b, first + 1) +
            rounding) >>
           2;
  };
  reg(s, o[0]) = (average(2) << 16 | average(0)) << shift;
};

// Signed halves of the first pair plus bytes of the second, clipped to 0..255.
constexpr auto kAddClipped = [](ExecutionState& s, const Operation& o) {
  const Sources bytes = sources(s, o, 1, 3);
  const u32 a = bytes.first;
  const u32 b = bytes.second;
  const bool high = (o[3] & kHigh) != 0;
  const auto sum = [&](int lane) {
    const int32_t value = s16(a >> (16 * lane));
    return static_cast<u32>(
        std::clamp(value + static_cast<int32_t>(byte_of(b, 2 * lane + (high ? 0 : 1))), 0, 255));
  };
  reg(s, o[0]) = (sum(1) << 16 | sum(0)) << (high ? 8 : 0);
};

// Bytes to sums or differences in halves: operand 0 takes the upper two, operand 1 the lower.
template <bool subtract>
constexpr auto kBytesToHalves = [](ExecutionState& s, const Operation& o) {
  const Sources bytes = sources(s, o, 2, 4);
  const u32 a = bytes.first;
  const u32 b = bytes.second;
  const auto lane = [&](int i) {
    const u32 value = subtract ? byte_of(a, i) - byte_of(b, i) : byte_of(a, i) + byte_of(b, i);
    return value & 0xffff;
  };
  reg(s, o[0]) = lane(3) << 16 | lane(2);
  reg(s, o[1]) = lane(1) << 16 | lane(0);
};

constexpr auto kPackBytes = [](ExecutionState& s, const Operation& o) {
  const u32 a = reg(s, o[1]);
  const u32 b = reg(s, o[2]);
  reg(s, o[0]) = byte_of(a, 0) | byte_of(a, 2) << 8 | byte_of(b, 0) << 16 | byte_of(b, 2) << 24;
};
constexpr auto kUnpackBytes = [](ExecutionState& s, const Operation& o) {
  const u32 a = pick_bytes(s, o[2], I0, (o[3] & kReverse) != 0);
  reg(s, o[0]) = byte_of(a, 3) << 16 | byte_of(a, 2);
  reg(s, o[1]) = byte_of(a, 1) << 16 | byte_of(a, 0);
};

// Absolute differences of four bytes, added to the four halves of A1 and A0, saturated to 16 bits.
constexpr auto kSumAbsolute = [](ExecutionState& s, const Operation& o) {
  const Sources bytes = sources(s, o, 0, 2);
  const u32 a = bytes.first;
  const u32 b = bytes.second;
  const auto lane = [&](int i) {
    const auto difference =
        static_cast<int32_t>(byte_of(a, i)) - static_cast<int32_t>(byte_of(b, i));
    const auto so_far = static_cast<u32>(s.accumulator[i / 2] >> (16 * (i % 2)) & 0xffff);
    return std::min(so_far + static_cast<u32>(difference < 0 ? -difference : difference), 0xffffU);
  };
  const u32 low = lane(1) << 16 | lane(0);
  const u32 high = lane(3) << 16 | lane(2);
  s.accumulator = {low, high};
};

constexpr Instruction video_form(std::string_view syntax, Execute execute,
                                 std::string_view meaning) {
  Instruction form = early_dsp_form(syntax, execute, meaning);
  form.aligns = true;
  return form;
}
constexpr Instruction kTable[] = {
    video_form("DISALGNEXCPT", plain<[](ExecutionState&, const Operation&) {}>,
               "loads of this packet through I registers ignore the two low address bits"),
    video_form("{D!} = BYTEOP1P({DD}, {DD}){avg}", plain<kAverage>, "averages of four bytes"),
    video_form("{D!} = BYTEOP2P({DD}, {DD}){rnd}", plain<kAverageOfFour>,
               "two averages of two by two bytes"),
    video_form("{D!} = BYTEOP3P({DD}, {DD}){lohi}", plain<kAddClipped>,
               "two halves plus two bytes, clipped to bytes"),
    two_results<0, 1>(video_form("({D!}, {D!}) = BYTEOP16P({DD}, {DD}){r}",
                                 plain<kBytesToHalves<false>>, "four sums of bytes")),
    two_results<0, 1>(video_form("({D!}, {D!}) = BYTEOP16M({DD}, {DD}){r}",
                                 plain<kBytesToHalves<true>>, "four differences of bytes")),
    video_form("{D!} = BYTEPACK({D}, {D})", plain<kPackBytes>, "the low bytes of four halves"),
    two_results<0, 1>(video_form("({D!}, {D!}) = BYTEUNPACK {DD}{r}", plain<kUnpackBytes>,
                                 "four bytes into four halves")),
    with_implicit(video_form("SAA({DD}, {DD}){r}", plain<kSumAbsolute>,
                             "absolute differences of four bytes, added to four halves"),
                  kReadsA0 | kWritesA0 | kReadsA1 | kWritesA1),
};

}  // namespace

std::span<const Instruction> video_instructions() { return kTable; }

}  // namespace finback::isa
