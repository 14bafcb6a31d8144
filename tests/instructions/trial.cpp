#include "trial.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <isa_sim/core/placed.hpp>

namespace finback::isa::laws {

namespace {

// The time that CYCLES reads as.
constexpr std::uint32_t kCycles = 0x12345;
constexpr std::uint32_t kCycles2 = 7;

struct Around {
  Actions actions;

  static void system(ExecutionState& state, const Operation&, SystemAction action,
                     std::uint32_t value) {
    if (action == SystemAction::read_cycles) {
      state.reg[CYCLES] = kCycles;
      state.reg[CYCLES2] = kCycles2;
      return;
    }
    static_cast<Around*>(state.engine)->actions.emplace_back(action, value);
  }
  static bool test_and_set(ExecutionState&, const Operation& o, Address address,
                           std::uint8_t& old) {
    std::uint8_t& byte = o.window->bytes[address - o.window->base];
    old = byte;
    byte |= 0x80;
    return true;
  }
};

bool is_supervisors(int reg) {
  return reg == USP || reg == SEQSTAT || reg == SYSCFG || (reg >= RETI && reg <= RETE);
}

std::string differences(const Trial& trial, const ExecutionState& actual) {
  std::string text;
  const auto differ = [&](std::string_view name, Exact is, Exact must) {
    if (is != must) {
      text += fmt::format(" {} is {:#x}, must be {:#x};", name, is, must);
    }
  };
  for (int i = 0; i < kRegisterCount; ++i) {
    const auto index = static_cast<std::size_t>(i);
    differ(register_name(static_cast<Register>(i)), actual.reg[index], trial.after.reg[index]);
  }
  differ("A0", actual.accumulator[0], trial.after.accumulator[0]);
  differ("A1", actual.accumulator[1], trial.after.accumulator[1]);
  differ("ASTAT", actual.astat(), trial.after.astat());
  differ("the next address", actual.next_address, trial.after.next_address);
  differ("IMASK", actual.interrupt_mask, trial.after.interrupt_mask);
  return text;
}

std::string describe(const Trial& trial) {
  std::string text = disassemble(trial.entry, trial.operand);
  text += fmt::format(" with A0 {:#x} A1 {:#x} ASTAT {:#x}", trial.before.accumulator[0],
                      trial.before.accumulator[1], trial.before.astat());
  int i = 0;
  for (const OperandRole& role : roles_of(trial.entry)) {
    if (is_register(role.kind)) {
      text += fmt::format(" {} {:#x}", register_name(static_cast<Register>(trial.reg(i))),
                          trial.word(i));
    }
    ++i;
  }
  return text;
}

}  // namespace

void Trial::set_half(int i, Exact result) {
  std::uint32_t& target = after.reg[static_cast<std::size_t>(reg(i))];
  const auto bits = static_cast<std::uint32_t>(result & 0xffff);
  target = is_high_half(number(i)) ? (target & 0xffff) | bits << 16 : (target & 0xffff0000) | bits;
}

std::uint32_t Trial::load(Address address, int bytes) const {
  std::uint32_t result = 0;
  for (int i = bytes - 1; i >= 0; --i) {
    result = result << 8 | memory_before.at(address - kMemory + static_cast<std::size_t>(i));
  }
  return result;
}

void Trial::store(Address address, int bytes, std::uint32_t stored) {
  for (int i = 0; i < bytes; ++i) {
    memory.at(address - kMemory + static_cast<std::size_t>(i)) =
        static_cast<std::uint8_t>(stored >> (8 * i));
  }
}

bool fits(Exact exact, int bits) { return nearest(exact, bits) == exact; }

Exact nearest(Exact exact, int bits) {
  const Exact limit = Exact{1} << (bits - 1);
  return std::clamp(exact, -limit, limit - 1);
}

Exact wrap(Exact exact, int bits) {
  const Exact modulus = Exact{1} << bits;
  const Exact low = exact & (modulus - 1);
  return low >= modulus / 2 ? low - modulus : low;
}

std::uint32_t register_value(Trial& trial, int reg) {
  const ExecutionState& s = trial.before;
  if (is_supervisors(reg)) {
    trial.act(SystemAction::privileged);
  }
  switch (reg) {
    case ASTAT:
      return s.astat();
    case CYCLES:
      trial.set_register(CYCLES, kCycles);
      trial.set_register(CYCLES2, kCycles2);
      return kCycles;
    case A0X:
    case A1X:
      return static_cast<std::uint32_t>(s.accumulator[reg == A1X] >> 32);
    case A0W:
    case A1W:
      return static_cast<std::uint32_t>(s.accumulator[reg == A1W]);
    default:
      return s.reg[static_cast<std::size_t>(reg)];
  }
}

void set_any_register(Trial& trial, int reg, std::uint32_t value) {
  if (is_supervisors(reg)) {
    trial.act(SystemAction::privileged);
  }
  const auto sum = [&](int unit) -> Exact& {
    return trial.after.accumulator[static_cast<std::size_t>(unit)];
  };
  switch (reg) {
    case ASTAT:
      trial.after.set_astat(value);
      break;
    case A0X:
    case A1X:
      sum(reg == A1X) = (sum(reg == A1X) & 0xffffffff) + wrap(value, 8) * (Exact{1} << 32);
      break;
    case A0W:
    case A1W:
      sum(reg == A1W) = (sum(reg == A1W) >> 32) * (Exact{1} << 32) + value;
      break;
    case LT0:
    case LT1:
      trial.set_register(reg, value & ~1U);
      break;
    case LB0:
    case LB1:
      trial.set_register(reg, value);
      trial.act(SystemAction::loop_bottom, value);
      break;
    case CYCLES:
      trial.act(SystemAction::write_cycles, value);
      break;
    case CYCLES2:
      trial.act(SystemAction::write_cycles2, value);
      break;
    case SEQSTAT:
      break;  // read-only
    case SYSCFG:
      trial.set_register(reg, value);
      trial.act(SystemAction::configure);
      break;
    default:
      trial.set_register(reg, value);
  }
}

std::string run(Trial& trial, void (*law)(Trial&)) {
  const Instruction& info = instruction_table()[static_cast<std::size_t>(trial.entry)];
  trial.after = trial.before;
  trial.memory = trial.memory_before;
  law(trial);

  std::vector<std::uint8_t> bytes = trial.memory_before;
  MemoryWindow window;
  window.base = Trial::kMemory;
  window.size = Trial::kMemoryBytes;
  window.bytes = bytes.data();
  Around around;
  const EngineHooks hooks{nullptr, nullptr, nullptr, Around::test_and_set, Around::system};
  ir::PlacedPacket packet;
  packet.address = Trial::kPlace;
  packet.length = static_cast<std::uint8_t>(info.length);
  packet.count = 1;
  packet.slots[0] = {trial.entry, trial.operand};
  Operation operation = core::operation_of(packet.slots[0], packet);
  operation.window = &window;
  ExecutionState actual = trial.before;
  actual.hooks = &hooks;
  actual.engine = &around;
  static_cast<void>(operation.execute(actual, &operation));

  std::string problem = differences(trial, actual);
  if (bytes != trial.memory) {
    problem += " memory differs;";
  }
  if (around.actions != trial.actions) {
    problem += " it asks other things of the system;";
  }
  return problem.empty() ? "" : describe(trial) + ":" + problem;
}

// ---- draws
// ---------------------------------------------------------------------------------------------------

Draws::Draws(int entry, std::uint32_t seed)
    : entry_(entry), state_(seed * 2654435761U + static_cast<std::uint32_t>(entry)) {}

std::uint32_t Draws::draw_word() {
  static constexpr std::array<std::uint32_t, 24> kEdges = {
      0,          1,          0xffffffff, 0x7fffffff, 0x80000000, 0x80000001,
      0x7fff,     0x8000,     0xffff8000, 0x00010000, 0xffff0000, 0x80008000,
      0x7fff7fff, 0x7fff8000, 0x80007fff, 0x00010001, 0xffff0001, 31,
      32,         0xffffffe0, 0xffffffe1, 0x40000000, 0xc0000000, 0x55aa33cc};
  return below(4) == 0 ? random() ^ random() >> 16 : kEdges[below(kEdges.size())];
}

void Draws::draw_state(ExecutionState& state) {
  static constexpr std::array<Exact, 14> kSums = {0,
                                                  1,
                                                  -1,
                                                  0x7fff,
                                                  0x8000,
                                                  0x18000,
                                                  0x7fffffff,
                                                  0x80000000,
                                                  -0x80000000LL,
                                                  -0x80000001LL,
                                                  0x7fffffffff,
                                                  -0x8000000000LL,
                                                  0x123456789a,
                                                  -0x123456789aLL};
  for (int i = 0; i < kRegisterCount; ++i) {
    state.reg[static_cast<std::size_t>(i)] = draw_word();
  }
  for (Exact& sum : state.accumulator) {
    sum = below(4) == 0 ? wrap(static_cast<Exact>(random()) << 13 ^ random(), 40)
                        : kSums[below(kSums.size())];
  }
  state.set_astat(random() ^ random() >> 13);
  state.interrupt_mask = below(0x10000);
  state.time = 1'000'000;
}

// Registers from a small set, so that some are the same; a register that an address comes from
// points into memory.
std::int32_t Draws::draw_operand(const OperandRole& role) {
  const auto half = [this] { return below(2) == 0 ? 0 : kHighHalf; };
  const auto of = [this](int first, std::size_t count) {
    return first + static_cast<std::int32_t>(below(count));
  };
  switch (role.kind) {
    case OperandKind::data:
    case OperandKind::data_low:
    case OperandKind::data_byte:
      return of(R0, 4);
    case OperandKind::data_high:
      return of(R0, 4) | kHighHalf;
    case OperandKind::data_half:
      return of(R0, 4) | half();
    case OperandKind::data_even:
      return 2 * of(0, 4);
    case OperandKind::data_odd:
      return 2 * of(0, 4) + 1;
    case OperandKind::pointer:
      return of(P0, 4);
    case OperandKind::any:
      return of(R0, ASTAT + 1);
    default:
      break;
  }
  const std::vector<OperandValue> samples = sample_values(role.kind);
  const OperandValue& sample = samples[below(samples.size())];
  return sample.symbol.empty() ? sample.number
                               : static_cast<std::int32_t>(Trial::kPlace) + 8 +
                                     2 * static_cast<std::int32_t>(below(8));
}

// The rules that the verifier has for single instructions, and no step by the stepped register.
bool Draws::legal(const OperandNumbers& operand) const {
  const Instruction& info = instruction_table()[static_cast<std::size_t>(entry_)];
  if (info.check != nullptr && !info.check(operand).empty()) {
    return false;
  }
  const OperandRoles& roles = roles_of(entry_);
  for (int i = 0; i < roles.count; ++i) {
    for (int j = 0; j < i; ++j) {
      const auto one = operand[static_cast<std::size_t>(i)];
      const auto other = operand[static_cast<std::size_t>(j)];
      const bool both = is_register(roles[i].kind) && is_register(roles[j].kind);
      const bool same = both && register_of(one) == register_of(other);
      const bool halves = same && (one ^ other) == kHighHalf;
      const bool written = roles[i].written && roles[j].written;
      const bool stepped = roles[i].address_stage != roles[j].address_stage &&
                           ((roles[i].address_stage && roles[j].written) ||
                            (roles[j].address_stage && roles[i].written));
      if (same && ((written && !halves) || (stepped && info.memory != MemoryUse::none))) {
        return false;
      }
    }
  }
  return true;
}

Trial Draws::draw() {
  Trial trial;
  trial.entry = entry_;
  const Instruction& info = instruction_table()[static_cast<std::size_t>(entry_)];
  trial.syntax = info.syntax;
  trial.length = info.length;
  const OperandRoles& roles = roles_of(entry_);
  do {
    for (int i = 0; i < roles.count; ++i) {
      trial.operand[static_cast<std::size_t>(i)] = draw_operand(roles[i]);
    }
  } while (!legal(trial.operand));
  draw_state(trial.before);
  trial.before.next_address = Trial::kPlace + static_cast<Address>(info.length);
  if (info.memory != MemoryUse::none) {
    // Pointers and index registers to the middle; steps and lengths small.
    for (int i = P0; i <= I3; ++i) {
      trial.before.reg[static_cast<std::size_t>(i)] =
          Trial::kMemory + Trial::kMemoryBytes / 2 + 4 * below(8);
    }
    int i = 0;
    std::int32_t base = -1;
    for (const OperandRole& role : roles) {
      const std::int32_t number = trial.operand[static_cast<std::size_t>(i++)];
      if (is_register(role.kind) && role.address_stage) {
        if (base >= 0 && number != base) {
          trial.before.reg[static_cast<std::size_t>(number)] = 4 * below(5) - 8;
        }
        base = number;
      } else if (immediate_range(role.kind) && role.kind != OperandKind::frame18x4) {
        // The base moves so that base + offset lies inside.
        for (std::size_t p = P0; p <= FP; ++p) {
          trial.before.reg[p] =
              Trial::kMemory + Trial::kMemoryBytes / 2 - static_cast<std::uint32_t>(number);
        }
      }
    }
    for (std::size_t l = L0; l <= L3; ++l) {
      trial.before.reg[l] = below(2) == 0 ? 0 : 16;
      trial.before.reg[l - L0 + B0] = Trial::kMemory + Trial::kMemoryBytes / 2;
    }
  }
  if (info.memory == MemoryUse::none) {
    // Circular buffers that fit into the address space, with an index inside and a short step.
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t base = random() >> 3;
      const std::uint32_t length = below(2) == 0 ? 0 : 64;
      trial.before.reg[B0 + i] = base;
      trial.before.reg[L0 + i] = length;
      trial.before.reg[I0 + i] = length == 0 ? draw_word() : base + below(length);
      trial.before.reg[M0 + i] = below(2) == 0 ? below(64) : 0U - below(64);
    }
  }
  trial.memory_before.resize(Trial::kMemoryBytes);
  std::ranges::generate(trial.memory_before,
                        [this] { return static_cast<std::uint8_t>(random() >> 11); });
  return trial;
}

}  // namespace finback::isa::laws
