// The arithmetic of one multiply-accumulate unit: product, accumulation, extraction of a result.
//
// Models every operand and result format of the two 16 x 16 units with their 40-bit accumulators,
// saturation, and rounding as the RND_MOD bit asks (unbiased unless it is set). Source: Programming
// Reference, "Multiplier Data Types" and "Rounding and Saturation"; the corners (-1 x -1, W32, IU
// with M) as the GNU simulator has them, which was held against the chip.
#pragma once

#include <algorithm>
#include <cstdint>

#include <isa_sim/isa/choice.hpp>

namespace finback::isa {

// A multiply mode with or without M.
struct MultiplyOption {
  MultiplyMode mode = MultiplyMode::fraction;
  bool mixed = false;
};
[[nodiscard]] constexpr MultiplyOption multiply_option(std::int32_t value) {
  return {static_cast<MultiplyMode>(value & 0xf), (value & kMixed) != 0};
}
// The accumulator and the product count as signed.
[[nodiscard]] constexpr bool is_signed(MultiplyOption option) {
  return option.mixed || (option.mode != MultiplyMode::fu && option.mode != MultiplyMode::iu &&
                          option.mode != MultiplyMode::tfu);
}

constexpr std::int64_t kMaximum40 = (std::int64_t{1} << 39) - 1;
constexpr std::int64_t kMaximum32 = (std::int64_t{1} << 31) - 1;

// An accumulator's 40 bits without a sign, and back.
constexpr std::uint64_t kAllBits40 = (std::uint64_t{1} << 40) - 1;
[[nodiscard]] constexpr std::uint64_t bits40(std::int64_t accumulator) {
  return static_cast<std::uint64_t>(accumulator) & kAllBits40;
}
[[nodiscard]] constexpr std::int64_t accumulator_of(std::uint64_t bits) {
  return static_cast<std::int64_t>(bits << 24) >> 24;
}

struct Product {
  std::int64_t value = 0;
  bool saturated = false;  // -1 x -1 of fractions
};
[[nodiscard]] constexpr Product multiply(std::uint16_t a, std::uint16_t b, MultiplyOption option) {
  if (option.mixed) {
    return {std::int64_t{static_cast<std::int16_t>(a)} * b, false};
  }
  if (!is_signed(option)) {
    return {std::int64_t{a} * b, false};
  }
  const std::int64_t exact =
      std::int64_t{static_cast<std::int16_t>(a)} * static_cast<std::int16_t>(b);
  switch (option.mode) {
    case MultiplyMode::fraction:
    case MultiplyMode::t:
    case MultiplyMode::s2rnd:
      return {exact * 2, exact == 0x40000000};
    case MultiplyMode::w32:
      return exact == 0x40000000 ? Product{kMaximum32, true} : Product{exact * 2, false};
    default:
      return {exact, false};
  }
}

// What the accumulator takes of `exact`, its signed 40 bits; `saturated` tells that it is another
// number.
struct Accumulated {
  std::int64_t value = 0;
  bool saturated = false;
};
[[nodiscard]] constexpr Accumulated accumulate(std::int64_t exact, MultiplyOption option) {
  std::int64_t low = -kMaximum40 - 1;
  std::int64_t high = kMaximum40;
  switch (option.mode) {
    case MultiplyMode::ih:
    case MultiplyMode::w32:
      low = -kMaximum32 - 1;
      high = kMaximum32;
      break;
    case MultiplyMode::iu:
      if (option.mixed) {
        return {accumulator_of(static_cast<std::uint64_t>(exact)), false};
      }
      [[fallthrough]];
    case MultiplyMode::fu:
    case MultiplyMode::tfu:
      if (!option.mixed) {
        low = 0;
        high = static_cast<std::int64_t>(kAllBits40);
      }
      break;
    default:
      break;
  }
  const std::int64_t clipped = std::clamp(exact, low, high);
  return {accumulator_of(static_cast<std::uint64_t>(clipped)), clipped != exact};
}

// value / 65536, to nearest; a half goes to even, or up when `biased` (RND_MOD).
[[nodiscard]] constexpr std::int64_t round_half_word(std::int64_t value, bool biased) {
  const bool down = !biased && (value & 0x1ffff) == 0x8000;
  return (value + (down ? 0 : 0x8000)) >> 16;
}

// The 16 or 32 bits that a data register takes of a product or an accumulator.
struct Extracted {
  std::uint32_t value = 0;
  bool overflow = false;
};
[[nodiscard]] constexpr Extracted clip(std::int64_t value, bool as_signed, int bits) {
  const std::int64_t high = (std::int64_t{1} << (as_signed ? bits - 1 : bits)) - 1;
  const std::int64_t clipped = std::clamp(value, as_signed ? -high - 1 : 0, high);
  return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(clipped) &
                                     ((std::uint64_t{1} << bits) - 1)),
          clipped != value};
}
[[nodiscard]] constexpr Extracted extract_word(std::int64_t value, MultiplyOption option) {
  const bool twice = option.mode == MultiplyMode::s2rnd || option.mode == MultiplyMode::iss2;
  return clip(twice ? value * 2 : value, is_signed(option), 32);
}
[[nodiscard]] constexpr Extracted extract_half(std::int64_t value, MultiplyOption option,
                                               bool biased) {
  switch (option.mode) {
    case MultiplyMode::is:
    case MultiplyMode::iu:
      break;
    case MultiplyMode::iss2:
      value *= 2;
      break;
    case MultiplyMode::t:
    case MultiplyMode::tfu:
      value >>= 16;
      break;
    case MultiplyMode::s2rnd:
      value = round_half_word(value * 2, biased);
      break;
    default:
      value = round_half_word(value, biased);
  }
  return clip(value, is_signed(option), 16);
}

}  // namespace finback::isa
