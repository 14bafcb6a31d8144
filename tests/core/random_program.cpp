#include "random_program.hpp"

#include <fmt/format.h>
#include <random>
#include <vector>

#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::core {

namespace {

using isa::Instruction;
using isa::MemoryUse;
using isa::OperandKind;

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {
    const auto table = isa::instruction_table();
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (usable(static_cast<int>(i))) {
        usable_.push_back(static_cast<int>(i));
      }
    }
  }

  std::string program(int packets) {
    std::string body;
    for (int reg = 0; reg < 8; ++reg) {
      body += "R" + std::to_string(reg) + ".L = " + std::to_string(random_() % 65536) + "; R" +
              std::to_string(reg) + ".H = " + std::to_string(random_() % 65536) + ";\n";
    }
    body += "P5 = 3 (X); M0 = P5; P5 = 4 (X); M0 = P5; M1 = P5; M2 = P5; M3 = P5;\n";
    while (packets > 0) {
      const int length = 1 + static_cast<int>(random_() % 12);
      body += piece(length, 0);
      packets -= length;
    }
    const std::string leaves = leaf(0) + leaf(1);
    return ".text\n.global _start\n.type _start, @function\n_start:\n" + body +
           "IDLE;\nRTS;\n.size _start, .-_start\n" + leaves +
           ".data\n.align 4\n.type _buffer, @object\n_buffer: "
           ".space 16384\n.size "
           "_buffer, 16384\n";
  }

 private:
  // Not the flow, the system, the stack, nor registers whose wild values would lead out of the
  // buffer.
  static bool usable(int index) {
    const Instruction& info = isa::instruction_table()[static_cast<std::size_t>(index)];
    const std::uint32_t kFrames = isa::kReadsSp | isa::kWritesSp | isa::kReadsFp | isa::kWritesFp;
    if (info.flow != isa::Flow::none || (info.implicit & kFrames) != 0 ||
        info.memory == MemoryUse::load_store || info.syntax.starts_with("CLI") ||
        info.syntax.starts_with("CSYNC") || info.syntax.starts_with("DBG")) {
      return false;
    }
    for (const isa::OperandRole& role : isa::roles_of(index)) {
      if (role.kind == OperandKind::any || role.kind == OperandKind::system) {
        return false;
      }
    }
    return true;
  }

  // About `length` packets, `depth` hardware loops deep: straight, or with a loop, a branch over
  // some of it, a call, or the stack around it.
  std::string piece(int length, int depth) {
    const std::string label = ".Ll" + std::to_string(labels_++);
    switch (random_() % 10) {
      case 0:
      case 1:
      case 2: {
        if (depth == 2) {
          return straight(length);
        }
        // The inner of two loops is loop 1, and its count stands in a register of its own.
        const int unit = depth == 1 ? 1 : static_cast<int>(random_() % 2);
        const std::string inner = unit == 0 ? piece(length / 2 + 1, 1) : straight(length);
        return fmt::format("P5 = {} (X);\nLSETUP ({}t, {}e) LC{} = P5{};\n{}t:\n{}{}e:\nNOP;\n",
                           1 + random_() % 5, label, label, unit, random_() % 4 == 0 ? " >> 1" : "",
                           label, inner, label);
      }
      case 3:
      case 4:
        return fmt::format("{}IF {}CC JUMP {}{};\n{}{}:\nNOP;\n", compare(),
                           random_() % 2 == 0 ? "!" : "", label, random_() % 2 == 0 ? " (BP)" : "",
                           straight(length), label);
      case 5:
        return fmt::format("JUMP.S {};\n{}{}:\n", label, straight(1), label) + straight(length);
      case 6:
        return fmt::format("CALL _leaf{};\n", random_() % 2) + straight(length);
      case 7:
        return fmt::format("[--SP] = R{};\n{}R{} = [SP++];\n", random_() % 8, straight(length),
                           random_() % 8);
      case 8:
        return "[--SP] = (R7:4, P5:3);\nLINK 16;\n" + straight(length) +
               "UNLINK;\n(R7:4, P5:3) = [SP++];\n";
      default:
        return straight(length);
    }
  }
  std::string compare() {
    static constexpr const char* kRelations[] = {"==", "<", "<="};
    return fmt::format("CC = R{} {} R{};\n", random_() % 8, kRelations[random_() % 3],
                       random_() % 8);
  }
  std::string leaf(int number) {
    return fmt::format(
        ".type _leaf{0}, @function\n_leaf{0}:\n{1}RTS;\n.size _leaf{0}, .-_leaf{0}\n", number,
        straight(3));
  }

  std::string straight(int length) {
    std::string text;
    for (int i = 0; i < length; ++i) {
      text += packet();
    }
    return text;
  }

  // One instruction, or two or three together when the rules allow what was drawn.
  std::string packet() {
    std::string setup;
    std::string text = instruction(any(), setup);
    while (!legal(text)) {  // a load into its own stepping base register, say
      setup.clear();
      text = instruction(any(), setup);
    }
    if (random_() % 2 == 0) {
      std::string joined_setup;
      std::string joined = instruction(any_in(isa::Slot::dsp), joined_setup);
      joined += " || " + instruction(any_in(isa::Slot::access), joined_setup);
      if (random_() % 2 == 0) {
        joined += " || " + instruction(any_in(isa::Slot::index_access), joined_setup);
      }
      if (legal(joined)) {
        return joined_setup + joined + ";\n";
      }
    }
    return setup + text + ";\n";
  }

  static bool legal(const std::string& packet) {
    return ir::problems(ir::parse(".bir 1\n.text\n.type _f, @function\n_f: " + packet + ";\nRTS;\n",
                                  "random"),
                        isa::instruction_syntax())
        .empty();
  }

  int any() { return usable_[random_() % usable_.size()]; }
  int any_in(isa::Slot slot) {
    for (;;) {
      const int index = any();
      if (isa::instruction_table()[static_cast<std::size_t>(index)].slot == slot) {
        return index;
      }
    }
  }

  // The text of entry `index` with operands drawn; `setup` gets what points its base register into
  // the buffer.
  std::string instruction(int index, std::string& setup) {
    const isa::OperandRoles& roles = isa::roles_of(index);
    const bool access =
        isa::instruction_table()[static_cast<std::size_t>(index)].memory != MemoryUse::none;
    isa::ParsedInstruction parsed;
    parsed.instruction = index;
    bool base_set = false;
    for (int i = 0; i < roles.count; ++i) {
      std::int32_t& number = parsed.operand[static_cast<std::size_t>(i)].number;
      do {  // a step register is not its own base
        number = draw(roles[i].kind);
      } while (access && i > 0 && roles[i].address_stage && roles[i - 1].address_stage &&
               number == parsed.operand[static_cast<std::size_t>(i - 1)].number);
      if (!access || !roles[i].address_stage) {
        continue;
      }
      const std::string name(isa::register_name(static_cast<isa::Register>(number)));
      const std::string value =
          base_set ? "4" : "_buffer + " + std::to_string(8192 + 4 * (random_() % 512));
      if (roles[i].kind != OperandKind::modify) {
        setup += fmt::format("{}.L = {}; {}.H = {};\n", name, value, name, base_set ? "0" : value);
      }
      base_set = true;
    }
    return isa::instruction_syntax().print(parsed);
  }

  std::int32_t draw(OperandKind kind) {
    const auto pick = [this](int from, int count) {
      return from + static_cast<int>(random_() % static_cast<unsigned>(count));
    };
    switch (kind) {
      case OperandKind::data:
      case OperandKind::data_low:
      case OperandKind::data_byte:
        return pick(isa::R0, 8);
      case OperandKind::data_high:
        return pick(isa::R0, 8) | isa::kHighHalf;
      case OperandKind::data_half:
        return pick(isa::R0, 8) | (random_() % 2 == 0 ? isa::kHighHalf : 0);
      case OperandKind::pointer:
      case OperandKind::pointer_low:
        return pick(isa::P0, 5);
      case OperandKind::pointer_high:
        return pick(isa::P0, 5) | isa::kHighHalf;
      case OperandKind::index:
        return pick(isa::I0, 4);
      case OperandKind::modify:
        return pick(isa::M0, 4);
      case OperandKind::offset16:
      case OperandKind::offset16x2:
      case OperandKind::offset16x4:
        return 4 * (static_cast<int>(random_() % 1024) - 512);
      default: {
        const auto values = isa::sample_values(kind);
        return values[random_() % values.size()].number;
      }
    }
  }

  std::mt19937 random_;
  std::vector<int> usable_;
  int labels_ = 0;
};

}  // namespace

std::string random_program(std::uint32_t seed, int packets) {
  return Generator(seed).program(packets);
}

}  // namespace finback::core
