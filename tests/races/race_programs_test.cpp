// Programs with and without a race, on the whole machine: both places are named, and what is
// synchronised is clean.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>

#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/race_report.hpp>

namespace finback::machine {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kShared =
    ".data\n.global _words\n_words: .space 64\n.global _ready\n_ready: .long 0\n"
    ".global _lock\n_lock: .long 0\n";

std::shared_ptr<const ir::Program> unit(const std::string& text, const std::string& file) {
  return std::make_shared<const ir::Program>(assembler::assemble(text, file));
}

// Runs core A's program, and core B's from when core A lets it, until both sleep or core A ends.
std::vector<RaceReport> races_of(const std::string& core_a, const std::string& core_b = "",
                                 std::vector<std::string> flags = {}) {
  ir::FirmwareUnits units;
  units.cores[0] = {true, {unit(".global _start\n_start: " + core_a, "a.s")}, "_start"};
  if (!core_b.empty()) {
    units.cores[1] = {true, {unit(".global _start\n_start: " + core_b, "b.s")}, "_start"};
  }
  units.shared.push_back(unit(kShared, "shared.s"));
  units.flags = std::move(flags);
  const MachineDescription description;
  const ir::Image image = ir::link(units, ir::default_placement(), description.map);
  Machine machine(description, image);
  machine.check_races();
  machine.run({.cycles = 1'000'000, .cancelled = {}});
  return machine.races();
}

constexpr const char* kReleaseCoreB =
    "P5.L = 0x0104; P5.H = 0xFFC0; R7 = 0 (X); [P5] = R7; SSYNC;\n";
constexpr const char* kAtWords = "P0.L = LO(_words); P0.H = HI(_words);\n";
constexpr const char* kAtReady = "P1.L = LO(_ready); P1.H = HI(_ready);\n";
constexpr const char* kSleep = "sleep: IDLE; JUMP sleep;\n";

// 16 words from L3 to _words by stream 0 of MDMA1.
std::string copy() {
  return std::string(kAtWords) +
         "P4.L = 0x1F00; P4.H = 0xFFC0; P3.L = 0x1F40; P3.H = 0xFFC0;\n"
         "R0 = 0x4000 (X); [P3 + 4] = R0; R1 = P0; [P4 + 4] = R1;\n"
         "R0 = 16 (X); W[P3 + 0x10] = R0; W[P4 + 0x10] = R0;\n"
         "R0 = 4 (X); W[P3 + 0x14] = R0; W[P4 + 0x14] = R0;\n"
         "R0 = 0x9 (X); W[P3 + 8] = R0; R0 = 0xB (X); W[P4 + 8] = R0; SSYNC;\n";
}
constexpr const char* kWaitForCopy =
    "wait: R0 = W[P4 + 0x28] (Z); CC = BITTST(R0, 0); IF !CC JUMP wait;\n";

TEST(RacePrograms, DmaThatNobodyWaitsForIsNamedWithBothPlaces) {
  const auto races = races_of(copy() + "R2 = [P0 + 8];\n" + kSleep);
  ASSERT_THAT(races, SizeIs(1));
  EXPECT_THAT(races[0].object, HasSubstr("words+8 of shared"));
  EXPECT_THAT(races[0].earlier, AllOf(HasSubstr("core_a reads"), HasSubstr("a.s:")));
  EXPECT_THAT(races[0].later,
              AllOf(HasSubstr("mdma1_0 writes, commanded by core_a"), HasSubstr("a.s:")));
}

TEST(RacePrograms, DmaThatIsWaitedForIsClean) {
  EXPECT_THAT(races_of(copy() + kWaitForCopy + "R2 = [P0 + 8];\n" + kSleep), IsEmpty());
}

TEST(RacePrograms, AWordThatBothCoresWrite) {
  const std::string add = std::string(kAtWords) + "R0 = [P0]; R0 += 1; [P0] = R0;\n" + kSleep;
  const auto races = races_of(kReleaseCoreB + add, add);
  ASSERT_FALSE(races.empty());
  EXPECT_THAT(races[0].earlier + races[0].later, AllOf(HasSubstr("core_a"), HasSubstr("core_b"),
                                                       HasSubstr("a.s:"), HasSubstr("b.s:")));
}

TEST(RacePrograms, ALockMakesItClean) {
  const std::string locked = std::string(kAtWords) +
                             "P2.L = LO(_lock); P2.H = HI(_lock);\n"
                             "take: TESTSET(P2); IF !CC JUMP take;\n"
                             "R0 = [P0]; R0 += 1; [P0] = R0; SSYNC;\n"
                             "R0 = 0 (X); [P2] = R0;\n" +
                             kSleep;
  EXPECT_THAT(races_of(kReleaseCoreB + locked, locked), IsEmpty());
}

TEST(RacePrograms, AFlagCountsWhenItIsDeclared) {
  const std::string writer = std::string(kReleaseCoreB) + kAtWords + kAtReady +
                             "R0 = 5 (X); [P0] = R0; R0 = 1 (X); [P1] = R0;\n" + kSleep;
  const std::string reader = std::string(kAtWords) + kAtReady +
                             "wait: R0 = [P1]; CC = R0 == 1; IF !CC JUMP wait;\n"
                             "R1 = [P0];\n" +
                             kSleep;
  EXPECT_THAT(races_of(writer, reader, {"ready"}), IsEmpty());
  EXPECT_THAT(races_of(writer, reader), SizeIs(2));  // the flag and the word
}

TEST(RacePrograms, WatchingChangesNoCycle) {
  const MachineDescription description;
  ir::FirmwareUnits units;
  units.cores[0] = {
      true, {unit(".global _start\n_start: " + copy() + kWaitForCopy + "HLT;\n", "a.s")}, "_start"};
  units.shared.push_back(unit(kShared, "shared.s"));
  const ir::Image image = ir::link(units, ir::default_placement(), description.map);
  const auto cycles = [&](bool watched) {
    Machine machine(description, image);
    if (watched) {
      machine.check_races();
    }
    return machine.run().time;
  };
  EXPECT_EQ(cycles(true), cycles(false));
}

}  // namespace
}  // namespace finback::machine
