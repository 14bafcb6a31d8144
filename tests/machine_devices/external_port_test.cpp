// The external port's registers: what they say of the machine, and what changes with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <isa_sim/machine/external_port.hpp>

namespace finback::machine {
namespace {

constexpr std::uint32_t kGlobal = 0x10, kBank = 0x14, kRefresh = 0x18, kStatus = 0x1C;
constexpr Address kRowApart = 2048;

class ExternalPortTest : public testing::Test {
 protected:
  std::uint32_t read(std::uint32_t offset) { return port_.read(offset, 4, 0); }
  void write(std::uint32_t offset, std::uint32_t value) { port_.write(offset, 4, value, 0); }
  Cycles load(Address address, Cycles now) {
    return memory_.core_read(0, memory_.find_span(0, address), address, 4, now);
  }
  memory::MemoryParameters parameters_;
  memory::ClockParameters clock_;
  memory::MemorySystem memory_{memory::bf561_map(), parameters_, clock_, {}};
  ExternalPort port_{memory_};
};

// As a board with this SDRAM at 120 MHz sets them (hardware.md 2.4).
TEST_F(ExternalPortTest, TellWhatTheMachineIs) {
  EXPECT_EQ(read(kGlobal) & 0x1FFFFF, 0x91998DU & 0x1FFFFF);
  EXPECT_EQ(read(kBank), 0x15U);              // enabled, 64 MB, 9 columns
  EXPECT_EQ(read(kRefresh), 937U - 6U - 3U);  // 7.81 us
  EXPECT_EQ(read(kStatus), 1U);
}

TEST_F(ExternalPortTest, TimesChangeWithSdgctl) {
  load(0, 100);
  const Cycles miss = load(kRowApart, 1000);
  const Cycles hit = load(kRowApart, 2000);
  write(kGlobal, 0x91114D);  // tRCD 2, tRP 2, as a board at 100 MHz has it
  EXPECT_EQ(read(kGlobal), 0x91114DU);
  EXPECT_EQ(load(0, 3000), miss - 2 * 5);
  write(kGlobal, 0x911149);  // CL 2
  EXPECT_EQ(load(0, 4000), hit - 5);
}

TEST_F(ExternalPortTest, RefreshComesAsSdrrcSays) {
  write(kRefresh, 91);  // with tRAS and tRP 100 SCLK
  EXPECT_EQ(read(kRefresh), 91U);
  load(0, 10'000);
  CounterRegistry registry;
  memory_.register_counters(registry);
  const auto refreshes = [&] {
    return registry.snapshot().at("memory.sdram.refresh.events").value;
  };
  const std::uint64_t before = refreshes();
  load(0, 20'000);
  EXPECT_EQ(refreshes() - before, 20U);
}

TEST_F(ExternalPortTest, SelfRefreshKeepsWhatIsThere) {
  *memory_.host_access(64, 1, memory::Direction::write) = 7;
  write(kGlobal, read(kGlobal) | 1U << 24);
  EXPECT_EQ(read(kStatus), 3U);
  EXPECT_EQ(*memory_.host_access(64, 1, memory::Direction::read), 7);
  write(kGlobal, read(kGlobal) & ~(1U << 24));
  EXPECT_EQ(read(kStatus), 1U);
}

TEST_F(ExternalPortTest, WhatCannotBeIsRefused) {
  const auto refused = [&](std::uint32_t offset, std::uint32_t value, const char* part) {
    try {
      write(offset, value);
      ADD_FAILURE() << "accepted " << value;
    } catch (const GuestFault& fault) {
      EXPECT_THAT(fault.what(), testing::HasSubstr(part));
    }
  };
  refused(kGlobal, 0x919985, "CL 1");
  refused(kBank, 0x13, "0x00000015");
  write(kBank, 0x15);
  write(0, 0xF3);
  EXPECT_EQ(read(0), 0xF3U);
  write(0, 0x1F3);  // CDPRIO
  EXPECT_EQ(read(0), 0x1F3U);
}

TEST_F(ExternalPortTest, AsynchronousBanksAreAsAmbctlSays) {
  constexpr Address kFlash = 0x20000000;
  EXPECT_EQ(read(0x04), 0xFFC2FFC2U);
  EXPECT_EQ(load(kFlash, 1000), (5U + 2 * 22 - 3) * 5 - 1);
  write(0x04, 0xFFC2BB3C);  // setup 3, read and write 11, hold 0, transition 3
  EXPECT_EQ(read(0x04), 0xFFC2BB3CU);
  EXPECT_EQ(load(kFlash, 2000), (5U + 2 * 14) * 5 - 1);
  write(0x08, 0xFFC2BB3C);
  EXPECT_EQ(read(0x08), 0xFFC2BB3CU);
}

}  // namespace
}  // namespace finback::machine
