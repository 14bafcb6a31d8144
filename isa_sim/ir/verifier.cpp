#include <algorithm>
#include <array>
#include <bitset>
#include <fmt/format.h>
#include <set>

#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::ir {
namespace {

using isa::Flow;
using isa::Instruction;
using isa::MemoryUse;
using isa::OperandKind;
using isa::OperandRole;
using isa::OperandRoles;
using isa::Slot;

// Registers, and apart from them the halves of data registers: two instructions of a packet may not
// write the same register, while one may write both of its halves.
using RegisterSet = std::bitset<isa::kRegisterCount>;

bool stores(const Instruction& form) {
  return form.memory == MemoryUse::store || form.memory == MemoryUse::load_store;
}

class Verifier {
 public:
  Verifier(const Program& program, const isa::Syntax& syntax)
      : program_(program), syntax_(syntax) {}

  std::vector<std::string> run() {
    for (const Function& function : program_.functions) {
      verify_function(function);
    }
    for (const Piece& piece : program_.pieces) {
      for (const PiecePacket& at : piece.packets) {
        verify_packet(at.packet);
      }
    }
    for (const Object& object : program_.objects) {
      if (object.size == 0) {
        report(object.written, fmt::format("object {} has no bytes", object.name));
      }
    }
    verify_symbols();
    return std::move(problems_);
  }

 private:
  void report(const SourcePlace& place, const std::string& message) {
    problems_.push_back(place.to_string() + ": " + message);
  }

  [[nodiscard]] const Instruction& form(const ParsedInstruction& instruction) const {
    return syntax_.table()[static_cast<std::size_t>(instruction.instruction)];
  }

  // --- packets ---

  void verify_function(const Function& function) {
    if (function.packets.empty()) {
      report(function.written, fmt::format("function {} has no instructions", function.name));
      return;
    }
    for (std::size_t i = 0; i < function.packets.size(); ++i) {
      const Packet& packet = function.packets[i];
      verify_packet(packet);
      if (form(packet.slots[0]).flow == Flow::loop_setup) {
        verify_loop(function, i);
      }
    }
    verify_end(function);
  }

  void verify_packet(const Packet& packet) {
    if (packet.slots.size() > 1) {
      verify_slots(packet);
      verify_anomaly(packet);
    }
    verify_operands(packet);
    verify_destinations(packet);
  }

  void verify_slots(const Packet& packet) {
    int dsp = 0;
    int access = 0;
    int others = 0;
    int stored = 0;
    for (const ParsedInstruction& instruction : packet.slots) {
      const Instruction& entry = form(instruction);
      stored += stores(entry) ? 1 : 0;
      switch (entry.slot) {
        case Slot::alone:
          report(packet.written,
                 fmt::format("'{}' issues alone, never in a packet", syntax_.print(instruction)));
          return;
        case Slot::dsp:
          ++dsp;
          break;
        case Slot::access:
          ++access;
          ++others;
          break;
        default:
          ++others;
      }
    }
    if (packet.slots.size() > 3) {
      report(packet.written, fmt::format("at most three instructions issue together, here are {}",
                                         packet.slots.size()));
    } else if (dsp > 1) {
      report(packet.written,
             "at most one 32-bit DSP instruction issues in a packet: it takes slot 0");
    } else if (others > 2) {
      report(packet.written,
             "at most two 16-bit instructions issue in a packet: slots 1 and 2; slot 0 takes a "
             "32-bit DSP instruction or MNOP");
    } else if (access > 1) {
      report(packet.written,
             "at most one access through a P register, SP or FP (or change of an I register) "
             "issues in a packet: the other must go through an I register");
    }
    if (stored > 1) {
      report(packet.written, "at most one store issues in a packet");
    }
  }

  // The rules of single instructions, such as results that go to neighbours.
  void verify_operands(const Packet& packet) {
    for (const ParsedInstruction& instruction : packet.slots) {
      const isa::Check check = form(instruction).check;
      if (check == nullptr) {
        continue;
      }
      isa::OperandNumbers numbers{};
      std::ranges::transform(instruction.operand, numbers.begin(), &OperandValue::number);
      if (const std::string_view problem = check(numbers); !problem.empty()) {
        report(packet.written, fmt::format("'{}': {}", syntax_.print(instruction), problem));
      }
    }
  }

