// Loads and stores of 8, 16 and 32 bits, push and pop, frames (Programming Reference chapters 8 and
// 10).
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using s8 = std::int8_t;
using s16 = std::int16_t;

// By the letter before the bracket: B[, W[ or neither.
constexpr std::uint8_t width_of(std::string_view syntax) {
  const std::size_t bracket = syntax.find('[');
  const char letter = bracket == 0 ? ' ' : syntax[bracket - 1];
  return letter == 'B' ? 1 : letter == 'W' ? 2 : 4;
}
constexpr Instruction load_form(std::string_view syntax, int length, Slot slot, Execute execute) {
  return {.syntax = syntax,
          .length = length,
          .slot = slot,
          .result = Result::load,
          .memory = MemoryUse::load,
          .access_bytes = width_of(syntax),
          .energy = Energy::access,
          .execute = execute};
}
constexpr Instruction store_form(std::string_view syntax, int length, Slot slot, Execute execute) {
  return {.syntax = syntax,
          .length = length,
          .slot = slot,
          .memory = MemoryUse::store,
          .access_bytes = width_of(syntax),
          .energy = Energy::access,
          .execute = execute};
}
// Through the frame pointer, which the syntax names by itself.
constexpr Instruction frame_form(Instruction form) {
  form.implicit = kReadsFp;
  return form;
}
constexpr Instruction stack_form(std::string_view syntax, MemoryUse memory, Issue issue,
                                 Execute execute, std::string_view meaning) {
  return {.syntax = syntax,
          .length = 2,
          .issue = issue,
          .result = Result::load,
          .memory = memory,
          .access_bytes = 4,
          .energy = Energy::access,
          .implicit = kReadsSp | kWritesSp,
          .execute = execute,
          .meaning = meaning};
}

const Operation* load_from_frame(ExecutionState& s, const Operation* o) {
  return read_memory(s, *o, s.reg[FP] + static_cast<u32>((*o)[1]), reg(s, (*o)[0])) ? o + 1
                                                                                    : nullptr;
}
const Operation* store_to_frame(ExecutionState& s, const Operation* o) {
  return write_memory<u32>(s, *o, s.reg[FP] + static_cast<u32>((*o)[0]), reg(s, (*o)[1])) ? o + 1
                                                                                          : nullptr;
}

const Operation* push(ExecutionState& s, const Operation* o) {
  if (!write_memory<u32>(s, *o, s.reg[SP] - 4, read_any(s, *o, (*o)[0]))) {
    return nullptr;
  }
  s.reg[SP] -= 4;
  if ((*o)[0] == RETI) {
    system(s, *o, SystemAction::saved_return);
  }
  return o + 1;
}
const Operation* pop(ExecutionState& s, const Operation* o) {
  u32 value = 0;
  if (!read_memory(s, *o, s.reg[SP], value)) {
    return nullptr;
  }
  const Address next = s.reg[SP] + 4;
  if ((*o)[0] == USP) {
    system(s, *o, SystemAction::pop_usp);
  }
  write_any(s, *o, (*o)[0], value);
  s.reg[SP] = next;
  if ((*o)[0] == RETI) {
    system(s, *o, SystemAction::loaded_return);
  }
  return o + 1;
}

// Pushes R`first_data`..R7, then P`first_pointer`..P5; 8 and 6 mean none.
const Operation* push_list(ExecutionState& s, const Operation* o, int first_data,
                           int first_pointer) {
  Address address = s.reg[SP];
  const auto put = [&](int number, bool continued) {
    address -= 4;
    return write_memory<u32>(s, *o, address, reg(s, number), continued);
  };
  bool continued = false;
  for (int i = first_data; i < 8; ++i, continued = true) {
    if (!put(R0 + i, continued)) {
      return nullptr;
    }
  }
  for (int i = first_pointer; i < 6; ++i, continued = true) {
    if (!put(P0 + i, continued)) {
      return nullptr;
    }
  }
  s.reg[SP] = address;
  return o + 1;
}
const Operation* pop_list(ExecutionState& s, const Operation* o, int first_data,
                          int first_pointer) {
  Address address = s.reg[SP];
  const auto take = [&](int number, bool continued) {
    const bool done = read_memory(s, *o, address, reg(s, number), continued);
    address += 4;
    return done;
  };
  bool continued = false;
  for (int i = 5; i >= first_pointer; --i, continued = true) {
    if (!take(P0 + i, continued)) {
      return nullptr;
    }
  }
  for (int i = 7; i >= first_data; --i, continued = true) {
    if (!take(R0 + i, continued)) {
      return nullptr;
    }
  }
  s.reg[SP] = address;
  return o + 1;
}

