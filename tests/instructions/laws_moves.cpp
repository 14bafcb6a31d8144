// Moves, immediates, conditional moves, comparisons, CC and the flags.
#include "laws.hpp"
#include <isa_sim/isa/choice.hpp>

namespace finback::isa::laws {

namespace {

// "CC = {D} < {imm3} (IU)": the registers as signed numbers, or unsigned with (IU).
void comparison(Trial& t) {
  const bool as_unsigned = has(t.syntax, "(IU)");
  const auto read = [&](int i, bool immediate) -> Exact {
    return immediate ? t.number(i) : as_unsigned ? Exact{t.word(i)} : t.value(i);
  };
  const bool immediate = has(t.syntax, "imm3");
  const Exact a = read(0, false);
  const Exact b = read(1, immediate);
  t.after.cc = has(t.syntax, "==") ? a == b : has(t.syntax, "<=") ? a <= b : a < b;
  if (has(t.syntax, "{D}")) {
    t.after.az = a == b;
    t.after.an = a < b;
    t.after.ac0 = t.word(0) >= static_cast<std::uint32_t>(b);
  }
}

// "IF !CC {D+} = {P}"
void conditional_move(Trial& t) {
  if ((t.before.cc != 0) != has(t.syntax, "!CC")) {
    t.set(0, t.word(1));
  }
}

void copy(Trial& t) { t.set(0, t.word(1)); }
void immediate(Trial& t) { t.set(0, t.number(1)); }
// {any16} into the half that the register's operand names.
void immediate_half(Trial& t) { t.set_half(0, t.number(1)); }
template <int bits, bool sign>
void extend(Trial& t) {
  const Exact value = sign ? wrap(t.word(1), bits) : t.word(1) & ((Exact{1} << bits) - 1);
  t.set(0, value);
  t.logic_flags(static_cast<std::uint32_t>(value));
}

bool updated(std::int32_t how, bool old, bool with) {
  const bool results[] = {with, old || with, old && with, old != with};
  return results[how];
}
bool astat_bit(const Trial& t, int i) { return (t.before.astat() >> t.number(i) & 1) != 0; }

constexpr Law kLaws[] = {
    {"{D!} = {D}", copy},
    {"{P!} = {P@}", copy},
    {"{D!} = {P}", copy},
    {"{P!} = {D}", copy},
    {"{G!} = {G}",
     [](Trial& t) {
       const std::uint32_t value = register_value(t, t.number(1));
       set_any_register(t, t.number(0), value);
     }},
    {"{D!} = {imm7} {?(X)}", immediate},
    {"{P!} = {imm7} {?(X)}", immediate},
    {"{D!} = {imm16} {?(X)}", immediate},
    {"{P!} = {imm16} {?(X)}", immediate},
    {"{D!} = {uimm16} (Z)", immediate},
    {"{P!} = {uimm16} (Z)", immediate},
    {"{IMBL!} = {imm16} {?(X)}", immediate},
    {"{IMBL!} = {uimm16} (Z)", immediate},
    {"{Dl!} = {any16}", immediate_half},
    {"{Dh!} = {any16}", immediate_half},
    {"{Pl!} = {any16}", immediate_half},
    {"{Ph!} = {any16}", immediate_half},
    {"{D!} = {Dl} {?(Z)}", extend<16, false>},
    {"{D!} = {Dl} (X)", extend<16, true>},
    {"{D!} = {Db} {?(Z)}", extend<8, false>},
    {"{D!} = {Db} (X)", extend<8, true>},
    {"{D!} = CC", [](Trial& t) { t.set(0, t.before.cc); }},
    {"CC = {D}", [](Trial& t) { t.after.cc = t.word(0) != 0; }},
    {"CC = !CC", [](Trial& t) { t.after.cc = t.before.cc == 0; }},
    {"CC {upd} {flag}",
     [](Trial& t) { t.after.cc = updated(t.number(0), t.before.cc != 0, astat_bit(t, 1)); }},
    {"{flag} {upd} CC",
     [](Trial& t) {
       const std::uint32_t bit = 1U << t.number(0);
       const bool flag = updated(t.number(1), astat_bit(t, 0), t.before.cc != 0);
       t.after.set_astat(flag ? t.before.astat() | bit : t.before.astat() & ~bit);
     }},
    {"CC = BITTST({D}, {uimm5})", [](Trial& t) { t.after.cc = t.word(0) >> t.number(1) & 1; }},
    {"CC = !BITTST({D}, {uimm5})", [](Trial& t) { t.after.cc = ~t.word(0) >> t.number(1) & 1; }},
};

}  // namespace

std::span<const Law> move_laws() { return kLaws; }

void (*move_law_of(std::string_view syntax))(Trial&) {
  const bool compares = syntax.starts_with("CC = {") && (has(syntax, "==") || has(syntax, "<"));
  return compares                                            ? comparison
         : syntax.starts_with("IF ") && has(syntax, "+} = ") ? conditional_move
                                                             : nullptr;
}

}  // namespace finback::isa::laws
