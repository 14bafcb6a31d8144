// The PLL's registers and transitions, alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clock_model/pll.hpp>
#include <common/error.hpp>

namespace finback::clock {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kCtl = 0x00, kDiv = 0x04, kVr = 0x08, kStat = 0x0C, kLock = 0x10;

class PllTest : public testing::Test {
 protected:
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    pll_.write(offset, 2, value, now);
  }
  std::uint32_t read(std::uint32_t offset) { return pll_.read(offset, 2, 0); }
  // "full_on 600/120 at 0"
  static std::string text(const OperatingPoint& point, Cycles at) {
    return std::string(name_of(point.mode)) + " " +
           std::to_string(static_cast<int>(point.core_hertz / 1e6)) + "/" +
           std::to_string(static_cast<int>(point.system_hertz / 1e6)) + " at " + std::to_string(at);
  }
  std::vector<std::string> events_;
  PllParameters parameters_;
  Pll pll_{parameters_,
           600,
           120,
           5,
           {.changed = [this](const OperatingPoint& point, ClockRatio,
                              Cycles at) { events_.push_back(text(point, at)); },
            .wake = [this](Cycles at) { events_.push_back("wake at " + std::to_string(at)); }}};
};

TEST_F(PllTest, TheDividerActsAtOnce) {
  write(kDiv, 0x16, 70);
  EXPECT_THAT(events_, ElementsAre("full_on 300/100 at 70"));
  EXPECT_FALSE(pll_.waits_for_idle());
  write(kDiv, 0x16, 80);
  EXPECT_EQ(events_.size(), 1U);  // the same again is no change
}

TEST_F(PllTest, AMultiplierWaitsForIdleAndLocksForLockcnt) {
  write(kLock, 300);
  write(kCtl, 20U << 9U);
  EXPECT_TRUE(pll_.waits_for_idle());
  EXPECT_TRUE(events_.empty());
  EXPECT_EQ(read(kStat), 0xA2U);
  pll_.idle(1000);
  pll_.advance(1000);
  EXPECT_EQ(read(kStat), 0x01U);  // active, not locked, the voltage not reached
  EXPECT_EQ(pll_.next_event_time(), 1300U);
  pll_.advance(1299);
  EXPECT_THAT(events_, ElementsAre("active 25/25 at 1000"));
  pll_.advance(1300);
  EXPECT_THAT(events_,
              ElementsAre("active 25/25 at 1000", "full_on 500/100 at 1300", "wake at 1300"));
  EXPECT_EQ(read(kStat), 0xA2U);
  EXPECT_FALSE(pll_.waits_for_idle());
}

TEST_F(PllTest, AVoltageLocksToo) {
  write(kDiv, 0x16);
  write(kVr, 0x7B);
  pll_.idle(100);
  pll_.advance(100);
  EXPECT_EQ(pll_.point().core_volts, 1.30);
  pll_.advance(100 + 0x200);
  EXPECT_EQ(pll_.point().core_volts, 0.90);
}

TEST_F(PllTest, BypassNeedsNoLock) {
  write(kCtl, 24U << 9U | kBypass);
  pll_.idle(100);
  pll_.advance(100);
  EXPECT_THAT(events_, ElementsAre("active 25/25 at 100", "wake at 100"));
  write(kDiv, 0x16, 200);  // for later
  EXPECT_EQ(events_.size(), 2U);
  write(kCtl, 24U << 9U, 300);
  pll_.idle(400);
  pll_.advance(400);
  EXPECT_EQ(events_.back(), "wake at 400");
  EXPECT_EQ(events_[2], "full_on 300/100 at 400");
}

TEST_F(PllTest, APllThatWasOffHasToLockAgain) {
  write(kCtl, 24U << 9U | kBypass | kPllOff);
  pll_.idle(100);
  pll_.advance(100);
  EXPECT_EQ(read(kStat), 0x84U);  // active, the PLL disabled
  write(kCtl, 24U << 9U);
  pll_.idle(200);
  pll_.advance(200);
  EXPECT_EQ(pll_.next_event_time(), 200U + 0x200);
}

TEST_F(PllTest, SleepIsEndedByAWakeUpAndCanBeHadAgain) {
  for (const Cycles at : {100, 1000}) {
    events_.clear();
    write(kCtl, 24U << 9U | kStopCore, at);
    EXPECT_TRUE(pll_.waits_for_idle());
    EXPECT_TRUE(pll_.will_stop_cores());
    pll_.idle(at);
    pll_.advance(at);
    EXPECT_TRUE(pll_.asleep());
    pll_.wake(at + 50);
    EXPECT_THAT(events_, ElementsAre("sleep 600/120 at " + std::to_string(at),
                                     "full_on 600/120 at " + std::to_string(at + 50)));
  }
}

TEST_F(PllTest, DeepSleepAndHibernationAreModes) {
  write(kCtl, 24U << 9U | kPowerDown);
  pll_.idle(100);
  pll_.advance(100);
  EXPECT_EQ(pll_.point().mode, Mode::deep_sleep);
  write(kVr, 0xF8);
  pll_.idle(200);
  pll_.advance(200);
  EXPECT_EQ(pll_.point().mode, Mode::hibernate);
  EXPECT_EQ(pll_.point().core_volts, 0);
}

TEST_F(PllTest, WhatTheChipDoesNotBearIsSaid) {
  const auto message = [this](std::uint32_t offset, std::uint32_t value) {
    try {
      write(offset, value);
    } catch (const GuestFault& fault) {
      return std::string(fault.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message(kDiv, 0x04),
            "PLL_DIV = 0x0004: SCLK would be 150 MHz, above its limit of 133.34 MHz at 1.30 V; "
            "raise SSEL");
  EXPECT_THAT(message(kVr, 0xCB), HasSubstr("VR_CTL = 0x00cb: CCLK would be 600 MHz"));
  EXPECT_THAT(message(kCtl, 0x3014), HasSubstr("bits 2 and 4 are reserved"));
  EXPECT_THAT(message(kCtl, 24U << 9U | kPllOff), HasSubstr("PLL_OFF without BYPASS"));
  EXPECT_THAT(message(kDiv, 0x45), HasSubstr("bits 15 to 6 are reserved"));
  EXPECT_THAT(message(kStat, 0), HasSubstr("read-only"));
  EXPECT_EQ(read(kCtl), 24U << 9U);  // nothing of it was taken
  EXPECT_EQ(read(kDiv), 5U);
}

// PLL_DIV acts at once: it must fit the VCO that there is, and the one that is to come.
TEST_F(PllTest, TheDividerMustFitBothClocks) {
  write(kCtl, 16U << 9U);  // 400 MHz, from IDLE on
  EXPECT_THAT([this] { write(kDiv, 0x03); },
              ThrowsMessage<GuestFault>(HasSubstr("SCLK would be 200 MHz")));
  write(kDiv, 0x06);
  EXPECT_EQ(read(kDiv), 6U);
}

TEST_F(PllTest, IsNotWrittenWhileItLocks) {
  write(kCtl, 20U << 9U);
  pll_.idle(100);
  pll_.advance(100);
  EXPECT_THAT([this] { write(kDiv, 0x06, 200); },
              ThrowsMessage<GuestFault>(HasSubstr("the PLL is locking")));
}

}  // namespace
}  // namespace finback::clock