const Operation* link(ExecutionState& s, const Operation* o) {
  const Address sp = s.reg[SP];
  if (!write_memory<u32>(s, *o, sp - 4, s.reg[RETS]) ||
      !write_memory<u32>(s, *o, sp - 8, s.reg[FP], true)) {
    return nullptr;
  }
  s.reg[FP] = sp - 8;
  s.reg[SP] = sp - 8 - static_cast<u32>((*o)[0]);
  return o + 1;
}
const Operation* unlink(ExecutionState& s, const Operation* o) {
  const Address fp = s.reg[FP];
  u32 old_fp = 0;
  u32 rets = 0;
  if (!read_memory(s, *o, fp, old_fp) || !read_memory(s, *o, fp + 4, rets, true)) {
    return nullptr;
  }
  s.reg[FP] = old_fp;
  s.reg[RETS] = rets;
  s.reg[SP] = fp + 8;
  return o + 1;
}

const Operation* test_and_set(ExecutionState& s, const Operation* o) {
  u8 old = 0;
  if (!s.hooks->test_and_set(s, *o, reg(s, (*o)[0]), old)) {
    return nullptr;
  }
  s.cc = old == 0;
  return o + 1;
}

template <Walk walk>
constexpr Instruction index_load_form(std::string_view syntax) {
  Instruction form = load_form(syntax, 2, Slot::index_access, load<u32, walk>);
  form.execute_aligned = load<u32, walk, Into::whole, ~Address{3}>;
  return form;
}

constexpr Slot kP = Slot::access;
constexpr Slot kI = Slot::index_access;
constexpr Slot kAlone = Slot::alone;

