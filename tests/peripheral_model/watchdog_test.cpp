// Watchdogs: the time to the bite, and what it does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <peripheral_model/watchdog.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Cycles kSclk = 5;
constexpr std::uint32_t kControl = 0, kCount = 4, kStatus = 8;
constexpr std::uint32_t kReset = 0, kNonMaskable = 2, kInterrupt = 4, kNothing = 6;
constexpr std::uint32_t kOff = 0xAD0, kBitten = 0x8000;

class WatchdogTest : public testing::Test {
 protected:
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    dog_.write(offset, 4, value, now);
  }
  std::uint32_t read(std::uint32_t offset, Cycles now = 0) { return dog_.read(offset, 4, now); }

  std::vector<std::pair<std::string, Cycles>> events_;
  Watchdog dog_{
      "WDOGA",
      kSclk,
      {.reset = [this](Cycles at) { events_.emplace_back("reset", at); },
       .non_maskable = [this](Cycles at) { events_.emplace_back("nmi", at); },
       .line = [this](bool level, Cycles at) { events_.emplace_back(level ? "up" : "down", at); }}};
};

TEST_F(WatchdogTest, ItIsOffAfterResetAndTakesItsCountThen) {
  EXPECT_EQ(read(kControl), kOff);
  write(kCount, 1000);
  EXPECT_EQ(read(kStatus), 1000U);
  EXPECT_EQ(dog_.next_event_time(), kNever);
}

TEST_F(WatchdogTest, EachEventComesAtItsCycle) {
  for (const auto& [control, event] :
       {std::pair(kReset, "reset"), std::pair(kNonMaskable, "nmi"), std::pair(kInterrupt, "up")}) {
    events_.clear();
    write(kControl, kOff | kBitten);
    events_.clear();
    write(kCount, 1000);
    write(kControl, control, 7);
    EXPECT_EQ(read(kStatus, 7 + 400 * kSclk), 600U);
    dog_.advance(7 + 1000 * kSclk - 1);
    EXPECT_TRUE(events_.empty());
    dog_.advance(7 + 1000 * kSclk);
    EXPECT_THAT(events_, ElementsAre(std::pair<std::string, Cycles>(event, 7 + 1000 * kSclk)));
    EXPECT_EQ(read(kControl), control | kBitten);
    EXPECT_EQ(dog_.next_event_time(), kNever);
  }
}

TEST_F(WatchdogTest, AWriteToTheStatusBeginsAnew) {
  write(kCount, 100);
  write(kControl, kInterrupt, 0);
  write(kStatus, 0, 300);
  EXPECT_EQ(dog_.next_event_time(), 300 + 100 * kSclk);
}

TEST_F(WatchdogTest, TheInterruptStandsUntilTheFlagIsCleared) {
  write(kCount, 10);
  write(kControl, kInterrupt);
  dog_.advance(10 * kSclk);
  write(kControl, kInterrupt, 60);
  EXPECT_EQ(events_.size(), 1U) << "a 0 clears nothing";
  write(kControl, kOff | kBitten, 70);
  EXPECT_EQ(events_.back(), std::pair(std::string("down"), Cycles{70}));
  EXPECT_EQ(read(kControl), kOff);
}

TEST_F(WatchdogTest, DisablingKeepsTheCountAndNothingHappensWhereNothingIsAsked) {
  write(kCount, 100);
  write(kControl, kNothing, 0);
  write(kControl, kNothing | kOff, 40 * kSclk);
  EXPECT_EQ(read(kStatus, 1'000'000), 60U);
  write(kControl, kNothing, 50 * kSclk);
  EXPECT_EQ(dog_.next_event_time(), 110 * kSclk);
  dog_.advance(110 * kSclk);
  EXPECT_EQ(read(kControl), kNothing | kBitten);
  EXPECT_TRUE(events_.empty());
}

TEST_F(WatchdogTest, TheCountOfARunningOneIsNotWritten) {
  write(kCount, 100);
  write(kControl, kReset);
  EXPECT_THAT([&] { write(kCount, 5); },
              ThrowsMessage<GuestFault>(HasSubstr("disable it first by WDOGA_CTL = 0x0ad0")));
}

}  // namespace
}  // namespace finback::peripheral
