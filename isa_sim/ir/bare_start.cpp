#include <isa_sim/ir/firmware.hpp>

namespace finback::ir {

// SP is set by the machine. The 12 bytes are those that a caller keeps for its callee's register
// arguments (the Blackfin calling convention).
std::string_view bare_start_text() {
  return R"(.bir 1
.text
.global _start
.type _start, @function
.align 2
_start:
  SP += -12;
  R0 = 0 (X);
  R1 = 0 (X);
  CALL _main;
  P0.L = 0xF020;  // EXIT, a register of the host port
  P0.H = 0xFFC0;
  [P0] = R0;
.Lidle:
  IDLE;
  JUMP .Lidle;
.size _start, .-_start
)";
}

}  // namespace finback::ir
