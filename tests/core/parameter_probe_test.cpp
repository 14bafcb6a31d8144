// Every parameter of the core decides the cycles that its meaning says: a program for each, with
// the difference that another value makes. A parameter without one fails.
#include <functional>
#include <gmock/gmock.h>
#include <set>
#include <string>

#include "core_harness.hpp"

namespace finback::core {
namespace {

constexpr const char* kPointer = "P0.L = _buffer; P0.H = _buffer; I0 = P0; NOP; NOP; NOP; NOP;\n";

struct ParameterProbe {
  const char* name;
  double value;             // instead of the default
  std::int64_t difference;  // in cycles
  const char* body;         // after P0 = I0 = buffer, R0 = 0, CC = 1
};

void PrintTo(const ParameterProbe& probe, std::ostream* out) {
  *out << probe.name << ": " << probe.body;
}

constexpr ParameterProbe kProbes[] = {
    {"core.branch.taken_cycles", 6, 1, "JUMP.S .Lx; NOP; .Lx: NOP;"},
    {"core.branch.taken_cycles", 7, 6, "CALL .Lx; JUMP.S .Lend; .Lx: RTS; .Lend: NOP;"},
    {"core.branch.mispredicted_cycles", 11, 2, "IF CC JUMP .Lx; NOP; .Lx: NOP;"},
    {"core.branch.mispredicted_cycles", 11, 2, "IF !CC JUMP .Lx (BP); NOP; .Lx: NOP;"},
    {"core.fetch.bytes", 64, -1, "JUMP.S .Lx; NOP; .Lx: R1 = R0 + R0 (NS) || NOP || NOP;"},
    {"core.fetch.split_target_cycles", 4, 3,
     "JUMP.S .Lx; NOP; .Lx: R1 = R0 + R0 (NS) || NOP || NOP;"},
    {"core.hazard.load_to_address_cycles", 5, 2, "P1 = [P0]; P2 = P1 + P0;"},
    {"core.hazard.move_to_address_cycles", 6, 2, "P1 = R0; P2 = P1 + P0;"},
    {"core.hazard.alu_to_ex1_cycles", 3, 2, "R1 = R0 + R0; R2.L = ONES R1;"},
    {"core.issue.multiply32_cycles", 5, 2, "R1 *= R0;"},
    {"core.issue.link_cycles", 5, 2, "LINK 8; UNLINK;"},
    {"core.issue.unlink_cycles", 5, 3, "LINK 8; UNLINK;"},
    {"core.issue.csync_cycles", 12, 2, "CSYNC;"},
    {"core.issue.ssync_cycles", 12, 2, "SSYNC;"},
    {"core.issue.event_cycles", 5, 4, "RAISE 14; STI R0;"},
    {"core.issue.testset_cycles", 5, 3, "TESTSET (P0);"},
    {"core.issue.loop_register_cycles", 13, 3, "LC0 = R0;"},
    {"core.sub_bank.conflict_cycles", 4, 3, "MNOP || R1 = [P0] || R2 = [I0];"},
    {"core.sub_bank.bytes", 8, -1, "P1 = 8; P1 = P0 + P1; MNOP || R1 = [P1] || R2 = [I0];"},
    {"core.store_buffer.stall_cycles", 2, 2, "[P0] = R0; R1 = B[P0 + 3] (Z);"},
    {"core.store_buffer.stall_cycles", 2, 0, "[P0] = R0; R1 = [P0 + 4];"},
    {"core.store_buffer.stall_cycles", 2, 2, "[P0] = R0; NOP; NOP; NOP; R1 = [P0];"},
    {"core.store_buffer.stall_cycles", 2, 0, "[P0] = R0; NOP; NOP; NOP; NOP; R1 = [P0];"},
    {"core.interrupt.entry_cycles", 13, 3,
     "P1.L = 0x2038; P1.H = 0xFFE0; R1.L = .Lhandler; R1.H = .Lhandler; [P1] = R1; R1.L = 0x4000;"
     "R1.H = 0; STI R1; RAISE 14; JUMP.S .Lend; .Lhandler: RTI; .Lend: NOP;"},
};

Cycles cycles_of(const ParameterProbe& probe, bool changed) {
  // _start is aligned, so that what lies across a fetch does so for sure: 26 bytes come first.
  CoreHarness harness(".text\n.global _start\n.type _start, @function\n.align 8\n_start:\n" +
                      std::string(kPointer) + "R0 = 0 (X); CC = R0 == 0;\n" + probe.body +
                      "\nIDLE;\nRTS;\n.size _start, .-_start\n" + kBuffer);
  if (changed) {
    harness.set(probe.name, probe.value);
  }
  return harness.run();
}

class Parameters : public testing::TestWithParam<ParameterProbe> {};

TEST_P(Parameters, DecidesTheCyclesThatItSays) {
  const ParameterProbe& probe = GetParam();
  EXPECT_EQ(static_cast<std::int64_t>(cycles_of(probe, true)),
            static_cast<std::int64_t>(cycles_of(probe, false)) + probe.difference)
      << probe.name << ": " << probe.body;
}

INSTANTIATE_TEST_SUITE_P(Core, Parameters, testing::ValuesIn(kProbes));

// How long a store stays decides whether the buffer's stall is met.
TEST(StoreBuffer, ForgetsAStoreAfterItsStay) {
  const auto cycles = [](int stay, const std::string& between) {
    CoreHarness harness(
        program(kPointer + std::string("[P0] = R0;") + between + "R1 = [P0];", kBuffer));
    harness.set("core.store_buffer.stall_cycles", 4);
    harness.set("core.store_buffer.stay_cycles", stay);
    return harness.run();
  };
  EXPECT_EQ(cycles(1, ""), cycles(2, "") - 4);
  EXPECT_EQ(cycles(2, "NOP;"), cycles(3, "NOP;") - 4);
}

TEST(Idle, WakesAfterItsLatency) {
  const auto cycles = [](int latency) {
    CoreHarness harness(program("R1.L = 0x8000; R1.H = 0; STI R1; IDLE; NOP; HLT;"));
    harness.set("core.idle.wake_cycles", latency);
    const Cycles asleep = harness.run();
    constexpr Cycles kWakeUp = 1000;
    harness.core().set_requests(0, true, kWakeUp);
    harness.core().run({});
    EXPECT_LT(asleep, kWakeUp);
    return harness.core().profile().cycles;
  };
  EXPECT_EQ(cycles(10), 1000U + 10 + 2);  // NOP and HLT
  EXPECT_EQ(cycles(25), 1000U + 25 + 2);
}

// A hundred loads, one a cycle, while a burst brings 32 words into their sub-bank: of five cycles
// one has a word, of whose halves every second is the loads'.
TEST(SubBank, DmaGoesFirst) {
  const auto cycles = [](int stall) {
    CoreHarness harness(program(
        std::string(kPointer) + "P1 = 160; LSETUP (.Lx, .Lx) LC0 = P1; .Lx: R1 = [P0];", kBuffer));
    harness.set("core.sub_bank.dma_conflict_cycles", stall);
    const ir::PlacedObject& buffer = harness.image().objects[0];
    return harness.run_beside([&] {
      const memory::DmaRun run{.address = buffer.address + 256, .stride = 4, .count = 32};
      harness.memory().dma_burst(memory::Initiator::mdma1_0, memory::Direction::write, {&run, 1}, 4,
                                 0, 0);
    });
  };
  EXPECT_EQ(cycles(1), cycles(0) + 16);
  EXPECT_EQ(cycles(3), cycles(0) + 3 * 16);
}

TEST(Parameters, EachHasAProbe) {
  std::set<std::string> probed = {"core.store_buffer.stay_cycles", "core.idle.wake_cycles",
                                  "core.sub_bank.dma_conflict_cycles"};
  for (const ParameterProbe& probe : kProbes) {
    probed.insert(probe.name);
  }
  const CoreParameters parameters;
  for (const ParameterBase* parameter : parameters.parameters()) {
    EXPECT_THAT(probed, testing::Contains(std::string(parameter->declaration().name)));
  }
}

}  // namespace
}  // namespace finback::core
