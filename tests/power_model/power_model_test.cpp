// The power model against the figures of hardware.md section 5.
#include <gtest/gtest.h>
#include <numeric>
#include <set>

#include <common/error.hpp>
#include <power_model/power_model.hpp>

namespace finback::power {
namespace {

constexpr Cycles kSecond = 600'000'000;

// One second of both cores at activity 1: every cycle issues one ALU operation.
Activity typical_second() {
  Activity activity;
  activity.cycles = kSecond;
  for (CoreActivity& core : activity.cores) {
    core = {.cycles = kSecond, .alu_operations = kSecond};
  }
  return activity;
}

const PowerComponent& find(const PowerEstimate& estimate, const std::string& name) {
  for (const PowerComponent& part : estimate.components) {
    if (part.name == name) {
      return part;
    }
  }
  throw std::logic_error("no component " + name);
}

TEST(CoreVoltage, FollowsTheSpeedGradeTable) {
  EXPECT_DOUBLE_EQ(lowest_core_volts(50e6), 0.85);
  EXPECT_DOUBLE_EQ(lowest_core_volts(250e6), 0.85);
  EXPECT_DOUBLE_EQ(lowest_core_volts(251e6), 0.90);
  EXPECT_DOUBLE_EQ(lowest_core_volts(500e6), 1.25);
  EXPECT_DOUBLE_EQ(lowest_core_volts(600e6), 1.30);
  EXPECT_THROW((void)lowest_core_volts(601e6), InputError);
}

TEST(ActivityFactor, GivesTheVectorsOfEe297) {
  const PowerParameters p;
  const auto factor = [&p](const CoreActivity& core) { return activity_factor(p, core); };
  EXPECT_DOUBLE_EQ(factor({.cycles = 100, .idle_cycles = 100}), 0.43);
  EXPECT_DOUBLE_EQ(factor({.cycles = 100}), 0.72);
  EXPECT_DOUBLE_EQ(factor({.cycles = 100, .alu_operations = 100}), 1.00);
  EXPECT_DOUBLE_EQ(factor({.cycles = 100, .mac_operations = 100}), 1.00);
  EXPECT_DOUBLE_EQ(factor({.cycles = 100, .access_operations = 100}), 0.88);
}

TEST(ActivityFactor, OfMultiplicationsGrowsWithTheBitsThatToggle) {
  PowerParameters p;
  p.activity_toggle.set(1);
  EXPECT_DOUBLE_EQ(activity_factor(p, {.cycles = 100, .mac_operations = 100}), 1.29);
  EXPECT_DOUBLE_EQ(activity_factor(p, {.cycles = 100, .alu_operations = 100}), 1.00);
  p.activity_toggle.set(0.5);
  EXPECT_DOUBLE_EQ(activity_factor(p, {.cycles = 100, .mac_operations = 100}), 1.145);
}

TEST(ActivityFactor, AveragesSleepAndWork) {
  const PowerParameters p;
  EXPECT_DOUBLE_EQ(activity_factor(p, {.cycles = 100, .idle_cycles = 50, .alu_operations = 50}),
                   (0.43 + 1.00) / 2);
}

TEST(ActivityFactor, StopsAtTheDearestClass) {
  const PowerParameters p;
  EXPECT_DOUBLE_EQ(
      activity_factor(p, {.cycles = 10, .mac_operations = 10, .access_operations = 20}), 1.00);
}

TEST(ActivityFactor, OfACoreThatNeverRanIsIdle) {
  const PowerParameters p;
  EXPECT_DOUBLE_EQ(activity_factor(p, {}), 0.43);
}

// hardware.md 5.2: at 600 MHz, 1.30 V, 25 C, TYP on both: 141 + 468 + 94 + 86 = 789 mA.
TEST(CorePower, GivesTheWorkedExampleAt600Megahertz) {
  PowerParameters p;
  p.junction_celsius.set(25);
  const PowerEstimate estimate = estimate_power(p, typical_second());
  EXPECT_DOUBLE_EQ(estimate.core_volts, 1.30);
  EXPECT_NEAR(find(estimate, "core.leakage").amperes, 0.141, 0.0005);
  EXPECT_NEAR(find(estimate, "core_a.dynamic").amperes, 0.234, 0.0005);
  EXPECT_NEAR(find(estimate, "core_b.dynamic").amperes, 0.234, 0.0005);
  EXPECT_NEAR(find(estimate, "core.shared").amperes, 0.094, 0.0005);
  EXPECT_NEAR(find(estimate, "core.system_clock").amperes, 0.086, 0.0005);
}

// The three remembered IDD-TYP points of hardware.md 5.2, as its own fit returns them.
TEST(CorePower, GivesTheFitsOfTheDataSheetPoints) {
  struct Point {
    double core_megahertz, system_megahertz, volts, milliamperes;
  };
  for (const Point& point :
       {Point{600, 120, 1.35, 824}, Point{500, 120, 1.25, 662}, Point{50, 50, 0.80, 104}}) {
    PowerParameters p;
    p.junction_celsius.set(25);
    p.core_volts.set(point.volts);
    Activity activity = typical_second();
    activity.core_hertz = point.core_megahertz * 1e6;
    activity.system_hertz = point.system_megahertz * 1e6;
    double amperes = 0;
    for (const char* name :
         {"core.leakage", "core_a.dynamic", "core_b.dynamic", "core.shared", "core.system_clock"}) {
      amperes += find(estimate_power(p, activity), name).amperes;
    }
    EXPECT_NEAR(amperes * 1e3, point.milliamperes, 1.5) << point.core_megahertz << " MHz";
  }
}

// Every mode takes less than the one before, and what stands still takes nothing.
TEST(PowerModes, CostWhatStillRuns) {
  const PowerParameters p;
  Activity activity = typical_second();
  activity.cores = {};
  double before = estimate_power(p, typical_second()).watts;
  for (const clock::Mode mode : {clock::Mode::full_on, clock::Mode::sleep, clock::Mode::deep_sleep,
                                 clock::Mode::hibernate}) {
    activity.mode = mode;
    const PowerEstimate estimate = estimate_power(p, activity);
    EXPECT_LT(estimate.watts, before) << clock::name_of(mode);
    before = estimate.watts;
    const bool core_runs = mode == clock::Mode::full_on;
    const bool system_runs = core_runs || mode == clock::Mode::sleep;
    EXPECT_EQ(find(estimate, "core_a.dynamic").watts > 0, core_runs);
    EXPECT_EQ(find(estimate, "core.shared").watts > 0, core_runs);
    EXPECT_EQ(find(estimate, "core.system_clock").watts > 0, system_runs);
    EXPECT_EQ(find(estimate, "io.sdram_clock").watts > 0, system_runs);
    EXPECT_EQ(find(estimate, "core.leakage").watts > 0, mode != clock::Mode::hibernate);
  }
  // Two devices in self-refresh, 75 % of 2.5 mA.
  EXPECT_NEAR(find(estimate_power(p, activity), "sdram").amperes, 2 * 0.75 * 0.0025, 1e-9);
}

TEST(PowerModes, VoltageIsWhatSoftwareSetUnlessTheBoardFixesIt) {
  PowerParameters p;
  Activity activity = typical_second();
  activity.core_hertz = 300e6;
  activity.core_volts = 1.15;
  EXPECT_EQ(estimate_power(p, activity).core_volts, 1.15);
  activity.core_volts = 0;
  EXPECT_EQ(estimate_power(p, activity).core_volts, 0.90);
  p.core_volts.set(1.2);
  activity.core_volts = 1.15;
  EXPECT_EQ(estimate_power(p, activity).core_volts, 1.2);
}

TEST(PowerModes, TheAverageGoesByTime) {
  const PowerParameters p;
  Activity slow = typical_second();
  slow.mode = clock::Mode::sleep;
  const TimedEstimate work{estimate_power(p, typical_second()), 1};
  const TimedEstimate sleep{estimate_power(p, slow), 3};
  const PowerEstimate both = average(std::array{work, sleep});
  EXPECT_NEAR(both.watts, (work.estimate.watts + 3 * sleep.estimate.watts) / 4, 1e-12);
  EXPECT_NEAR(find(both, "core_a.dynamic").watts, find(work.estimate, "core_a.dynamic").watts / 4,
              1e-12);
  double sum = 0;
  for (const PowerComponent& component : both.components) {
    sum += component.watts;
  }
  EXPECT_NEAR(sum, both.watts, 1e-12);
  EXPECT_EQ(average(std::array{work}).watts, work.estimate.watts);
}

TEST(CorePower, LeakageDoublesIn35Degrees) {
  PowerParameters cold;
  cold.junction_celsius.set(25);
  PowerParameters warm;
  warm.junction_celsius.set(25 + 34.66);
  const auto leakage = [](const PowerParameters& p) {
    return find(estimate_power(p, typical_second()), "core.leakage").amperes;
  };
  EXPECT_NEAR(leakage(warm) / leakage(cold), 2.0, 0.001);
}

// hardware.md 5.3: 54 pins at 120 MHz, 3.3 V, toggle 0.25: 0.26 W x utilisation; clock pins 39 mW.
TEST(ExternalBus, CostsByUtilisation) {
  const PowerParameters p;
  Activity activity = typical_second();
  EXPECT_DOUBLE_EQ(find(estimate_power(p, activity), "io.external_bus").watts, 0);
  activity.external_beats = 60'000'000;  // half of a second's SCLK cycles
  const PowerEstimate estimate = estimate_power(p, activity);
  EXPECT_DOUBLE_EQ(estimate.bus_utilisation, 0.5);
  EXPECT_NEAR(find(estimate, "io.external_bus").watts, 0.26 / 2, 0.003);
  EXPECT_NEAR(find(estimate, "io.sdram_clock").watts, 2 * 0.039, 0.001);
}

// hardware.md 5.5: two devices, 10 % burst: 103 mA at most.
TEST(Sdram, CostsStandbyBurstAndRefresh) {
  PowerParameters p;
  p.sdram_typical_share.set(1);
  Activity activity = typical_second();
  activity.external_beats = 12'000'000;
  EXPECT_NEAR(find(estimate_power(p, activity), "sdram").amperes, 0.103, 0.001);
}

// hardware.md 5.5's two columns: the board draws between 1.81 and 2.40 W.
TEST(Board, FallsInTheSanityBudget) {
  PowerParameters low;
  low.junction_celsius.set(40);
  Activity modest;
  modest.cycles = kSecond;
  for (CoreActivity& core : modest.cores) {
    core = {.cycles = kSecond,
            .idle_cycles = kSecond / 5,
            .mac_operations = kSecond * 8 / 10 * 28 / 100};  // APP's 0.88 while awake
  }
  modest.external_beats = 12'000'000;
  EXPECT_NEAR(estimate_power(low, modest).watts, 1.81, 0.12);

  PowerParameters high;
  high.junction_celsius.set(60);
  Activity busy = typical_second();
  busy.external_beats = 30'000'000;
  EXPECT_NEAR(estimate_power(high, busy).watts, 2.40, 0.12);
}

TEST(Board, IsTheSumOfItsComponents) {
  const PowerEstimate estimate = estimate_power(PowerParameters(), typical_second());
  double sum = 0;
  std::set<std::string> names;
  for (const PowerComponent& part : estimate.components) {
    sum += part.watts;
    names.insert(part.name);
    EXPECT_NEAR(part.watts, part.volts * part.amperes, 1e-12) << part.name;
    EXPECT_FALSE(part.source.empty()) << part.name;
  }
  EXPECT_EQ(names.size(), estimate.components.size());
  EXPECT_DOUBLE_EQ(estimate.watts, sum);
  EXPECT_NEAR(estimate.amperes, estimate.watts / 3.3, 1e-12);
}

TEST(Board, NeedsTimeToAverageOver) {
  EXPECT_THROW((void)estimate_power(PowerParameters(), Activity()), std::logic_error);
}

}  // namespace
}  // namespace finback::power
