// The options of instructions, such as the (IS) of a multiply, and the values that stand for them
// in operands of the choice kinds. Source: Blackfin Programming Reference, "Multiplier Data Types"
// and the instructions that have them; spellings as the GNU assembler reads them.
#pragma once

#include <cstdint>

namespace finback::isa {

// How a multiply reads its operands, and how a result is rounded and saturated.
enum class MultiplyMode : std::uint8_t {
  fraction,  // signed 1.15, no option written
  fu,        // unsigned fraction
  is,        // signed integer
  iu,        // unsigned integer
  t,         // signed fraction, truncated
  tfu,       // unsigned fraction, truncated
  s2rnd,     // signed fraction, scaled by two, rounded
  iss2,      // signed integer, scaled by two
  ih,        // signed integer, high half
  w32,       // signed fraction, accumulators saturate at 32 bits
};
// Added to a mode: the first operand is signed, the second unsigned.
inline constexpr std::int32_t kMixed = 0x10;

// {acc}
enum Accumulate : std::int32_t { kSet, kAdd, kSubtract };
// {lanes}: which lanes subtract.
enum Lanes : std::int32_t { kSubtractLow = 1, kSubtractHigh = 2 };
// {sco} and {sco_sft}, added up.
enum LaneMode : std::int32_t { kSaturate = 1, kCross = 2, kHalve = 4, kDouble = 8 };
// {r}, {avg}, {rnd} and {lohi}, added up.
enum ByteMode : std::int32_t { kReverse = 1, kTruncate = 2, kHigh = 4 };
// {rel}
enum Relation : std::int32_t { kGreater, kGreaterEqual, kLess, kLessEqual };
// {side}: to the left or to the right.
enum ShiftSide : std::int32_t { kToLeft, kToRight };
// {upd}; the value of {flag} is its bit in ASTAT.
enum FlagUpdate : std::int32_t { kFlagSet, kFlagOr, kFlagAnd, kFlagXor };

}  // namespace finback::isa