  // Anomaly 05000074: an immediate shift in slot 0 with a store of a P register in slot 1.
  void verify_anomaly(const Packet& packet) {
    bool shift = false;
    bool pointer_stored = false;
    for (const ParsedInstruction& instruction : packet.slots) {
      const Instruction& entry = form(instruction);
      const OperandRoles& roles = syntax_.roles(instruction.instruction);
      shift = shift ||
              (entry.slot == Slot::dsp && std::ranges::any_of(roles, [](const OperandRole& role) {
                 return isa::immediate_range(role.kind).has_value();
               }));
      pointer_stored = pointer_stored ||
                       (stores(entry) && std::ranges::any_of(roles, [](const OperandRole& role) {
                          return role.kind == OperandKind::pointer && !role.address_stage;
                        }));
    }
    if (shift && pointer_stored) {
      report(packet.written,
             "an immediate shift and a store of a P register do not issue together (anomaly "
             "05000074)");
    }
  }

  // The registers that one instruction writes; complains when it writes one twice.
  RegisterSet destinations(const Packet& packet, const ParsedInstruction& instruction) {
    RegisterSet whole;
    RegisterSet low;
    RegisterSet high;
    const OperandRoles& roles = syntax_.roles(instruction.instruction);
    const auto write = [&](RegisterSet& set, int reg) {
      const auto bit = static_cast<std::size_t>(reg);
      const bool taken = set[bit] || whole[bit] || (&set == &whole && (low[bit] || high[bit]));
      if (taken) {
        report(packet.written, fmt::format("'{}' writes {} twice", syntax_.print(instruction),
                                           isa::register_name(static_cast<isa::Register>(reg))));
      }
      set.set(bit);
    };
    for (int i = 0; i < roles.count; ++i) {
      if (!roles[i].written) {
        continue;
      }
      const int value = instruction.operand[static_cast<std::size_t>(i)].number;
      write_operand(roles[i].kind, value, [&](int reg, int part) {
        write(part == 0 ? whole : (part > 0 ? high : low), reg);
      });
    }
    const std::uint32_t implicit = form(instruction).implicit;
    static constexpr std::array<std::pair<std::uint32_t, int>, 6> kImplicit = {
        std::pair{isa::kWritesCc, isa::CC}, {isa::kWritesSp, isa::SP}, {isa::kWritesFp, isa::FP},
        {isa::kWritesRets, isa::RETS},      {isa::kWritesA0, isa::A0}, {isa::kWritesA1, isa::A1}};
    for (const auto& [flag, reg] : kImplicit) {
      if ((implicit & flag) != 0) {
        whole.set(static_cast<std::size_t>(reg));
      }
    }
    return whole | low | high;
  }

  // Calls write(register, part) for each register of an operand; part -1: low half, 1: high.
  static void write_operand(OperandKind kind, int value, const auto& write) {
    switch (kind) {
      case OperandKind::data_pair:
        write(value, 0);
        write(value + 1, 0);
        break;
      case OperandKind::data_list:
        for (int reg = isa::R0 + value; reg <= isa::R7; ++reg) {
          write(reg, 0);
        }
        break;
      case OperandKind::pointer_list:
        for (int reg = isa::P0 + value; reg <= isa::P5; ++reg) {
          write(reg, 0);
        }
        break;
      case OperandKind::data_low:
      case OperandKind::data_high:
      case OperandKind::data_half:
      case OperandKind::pointer_low:
      case OperandKind::pointer_high:
        write(isa::register_of(value), isa::is_high_half(value) ? 1 : -1);
        break;
      default:
        write(value, 0);
    }
  }

  void verify_destinations(const Packet& packet) {
    RegisterSet written;
    for (const ParsedInstruction& instruction : packet.slots) {
      const RegisterSet own = destinations(packet, instruction);
      const RegisterSet both = written & own;
      for (int reg = 0; reg < isa::kRegisterCount && both.any(); ++reg) {
        if (both[static_cast<std::size_t>(reg)]) {
          report(packet.written, fmt::format("two instructions of this packet write {}",
                                             isa::register_name(static_cast<isa::Register>(reg))));
        }
      }
      written |= own;
    }
  }

  // --- loops and ends ---

