// Ratios, real time and seconds: what a change of clock makes of times.
#include <gtest/gtest.h>

#include <clock_model/clock_history.hpp>
#include <clock_model/real_time.hpp>

namespace finback::clock {
namespace {

constexpr std::uint64_t kFast = 600'000'000, kSlow = 300'000'000;

TEST(ClockRatio, WholeOnesMultiply) {
  const ClockRatio five(5);
  EXPECT_EQ(five.cycles(7), 35U);
  EXPECT_EQ(five.passed(34), 6U);
  EXPECT_EQ(five.left(31), 7U);
}

TEST(ClockRatio, AHalfEndsWithTheNextCoreCycle) {
  const ClockRatio two_and_a_half(5, 1);
  EXPECT_EQ(two_and_a_half.cycles(1), 3U);
  EXPECT_EQ(two_and_a_half.cycles(2), 5U);
  EXPECT_EQ(two_and_a_half.cycles(8), 20U);
  EXPECT_EQ(two_and_a_half.passed(5), 2U);
  EXPECT_EQ(two_and_a_half.passed(4), 1U);
  EXPECT_EQ(two_and_a_half.left(4), 2U);
}

TEST(ClockChange, PlansSystemClocksAnew) {
  const ClockChange change{.at = 100, .from = 5, .to = ClockRatio(5, 1)};
  EXPECT_EQ(change.system_time(100 + 8 * 5), 100U + 20);
  EXPECT_EQ(change.system_time(99), 99U);  // over
  EXPECT_EQ(change.system_time(kNever), kNever);
  const ClockChange none{.at = 100, .from = 5, .to = 5};
  EXPECT_EQ(none.system_time(133), 133U);  // not even rounded to whole SCLK
}

TEST(RealTime, IsCyclesUntilTheClockChanges) {
  RealTime time;
  EXPECT_EQ(time.from_reference(12345), 12345U);
  EXPECT_EQ(time.to_reference(12345), 12345U);
}

TEST(RealTime, GoesOnThroughChanges) {
  RealTime time;
  time.change({.at = 1000, .from_hertz = kFast, .to_hertz = kSlow});
  EXPECT_EQ(time.from_reference(3000), 2000U);
  EXPECT_EQ(time.from_reference(3001), 2001U);  // not before it
  EXPECT_EQ(time.to_reference(2000), 3000U);
  EXPECT_EQ(time.from_reference(500), 1000U);  // over
  EXPECT_EQ(time.from_reference(kNever), kNever);
  time.change({.at = 2000, .from_hertz = kSlow, .to_hertz = kFast});
  EXPECT_EQ(time.from_reference(3100), 2100U);
  EXPECT_EQ(time.to_reference(2100), 3100U);
}

TEST(RealTime, HoldsForYears) {
  RealTime time;
  time.change({.at = 0, .from_hertz = kFast, .to_hertz = kSlow});
  EXPECT_EQ(time.from_reference(Cycles{1} << 60), Cycles{1} << 59);
}

TEST(ClockHistory, SumsSeconds) {
  ClockHistory history({.mode = Mode::full_on, .core_hertz = 600e6});
  EXPECT_DOUBLE_EQ(history.seconds(0, 600), 1e-6);
  EXPECT_EQ(history.mean_hertz(10, 20), 600e6);
  history.change(600, {.mode = Mode::full_on, .core_hertz = 300e6});
  EXPECT_TRUE(history.changed());
  EXPECT_DOUBLE_EQ(history.seconds(0, 1200), 3e-6);
  EXPECT_DOUBLE_EQ(history.seconds(300, 900), 1.5e-6);
  EXPECT_EQ(history.mean_hertz(0, 600), 600e6);
  EXPECT_EQ(history.mean_hertz(600, 900), 300e6);
  EXPECT_DOUBLE_EQ(history.mean_hertz(0, 1200), 400e6);
}

TEST(ClockHistory, OfTwoChangesAtOnceTheLastCounts) {
  ClockHistory history({.core_hertz = 600e6});
  history.change(600, {.core_hertz = 25e6});
  history.change(600, {.core_hertz = 300e6});
  EXPECT_EQ(history.segments().size(), 2U);
  EXPECT_DOUBLE_EQ(history.seconds(600, 900), 1e-6);
}

}  // namespace
}  // namespace finback::clock
