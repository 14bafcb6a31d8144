// Operands: the kinds that an instruction's syntax names, and their decoded values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace finback::isa {

// One kind of operand. In a syntax pattern it stands between braces by the name given here,
// followed by marks:
//   !  written    +  read and written    (neither)  read    @  read in stage AC (addresses, pointer
//   arithmetic)
// and `{=N}` for operand N (from 0) once more, as in "{D+} = ({=0} + {D}) << 1"; `{?(X)}` at
// the end is text that may be left out. For example
// "{D!} = [{P@+}++]". The value of a register operand is its Register number; of a half
// or byte register `reg | kHighHalf` for the high half, `reg` for the low; of an immediate, its
// value after scaling; of a label or symbol, its address (the part asked for by the instruction).
enum class OperandKind : std::uint8_t {
  // registers
  data,          // {D}     R0..R7
  data_low,      // {Dl}    R0.L
  data_high,     // {Dh}    R0.H
  data_half,     // {Dx}    R0.L or R0.H
  data_byte,     // {Db}    R0.B
  data_even,     // {Deven} R0, R2, R4, R6
  data_odd,      // {Dodd}  R1, R3, R5, R7
  pointer,       // {P}     P0..P5, SP, FP
  index,         // {I}
  modify,        // {M}
  pointer_low,   // {Pl}    P0.L, and I0.L, M0.L, B0.L, L0.L
  pointer_high,  // {Ph}
  any,  // {G}     any register that a move takes: D, P, I, M, B, L, loops, returns, ASTAT, A0.X ...
  system,   // {S}     any but D and P: I, M, B, L, loops, returns, ASTAT, SEQSTAT, CYCLES, A0.X ...
  address,  // {IMBL}  I0..I3, M0..M3, B0..B3, L0..L3
  data_pair,     // {DD}    R1:0 or R3:2 (value: the lower register)
  data_list,     // {Dlist} R7:n (value: n)
  pointer_list,  // {Plist} P5:n (value: n)
  // choices of a word or an option, by the names and spellings in operand.cpp; their value is the
  // number of the choice. The empty spelling is the option left out.
  accumulate,         // {acc}       =  +=  -=
  accumulate_mode,    // {amode}     (FU) (IS) (W32)
  accumulate_mode_m,  // {amode_m}   the same with or without M
  half_mode,          // {hmode}     (FU) (IS) (IU) (T) (TFU) (S2RND) (ISS2) (IH)
  half_mode_m,        // {hmode_m}
  word_mode,          // {wmode}     (FU) (IS) (IU) (S2RND) (ISS2)
  word_mode_m,        // {wmode_m}
  mixed,              // {m}         (M)
  lanes,              // {lanes}     +|+  +|-  -|+  -|-
  lane_mode,          // {sco}       (S) (CO) (SCO)
  lane_shift_mode,    // {sco_sft}   the same with or without ASR or ASL
  wide_saturate,      // {ns}        (NS) (S)
  wide_accumulate,    // {w32}       (W32)
  byte_order,         // {r}         (R)
  byte_average,       // {avg}       (R) (T) (T, R)
  byte_round,         // {rnd}       (RNDL) (RNDH) (TL) (TH), each with or without R
  byte_half,          // {lohi}      (LO) (HI), with or without R
  relation,           // {rel}       (GT) (GE) (LT) (LE)
  shift_side,         // {side}      (ASL) (ASR)
  status_flag,        // {flag}      AZ AN AC0_COPY V_COPY AQ RND_MOD AC0 AC1 AV0 AV0S AV1 AV1S V VS
  flag_update,        // {upd}       =  |=  &=  ^=
  // immediates: the table in operand.cpp has bits, sign and scale of each
  imm3,
  imm4,
  imm6,
  imm7,
  imm16,
  uimm3,
  uimm4,
  uimm5,
  uimm6,
  uimm16,
  any16,      // {any16}    -32768..65535: a half to be written, or a symbol's half (by the register
              // half)
  offset4x2,  // {off4x2}   0..30, even
  offset4x4,  // {off4x4}   0..60, multiples of 4
  offset5x4neg,  // {off5n4}   -128..-4, multiples of 4 (FP-relative)
  offset16,      // {off16}    -32768..32767
  offset16x2,    // {off16x2}  even
  offset16x4,    // {off16x4}  multiples of 4
  frame18x4,     // {frame}    0..262140, multiples of 4 (LINK)
  // code addresses, relative to the instruction
  pc10,         // {pc10}     -1024..1022    IF CC JUMP
  pc12,         // {pc12}     -4096..4094    JUMP.S
  pc24,         // {pc24}     -16 M..16 M    JUMP.L, CALL
  loop_top,     // {ltop}     4..30
  loop_bottom,  // {lbottom}  4..2046
};

inline constexpr std::int32_t kHighHalf = 0x40;
[[nodiscard]] constexpr int register_of(std::int32_t operand) { return operand & 0x3f; }
[[nodiscard]] constexpr bool is_high_half(std::int32_t operand) {
  return (operand & kHighHalf) != 0;
}

// What an immediate or code-address kind holds.
struct ImmediateRange {
  std::int32_t minimum = 0;
  std::int32_t maximum = 0;
  std::int32_t scale = 1;  // the value must be a multiple of it
};

// The kind's name as patterns spell it ("D", "off4x4").
[[nodiscard]] std::string_view kind_name(OperandKind kind);
[[nodiscard]] std::optional<OperandKind> kind_by_name(std::string_view name);
// Nothing for registers.
[[nodiscard]] std::optional<ImmediateRange> immediate_range(OperandKind kind);
[[nodiscard]] constexpr bool is_code_address(OperandKind kind) { return kind >= OperandKind::pc10; }
[[nodiscard]] constexpr bool is_register(OperandKind kind) {
  return kind <= OperandKind::pointer_list;
}
[[nodiscard]] constexpr bool is_choice(OperandKind kind) {
  return kind >= OperandKind::accumulate && kind <= OperandKind::flag_update;
}

// One way to write a choice. Several spellings may stand for one value: the first is printed.
struct Spelling {
  std::string_view text;
  std::int32_t value = 0;
};
// Of a choice; empty for other kinds.
[[nodiscard]] std::span<const Spelling> spellings(OperandKind kind);

// One operand of a pattern.
struct OperandRole {
  OperandKind kind = OperandKind::data;
  bool read = false;
  bool written = false;
  bool address_stage = false;  // read in stage AC
};

// Of one instruction: a vector multiply-accumulate into two halves has ten.
inline constexpr int kMaxOperands = 10;

}  // namespace finback::isa
