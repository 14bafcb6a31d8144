// Program flow, loops, events, debug instructions: where control goes, and what the system is asked
// to do.
#include "laws.hpp"

namespace finback::isa::laws {

namespace {

constexpr std::uint32_t kAlwaysSet = 0x1f;  // of IMASK

void jump(Trial& t) { t.after.next_address = static_cast<Address>(t.number(0)); }
void jump_register(Trial& t) { t.after.next_address = t.word(0); }
template <bool when>
void branch(Trial& t) {
  if ((t.before.cc != 0) == when) {
    jump(t);
  }
}
void save_return(Trial& t) { t.set_register(RETS, Trial::kPlace + static_cast<Exact>(t.length)); }
void call(Trial& t) {
  jump(t);
  save_return(t);
}
void nothing(Trial&) {}
// The line that the register points to, and one line on.
template <SystemAction action>
void line(Trial& t) {
  t.act(action, t.word(0));
}
template <SystemAction action>
void next_line(Trial& t) {
  line<action>(t);
  t.set(0, Exact{t.word(0)} + 32);
}
template <Register from, SystemAction action>
void event_return(Trial& t) {
  t.after.next_address = t.before.reg[from];
  t.act(action);
}
template <int loop>
void set_loop(Trial& t) {
  t.set_register(LT0 + loop, t.number(0));
  t.set_register(LB0 + loop, t.number(1));
}
template <int loop, int shift>
void count_loop(Trial& t) {
  set_loop<loop>(t);
  t.set_register(LC0 + loop, t.word(2) >> shift);
}
template <SystemAction action, std::uint32_t value = 0>
void asks(Trial& t) {
  t.act(action, value);
}
template <SystemAction action>
void asks_with_operand(Trial& t) {
  t.act(action, static_cast<std::uint32_t>(t.number(0)));
}

// The half of a register is as the second operand says, or the program is stopped.
void expect_half(Trial& t, bool high) {
  const std::uint32_t word = register_value(t, t.reg(0));
  if ((high ? word >> 16 : word & 0xffff) != (static_cast<std::uint32_t>(t.number(1)) & 0xffff)) {
    t.act(SystemAction::assertion_failed, high ? static_cast<std::uint32_t>(kHighHalf) : 0);
  }
}
void expect_low(Trial& t) { expect_half(t, false); }
void expect_high(Trial& t) { expect_half(t, true); }

constexpr Law kLaws[] = {
    {"JUMP.S {pc12}", jump},
    {"JUMP.L {pc24}", jump},
    {"JUMP.X {pc24}", jump},
    {"JUMP {pc24}", jump},
    {"CALL.X {pc24}", call},
    {"JUMP ({P@})", jump_register},
    {"IF CC JUMP {pc10}", branch<true>},
    {"IF CC JUMP {pc10} (BP)", branch<true>},
    {"IF !CC JUMP {pc10}", branch<false>},
    {"IF !CC JUMP {pc10} (BP)", branch<false>},
    {"CALL {pc24}", call},
    {"CALL ({P@})",
     [](Trial& t) {
       jump_register(t);
       save_return(t);
     }},
    {"JUMP (PC + {P@})", [](Trial& t) { t.after.next_address = Trial::kPlace + t.word(0); }},
    {"CALL (PC + {P@})",
     [](Trial& t) {
       t.after.next_address = Trial::kPlace + t.word(0);
       save_return(t);
     }},
    {"RTS", [](Trial& t) { t.after.next_address = t.before.reg[RETS]; }},
    {"RTI", event_return<RETI, SystemAction::return_from_interrupt>},
    {"RTX", event_return<RETX, SystemAction::return_from_exception>},
    {"RTN", event_return<RETN, SystemAction::return_from_nmi>},
    {"RTE", event_return<RETE, SystemAction::return_from_emulation>},
    {"LSETUP ({ltop}, {lbottom}) LC0 = {P@}", count_loop<0, 0>},
    {"LSETUP ({ltop}, {lbottom}) LC1 = {P@}", count_loop<1, 0>},
    {"LSETUP ({ltop}, {lbottom}) LC0 = {P@} >> 1", count_loop<0, 1>},
    {"LSETUP ({ltop}, {lbottom}) LC1 = {P@} >> 1", count_loop<1, 1>},
    {"LSETUP ({ltop}, {lbottom}) LC0", set_loop<0>},
    {"LSETUP ({ltop}, {lbottom}) LC1", set_loop<1>},
    {"IDLE", asks<SystemAction::idle>},
    {"CSYNC", asks<SystemAction::core_sync>},
    {"SSYNC", asks<SystemAction::system_sync>},
    {"CLI {D!}",
     [](Trial& t) {
       t.act(SystemAction::disable_interrupts);
       t.set(0, t.before.interrupt_mask | kAlwaysSet);
       t.after.interrupt_mask = 0;
     }},
    {"STI {D}",
     [](Trial& t) {
       t.act(SystemAction::enable_interrupts);
       t.after.interrupt_mask = t.word(0) & 0xffff & ~kAlwaysSet;
     }},
    {"RAISE {uimm4}", asks_with_operand<SystemAction::raise>},
    {"EXCPT {uimm4}", asks_with_operand<SystemAction::exception>},
    {"NOP", nothing},
    {"PREFETCH [{P@}]", line<SystemAction::prefetch_line>},
    {"PREFETCH [{P@+}++]", next_line<SystemAction::prefetch_line>},
    {"FLUSH [{P@}]", line<SystemAction::flush_line>},
    {"FLUSH [{P@+}++]", next_line<SystemAction::flush_line>},
    {"FLUSHINV [{P@}]", line<SystemAction::flush_invalidate_line>},
    {"FLUSHINV [{P@+}++]", next_line<SystemAction::flush_invalidate_line>},
    {"IFLUSH [{P@}]", line<SystemAction::flush_code_line>},
    {"IFLUSH [{P@+}++]", next_line<SystemAction::flush_code_line>},
    {"TESTSET ({P@})",
     [](Trial& t) {
       t.after.cc = t.load(t.word(0), 1) == 0;
       t.store(t.word(0), 1, t.load(t.word(0), 1) | 0x80);
     }},

    {"DBGA ({Dx}, {any16})", [](Trial& t) { expect_half(t, is_high_half(t.number(0))); }},
    {"DBGA ({Pl}, {any16})", expect_low},
    {"DBGA ({Ph}, {any16})", expect_high},
    {"DBGAL ({G}, {any16})", expect_low},
    {"DBGAH ({G}, {any16})", expect_high},
    {"DBG {G}", asks_with_operand<SystemAction::print_register>},
    {"DBG A0", asks<SystemAction::print_register, A0>},
    {"DBG A1", asks<SystemAction::print_register, A1>},
    {"DBG", asks<SystemAction::print_registers>},
    {"PRNT {G}", asks_with_operand<SystemAction::print_register>},
    {"DBGCMPLX ({D})", asks_with_operand<SystemAction::print_halves>},
    {"OUTC {D}", [](Trial& t) { t.act(SystemAction::print_character, t.word(0) & 0xff); }},
    {"OUTC {uimm16}",
     [](Trial& t) {
       t.act(SystemAction::print_character, static_cast<std::uint32_t>(t.number(0)) & 0xff);
     }},
    {"HLT", asks<SystemAction::halt, 0>},
    {"DBGHALT", asks<SystemAction::halt, 0>},
    {"ABORT", asks<SystemAction::halt, 1>},
    {"EMUEXCPT", asks<SystemAction::emulation>},
};

}  // namespace

std::span<const Law> control_laws() { return kLaws; }

}  // namespace finback::isa::laws
