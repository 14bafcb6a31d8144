// The firmware's drivers and runtime, compiled by finback-cc, on the simulated chip.
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "../core/trace_tally.hpp"
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback {
namespace {

struct Latencies {
  double intercore_cycles;
  double peripheral_sclk;
  double dma_startup_sclk;
};

void PrintTo(const Latencies& l, std::ostream* out) {
  *out << "inter-core " << l.intercore_cycles << ", peripheral " << l.peripheral_sclk
       << ", DMA start-up " << l.dma_startup_sclk;
}

class Drivers : public testing::TestWithParam<Latencies> {};

// Whatever the latencies: an interrupt may come before, at or after the moment of going to sleep.
TEST_P(Drivers, PassTheirChecks) {
  machine::MachineDescription description;
  description.set("events.intercore_latency_cycles", GetParam().intercore_cycles);
  description.set("events.peripheral_latency_sclk", GetParam().peripheral_sclk);
  description.set("dma.startup_sclk", GetParam().dma_startup_sclk);
  const ir::Firmware firmware = ir::load_firmware(FINBACK_CHECKS "/firmware.toml");
  const ir::Image image = ir::link(firmware.units, firmware.placement, description.map);
  machine::Machine machine(description, image);
  std::vector<std::string> lines;
  machine.host().set_console([&lines](const std::string& line) { lines.push_back(line); });

  const machine::StopInfo stop = machine.run({.cycles = 100'000'000, .cancelled = {}});
  ASSERT_EQ(stop.reason, machine::Stop::exited) << "a wake-up was lost, or something hangs";
  EXPECT_EQ(stop.exit_status, 0U) << "see enum check in checks_a.c";
  EXPECT_EQ(lines, std::vector<std::string>{"all checks passed"});
}

// The short ones one by one: the interrupt then walks across the few instructions between the test
// and the sleep.
std::vector<Latencies> latencies() {
  std::vector<Latencies> all = {{50, 3, 8}, {17, 1, 40}, {333, 20, 2}, {2000, 100, 100}};
  for (int cycles = 1; cycles <= 32; ++cycles) {
    all.push_back({static_cast<double>(cycles), 1, 0});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Latencies, Drivers, testing::ValuesIn(latencies()));

// L2, L3, DMA, interrupts and sleep on both cores: traced, they are what they are otherwise.
TEST(Trace, OfTwoCoresIsTheRun) {
  const machine::MachineDescription description;
  const ir::Firmware firmware = ir::load_firmware(FINBACK_CHECKS "/firmware.toml");
  const ir::Image image = ir::link(firmware.units, firmware.placement, description.map);
  machine::Machine plain(description, image);
  machine::Machine traced(description, image);
  std::array<core::TraceTally, kCoreCount> tallies;
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    traced.trace(core, tallies[static_cast<std::size_t>(core)].sink());
  }
  const machine::StopInfo expected = plain.run();
  const machine::StopInfo stop = traced.run();
  EXPECT_EQ(stop.time, expected.time);
  EXPECT_EQ(stop.exit_status, 0U);
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    const core::CoreProfile profile = traced.profile(core);
    EXPECT_EQ(profile.cycles, plain.profile(core).cycles);
    EXPECT_EQ(profile.causes, plain.profile(core).causes);
    tallies[static_cast<std::size_t>(core)].check(profile);
  }
}

}  // namespace
}  // namespace finback
