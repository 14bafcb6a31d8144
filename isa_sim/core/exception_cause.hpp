// Why an exception or a hardware error happened: EXCAUSE and HWERRCAUSE of SEQSTAT, and the bits of
// SYSCFG. Source: Programming Reference, chapter 4.
#pragma once

#include <cstdint>

namespace finback::core {

// EXCAUSE. Codes below 0x20 are services, which return to the next instruction; 0..15 are EXCPT's.
enum ExceptionCause : int {
  kSingleStep = 0x10,
  kUndefinedInstruction = 0x21,
  kIllegalCombination = 0x22,
  kDataProtection = 0x23,
  kMisalignedAccess = 0x24,
  kDataMiss = 0x26,
  kDataMultipleHits = 0x27,
  kMisalignedFetch = 0x2A,
  kFetchProtection = 0x2B,
  kFetchMiss = 0x2C,
  kFetchMultipleHits = 0x2D,
  kSupervisorResource = 0x2E,
};
inline constexpr std::uint32_t kExceptionCauseBits = 0x3F;

// HWERRCAUSE
enum HardwareErrorCause : std::uint32_t {
  kExternalAddress = 0x03,
  kRaised = 0x18,  // RAISE 5
};
inline constexpr int kHardwareCauseShift = 14;
inline constexpr std::uint32_t kHardwareCauseBits = 0x1FU << kHardwareCauseShift;

// SYSCFG
inline constexpr std::uint32_t kSingleStepEnable = 1U << 0;
inline constexpr std::uint32_t kCycleCounterEnable = 1U << 1;
inline constexpr std::uint32_t kSelfNestingEnable = 1U << 2;
// After reset, and with CYCLES running.
inline constexpr std::uint32_t kConfigAfterReset = 0x30;
inline constexpr std::uint32_t kCyclesRun = kConfigAfterReset | kCycleCounterEnable;

}  // namespace finback::core