constexpr Instruction kTable[] = {
    // 32 bits into a data register
    load_form("{D!} = [{P@}]", 2, kP, load<u32, Walk::none>),
    load_form("{D!} = [{P@+}++]", 2, kP, load<u32, Walk::up>),
    load_form("{D!} = [{P@+}--]", 2, kP, load<u32, Walk::down>),
    load_form("{D!} = [{P@} + {off4x4}]", 2, kP, load<u32, Walk::offset>),
    frame_form(load_form("{D!} = [FP + {off5n4}]", 2, kP, load_from_frame)),
    frame_form(load_form("{P!} = [FP + {off5n4}]", 2, kP, load_from_frame)),
    load_form("{D!} = [{P@} + {off16x4}]", 4, kAlone, load<u32, Walk::offset>),
    load_form("{D!} = [{P@+}++{P@}]", 2, kP, load<u32, Walk::by_register>),
    index_load_form<Walk::none>("{D!} = [{I@}]"),
    index_load_form<Walk::up>("{D!} = [{I@+}++]"),
    index_load_form<Walk::down>("{D!} = [{I@+}--]"),
    index_load_form<Walk::by_register>("{D!} = [{I@+}++{M@}]"),
    // 32 bits into a pointer register
    load_form("{P!} = [{P@}]", 2, kP, load<u32, Walk::none>),
    load_form("{P!} = [{P@+}++]", 2, kP, load<u32, Walk::up>),
    load_form("{P!} = [{P@+}--]", 2, kP, load<u32, Walk::down>),
    load_form("{P!} = [{P@} + {off4x4}]", 2, kP, load<u32, Walk::offset>),
    load_form("{P!} = [{P@} + {off16x4}]", 4, kAlone, load<u32, Walk::offset>),
    // 16 bits, zero- or sign-extended
    load_form("{D!} = W[{P@}] {?(Z)}", 2, kP, load<u16, Walk::none>),
    load_form("{D!} = W[{P@}] (X)", 2, kP, load<s16, Walk::none>),
    load_form("{D!} = W[{P@+}++] {?(Z)}", 2, kP, load<u16, Walk::up>),
    load_form("{D!} = W[{P@+}++] (X)", 2, kP, load<s16, Walk::up>),
    load_form("{D!} = W[{P@+}--] {?(Z)}", 2, kP, load<u16, Walk::down>),
    load_form("{D!} = W[{P@+}--] (X)", 2, kP, load<s16, Walk::down>),
    load_form("{D!} = W[{P@} + {off4x2}] {?(Z)}", 2, kP, load<u16, Walk::offset>),
    load_form("{D!} = W[{P@} + {off4x2}] (X)", 2, kP, load<s16, Walk::offset>),
    load_form("{D!} = W[{P@} + {off16x2}] {?(Z)}", 4, kAlone, load<u16, Walk::offset>),
    load_form("{D!} = W[{P@} + {off16x2}] (X)", 4, kAlone, load<s16, Walk::offset>),
    load_form("{D!} = W[{P@+}++{P@}] {?(Z)}", 2, kP, load<u16, Walk::by_register>),
    load_form("{D!} = W[{P@+}++{P@}] (X)", 2, kP, load<s16, Walk::by_register>),
    // 16 bits into one half; the other half stays
    load_form("{Dl!} = W[{P@}]", 2, kP, load<u16, Walk::none, Into::low>),
    load_form("{Dh!} = W[{P@}]", 2, kP, load<u16, Walk::none, Into::high>),
    load_form("{Dl!} = W[{P@+}++{P@}]", 2, kP, load<u16, Walk::by_register, Into::low>),
    load_form("{Dh!} = W[{P@+}++{P@}]", 2, kP, load<u16, Walk::by_register, Into::high>),
    load_form("{Dl!} = W[{I@}]", 2, kI, load<u16, Walk::none, Into::low>),
    load_form("{Dh!} = W[{I@}]", 2, kI, load<u16, Walk::none, Into::high>),
    load_form("{Dl!} = W[{I@+}++]", 2, kI, load<u16, Walk::up, Into::low>),
    load_form("{Dh!} = W[{I@+}++]", 2, kI, load<u16, Walk::up, Into::high>),
    load_form("{Dl!} = W[{I@+}--]", 2, kI, load<u16, Walk::down, Into::low>),
    load_form("{Dh!} = W[{I@+}--]", 2, kI, load<u16, Walk::down, Into::high>),
    // 8 bits
    load_form("{D!} = B[{P@}] {?(Z)}", 2, kP, load<u8, Walk::none>),
    load_form("{D!} = B[{P@}] (X)", 2, kP, load<s8, Walk::none>),
    load_form("{D!} = B[{P@+}++] {?(Z)}", 2, kP, load<u8, Walk::up>),
    load_form("{D!} = B[{P@+}++] (X)", 2, kP, load<s8, Walk::up>),
    load_form("{D!} = B[{P@+}--] {?(Z)}", 2, kP, load<u8, Walk::down>),
    load_form("{D!} = B[{P@+}--] (X)", 2, kP, load<s8, Walk::down>),
    load_form("{D!} = B[{P@} + {off16}] {?(Z)}", 4, kAlone, load<u8, Walk::offset>),
    load_form("{D!} = B[{P@} + {off16}] (X)", 4, kAlone, load<s8, Walk::offset>),

    // stores, 32 bits
    store_form("[{P@}] = {D}", 2, kP, store<u32, Walk::none>),
    store_form("[{P@+}++] = {D}", 2, kP, store<u32, Walk::up>),
    store_form("[{P@+}--] = {D}", 2, kP, store<u32, Walk::down>),
    store_form("[{P@} + {off4x4}] = {D}", 2, kP, store<u32, Walk::offset>),
    frame_form(store_form("[FP + {off5n4}] = {D}", 2, kP, store_to_frame)),
    frame_form(store_form("[FP + {off5n4}] = {P}", 2, kP, store_to_frame)),
    store_form("[{P@} + {off16x4}] = {D}", 4, kAlone, store<u32, Walk::offset>),
    store_form("[{P@+}++{P@}] = {D}", 2, kP, store<u32, Walk::by_register>),
    store_form("[{I@}] = {D}", 2, kI, store<u32, Walk::none>),
    store_form("[{I@+}++] = {D}", 2, kI, store<u32, Walk::up>),
    store_form("[{I@+}--] = {D}", 2, kI, store<u32, Walk::down>),
    store_form("[{I@+}++{M@}] = {D}", 2, kI, store<u32, Walk::by_register>),
    store_form("[{P@}] = {P}", 2, kP, store<u32, Walk::none>),
    store_form("[{P@+}++] = {P}", 2, kP, store<u32, Walk::up>),
    store_form("[{P@+}--] = {P}", 2, kP, store<u32, Walk::down>),
    store_form("[{P@} + {off4x4}] = {P}", 2, kP, store<u32, Walk::offset>),
    store_form("[{P@} + {off16x4}] = {P}", 4, kAlone, store<u32, Walk::offset>),
    // 16 bits
    store_form("W[{P@}] = {D}", 2, kP, store<u16, Walk::none>),
    store_form("W[{P@+}++] = {D}", 2, kP, store<u16, Walk::up>),
    store_form("W[{P@+}--] = {D}", 2, kP, store<u16, Walk::down>),
    store_form("W[{P@} + {off4x2}] = {D}", 2, kP, store<u16, Walk::offset>),
    store_form("W[{P@} + {off16x2}] = {D}", 4, kAlone, store<u16, Walk::offset>),
    store_form("W[{P@}] = {Dl}", 2, kP, store<u16, Walk::none>),
    store_form("W[{P@}] = {Dh}", 2, kP, store<u16, Walk::none, Into::high>),
    store_form("W[{P@+}++{P@}] = {Dl}", 2, kP, store<u16, Walk::by_register>),
    store_form("W[{P@+}++{P@}] = {Dh}", 2, kP, store<u16, Walk::by_register, Into::high>),
    store_form("W[{I@}] = {Dl}", 2, kI, store<u16, Walk::none>),
    store_form("W[{I@}] = {Dh}", 2, kI, store<u16, Walk::none, Into::high>),
    store_form("W[{I@+}++] = {Dl}", 2, kI, store<u16, Walk::up>),
    store_form("W[{I@+}++] = {Dh}", 2, kI, store<u16, Walk::up, Into::high>),
    store_form("W[{I@+}--] = {Dl}", 2, kI, store<u16, Walk::down>),
    store_form("W[{I@+}--] = {Dh}", 2, kI, store<u16, Walk::down, Into::high>),
    // 8 bits
    store_form("B[{P@}] = {D}", 2, kP, store<u8, Walk::none>),
    store_form("B[{P@+}++] = {D}", 2, kP, store<u8, Walk::up>),
    store_form("B[{P@+}--] = {D}", 2, kP, store<u8, Walk::down>),
    store_form("B[{P@} + {off16}] = {D}", 4, kAlone, store<u8, Walk::offset>),

    // the stack
    stack_form("[--SP] = {G}", MemoryUse::store, Issue::one, push, "push one register"),
    stack_form("{G!} = [SP++]", MemoryUse::load, Issue::one, pop, "pop one register"),
    stack_form(
        "[--SP] = ({Dlist}, {Plist})", MemoryUse::store, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return push_list(s, o, (*o)[0], (*o)[1]); },
        "push R7 to Rn and P5 to Pm"),
    stack_form(
        "[--SP] = ({Dlist})", MemoryUse::store, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return push_list(s, o, (*o)[0], 6); },
        "push R7 to Rn"),
    stack_form(
        "[--SP] = ({Plist})", MemoryUse::store, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return push_list(s, o, 8, (*o)[0]); },
        "push P5 to Pn"),
    stack_form(
        "({Dlist!}, {Plist!}) = [SP++]", MemoryUse::load, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return pop_list(s, o, (*o)[0], (*o)[1]); },
        "pop R7 to Rn and P5 to Pm"),
    stack_form(
        "({Dlist!}) = [SP++]", MemoryUse::load, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return pop_list(s, o, (*o)[0], 6); },
        "pop R7 to Rn"),
    stack_form(
        "({Plist!}) = [SP++]", MemoryUse::load, Issue::register_list,
        [](ExecutionState& s, const Operation* o) { return pop_list(s, o, 8, (*o)[0]); },
        "pop P5 to Pn"),
    {.syntax = "LINK {frame}",
     .length = 4,
     .issue = Issue::link,
     .result = Result::pointer,
     .memory = MemoryUse::store,
     .access_bytes = 8,
     .energy = Energy::access,
     .implicit = kReadsSp | kWritesSp | kReadsFp | kWritesFp | kReadsRets,
     .execute = link,
     .meaning = "push RETS and FP, set FP to SP, open a frame of that many bytes"},
    {.syntax = "UNLINK",
     .length = 4,
     .issue = Issue::unlink,
     .result = Result::load,
     .memory = MemoryUse::load,
     .access_bytes = 8,
     .energy = Energy::access,
     .implicit = kWritesSp | kReadsFp | kWritesFp | kWritesRets,
     .execute = unlink,
     .meaning = "close the frame, pop FP and RETS"},
    {.syntax = "TESTSET ({P@})",
     .length = 2,
     .issue = Issue::test_and_set,
     .memory = MemoryUse::load_store,
     .access_bytes = 2,
     .energy = Energy::access,
     .implicit = kWritesCc,
     .execute = test_and_set,
     .meaning = "CC = the byte was 0; sets its bit 7, with the bus locked"},
};

}  // namespace

std::span<const Instruction> memory_instructions() { return kTable; }

}  // namespace finback::isa
