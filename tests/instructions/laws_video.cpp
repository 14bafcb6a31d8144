// Quad byte operations.
#include <algorithm>
#include <array>

#include "laws.hpp"
#include <isa_sim/isa/choice.hpp>

namespace finback::isa::laws {

namespace {

// The four bytes, lowest first, that an index register picks out of the eight of a register pair.
std::array<Exact, 4> picked(const Trial& t, int pair_operand, Register index, bool reversed) {
  const auto first = static_cast<std::size_t>(t.number(pair_operand));
  std::array<Exact, 8> eight{};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t upper = i / 4 ^ (reversed ? 1U : 0U);
    eight[i] = t.before.reg[first + upper] >> (8 * (i % 4)) & 0xff;
  }
  std::array<Exact, 4> four{};
  std::copy_n(eight.begin() + (t.before.reg[index] & 3), 4, four.begin());
  return four;
}
Exact joined(std::array<Exact, 4> bytes) {
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24;
}
Exact two(Exact high, Exact low) { return (high & 0xffff) << 16 | (low & 0xffff); }

template <int sign>
void bytes_to_halves(Trial& t) {
  const bool reversed = t.number(4) != 0;
  const auto a = picked(t, 2, I0, reversed);
  const auto b = picked(t, 3, I1, reversed);
  const auto lane = [&](std::size_t i) { return a[i] + sign * b[i]; };
  t.set(0, two(lane(3), lane(2)));
  t.set(1, two(lane(1), lane(0)));
}

constexpr Law kLaws[] = {
    {"DISALGNEXCPT", [](Trial&) {}},
    {"{D!} = BYTEOP1P({DD}, {DD}){avg}",
     [](Trial& t) {
       const bool reversed = (t.number(3) & kReverse) != 0;
       const auto a = picked(t, 1, I0, reversed);
       const auto b = picked(t, 2, I1, reversed);
       std::array<Exact, 4> result{};
       for (std::size_t i = 0; i < 4; ++i) {
         const Exact sum = a[i] + b[i];
         result[i] = (t.number(3) & kTruncate) != 0 ? sum / 2 : (sum + 1) / 2;
       }
       t.set(0, joined(result));
     }},
    {"{D!} = BYTEOP2P({DD}, {DD}){rnd}",
     [](Trial& t) {
       const bool reversed = (t.number(3) & kReverse) != 0;
       const auto a = picked(t, 1, I0, reversed);
       const auto b = picked(t, 2, I0, reversed);
       const Exact half = (t.number(3) & kTruncate) != 0 ? 0 : 2;
       const Exact low = (a[0] + a[1] + b[0] + b[1] + half) / 4;
       const Exact high = (a[2] + a[3] + b[2] + b[3] + half) / 4;
       const Exact scale = (t.number(3) & kHigh) != 0 ? 256 : 1;
       t.set(0, two(high * scale, low * scale));
     }},
    {"{D!} = BYTEOP3P({DD}, {DD}){lohi}",
     [](Trial& t) {
       const bool reversed = (t.number(3) & kReverse) != 0;
       const bool high = (t.number(3) & kHigh) != 0;
       const auto a = picked(t, 1, I0, reversed);
       const auto b = picked(t, 2, I1, reversed);
       const std::size_t odd = high ? 0 : 1;
       const auto sum = [&](std::size_t lane) {
         const Exact value = wrap(a[2 * lane] + 256 * a[2 * lane + 1], 16) + b[2 * lane + odd];
         return std::clamp<Exact>(value, 0, 255) * (high ? 256 : 1);
       };
       t.set(0, two(sum(1), sum(0)));
     }},
    {"({D!}, {D!}) = BYTEOP16P({DD}, {DD}){r}", bytes_to_halves<1>},
    {"({D!}, {D!}) = BYTEOP16M({DD}, {DD}){r}", bytes_to_halves<-1>},
    {"{D!} = BYTEPACK({D}, {D})",
     [](Trial& t) {
       t.set(0, joined({t.low(1) & 0xff, t.high(1) & 0xff, t.low(2) & 0xff, t.high(2) & 0xff}));
     }},
    {"({D!}, {D!}) = BYTEUNPACK {DD}{r}",
     [](Trial& t) {
       const auto a = picked(t, 2, I0, t.number(3) != 0);
       t.set(0, two(a[3], a[2]));
       t.set(1, two(a[1], a[0]));
     }},
    {"SAA({DD}, {DD}){r}",
     [](Trial& t) {
       const auto a = picked(t, 0, I0, t.number(2) != 0);
       const auto b = picked(t, 1, I1, t.number(2) != 0);
       const auto lane = [&](std::size_t i) {
         const Exact so_far = t.before.accumulator[i / 2] >> (16 * (i % 2)) & 0xffff;
         return std::min<Exact>(so_far + std::abs(a[i] - b[i]), 0xffff);
       };
       t.after.accumulator[0] = two(lane(1), lane(0));
       t.after.accumulator[1] = two(lane(3), lane(2));
     }},
};

}  // namespace

std::span<const Law> video_laws() { return kLaws; }

}  // namespace finback::isa::laws
