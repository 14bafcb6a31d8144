// Instructions for tests and debuggers: assertions, output, the end of a program. On a chip they
// are undefined or wait for an emulator; a simulator gives them their meaning. Spellings and output
// as in the GNU tools.
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u32 = std::uint32_t;

constexpr Instruction debug_form(std::string_view syntax, int length, Flow flow, Execute execute,
                                 std::string_view meaning) {
  return {.syntax = syntax,
          .length = length,
          .flow = flow,
          .energy = Energy::nop,
          .execute = execute,
          .meaning = meaning};
}
// Ends its block, so that the engine may send it back or end the program.
constexpr Instruction action_form(std::string_view syntax, Execute execute,
                                  std::string_view meaning) {
  return debug_form(syntax, 2, Flow::event, execute, meaning);
}

enum class Half : std::uint8_t { low, high, by_operand };

// The half of register {0} is {1}.
template <Half part>
const Operation* assert_half(ExecutionState& s, const Operation* o) {
  const bool high = part == Half::high || (part == Half::by_operand && is_high_half((*o)[0]));
  const u32 word = read_any(s, *o, register_of((*o)[0]));
  const u32 found = high ? word >> 16 : word & 0xffff;
  if (found == (static_cast<u32>((*o)[1]) & 0xffff)) {
    return o + 1;
  }
  system(s, *o, SystemAction::assertion_failed, high ? kHighHalf : 0);
  return nullptr;
}
constexpr std::string_view kAssert = "end the program with status 1 unless the half is as given";

template <SystemAction action, u32 value = 0>
constexpr auto kAct = [](ExecutionState& s, const Operation& o) { system(s, o, action, value); };
template <SystemAction action>
constexpr auto kActOnOperand =
    [](ExecutionState& s, const Operation& o) { system(s, o, action, static_cast<u32>(o[0])); };

constexpr Instruction kTable[] = {
    debug_form("DBGA ({Dx}, {any16})", 4, Flow::none, assert_half<Half::by_operand>, kAssert),
    debug_form("DBGA ({Pl}, {any16})", 4, Flow::none, assert_half<Half::low>, kAssert),
    debug_form("DBGA ({Ph}, {any16})", 4, Flow::none, assert_half<Half::high>, kAssert),
    debug_form("DBGAL ({G}, {any16})", 4, Flow::none, assert_half<Half::low>, kAssert),
    debug_form("DBGAH ({G}, {any16})", 4, Flow::none, assert_half<Half::high>, kAssert),
    action_form("DBG {G}", ending<kActOnOperand<SystemAction::print_register>>, "print a register"),
    action_form("DBG A0", ending<kAct<SystemAction::print_register, A0>>, "print an accumulator"),
    action_form("DBG A1", ending<kAct<SystemAction::print_register, A1>>, "print an accumulator"),
    action_form("DBG", ending<kAct<SystemAction::print_registers>>, "print all registers"),
    action_form("PRNT {G}", ending<kActOnOperand<SystemAction::print_register>>,
                "print a register"),
    action_form("DBGCMPLX ({D})", ending<kActOnOperand<SystemAction::print_halves>>,
                "print a register as two signed halves"),
    action_form("OUTC {D}", ending<[](ExecutionState& s, const Operation& o) {
                  system(s, o, SystemAction::print_character, reg(s, o[0]) & 0xff);
                }>,
                "print the character in the low byte"),
    action_form("OUTC {uimm16}", ending<[](ExecutionState& s, const Operation& o) {
                  system(s, o, SystemAction::print_character, static_cast<u32>(o[0]) & 0xff);
                }>,
                "print a character"),
    action_form("HLT", ending<kAct<SystemAction::halt, 0>>, "end the program with status 0"),
    action_form("DBGHALT", ending<kAct<SystemAction::halt, 0>>, "end the program with status 0"),
    action_form("ABORT", ending<kAct<SystemAction::halt, 1>>, "end the program with status 1"),
    action_form("EMUEXCPT", ending<kAct<SystemAction::emulation>>,
                "call the emulator: nothing without one"),
};

}  // namespace

std::span<const Instruction> debug_instructions() { return kTable; }

}  // namespace finback::isa
