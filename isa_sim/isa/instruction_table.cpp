#include <vector>

#include <isa_sim/isa/table.hpp>

namespace finback::isa {

std::span<const Instruction> instruction_table() {
  static const std::vector<Instruction> table = [] {
    std::vector<Instruction> all;
    for (const auto part : {memory_instructions(), move_instructions(), arithmetic_instructions(),
                            alu_instructions(), multiply_instructions(), accumulator_instructions(),
                            video_instructions(), shift_instructions(), control_instructions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

std::uint32_t ExecutionState::astat() const {
  // Bit positions: Programming Reference, "Arithmetic Status Register".
  return std::uint32_t{az} | std::uint32_t{an} << 1 | std::uint32_t{cc} << 5 |
         std::uint32_t{aq} << 6 | std::uint32_t{rnd_mod} << 8 | std::uint32_t{ac0} << 12 |
         std::uint32_t{ac1} << 13 | std::uint32_t{av0} << 16 | std::uint32_t{av0s} << 17 |
         std::uint32_t{av1} << 18 | std::uint32_t{av1s} << 19 | std::uint32_t{v} << 24 |
         std::uint32_t{vs} << 25;
}

void ExecutionState::set_astat(std::uint32_t value) {
  const auto bit = [value](int number) { return static_cast<std::uint8_t>(value >> number & 1); };
  az = bit(0);
  an = bit(1);
  cc = bit(5);
  aq = bit(6);
  rnd_mod = bit(8);
  ac0 = bit(12);
  ac1 = bit(13);
  av0 = bit(16);
  av0s = bit(17);
  av1 = bit(18);
  av1s = bit(19);
  v = bit(24);
  vs = bit(25);
}

}  // namespace finback::isa
