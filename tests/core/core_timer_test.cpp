// The core timer: when it requests, and what its registers tell in between.
#include <gtest/gtest.h>

#include "core_harness.hpp"

namespace finback::core {
namespace {

constexpr Address kControl = CoreTimer::kFirstRegister, kPeriod = kControl + 4,
                  kScale = kControl + 8, kCount = kControl + 12;
constexpr std::uint32_t kPower = 1, kRun = 3, kRunAgain = 7, kExpired = 8;

TEST(CoreTimer, CountsInStepsOfItsScale) {
  CoreTimer timer;
  timer.write(kPeriod, 10, 0);
  timer.write(kScale, 4, 0);
  EXPECT_EQ(timer.next_event(), kNever);
  timer.write(kControl, kRun, 100);
  EXPECT_EQ(timer.next_event(), 150U);
  EXPECT_EQ(timer.read(kCount, 100), 10U);
  EXPECT_EQ(timer.read(kCount, 104), 10U);
  EXPECT_EQ(timer.read(kCount, 105), 9U);
  EXPECT_EQ(timer.read(kCount, 149), 1U);
  timer.expire();
  EXPECT_EQ(timer.read(kControl, 150), kRun | kExpired);
  EXPECT_EQ(timer.read(kCount, 150), 0U);
  EXPECT_EQ(timer.next_event(), kNever);
}

TEST(CoreTimer, ReloadsWithoutLosingTime) {
  CoreTimer timer;
  timer.write(kPeriod, 10, 0);
  timer.write(kCount, 3, 0);
  timer.write(kControl, kRunAgain, 100);
  EXPECT_EQ(timer.next_event(), 103U);
  timer.expire();
  EXPECT_EQ(timer.next_event(), 113U);
  timer.expire();
  EXPECT_EQ(timer.next_event(), 123U);
}

TEST(CoreTimer, StandsStillAndGoesOn) {
  CoreTimer timer;
  timer.write(kPeriod, 10, 0);
  timer.write(kControl, kRun, 100);
  timer.write(kControl, kRun, 103);  // runs already: changes nothing
  EXPECT_EQ(timer.next_event(), 110U);
  timer.write(kControl, kPower, 104);
  EXPECT_EQ(timer.next_event(), kNever);
  EXPECT_EQ(timer.read(kCount, 200), 6U);
  timer.write(kControl, kRun, 200);
  EXPECT_EQ(timer.next_event(), 206U);
  timer.write(kScale, 1, 203);
  EXPECT_EQ(timer.next_event(), 209U);
}

TEST(CoreTimer, StartedAtZeroRequestsAtOnce) {
  CoreTimer timer;
  timer.write(kControl, kRun, 50);
  EXPECT_EQ(timer.next_event(), 50U);
  timer.expire();
  timer.write(kControl, kRun, 60);
  EXPECT_EQ(timer.next_event(), kNever);
}

// However long the straight code is, the interrupt comes within it, at its cycle, each time.
TEST(CoreTimer, InterruptsStraightCodeAtItsTime) {
  std::string body =
      "P0.L = 0x2018; P0.H = 0xFFE0; R1.L = _tick; R1.H = _tick; [P0] = R1; R1 = 64 (X); STI R1;"
      "P0.L = 0x3000; R1 = 1; [P0] = R1; R1 = 20; [P0 + 4] = R1; R7 = 0; R1 = 7; [P0] = R1;"
      "R6 = CYCLES;\n";
  for (int i = 0; i < 100; ++i) {
    body += "NOP;\n";
  }
  body += "R5 = CYCLES; R1 = 0; [P0] = R1; HLT;";
  CoreHarness harness(
      program(body) +
      ".text\n.type _tick, @function\n_tick: R7 += 1; RTI;\n.size _tick, .-_tick\n");
  harness.run();
  // one every 20 cycles, give or take the edges
  const std::uint32_t requests = (harness.reg(isa::R5) - harness.reg(isa::R6)) / 20;
  EXPECT_GT(requests, 10U);
  EXPECT_NEAR(harness.reg(isa::R7), requests, 1);
}

}  // namespace
}  // namespace finback::core
