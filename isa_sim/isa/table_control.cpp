// Program flow, hardware loops, events and synchronisation (Programming Reference chapters 7 and
// 16).
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u32 = std::uint32_t;

constexpr Instruction flow_form(std::string_view syntax, int length, Flow flow,
                                std::uint32_t implicit, Execute execute,
                                std::string_view meaning = {}) {
  return {.syntax = syntax,
          .length = length,
          .flow = flow,
          .energy = Energy::nop,
          .implicit = implicit,
          .execute = execute,
          .meaning = meaning};
}
constexpr Instruction event_form(std::string_view syntax, Issue issue, Flow flow, Execute execute,
                                 std::string_view meaning) {
  return {.syntax = syntax,
          .length = 2,
          .issue = issue,
          .flow = flow,
          .energy = Energy::nop,
          .execute = execute,
          .meaning = meaning};
}

// IMASK's bits that always read as 1.
constexpr u32 kUnmaskable = 0x1f;

constexpr Instruction cache_form(std::string_view syntax, Execute execute,
                                 std::string_view meaning) {
  return {.syntax = syntax,
          .length = 2,
          .result = Result::pointer,
          .energy = Energy::control,
          .execute = execute,
          .meaning = meaning};
}
constexpr u32 kCacheLineBytes = 32;
// Asks for `action` on the line that the base register points to; may be sent back.
template <SystemAction action, bool steps>
const Operation* cache_line(ExecutionState& s, const Operation* o) {
  system(s, *o, action, reg(s, (*o)[0]));
  if (s.retry != nullptr) {
    return nullptr;
  }
  if (steps) {
    reg(s, (*o)[0]) += kCacheLineBytes;
  }
  return o + 1;
}

constexpr auto kJump = [](ExecutionState& s, const Operation& o) {
  s.next_address = static_cast<Address>(o[0]);
};
constexpr auto kJumpIndirect = [](ExecutionState& s, const Operation& o) {
  s.next_address = reg(s, o[0]);
};
constexpr auto kJumpRelative = [](ExecutionState& s, const Operation& o) {
  s.next_address = o.address + reg(s, o[0]);
};
constexpr auto kCall = [](ExecutionState& s, const Operation& o) {
  s.reg[RETS] = o.address + o.length;
  s.next_address = static_cast<Address>(o[0]);
};
constexpr auto kCallIndirect = [](ExecutionState& s, const Operation& o) {
  s.next_address = reg(s, o[0]);
  s.reg[RETS] = o.address + o.length;
};
constexpr auto kCallRelative = [](ExecutionState& s, const Operation& o) {
  s.next_address = o.address + reg(s, o[0]);
  s.reg[RETS] = o.address + o.length;
};
template <bool when>
constexpr auto kBranch = [](ExecutionState& s, const Operation& o) {
  if ((s.cc != 0) == when) {
    s.next_address = static_cast<Address>(o[0]);
  }
};
// Operands: top, bottom, count register. LB takes the address of the last packet.
template <int loop, int shift>
constexpr auto kLoopSetup = [](ExecutionState& s, const Operation& o) {
  s.reg[LT0 + loop] = static_cast<u32>(o[0]);
  s.reg[LB0 + loop] = static_cast<u32>(o[1]);
  s.reg[LC0 + loop] = reg(s, o[2]) >> shift;
};
template <int loop>
constexpr auto kLoopSetupPlain = [](ExecutionState& s, const Operation& o) {
  s.reg[LT0 + loop] = static_cast<u32>(o[0]);
  s.reg[LB0 + loop] = static_cast<u32>(o[1]);
};
template <Register from, SystemAction action>
constexpr auto kReturn = [](ExecutionState& s, const Operation& o) {
  s.next_address = s.reg[from];
  system(s, o, action);
};
template <SystemAction action>
constexpr auto kSystem = [](ExecutionState& s, const Operation& o) { system(s, o, action, 0); };

