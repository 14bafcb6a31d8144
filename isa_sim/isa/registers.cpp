#include <algorithm>
#include <array>
#include <cctype>

#include <isa_sim/isa/registers.hpp>

namespace finback::isa {
namespace {

constexpr std::array<std::string_view, kRegisterCount> kNames = {
    // clang-format off
    "R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7",
    "P0", "P1", "P2", "P3", "P4", "P5", "SP", "FP",
    "I0", "I1", "I2", "I3", "M0", "M1", "M2", "M3",
    "B0", "B1", "B2", "B3", "L0", "L1", "L2", "L3",
    "LC0", "LC1", "LT0", "LT1", "LB0", "LB1",
    "RETS", "RETI", "RETX", "RETN", "RETE",
    "USP", "SEQSTAT", "SYSCFG", "CYCLES", "CYCLES2", "EMUDAT",
    "A0.X", "A0.W", "A1.X", "A1.W",
    "ASTAT", "CC", "A0", "A1",
    // clang-format on
};

bool same_letters(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other, [](unsigned char a, unsigned char b) {
    return std::toupper(a) == std::toupper(b);
  });
}

}  // namespace

std::string_view register_name(Register reg) { return kNames.at(reg); }

std::optional<Register> register_by_name(std::string_view name) {
  for (std::size_t reg = 0; reg < kNames.size(); ++reg) {
    if (same_letters(kNames[reg], name)) {
      return static_cast<Register>(reg);
    }
  }
  return std::nullopt;
}

}  // namespace finback::isa
