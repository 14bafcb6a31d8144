#include <vector>

#include <isa_sim/isa/table.hpp>

namespace finback::isa {

std::span<const Instruction> instruction_table() {
  static const std::vector<Instruction> table = [] {
    std::vector<Instruction> all;
    for (const auto part :
         {memory_instructions(), move_instructions(), arithmetic_instructions(), alu_instructions(),
          multiply_instructions(), accumulator_instructions(), video_instructions(),
          shift_instructions(), control_instructions(), debug_instructions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

namespace {

struct FlagBit {
  std::uint8_t ExecutionState::*flag;
  int bit;
};
// Programming Reference, "Arithmetic Status Register".
constexpr FlagBit kFlagBits[] = {
    {&ExecutionState::az, 0},   {&ExecutionState::an, 1},      {&ExecutionState::cc, 5},
    {&ExecutionState::aq, 6},   {&ExecutionState::rnd_mod, 8}, {&ExecutionState::ac0, 12},
    {&ExecutionState::ac1, 13}, {&ExecutionState::av0, 16},    {&ExecutionState::av0s, 17},
    {&ExecutionState::av1, 18}, {&ExecutionState::av1s, 19},   {&ExecutionState::v, 24},
    {&ExecutionState::vs, 25},
};
constexpr int kCarryCopy = 2;
constexpr int kOverflowCopy = 3;
constexpr std::uint32_t kFlagMask = 0x030F316F;

constexpr std::uint32_t copy_of(std::uint8_t flag) { return (flag ^ flag >> 1) & 1U; }
constexpr std::uint8_t with_copy(std::uint32_t flag, std::uint32_t copy) {
  return static_cast<std::uint8_t>(flag | (flag ^ copy) << 1);
}

}  // namespace

std::uint32_t ExecutionState::astat() const {
  std::uint32_t value = astat_reserved | copy_of(ac0) << kCarryCopy | copy_of(v) << kOverflowCopy;
  for (const FlagBit& one : kFlagBits) {
    value |= (this->*one.flag & 1U) << one.bit;
  }
  return value;
}

bool ExecutionState::flag(int bit) const {
  for (const FlagBit& one : kFlagBits) {
    if (one.bit == bit) {
      return (this->*one.flag & 1U) != 0;
    }
  }
  return (astat() >> bit & 1U) != 0;
}

void ExecutionState::set_astat(std::uint32_t value) {
  for (const FlagBit& one : kFlagBits) {
    this->*one.flag = static_cast<std::uint8_t>(value >> one.bit & 1);
  }
  ac0 = with_copy(ac0, value >> kCarryCopy & 1);
  v = with_copy(v, value >> kOverflowCopy & 1);
  astat_reserved = value & ~kFlagMask;
}

}  // namespace finback::isa