constexpr Instruction kTable[] = {
    flow_form("JUMP.S {pc12}", 2, Flow::jump, kNothing, ending<kJump>),
    flow_form("JUMP.L {pc24}", 4, Flow::jump, kNothing, ending<kJump>),
    flow_form("JUMP {pc24}", 4, Flow::jump, kNothing, ending<kJump>),
    flow_form("JUMP.X {pc24}", 4, Flow::jump, kNothing, ending<kJump>),
    flow_form("JUMP ({P@})", 2, Flow::jump_indirect, kNothing, ending<kJumpIndirect>),
    flow_form("JUMP (PC + {P@})", 2, Flow::jump_indirect, kNothing, ending<kJumpRelative>),
    flow_form("IF CC JUMP {pc10}", 2, Flow::branch, kReadsCc, ending<kBranch<true>>,
              "predicted not taken"),
    flow_form("IF CC JUMP {pc10} (BP)", 2, Flow::branch_predicted, kReadsCc, ending<kBranch<true>>,
              "predicted taken"),
    flow_form("IF !CC JUMP {pc10}", 2, Flow::branch, kReadsCc, ending<kBranch<false>>,
              "predicted not taken"),
    flow_form("IF !CC JUMP {pc10} (BP)", 2, Flow::branch_predicted, kReadsCc,
              ending<kBranch<false>>, "predicted taken"),
    flow_form("CALL {pc24}", 4, Flow::call, kWritesRets, ending<kCall>),
    flow_form("CALL.X {pc24}", 4, Flow::call, kWritesRets, ending<kCall>),
    flow_form("CALL ({P@})", 2, Flow::call_indirect, kWritesRets, ending<kCallIndirect>),
    flow_form("CALL (PC + {P@})", 2, Flow::call_indirect, kWritesRets, ending<kCallRelative>),
    flow_form("RTS", 2, Flow::ret, kReadsRets,
              ending<[](ExecutionState& s, const Operation&) { s.next_address = s.reg[RETS]; }>),
    flow_form("RTI", 2, Flow::ret_event, kNothing,
              ending<kReturn<RETI, SystemAction::return_from_interrupt>>,
              "return from an interrupt"),
    flow_form("RTX", 2, Flow::ret_event, kNothing,
              ending<kReturn<RETX, SystemAction::return_from_exception>>,
              "return from an exception"),
    flow_form("RTN", 2, Flow::ret_event, kNothing,
              ending<kReturn<RETN, SystemAction::return_from_nmi>>,
              "return from a non-maskable interrupt"),
    flow_form("RTE", 2, Flow::ret_event, kNothing,
              ending<kReturn<RETE, SystemAction::return_from_emulation>>, "return from emulation"),

    flow_form("LSETUP ({ltop}, {lbottom}) LC0 = {P@}", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetup<0, 0>>),
    flow_form("LSETUP ({ltop}, {lbottom}) LC1 = {P@}", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetup<1, 0>>),
    flow_form("LSETUP ({ltop}, {lbottom}) LC0 = {P@} >> 1", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetup<0, 1>>),
    flow_form("LSETUP ({ltop}, {lbottom}) LC1 = {P@} >> 1", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetup<1, 1>>),
    flow_form("LSETUP ({ltop}, {lbottom}) LC0", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetupPlain<0>>),
    flow_form("LSETUP ({ltop}, {lbottom}) LC1", 4, Flow::loop_setup, kNothing,
              plain<kLoopSetupPlain<1>>),

    event_form("IDLE", Issue::one, Flow::idle, ending<kSystem<SystemAction::idle>>,
               "sleep until a wake-up event"),
    event_form("CSYNC", Issue::core_sync, Flow::none, plain<kSystem<SystemAction::core_sync>>,
               "wait until the core's pending writes are done"),
    event_form("SSYNC", Issue::system_sync, Flow::event, ending<kSystem<SystemAction::system_sync>>,
               "wait until the system's pending writes are done"),
    event_form("CLI {D!}", Issue::one, Flow::none, plain<[](ExecutionState& s, const Operation& o) {
                 system(s, o, SystemAction::disable_interrupts);
                 reg(s, o[0]) = s.interrupt_mask | kUnmaskable;
                 s.interrupt_mask = 0;
               }>,
               "save and clear the interrupt mask"),
    event_form("STI {D}", Issue::event, Flow::event,
               ending<[](ExecutionState& s, const Operation& o) {
                 system(s, o, SystemAction::enable_interrupts);
                 s.interrupt_mask = reg(s, o[0]) & ~kUnmaskable & 0xffff;
               }>,
               "set the interrupt mask"),
    event_form("RAISE {uimm4}", Issue::event, Flow::event,
               ending<[](ExecutionState& s, const Operation& o) {
                 system(s, o, SystemAction::raise, static_cast<u32>(o[0]));
               }>,
               "raise an event"),
    event_form("EXCPT {uimm4}", Issue::event, Flow::event,
               ending<[](ExecutionState& s, const Operation& o) {
                 system(s, o, SystemAction::exception, static_cast<u32>(o[0]));
               }>,
               "raise an exception"),
    cache_form("PREFETCH [{P@}]", cache_line<SystemAction::prefetch_line, false>,
               "bring the line into the data cache"),
    cache_form("PREFETCH [{P@+}++]", cache_line<SystemAction::prefetch_line, true>,
               "bring the line into the data cache, and step to the next line"),
    cache_form("FLUSH [{P@}]", cache_line<SystemAction::flush_line, false>,
               "write the line back where it is dirty"),
    cache_form("FLUSH [{P@+}++]", cache_line<SystemAction::flush_line, true>,
               "write the line back where it is dirty, and step to the next line"),
    cache_form("FLUSHINV [{P@}]", cache_line<SystemAction::flush_invalidate_line, false>,
               "write the line back where it is dirty, and forget it"),
    cache_form("FLUSHINV [{P@+}++]", cache_line<SystemAction::flush_invalidate_line, true>,
               "write the line back where it is dirty, forget it, and step to the next line"),
    cache_form("IFLUSH [{P@}]", cache_line<SystemAction::flush_code_line, false>,
               "forget the line of the instruction cache"),
    cache_form("IFLUSH [{P@+}++]", cache_line<SystemAction::flush_code_line, true>,
               "forget the line of the instruction cache, and step to the next line"),
    {.syntax = "NOP",
     .length = 2,
     .slot = Slot::nop,
     .energy = Energy::nop,
     .execute = plain<[](ExecutionState&, const Operation&) {}>},
};

}  // namespace

std::span<const Instruction> control_instructions() { return kTable; }

}  // namespace finback::isa
