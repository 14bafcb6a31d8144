// One probe for each latency of the pipeline: a consumer that comes a cycle too early waits a
// cycle, one that comes in time does not wait. The figures are those of hardware.md 1.4 to 1.6
// and 6.1.
#include <gtest/gtest.h>

#include "core_harness.hpp"

namespace finback::core {
namespace {

constexpr const char* kData =
    ".data\n.align 4\n.type _buffer, @object\n_buffer: .space 64\n.size _buffer, 64\n";

// Cycles of `body` alone: those of a program less its IDLE.
Cycles cycles_of(const std::string& body) {
  CoreHarness harness(program(body, kData));
  return harness.run() - 1;
}

struct HazardProbe {
  const char* name;
  const char* setup;
  const char* producer;
  const char* consumer;
  Cycles stall;  // when the consumer follows at once
};

class Hazards : public testing::TestWithParam<HazardProbe> {};

TEST_P(Hazards, ConsumerWaitsJustAsLongAsTheProducerTakes) {
  const HazardProbe& probe = GetParam();
  // Fillers touch nothing that the pair uses.
  std::string fillers;
  for (Cycles distance = 0; distance <= probe.stall + 1; ++distance) {
    const Cycles without = cycles_of(std::string(probe.setup) + probe.producer + fillers);
    const Cycles with =
        cycles_of(std::string(probe.setup) + probe.producer + fillers + probe.consumer);
    const Cycles expected = distance < probe.stall ? probe.stall - distance : 0;
    EXPECT_EQ(with - without - 1, expected) << probe.name << " at distance " << distance;
    fillers += "R4 = R6 & R6;\n";
  }
}

constexpr const char* kPointers =
    "P0.L = _buffer; P0.H = _buffer; I0 = P0; R7 = 0 (X); R6 = 0 (X); R4 = R6 & R6; R4 = R6 & R6; "
    "R4 = R6 & R6; R4 = R6 & R6;\n";

INSTANTIATE_TEST_SUITE_P(
    Pipeline, Hazards,
    testing::Values(
        HazardProbe{"load P, use as address", kPointers, "P1 = [P0];\n", "P2 = P1 + P0;\n", 3},
        HazardProbe{"pop P, use as address", kPointers, "[--SP] = P0; P1 = [SP++];\n",
                    "R0 = [P1];\n", 3},
        HazardProbe{"move D to P, use as address", kPointers, "P1 = R7;\n", "P2 = P1 + P0;\n", 4},
        HazardProbe{"move D to I, use as address",
                    "P0.L = _buffer; P0.H = _buffer; R5 = P0; R7 = 0 (X); R6 = 0 (X);\n",
                    "I0 = R5;\n", "R0 = [I0];\n", 4},
        HazardProbe{"immediate to P, use as address", kPointers, "P1 = 4 (X);\n", "P2 = P1 + P0;\n",
                    0},
        HazardProbe{"P arithmetic, use as address", kPointers, "P1 = P0 + P0;\n", "P2 = P1 + P0;\n",
                    0},
        HazardProbe{"move I to P, use as address", kPointers, "P1 = I0;\n", "R0 = [P1];\n", 0},
        HazardProbe{"post-modify, use as address", kPointers, "R0 = [P0++];\n", "R1 = [P0];\n", 0},
        HazardProbe{"load D, use in an ALU instruction", kPointers, "R0 = [P0];\n",
                    "R1 = R0 + R0;\n", 0},
        HazardProbe{"load D, use in a multiply", kPointers, "R0 = [P0];\n",
                    "R1 = R0.L * R0.L (IS);\n", 0},
        HazardProbe{"load D, store it", kPointers, "R0 = [P0];\n", "[P0] = R0;\n", 0},
        HazardProbe{"ALU, ALU", kPointers, "R0 = R7 + R6;\n", "R1 = R0 + R7;\n", 0},
        HazardProbe{"ALU, multiply", kPointers, "R0 = R7 + R6;\n", "R1 = R0.L * R7.L (IS);\n", 1},
        HazardProbe{"ALU, ONES", kPointers, "R0 = R7 ^ R6;\n", "R1.L = ONES R0;\n", 1},
        HazardProbe{"ALU, EXTRACT", kPointers, "R0 = R7 ^ R6;\n", "R1 = EXTRACT(R0, R7.L) (Z);\n",
                    1},
        HazardProbe{"multiply, ALU", kPointers, "R0 = R7.L * R6.L (IS);\n", "R1 = R0 + R7;\n", 0},
        HazardProbe{"MAC, accumulator to register", kPointers, "A0 += R7.L * R6.L (IS);\n",
                    "R2 = A0;\n", 0},
        HazardProbe{"accumulator to register, store", kPointers, "R2 = A0;\n", "[P0] = R2;\n", 0}));

struct CostProbe {
  const char* name;
  const char* code;
  Cycles cycles;
};
class Costs : public testing::TestWithParam<CostProbe> {};

TEST_P(Costs, TotalCycles) {
  const std::string setup = "P0 = 3 (X); R0 = 0 (X); CC = R0 == 0;\n";
  EXPECT_EQ(cycles_of(setup + GetParam().code) - cycles_of(setup), GetParam().cycles)
      << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(
    Pipeline, Costs,
    testing::Values(
        CostProbe{"plain", "R1 = R0 + R0;\n", 1},
        CostProbe{"packet of three", "R1 = R0 + R0 (NS) || NOP || NOP;\n", 1},
        CostProbe{"branch not taken, predicted not taken", "IF !CC JUMP .Lx; .Lx:\n", 1},
        CostProbe{"branch taken, predicted taken", "IF CC JUMP .Lx (BP); NOP; .Lx:\n", 5},
        CostProbe{"branch taken, predicted not taken", "IF CC JUMP .Lx; NOP; .Lx:\n", 9},
        CostProbe{"branch not taken, predicted taken", "IF !CC JUMP .Lx (BP); .Lx:\n", 9},
        CostProbe{"JUMP.S", "JUMP.S .Lx; NOP; .Lx:\n", 5},
        CostProbe{"JUMP.S to the next packet", "JUMP.S .Lx; .Lx:\n", 5},
        CostProbe{"JUMP.L", "JUMP.L .Lx; NOP; .Lx:\n", 5},
        CostProbe{"JUMP (P)", "P1.L = .Lx; P1.H = .Lx; NOP; JUMP (P1); NOP; .Lx:\n", 3 + 5},
        CostProbe{"JUMP (PC + P)", "P1 = 4 (X); JUMP (PC + P1); NOP; NOP;\n", 1 + 5 + 1},
        CostProbe{"conditional move", "IF CC R1 = R0;\n", 1},
        CostProbe{"32-bit multiply", "R1 *= R0;\n", 3},
        CostProbe{"LINK and UNLINK", "LINK 8; UNLINK;\n", 3 + 2},
        CostProbe{"push and pop of four", "[--SP] = (R7:6, P5:4); (R7:6, P5:4) = [SP++];\n", 8},
        CostProbe{"push of all", "[--SP] = (R7:0, P5:0);\n", 14},
        CostProbe{"CSYNC", "CSYNC;\n", 10}, CostProbe{"SSYNC", "SSYNC;\n", 10},
        CostProbe{"CLI and STI", "CLI R1; STI R1;\n", 1 + 3},
        CostProbe{"loop register by move", "LC1 = R0;\n", 10}, CostProbe{"RAISE", "RAISE 14;\n", 3},
        CostProbe{"DIVS and DIVQ", "DIVS (R1, R0); DIVQ (R1, R0);\n", 1 + 1},
        CostProbe{"SAA with two accesses", "SAA (R1:0, R3:2) || NOP || NOP;\n", 1},
        CostProbe{"ALIGN8", "R1 = ALIGN8 (R2, R3);\n", 1},
        CostProbe{"DISALGNEXCPT with two accesses", "DISALGNEXCPT || NOP || NOP;\n", 1},
        CostProbe{"LSETUP and one packet thrice",
                  "LSETUP (.Lt, .Lt) LC0 = P0; .Lt: R1 = R1 + R0;\n", 1 + 3},
        CostProbe{"nested loops",
                  "P1 = 2 (X); LSETUP (.Lo, .Le) LC0 = P1; .Lo: R1 = R0 + R0; LSETUP (.Li, .Li) "
                  "LC1 = P0; .Li: R2 = R2 + R0; .Le: NOP;\n",
                  2 + 2 * (1 + 1 + 3 + 1)}));

// A packet that begins `offset` bytes after a multiple of 8 and is led to by `jump`.
Cycles cycles_of_target(int offset, const std::string& jump, const std::string& packet) {
  std::string gap;
  for (int bytes = 0; bytes < offset; bytes += 2) {
    gap += "NOP; ";
  }
  const auto text = [&](const std::string& there) {
    return ".text\n.global _start\n.type _start, @function\n.align 8\n_start: R0 = 0 (X); CC = R0 "
           "== 0; " +
           jump + "\nNOP;\n.align 8\n" + gap + ".Lx: " + there +
           "\nIDLE; RTS;\n.size _start, "
           ".-_start\n";
  };
  CoreHarness with(text(packet));
  CoreHarness without(text("NOP;"));
  const Cycles cycles = with.run() + 1 - without.run();
  EXPECT_EQ(with.evaluate(), with.core().profile().cycles);
  return cycles;
}

TEST(Fetch, APacketThatIsLedToWaitsOnlyForASecondFetch) {
  const std::string packet = "R1 = R0 + R0 (NS) || NOP || NOP;";  // 8 bytes
  const std::string wide = "R1 = 1000 (X);";                      // 4 bytes
  for (const char* jump : {"JUMP.S .Lx;", "IF CC JUMP .Lx (BP);", "IF CC JUMP .Lx;"}) {
    for (const int offset : {0, 2, 4, 6}) {
      EXPECT_EQ(cycles_of_target(offset, jump, packet), offset == 0 ? 1U : 2U) << jump << offset;
      EXPECT_EQ(cycles_of_target(offset, jump, wide), offset == 6 ? 2U : 1U) << jump << offset;
    }
  }
}

TEST(Fetch, StraightCodeAndLoopsNeverWait) {
  const std::string packet = "R1 = R0 + R0 (NS) || NOP || NOP; ";
  for (const char* gap : {"", "NOP; ", "NOP; NOP; ", "NOP; NOP; NOP; "}) {
    EXPECT_EQ(cycles_of(gap + packet + packet + packet) - cycles_of(gap), 3U);
    const std::string loop = "P0 = 5 (X); LSETUP (.Lt, .Le) LC0 = P0; ";
    EXPECT_EQ(cycles_of(loop + gap + ".Lt: " + packet + ".Le: " + packet) -
                  cycles_of(loop + gap + ".Lt: NOP; .Le: NOP;"),
              0U);
  }
}

TEST(Fetch, ItsWidthAndItsWaitAreParameters) {
  const std::string body = "JUMP.S .Lx; NOP; NOP; .Lx: R1 = R0 + R0 (NS) || NOP || NOP;";
  const auto cycles = [&](int bytes, int wait) {
    CoreHarness harness(program(body));
    harness.parameters().fetch_bytes.set(bytes);
    harness.parameters().split_target.set(wait);
    return harness.run();
  };
  EXPECT_EQ(cycles(8, 3), cycles(8, 0) + 3);
  EXPECT_EQ(cycles(16, 3), cycles(8, 0));
}

TEST(Calls, CallAndReturnTakeFiveEach) {
  const std::string body =
      ".text\n.global _start\n.type _start, @function\n_start: CALL _f; IDLE; RTS;\n.size _start, "
      ".-_start\n"
      ".type _f, @function\n_f: R0 = 7 (X); RTS;\n.size _f, .-_f\n";
  CoreHarness harness(body);
  EXPECT_EQ(harness.run(), 5U + 1 + 5 + 1);
  EXPECT_EQ(harness.reg(isa::R0), 7U);
  const CoreProfile profile = harness.core().profile();
  for (const FunctionProfile& function : profile.functions) {
    if (function.name == "f") {
      EXPECT_EQ(function.calls, 1U);
      EXPECT_EQ(function.inclusive, 6U);
    }
  }
}

// hardware.md 6.1: the inner column of transpm costs rows + 4, that of matmmlt Ac + 4.
TEST(PublishedKernels, TransposeColumn) {
  const std::string column = "P0.L = _buffer; P0.H = _buffer; I0 = P0; I1 = P0; P1 = 8 (X);\n";
  const std::string kernel =
      "R0 = [P0++P1]; LSETUP (.Lt, .Lt) LC0 = P1; .Lt: MNOP || R0 = [P0++P1] || [I1++] = R0; I0 += "
      "2; P0 = I0;\n";
  const Cycles setup = cycles_of(column);
  CoreHarness harness(program(
      column + kernel,
      ".data\n.align 4\n.type _buffer, @object\n_buffer: .space 4096\n.size _buffer, 4096\n"));
  harness.parameters().sub_bank_conflict.set(
      0);  // source and target share a sub-bank here, unlike in ADI's figure
  EXPECT_EQ(harness.run() - 1 - setup, 8U + 4);
}

TEST(SubBanks, TwoAccessesConflictOnlyInOneBankWithEqualBit2) {
  const std::string data =
      ".data\n.align 4\n.type _buffer, @object\n_buffer: .space 8192\n.size _buffer, 8192\n";
  const auto cost = [&](int distance) {
    const std::string setup =
        "P0.L = _buffer; P0.H = _buffer; I0 = P0; P1.L = " + std::to_string(distance) +
        "; P1.H = 0; P1 = P0 + P1;\n";
    CoreHarness with(program(setup + "MNOP || R0 = [P1] || R1 = [I0];\n", data));
    CoreHarness without(program(setup, data));
    return with.run() - without.run();
  };
  EXPECT_EQ(cost(8), 2U);
  EXPECT_EQ(cost(4), 1U);
  EXPECT_EQ(cost(4096), 1U);
}

TEST(Sums, CyclesOverCausesFunctionsAndPacketsAreTheTotal) {
  CoreHarness harness(
      program("P0 = 100 (X); LSETUP (.Lt, .Le) LC0 = P0; .Lt: R0 = R0 + R1; P1 = R0; P2 = P1 + P0; "
              "CC = R0 == 0; IF !CC JUMP .Lx; .Lx: .Le: R1.L = ONES R0;\n"));
  const Cycles total = harness.run();
  const CoreProfile profile = harness.core().profile();
  Cycles causes = 0;
  Cycles functions = 0;
  Cycles packets = 0;
  for (int cause = 0; cause < kCauseCount; ++cause) {
    causes += profile.causes[static_cast<std::size_t>(cause)];
    for (const FunctionProfile& function : profile.functions) {
      functions += function.exclusive[static_cast<std::size_t>(cause)];
    }
    for (const PacketProfile& packet : profile.packet_profiles) {
      packets += packet.cycles[static_cast<std::size_t>(cause)];
    }
  }
  EXPECT_EQ(causes, total);
  EXPECT_EQ(functions, total);
  EXPECT_EQ(packets, total);
  EXPECT_GT(profile.causes[static_cast<std::size_t>(Cause::hazard_address)], 0U);
}

}  // namespace
}  // namespace finback::core