  // LSETUP's labels are operands 0 (top) and 1 (bottom: the last instruction of the loop).
  void verify_loop(const Function& function, std::size_t setup) {
    const Packet& packet = function.packets[setup];
    std::array<std::size_t, 2> at{};
    for (std::size_t i = 0; i < at.size(); ++i) {
      const OperandValue& label = packet.slots[0].operand[i];
      const auto found = function.labels.find(label.symbol);
      if (found == function.labels.end() || label.number != 0 ||
          found->second >= function.packets.size()) {
        report(packet.written,
               fmt::format("the {} of this loop, {}, is no label before an instruction of {}",
                           i == 0 ? "top" : "bottom", label.symbol, function.name));
        return;
      }
      at[i] = found->second;
    }
    if (at[0] <= setup || at[1] < at[0]) {
      report(packet.written,
             "a loop's top stands after its LSETUP, and its bottom not before its "
             "top");
      return;
    }
    const Packet& last = function.packets[at[1]];
    const Flow flow = form(last.slots[0]).flow;
    if (flow != Flow::none && flow != Flow::idle && flow != Flow::event) {
      report(last.written,
             fmt::format("the last instruction of a hardware loop is no branch, call, return or "
                         "loop set-up, but this is '{}': end the loop with a NOP",
                         syntax_.print(last.slots[0])));
    }
  }

  // What runs must not run out of its function.
  void verify_end(const Function& function) {
    const Packet& last = function.packets.back();
    switch (form(last.slots[0]).flow) {
      case Flow::jump:
      case Flow::jump_indirect:
      case Flow::ret:
      case Flow::ret_event:
      case Flow::call:  // of a function that never returns
      case Flow::call_indirect:
      case Flow::event:  // a trap
        return;
      default:
        report(last.written, fmt::format("{} runs on past its last instruction: end it with RTS or "
                                         "a jump",
                                         function.name));
    }
  }

  // --- symbols ---

  void verify_symbols() {
    std::set<std::string_view> symbols;
    for (const Function& function : program_.functions) {
      verify_unique(symbols, function.name, function.written);
    }
    for (const Object& object : program_.objects) {
      verify_unique(symbols, object.name, object.written);
    }
    for (const Function& function : program_.functions) {
      for (const auto& [label, packet] : function.labels) {
        if (symbols.contains(label)) {
          report(function.written, fmt::format("label {} of {} is a function or an object, too",
                                               label, function.name));
        }
      }
    }
    verify_labels(symbols);
  }

  void verify_unique(std::set<std::string_view>& symbols, std::string_view name,
                     const SourcePlace& place) {
    if (!symbols.insert(name).second) {
      report(place, fmt::format("{} is defined twice in this file", name));
    }
  }

  // Labels of the form .Lx can only be of this file.
  void verify_labels(const std::set<std::string_view>& symbols) {
    std::set<std::string_view> labels;
    for (const Function& function : program_.functions) {
      for (const auto& [label, packet] : function.labels) {
        labels.insert(label);
      }
    }
    for (const Function& function : program_.functions) {
      for (const Packet& packet : function.packets) {
        for (const ParsedInstruction& instruction : packet.slots) {
          const isa::OperandRoles& roles = isa::roles_of(instruction.instruction);
          for (int i = 0; i < roles.count; ++i) {
            const OperandValue& value = instruction.operand[static_cast<std::size_t>(i)];
            const bool elsewhere =
                !isa::is_code_address(roles[i].kind) && labels.contains(value.symbol);
            if (value.symbol.starts_with(".L") && !function.labels.contains(value.symbol) &&
                !symbols.contains(value.symbol) && !elsewhere) {
              report(packet.written,
                     fmt::format("{} has no label {}", function.name, value.symbol));
            }
          }
        }
      }
    }
    for (const Object& object : program_.objects) {
      for (const Relocation& relocation : object.relocations) {
        if (relocation.symbol.starts_with(".L") && !symbols.contains(relocation.symbol) &&
            !labels.contains(relocation.symbol)) {
          report(object.written, fmt::format("{} takes the address of {}, which is nowhere in this "
                                             "file",
                                             object.name, relocation.symbol));
        }
      }
    }
  }

  const Program& program_;
  const isa::Syntax& syntax_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> problems(const Program& program, const isa::Syntax& syntax) {
  return Verifier(program, syntax).run();
}

void verify(const Program& program, const isa::Syntax& syntax) {
  const std::vector<std::string> found = problems(program, syntax);
  if (found.size() > 1) {
    throw InputError(fmt::format("{} (and {} more)", found[0], found.size() - 1));
  }
  if (!found.empty()) {
    throw InputError(found[0]);
  }
}

void verify(const Program& program) { verify(program, isa::instruction_syntax()); }

}  // namespace finback::ir
