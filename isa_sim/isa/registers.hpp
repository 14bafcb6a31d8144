// The registers of one Blackfin core, as one flat numbering.
//
// A register's number indexes ExecutionState::reg, so that an operand needs no decoding.
// Accumulators (40 bits) and status flags live beside that array; their numbers here serve moves,
// hazards and printing. Source: Blackfin Programming Reference, chapter 2 (register files).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace finback::isa {

enum Register : std::uint8_t {
  // clang-format off
  R0, R1, R2, R3, R4, R5, R6, R7,          // data registers
  P0, P1, P2, P3, P4, P5, SP, FP,          // pointer registers
  I0, I1, I2, I3, M0, M1, M2, M3,          // index and modify registers
  B0, B1, B2, B3, L0, L1, L2, L3,          // circular buffers: base and length
  LC0, LC1, LT0, LT1, LB0, LB1,            // hardware loops: count, top, bottom
  RETS, RETI, RETX, RETN, RETE,            // return addresses
  USP, SEQSTAT, SYSCFG, CYCLES, CYCLES2, EMUDAT,
  A0X, A0W, A1X, A1W,                      // parts of the accumulators
  ASTAT, CC, A0, A1,
  kRegisterCount
  // clang-format on
};

// "R0", "SP", "A0.X", ...
[[nodiscard]] std::string_view register_name(Register reg);
// Any case ("r0", "R0"); nothing when the name is no register's.
[[nodiscard]] std::optional<Register> register_by_name(std::string_view name);

[[nodiscard]] constexpr bool is_data_register(int reg) { return reg >= R0 && reg <= R7; }
[[nodiscard]] constexpr bool is_pointer_register(int reg) { return reg >= P0 && reg <= FP; }
// Registers that the data address generators read in stage AC (P, I, M, B, L).
[[nodiscard]] constexpr bool is_address_register(int reg) { return reg >= P0 && reg <= L3; }

}  // namespace finback::isa
