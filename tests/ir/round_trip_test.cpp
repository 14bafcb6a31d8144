// What is printed says the same when it is read, and prints to the same bytes: for a written
// example and for programs made at random from the instruction table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <tests/ir/support.hpp>

#include <isa_sim/ir/printer.hpp>

namespace finback::ir {
namespace {

using isa::OperandKind;
using isa::Slot;

void expect_round_trip(const Program& original) {
  const std::string text = print(original);
  Program again;
  ASSERT_EQ(error_of([&] { again = parse(text, "again.bir"); }), "") << text;
  EXPECT_TRUE(same_program(original, again)) << text;
  EXPECT_EQ(print(again), text);
}

// Random programs: any instruction of the table with sampled operands, lawful packets, data.
class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {
    const auto table = isa::instruction_table();
    for (std::size_t i = 0; i < table.size(); ++i) {
      by_slot_[static_cast<std::size_t>(table[i].slot)].push_back(static_cast<int>(i));
    }
  }

  Program make() {
    Program program;
    program.source_files = {"", "a file.c", "b\"quoted\\.c"};
    const std::size_t functions = 1 + below(4);
    for (std::size_t i = 0; i < functions; ++i) {
      program.functions.push_back(make_function("_f" + std::to_string(i)));
    }
    const std::size_t objects = below(5);
    for (std::size_t i = 0; i < objects; ++i) {
      program.objects.push_back(make_object("_o" + std::to_string(i)));
    }
    return program;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }

  Binding any_binding() { return static_cast<Binding>(below(3)); }

  Function make_function(const std::string& name) {
    Function function;
    function.name = name;
    function.binding = any_binding();
    function.align = 2u << below(4);
    function.section = below(3) == 0 ? ".text.hot" : (below(5) == 0 ? ".l1.code" : ".text");
    const std::size_t packets = 1 + below(40);
    for (std::size_t i = 0; i < packets; ++i) {
      function.packets.push_back(make_packet());
      if (below(4) == 0) {
        function.labels[".L" + std::to_string(i)] = below(packets + 1);
      }
    }
    return function;
  }

  Packet make_packet() {
    Packet packet;
    packet.file = static_cast<int>(below(3));
    packet.line = packet.file == 0 ? 0 : static_cast<int>(below(1000));
    if (below(3) != 0) {
      packet.slots.push_back(make_instruction(Slot::alone));
      return packet;
    }
    packet.slots.push_back(make_instruction(Slot::dsp));
    if (below(2) == 0) {
      packet.slots.push_back(make_instruction(Slot::access));
    }
    packet.slots.push_back(make_instruction(below(2) == 0 ? Slot::index_access : Slot::nop));
    return packet;
  }

  // The entry that reading will find: an earlier one when its operands fit there.
  ParsedInstruction make_instruction(Slot slot) {
    const std::vector<int>& entries = by_slot_[static_cast<std::size_t>(slot)];
    ParsedInstruction instruction{.instruction = entries[below(entries.size())], .operand = {}};
    const isa::OperandRoles& roles = isa::roles_of(instruction.instruction);
    for (int i = 0; i < roles.count; ++i) {
      instruction.operand[static_cast<std::size_t>(i)] = make_operand(roles[i].kind);
    }
    return isa::instruction_syntax().parse(isa::instruction_syntax().print(instruction));
  }

  OperandValue make_operand(OperandKind kind) {
    const auto range = isa::immediate_range(kind);
    if (range && !isa::is_code_address(kind) && below(2) == 0) {
      const std::int32_t last = (range->maximum - range->minimum) / range->scale;
      const std::size_t steps = static_cast<std::size_t>(last) + 1;
      return {range->minimum + static_cast<std::int32_t>(below(steps)) * range->scale, {}};
    }
    const std::vector<OperandValue> samples = isa::sample_values(kind);
    return samples[below(samples.size())];
  }

  Object make_object(const std::string& name) {
    Object object;
    object.name = name;
    object.binding = any_binding();
    object.align = 1u << below(6);
    object.section = std::vector<std::string>{".data", ".bss", ".rodata", ".l2.data"}[below(4)];
    object.size = static_cast<std::uint32_t>(1 + below(200));
    for (std::uint32_t at = 0; at + 4 <= object.size; at += 4) {
      if (below(6) == 0) {
        object.relocations.push_back({at, 4, "_f0", static_cast<std::int32_t>(below(100)) - 50});
      }
    }
    object.initial.resize(below(object.size + 1));
    for (std::uint8_t& byte : object.initial) {
      byte = below(3) == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(random_());
    }
    for (const Relocation& relocation : object.relocations) {
      for (std::size_t i = relocation.offset; i < relocation.offset + 4u; ++i) {
        if (i < object.initial.size()) {
          object.initial[i] = 0;
        }
      }
    }
    while (!object.initial.empty() && object.initial.back() == 0) {
      object.initial.pop_back();
    }
    return object;
  }

  std::mt19937 random_;
  std::array<std::vector<int>, 5> by_slot_;
};

class RandomRoundTrip : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomRoundTrip, IsTheIdentity) {
  Generator generator(GetParam());
  for (int i = 0; i < 40; ++i) {
    expect_round_trip(generator.make());
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRoundTrip, testing::Values(1u, 2u, 3u, 4u, 5u));

TEST(RoundTrip, CanonicalTextOfAnExample) {
  const std::string canonical = R"(.bir 1
.file 2 "a.c"
.text
.global _f
.type _f, @function
.align 4
_f:
  .loc 2 7
  R2.L = ONES R2 || R0 = [P0++] || NOP;
.La:
.Lb:
  .loc 0 0
  IF !CC JUMP .La (BP);
  RTS;
.Lend:
.size _f, .-_f
.section .text.cold,"ax"
.type _g, @function
.align 2
_g:
  R0 = [FP + -8];
  RTS;
.size _g, .-_g
.data
.weak _x
.type _x, @object
.align 8
_x:
  .byte 1,2,0,4
  .byte4 _f + 4
  .space 8
  .byte4 _x
.size _x, 20
)";
  EXPECT_EQ(print(parse(canonical, "a.bir")), canonical);
}

TEST(RoundTrip, OrdinaryTextBecomesCanonical) {
  const Program p = program(".type _f,STT_FUNC;_f:r0=[fp-8];;rts; // done\n");
  expect_round_trip(p);
}

TEST(SameProgram, TellsDifferencesApart) {
  const auto make = [](const std::string& body) { return function(body); };
  const Program one = make("R0 = R1;\nRTS;");
  EXPECT_TRUE(same_program(one, make("\n\nR0 = R1; RTS;"))) << "places do not count";
  EXPECT_FALSE(same_program(one, make("R0 = R2;\nRTS;")));
  EXPECT_FALSE(same_program(one, make("R0 = R1;\n.La: RTS;")));
  EXPECT_FALSE(same_program(one, make("R0 = R1;\nRTS;\n.data\n_x: .byte 1")));
}

}  // namespace
}  // namespace finback::ir
