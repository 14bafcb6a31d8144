// Loads and stores by what their patterns say: width, extension, destination and step are read from
// the text. Stacks and frames by hand.
#include "laws.hpp"
#include <isa_sim/isa/registers.hpp>

namespace finback::isa::laws {

namespace {

// What stands inside the brackets, and to the left and right of the sign of equality.
struct Access {
  std::string_view inside;
  std::string_view left;
  bool loads = false;
  int bytes = 4;
};
Access access_of(std::string_view syntax) {
  Access access;
  const std::size_t open = syntax.find('[');
  access.inside = syntax.substr(open + 1, syntax.find(']') - open - 1);
  access.left = syntax.substr(0, syntax.find(" = "));
  access.loads = !has(access.left, "[");
  const char letter = open == 0 ? ' ' : syntax[open - 1];
  access.bytes = letter == 'B' ? 1 : letter == 'W' ? 2 : 4;
  return access;
}

// Post-modify, inside the circular buffer where the index register has one; buffers lie so that no
// sum leaves 32 bits.
Exact stepped(const Trial& t, int base, Exact step) {
  Exact next = t.before.reg[static_cast<std::size_t>(base)] + step;
  if (base >= I0 && base <= I3) {
    const auto number = static_cast<std::size_t>(base - I0);
    const Exact length = t.before.reg[L0 + number];
    const Exact first = t.before.reg[B0 + number];
    if (length != 0 && step >= 0 && next >= first + length) {
      next -= length;
    } else if (length != 0 && step < 0 && next < first) {
      next += length;
    }
  }
  return next;
}

void access_law(Trial& t) {
  const Access access = access_of(t.syntax);
  const bool frame = access.inside.starts_with("FP");
  int i = access.loads ? 1 : 0;
  const int base = frame ? static_cast<int>(FP) : t.reg(i++);
  Address address = t.before.reg[static_cast<std::size_t>(base)];
  if (has(access.inside, " + {")) {
    address += static_cast<Address>(t.number(i++));
  } else if (has(access.inside, "}++{")) {
    const Exact step = t.reg(i) == base ? 0 : t.value(i);
    t.set_register(base, stepped(t, base, step));
    ++i;
  } else if (access.inside.ends_with("++") || access.inside.ends_with("--")) {
    t.set_register(base,
                   stepped(t, base, access.inside.ends_with("++") ? access.bytes : -access.bytes));
  }
  if (access.loads) {
    const std::uint32_t loaded = t.load(address, access.bytes);
    if (has(access.left, "{Dl") || has(access.left, "{Dh")) {
      t.set_half(0, loaded);
    } else {
      t.set(0, has(t.syntax, "(X)") ? wrap(loaded, 8 * access.bytes) : Exact{loaded});
    }
    return;
  }
  t.store(address, access.bytes, has(t.syntax, "{Dh}") ? t.word(i) >> 16 : t.word(i));
}

// ---- stack
// ---------------------------------------------------------------------------------------------------

void push_list(Trial& t, int first_data, int first_pointer) {
  Address address = t.before.reg[SP];
  for (int reg = R0 + first_data; reg <= R7; ++reg) {
    t.store(address -= 4, 4, t.before.reg[static_cast<std::size_t>(reg)]);
  }
  for (int reg = P0 + first_pointer; reg <= P5; ++reg) {
    t.store(address -= 4, 4, t.before.reg[static_cast<std::size_t>(reg)]);
  }
  t.set_register(SP, address);
}
void pop_list(Trial& t, int first_data, int first_pointer) {
  Address address = t.before.reg[SP];
  const auto take = [&](int reg) {
    t.set_register(reg, t.load(address, 4));
    address += 4;
  };
  for (int reg = P5; reg >= P0 + first_pointer; --reg) {
    take(reg);
  }
  for (int reg = R7; reg >= R0 + first_data; --reg) {
    take(reg);
  }
  t.set_register(SP, address);
}
constexpr int kNoData = 8;
constexpr int kNoPointer = 6;

void link_law(Trial& t) {
  const Address sp = t.before.reg[SP];
  t.store(sp - 4, 4, t.before.reg[RETS]);
  t.store(sp - 8, 4, t.before.reg[FP]);
  t.set_register(FP, sp - 8);
  t.set_register(SP, sp - 8 - static_cast<Address>(t.number(0)));
}
void unlink_law(Trial& t) {
  const Address fp = t.before.reg[FP];
  t.set_register(RETS, t.load(fp + 4, 4));
  t.set_register(SP, fp + 8);
  t.set_register(FP, t.load(fp, 4));
}

constexpr Law kLaws[] = {
    {"[--SP] = {G}",
     [](Trial& t) {
       t.store(t.before.reg[SP] - 4, 4, register_value(t, t.number(0)));
       t.set_register(SP, Exact{t.before.reg[SP]} - 4);
       if (t.number(0) == RETI) {
         t.act(SystemAction::saved_return);
       }
     }},
    {"{G!} = [SP++]",
     [](Trial& t) {
       if (t.number(0) == USP) {
         t.act(SystemAction::pop_usp);
       }
       set_any_register(t, t.number(0), t.load(t.before.reg[SP], 4));
       t.set_register(SP, Exact{t.before.reg[SP]} + 4);
       if (t.number(0) == RETI) {
         t.act(SystemAction::loaded_return);
       }
     }},
    {"[--SP] = ({Dlist}, {Plist})", [](Trial& t) { push_list(t, t.number(0), t.number(1)); }},
    {"[--SP] = ({Dlist})", [](Trial& t) { push_list(t, t.number(0), kNoPointer); }},
    {"[--SP] = ({Plist})", [](Trial& t) { push_list(t, kNoData, t.number(0)); }},
    {"({Dlist!}, {Plist!}) = [SP++]", [](Trial& t) { pop_list(t, t.number(0), t.number(1)); }},
    {"({Dlist!}) = [SP++]", [](Trial& t) { pop_list(t, t.number(0), kNoPointer); }},
    {"({Plist!}) = [SP++]", [](Trial& t) { pop_list(t, kNoData, t.number(0)); }},
    {"LINK {frame}", link_law},
    {"UNLINK", unlink_law},
};

}  // namespace

std::span<const Law> memory_laws() { return kLaws; }

void (*access_law_of(std::string_view syntax))(Trial&) {
  if (!has(syntax, " = ")) {
    return nullptr;
  }
  return has(syntax, "[{P@") || has(syntax, "[{I@") || has(syntax, "[FP + ") ? access_law : nullptr;
}

}  // namespace finback::isa::laws
