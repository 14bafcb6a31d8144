// Changes of clock and power modes as programs make them, to the cycle, on a whole machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guest_program.hpp"
#include <common/error.hpp>
#include <isa_sim/machine/clock_log.hpp>
#include <isa_sim/machine/peripherals.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::machine {
namespace {

using clock::Mode;
using testing::HasSubstr;

constexpr Address kLockCount = 0xFFC00010, kWakeup0 = 0xFFC0011C, kWakeup1 = 0xFFC00120;
constexpr std::uint32_t kMsel24 = 24U << 9U, kMsel20 = 20U << 9U;

class ClocksTest : public GuestProgramTest {
 protected:
  [[nodiscard]] std::vector<clock::ClockSegment> segments() const {
    return machine_->clocks().history().segments();
  }
  [[nodiscard]] std::uint32_t reg(isa::Register which) const {
    return machine_->state(CoreId::a).reg[which];
  }
  // In seconds.
  double time_of(const std::string& body) {
    load(body + "HLT;");
    const StopInfo stop = run();
    EXPECT_EQ(stop.message, "");
    return machine_->clocks().history().seconds(0, stop.time);
  }
};

const std::string kPllWakes = store(kWakeup0, 1) + store(kWakeup1, 0);

TEST_F(ClocksTest, AMultiplierTakesTheLockCountInClkin) {
  for (const unsigned count : {1U, 300U, 0x200U}) {
    load(kPllWakes + store(kLockCount, count, 2) + store(kPllCtl, kMsel20, 2) +
         "IDLE; R7 = CYCLES; HLT;");
    const StopInfo stop = run();
    ASSERT_EQ(stop.reason, Stop::exited);
    ASSERT_EQ(segments().size(), 3U);
    EXPECT_EQ(segments()[1].point.mode, Mode::active);
    EXPECT_EQ(segments()[1].point.core_hertz, 25e6);
    EXPECT_EQ(segments()[2].from - segments()[1].from, count);
    EXPECT_EQ(segments()[2].point.core_hertz, 500e6);
    EXPECT_EQ(segments()[2].point.system_hertz, 100e6);
    // It goes on as from any IDLE.
    EXPECT_EQ(reg(isa::R7),
              segments()[2].from + std::uint64_t(std::int64_t{description_.core.idle_wake}));
  }
}

TEST_F(ClocksTest, WithoutThePllsWakeUpNothingEndsIdle) {
  load(store(kWakeup0, 0) + store(kWakeup1, 0) + store(kPllCtl, kMsel20, 2) + "IDLE; HLT;");
  EXPECT_EQ(run().reason, Stop::deadlock);
  EXPECT_EQ(segments().size(), 3U);  // the PLL has locked, and nobody was told
}

TEST_F(ClocksTest, APllsWakeUpThatComesToNobodyIsLost) {
  load(kPllWakes + store(kPllCtl, kMsel20, 2) + "IDLE; IDLE; HLT;");
  EXPECT_EQ(run().reason, Stop::deadlock);
}

TEST_F(ClocksTest, APllsWakeUpInterruptsWhoseMaskAdmitsIt) {
  // Source 0 goes to IVG7. Nothing wakes by SICA_IWR: the interrupt does, once.
  load("P0.L = 0x201C; P0.H = 0xFFE0; R0.L = _locked; R0.H = _locked; [P0] = R0; R7 = 0;\n" +
           store(kWakeup0, 0) + store(kWakeup1, 0) + store(0xFFC0010C, 1) +
           "R0 = 0x80 (X); STI R0;\n" + store(kPllCtl, kMsel20, 2) + "IDLE; NOP; NOP; HLT;",
       function("_locked", "R7 += 1; RTI;"));
  EXPECT_EQ(run().reason, Stop::exited);
  EXPECT_EQ(reg(isa::R7), 1U);
  EXPECT_EQ(segments().back().point.core_hertz, 500e6);
}

TEST_F(ClocksTest, ASoftwareResetEndsTheRun) {
  load(store(0xFFC00100, 5, 2) + "R7 = 1;\n" + store(0xFFC00100, 7, 2) + "R7 = 2; HLT;");
  const StopInfo stop = run();
  EXPECT_EQ(stop.reason, Stop::exited);
  EXPECT_EQ(stop.exit_status, 0U);
  EXPECT_EQ(reg(isa::R7), 1U);
}

const std::string kLoop =
    "P1.L = 50000; P1.H = 0; LSETUP (.Lwork, .Lwork) LC0 = P1;\n.Lwork: R1 = R1 + R2;\n";
const std::string kReads =
    "P2.L = 0; P2.H = 0x10; P1 = 2000 (X); LSETUP (.Lread, .Lread) LC0 = P1;\n.Lread: R3 = "
    "[P2++];\n";

TEST_F(ClocksTest, HalfTheCoreClockDoublesWhatTheCoreDoes) {
  const std::string half = store(kPllDiv, 0x15, 2);
  EXPECT_NEAR(time_of(half + kLoop) / time_of(kLoop), 2, 0.01);
  const double reads = time_of(half + kReads) / time_of(kReads);
  EXPECT_GE(reads, 1.0);
  EXPECT_LT(reads, 1.05);
}

TEST_F(ClocksTest, TheMemorysHalfCyclesAreNotLost) {
  // 8 SCLK are 20 core cycles at 300 / 120 MHz; at 600 / 120 MHz 40.
  const auto stalls = [this](const std::string& clock) {
    load(clock +
         "P2.L = 0; P2.H = 0x10; R0 = [P2]; R1 = CYCLES; R0 = [P2]; R2 = CYCLES;"
         "R7 = R2 - R1; HLT;");
    run();
    return reg(isa::R7);
  };
  const std::uint32_t full = stalls("");
  const std::uint32_t half = stalls(store(kPllDiv, 0x15, 2));
  EXPECT_EQ(full - half, 20U);
}

TEST_F(ClocksTest, TimersCountSystemClocksThroughAChange) {
  // TIMER0, 2000 SCLK once; the core clock is halved on the way.
  load(store(0xFFC00600, 0x11, 2) + store(0xFFC0060C, 2000) + store(kWakeup0, 0) +
       store(kWakeup1, 1U << 3) + store(0xFFC00680, 1, 2) + "R6 = CYCLES;\n" +
       store(kPllDiv, 0x15, 2) + "IDLE; R7 = CYCLES; HLT;");
  EXPECT_EQ(run().message, "");
  // At least the part behind the change takes 2.5 cycles an SCLK.
  const std::uint32_t cycles = reg(isa::R7) - reg(isa::R6);
  EXPECT_GE(cycles, 2000U * 5 / 2);
  EXPECT_LT(cycles, 2000U * 5 / 2 + 200);
}

// MDMA1 copies 1024 words of SDRAM to L2; `on_the_way` is done when it has begun.
std::string copy(const std::string& on_the_way) {
  return store(0xFFC01F44, 0x100000) + store(0xFFC01F50, 1024, 2) + store(0xFFC01F54, 4, 2) +
         store(0xFFC01F04, 0xFEB00000) + store(0xFFC01F10, 1024, 2) + store(0xFFC01F14, 4, 2) +
         store(0xFFC01F48, 0x9, 2) + store(0xFFC01F08, 0xB, 2) + on_the_way +
         "P0.L = 0x1F28; P0.H = 0xFFC0;\n"
         ".Lcopy: R0 = W[P0] (Z); CC = BITTST(R0, 0); IF !CC JUMP .Lcopy;\n";
}

TEST_F(ClocksTest, DmaKeepsToTheSystemClock) {
  const double whole = time_of(copy(""));
  // CCLK alone; the bursts' starts lose half core cycles, and polling is slower.
  EXPECT_NEAR(time_of(copy(store(kPllDiv, 0x15, 2))) / whole, 1, 0.04);
  EXPECT_NEAR(time_of(store(kPllDiv, 0x0A, 2) + copy("")) / whole, 2, 0.05);
  const double late =
      time_of(copy("P1 = 3000 (X); LSETUP (.Lwait, .Lwait) LC0 = P1;\n.Lwait: NOP;\n" +
                   store(kPllDiv, 0x0A, 2)));
  EXPECT_GT(late / whole, 1.2);
  EXPECT_LT(late / whole, 1.8);
}

TEST_F(ClocksTest, PinsChangeInRealTime) {
  load(store(0xFFC00740, 1, 2) + store(kPllDiv, 0x15, 2) +
       "P0.L = 0x0700; P0.H = 0xFFC0;\n.Lpin: R0 = W[P0] (Z); CC = R0 == 0; IF CC JUMP .Lpin;\n"
       "R7 = CYCLES; HLT;");
  machine_->peripherals().drive_flags({{100'000, 0, true}});
  const StopInfo stop = run();
  EXPECT_EQ(stop.message, "");
  EXPECT_NEAR(machine_->clocks().history().seconds(0, stop.time), 100'000 / 600e6, 0.5e-6);
  EXPECT_LT(reg(isa::R7), 51'000U);
  EXPECT_NEAR(static_cast<double>(machine_->reference_time(stop.time)), 100'000, 300);
}

TEST_F(ClocksTest, ACameraKeepsItsTimeThroughAChange) {
  // QQVGA at 100 Hz by PPI0 and channel 0 of DMA1; core and system clock fall on the way to half.
  description_.camera.halvings.set(2);
  description_.camera.frame_rate.set(100);
  const auto capture = [&](const std::string& on_the_way) {
    load(store(0xFFC01C04, 0x100000) + store(0xFFC01C10, 80, 2) + store(0xFFC01C14, 2, 2) +
         store(0xFFC01C18, 120, 2) + store(0xFFC01C1C, 2, 2) + store(0xFFC01C08, 0x97, 2) +
         store(0xFFC01008, 319, 2) + store(0xFFC0100C, 0, 2) + store(0xFFC01010, 120, 2) +
         store(0xFFC01000, 0x2AD, 2) + on_the_way + "IDLE; HLT;");
    machine_->peripherals().connect_camera(
        peripheral::Camera::Side::left,
        [](std::uint32_t) {
          auto picture = std::make_shared<peripheral::Picture>();
          *picture = {160, 120, std::vector<std::uint8_t>(160 * 120)};
          for (std::size_t i = 0; i < picture->luma.size(); ++i) {
            picture->luma[i] = static_cast<std::uint8_t>(i * 7 % 251);
          }
          return std::shared_ptr<const peripheral::Picture>(picture);
        },
        {});
    const StopInfo stop = machine_->run({.cycles = 20'000'000, .cancelled = {}});
    EXPECT_EQ(stop.reason, Stop::exited) << stop.message;
    const auto view = machine_->memory().view_bytes(0x100000, 160 * 120);
    for (std::size_t i = 0; i < view.size(); ++i) {
      EXPECT_EQ(view[i], i * 7 % 251) << i;
    }
    return machine_->clocks().history().seconds(0, stop.time);
  };
  const double before = capture("");
  EXPECT_NEAR(capture(store(kPllDiv, 0x1A, 2)), before, 3e-6);
  EXPECT_GT(before, 1.0 / 100);  // frame 0 had begun
  EXPECT_LT(before, 2.0 / 100);
}

TEST_F(ClocksTest, SleepStopsTheCoreAndItsCounters) {
  // The core timer would come after 1000 cycles, TIMER0 comes after 2000 SCLK and wakes.
  load(store(0xFFC00600, 0x11, 2) + store(0xFFC0060C, 2000) + store(0xFFC00680, 1, 2) +
       store(kWakeup0, 0) + store(kWakeup1, 1U << 3) + store(kPllCtl, kMsel24 | 8, 2) +
       store(0xFFE03004, 1000) + store(0xFFE03000, 3) +
       "R5 = 0x40 (X); STI R5; R6 = CYCLES; IDLE; R7 = CYCLES; CLI R5;\n"
       "P0.L = 0x300C; P0.H = 0xFFE0; R4 = [P0]; HLT;");
  const StopInfo stop = run();
  EXPECT_EQ(stop.message, "");
  ASSERT_EQ(segments().size(), 3U);
  EXPECT_EQ(segments()[1].point.mode, Mode::sleep);
  EXPECT_EQ(segments()[2].point.mode, Mode::full_on);
  EXPECT_GT(segments()[2].from - segments()[1].from, 9000U);
  EXPECT_LT(reg(isa::R7) - reg(isa::R6), 60U);  // IDLE's own, and waking
  EXPECT_GT(reg(isa::R4), 900U);                // TCOUNT
  EXPECT_LT(reg(isa::R4), 1000U);
}

TEST_F(ClocksTest, OnlyWakeUpsEndSleep) {
  // The timer's interrupt is enabled, its wake-up is not: it would end IDLE, not sleep.
  const std::string timer = store(0xFFC00600, 0x11, 2) + store(0xFFC0060C, 2000) +
                            store(0xFFC00680, 1, 2) + store(kWakeup0, 0) + store(kWakeup1, 0) +
                            store(0xFFC00110, 1U << 3) + "R5 = 0x400 (X);\n";
  load(timer + "P0.L = 0x2028; P0.H = 0xFFE0; R0.L = _h; R0.H = _h; [P0] = R0; STI R5; IDLE; HLT;",
       function("_h", "HLT;"));
  EXPECT_EQ(run().reason, Stop::exited);
  load(timer + store(kPllCtl, kMsel24 | 8, 2) + "STI R5; IDLE; HLT;");
  EXPECT_EQ(run().reason, Stop::deadlock);
}

TEST_F(ClocksTest, WorkIsCountedByOperatingPoint) {
  load("P5 = 2 (X);\n.Ltwice: " + kLoop + store(kPllDiv, 0x15, 2) +
       "P5 += -1; CC = P5 == 0; IF !CC JUMP .Ltwice;\nHLT;");
  const StopInfo stop = run();
  const auto& uses = machine_->clocks().uses();
  ASSERT_EQ(uses.size(), 2U);
  EXPECT_EQ(uses[0].cycles + uses[1].cycles, stop.time);
  for (const PointUse& use : uses) {
    EXPECT_NEAR(static_cast<double>(use.work.cores[0].busy), 50000, 300);
    EXPECT_EQ(use.work.cores[1].busy, 0U);
  }
  EXPECT_NEAR(uses[1].seconds / uses[0].seconds, 2, 0.02);
}

TEST_F(ClocksTest, TheSamePointAgainIsTheSameRow) {
  const std::string there_and_back = store(kPllDiv, 0x15, 2) + store(kPllDiv, 0x05, 2);
  load(there_and_back + there_and_back + "HLT;");
  run();
  EXPECT_EQ(segments().size(), 5U);
  EXPECT_EQ(machine_->clocks().uses().size(), 2U);
}

TEST_F(ClocksTest, DeepSleepEndsWithReset) {
  const std::string down = store(kPllCtl, kMsel24 | 0x20, 2) + "IDLE; HLT;";
  load(down);
  StopInfo stop = run();
  EXPECT_EQ(stop.reason, Stop::deadlock);
  EXPECT_THAT(stop.message, HasSubstr("deep_sleep, which only RESET ends: set "
                                      "clock.reset_after_us"));
  description_.pll.reset_after_us.set(1000);
  load(down);
  stop = run();
  EXPECT_EQ(stop.reason, Stop::exited);
  EXPECT_EQ(stop.exit_status, 0U);
  EXPECT_EQ(segments().back().point.mode, Mode::deep_sleep);
  EXPECT_EQ(stop.time - segments().back().from, 600'000U);
}

TEST_F(ClocksTest, HibernationIsVrCtlsFreq) {
  description_.pll.reset_after_us.set(10);
  load(store(kVrCtl, 0xF8, 2) + "IDLE; HLT;");
  EXPECT_EQ(run().reason, Stop::exited);
  EXPECT_EQ(segments().back().point.mode, Mode::hibernate);
}

TEST_F(ClocksTest, AnIllegalValueIsAFaultWithItsPlace) {
  load(store(kPllDiv, 0x04, 2) + "HLT;");
  EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<GuestFault>(testing::AllOf(
                                     HasSubstr("core_a in start"),
                                     HasSubstr("PLL_DIV = 0x0004: SCLK would be 150 MHz"))));
}

TEST_F(ClocksTest, LimitsInRealTimeCountWhatIsSlower) {
  load(store(kPllDiv, 0x15, 2) + ".Lever: JUMP .Lever;");
  RunLimits limits;
  limits.reference_cycles = 600'000;
  const StopInfo stop = machine_->run(limits);
  EXPECT_EQ(stop.reason, Stop::cycle_limit);
  EXPECT_NEAR(static_cast<double>(stop.time), 300'000, 100);
}

}  // namespace
}  // namespace finback::machine
