// General-purpose timers: periods to the cycle, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <peripheral_model/general_timers.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Cycles kSclk = 5;
constexpr Cycles kStart = 3 * kSclk;
constexpr std::uint32_t kPwm = 1, kContinuous = 8, kIrq = 16;
constexpr std::uint32_t kEnable = 0x80, kDisable = 0x84, kStatus = 0x88;

using Change = std::tuple<int, bool, Cycles>;

class GeneralTimersTest : public testing::Test {
 protected:
  static constexpr std::uint32_t at(std::uint32_t timer, std::uint32_t reg) {
    return timer * 0x10 + reg;
  }
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    timers_.write(offset, 4, value, now);
  }
  std::uint32_t read(std::uint32_t offset, Cycles now = 0) { return timers_.read(offset, 4, now); }
  void set_up(std::uint32_t timer, std::uint32_t config, std::uint32_t period,
              std::uint32_t width) {
    write(at(timer, 0x0), config);
    write(at(timer, 0x8), period);
    write(at(timer, 0xC), width);
  }
  void clear(std::uint32_t bits, Cycles now) { write(kStatus, bits, now); }

  PeripheralParameters parameters_;
  std::vector<Change> lines_;
  GeneralTimers timers_{0, 8, parameters_, kSclk, [this](int timer, bool level, Cycles at) {
                          lines_.emplace_back(timer, level, at);
                        }};
};

TEST_F(GeneralTimersTest, RegistersHaveTheirNames) {
  EXPECT_EQ(timers_.register_name(0x38), "TIMER3_PERIOD");
  EXPECT_EQ(timers_.register_name(0x80), "TMRS8_ENABLE");
  GeneralTimers four(8, 4, parameters_, kSclk, nullptr);
  EXPECT_EQ(four.register_name(0x30), "TIMER11_CONFIG");
  EXPECT_EQ(four.register_name(0x48), "TMRS4_STATUS");
  EXPECT_EQ(four.register_name(0x4C), "");
}

TEST_F(GeneralTimersTest, PeriodsAreExact) {
  set_up(3, kPwm | kContinuous | kIrq, 1000, 1);
  write(kEnable, 1U << 3, 100);
  for (Cycles i = 1; i <= 3; ++i) {
    const Cycles due = 100 + kStart + i * 1000 * kSclk;
    EXPECT_EQ(timers_.next_event_time(), due);
    timers_.advance(due - 1);
    EXPECT_EQ(read(kStatus) & 8U, 0U) << "not a cycle before";
    timers_.advance(due);
    EXPECT_EQ(read(kStatus), 0x8008U);
    EXPECT_EQ(lines_.back(), Change(3, true, due));
    clear(8, due + 1);
    EXPECT_EQ(lines_.back(), Change(3, false, due + 1));
  }
}

TEST_F(GeneralTimersTest, TheCounterRunsFromOneToThePeriod) {
  set_up(0, kPwm | kContinuous, 10, 1);
  write(kEnable, 1, 0);
  EXPECT_EQ(read(0x4, kStart), 1U);
  EXPECT_EQ(read(0x4, kStart + kSclk - 1), 1U);
  EXPECT_EQ(read(0x4, kStart + kSclk), 2U);
  EXPECT_EQ(read(0x4, kStart + 10 * kSclk - 1), 10U);
  timers_.advance(kStart + 10 * kSclk);
  EXPECT_EQ(read(0x4, kStart + 10 * kSclk), 1U);
  EXPECT_TRUE(lines_.empty()) << "without IRQ_ENA nobody is told";
}

TEST_F(GeneralTimersTest, ANewPeriodIsTakenOverAtTheEndOfTheOld) {
  set_up(0, kPwm | kContinuous | kIrq, 100, 1);
  write(kEnable, 1, 0);
  write(0x8, 30, 200);
  timers_.advance(kStart + 100 * kSclk);
  EXPECT_EQ(timers_.next_event_time(), kStart + 130 * kSclk);
}

TEST_F(GeneralTimersTest, ASinglePulseEndsByItself) {
  set_up(5, kPwm | kIrq, 0, 40);
  write(kEnable, 1U << 5, 0);
  EXPECT_EQ(read(kEnable), 1U << 5);
  const Cycles due = kStart + 40 * kSclk;
  timers_.advance(due);
  EXPECT_THAT(lines_, ElementsAre(Change(5, true, due)));
  EXPECT_EQ(read(kEnable), 0U);
  EXPECT_EQ(read(kStatus), 2U << 16) << "TIMIL5 without TRUN5";
  EXPECT_EQ(timers_.next_event_time(), kNever);
  EXPECT_EQ(read(at(5, 4), due + 100), 40U);
}

TEST_F(GeneralTimersTest, ADisabledTimerEndsItsPeriodUnlessItIsStopped) {
  set_up(0, kPwm | kContinuous | kIrq, 100, 1);
  set_up(1, kPwm | kContinuous | kIrq, 100, 1);
  write(kEnable, 3, 0);
  write(kDisable, 3, 50);
  EXPECT_EQ(read(kEnable), 0U);
  EXPECT_EQ(read(kStatus), 0x3000U) << "both run on";
  clear(0x2000, 60);
  EXPECT_EQ(read(kStatus), 0x1000U);
  timers_.advance(10'000);
  EXPECT_THAT(lines_, ElementsAre(Change(0, true, kStart + 100 * kSclk)));
  EXPECT_EQ(timers_.next_event_time(), kNever);
}

TEST_F(GeneralTimersTest, WhatIsNotModelledOrMakesNoSenseIsAFault) {
  const auto refuses = [&](std::uint32_t offset, std::uint32_t value, const char* why) {
    EXPECT_THAT([&] { write(offset, value); }, ThrowsMessage<GuestFault>(HasSubstr(why)));
  };
  refuses(at(2, 0), 2, "TIMER2_CONFIG = 0x2: WDTH_CAP is not modelled");
  refuses(at(2, 0), 3, "EXT_CLK is not modelled");
  refuses(at(2, 0), 0x81, "CLK_SEL = 1");
  refuses(at(2, 4), 1, "it is read-only");
  refuses(kEnable, 4, "needs TMODE = 1");
  set_up(2, kPwm | kContinuous, 1, 1);
  refuses(kEnable, 4, "TIMER2_PERIOD = 0x1: must be at least 2");
  set_up(2, kPwm | kContinuous, 5, 5);
  refuses(kEnable, 4, "TIMER2_WIDTH = 0x5: must be 1 to PERIOD - 1, 4");
}

TEST_F(GeneralTimersTest, ARunningTimersConfigurationIsNotWritten) {
  set_up(0, kPwm | kContinuous, 100, 1);
  write(kEnable, 1);
  EXPECT_THAT([&] { write(0, kPwm); },
              ThrowsMessage<GuestFault>(HasSubstr("disable it and wait for TRUN = 0")));
}

}  // namespace
}  // namespace finback::peripheral
