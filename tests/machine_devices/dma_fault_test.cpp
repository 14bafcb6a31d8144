// A DMA that goes wrong later tells which instruction began it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>

#include <common/error.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback::machine {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A copy of `words` words to the last of core A's data bank A; then the core sleeps.
std::string copy(int words) {
  return ".global _start\n_start:\n"
         "P4.L = 0x1F00; P4.H = 0xFFC0; P3.L = 0x1F40; P3.H = 0xFFC0;\n"
         "R0 = 0x4000 (X); [P3 + 4] = R0; R1.L = 0x7FFC; R1.H = 0xFF80; [P4 + 4] = R1;\n"
         "R0 = " +
         std::to_string(words) +
         " (X); W[P3 + 0x10] = R0; W[P4 + 0x10] = R0;\n"
         "R0 = 4 (X); W[P3 + 0x14] = R0; W[P4 + 0x14] = R0;\n"
         "R0 = 0x9 (X); W[P3 + 8] = R0; R0 = 0xB (X);\n"
         "W[P4 + 8] = R0;\n"  // line 8
         "sleep: IDLE; JUMP sleep;\n";
}

StopInfo run(const std::string& text) {
  ir::FirmwareUnits units;
  units.cores[0] = {
      true, {std::make_shared<const ir::Program>(assembler::assemble(text, "copy.s"))}, "_start"};
  const MachineDescription description;
  const ir::Image image = ir::link(units, ir::default_placement(), description.map);
  Machine machine(description, image);
  return machine.run({.cycles = 100'000, .cancelled = {}});
}

TEST(DmaFault, OneThatComesLaterTellsWhoBeganTheTransfer) {
  EXPECT_THAT(
      [] { run(copy(2)); },
      ThrowsMessage<GuestFault>(AllOf(
          HasSubstr("DMA: MDMA1_D0_CURR_ADDR = 0xff808003: the transfer leaves l1.data.a"),
          HasSubstr("; the channel was started by core_a in start ("), HasSubstr("copy.s:8)"))));
  EXPECT_EQ(run(copy(1)).reason, Stop::deadlock);
}

TEST(DmaFault, OneThatComesAtOnceTellsItsOwnPlace) {
  std::string narrow = copy(1);
  narrow.replace(narrow.find("R0 = 0xB"), 8, "R0 = 0x7");  // WDSIZE 1 at the destination
  EXPECT_THAT([&] { run(narrow); },
              ThrowsMessage<GuestFault>(AllOf(
                  HasSubstr("core_a in start ("), HasSubstr("copy.s:8)"),
                  HasSubstr("WDSIZE of MDMA1_S0_CONFIG"), testing::Not(HasSubstr("started by")))));
}

}  // namespace
}  // namespace finback::machine
