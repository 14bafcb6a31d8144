// docs/fidelity.md holds what was published of currents and watts (hardware.md, section 5, marks V
// and D) against what the model says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/fidelity/figures_on_page.hpp>
#include <vector>

#include <clock_model/core_voltage.hpp>
#include <power_model/power_model.hpp>

namespace finback::power {
namespace {

constexpr Cycles kCycles = 1'200'000;

// EE-297's vectors, by what they issue, on typical data or on data of which every bit toggles.
PublishedFigure vector(const std::string& what, double published, const CoreActivity& issued,
                       double toggle = 0) {
  return {what, published, "of TYP", "V 5.2", [=] {
            PowerParameters p;
            p.activity_toggle.set(toggle);
            return activity_factor(p, issued);
          }};
}

// The core supply's current in mA, with both cores at an activity of at most 1, an ALU operation's.
double core_milliamperes(double megahertz, double system_megahertz, double volts, double celsius,
                         double activity) {
  PowerParameters p;
  p.junction_celsius.set(celsius);
  p.core_volts.set(volts);
  const double working = (activity - p.activity_idle) / (p.activity_alu - p.activity_idle);
  const auto busy = static_cast<Cycles>(working * kCycles);
  Activity done;
  done.core_hertz = megahertz * 1e6;
  done.system_hertz = system_megahertz * 1e6;
  done.cycles = kCycles;
  done.cores.fill({.cycles = kCycles, .idle_cycles = kCycles - busy, .alu_operations = busy});
  double amperes = 0;
  for (const PowerComponent& part : estimate_power(p, done).components) {
    if (part.name.starts_with("core") && part.name != "core.regulator_loss") {
      amperes += part.amperes;
    }
  }
  return 1e3 * amperes;
}
PublishedFigure core_current(double megahertz, double system_megahertz, double volts,
                             double milliamperes) {
  return {fmt::format("core supply, TYP on both cores, {:g} / {:g} MHz, {:.2f} V, 25 C", megahertz,
                      system_megahertz, volts),
          milliamperes, "mA", "D 5.2",
          [=] { return core_milliamperes(megahertz, system_megahertz, volts, 25, 1); }};
}

// Milliwatts of a component, with the external bus in use for a share of the time.
double board_part(const PowerParameters& p, const std::string& name, double system_hertz,
                  double utilisation) {
  Activity activity;
  activity.system_hertz = system_hertz;
  activity.cycles = kCycles;
  activity.external_beats =
      static_cast<std::uint64_t>(utilisation * kCycles * system_hertz / activity.core_hertz);
  for (const PowerComponent& part : estimate_power(p, activity).components) {
    if (part.name == name) {
      return 1e3 * part.watts;
    }
  }
  throw std::logic_error("no component " + name);
}
double pins_of_ee297() {
  PowerParameters p;
  p.bus_pins.set(36);
  p.io_volts.set(3.6);
  return board_part(p, "io.external_bus", 133e6, 0.5);
}
double camera_pins_of_ee297() {
  PowerParameters p;
  p.bus_pins.set(9);
  p.bus_toggle.set(1);
  p.io_volts.set(3.6);
  return board_part(p, "io.external_bus", 27e6, 1);
}
double sdram_milliamperes(double system_hertz, double utilisation) {
  PowerParameters p;
  p.sdram_typical_share.set(1);
  p.sdram_chips.set(1);
  return board_part(p, "sdram", system_hertz, utilisation) / 3.3;
}

std::vector<PublishedFigure> figures() {
  std::vector<PublishedFigure> all;
  constexpr double kPublished[] = {0.85, 0.90, 0.95, 1.00, 1.05, 1.10, 1.15, 1.20, 1.25, 1.30};
  constexpr double kMegahertz[] = {250, 300, 313, 350, 400, 444, 450, 475, 500, 600};
  for (std::size_t i = 0; i < std::size(kPublished); ++i) {
    all.push_back({fmt::format("least voltage at {:g} MHz, SBB600", kMegahertz[i]), kPublished[i],
                   "V", "V 5.1", [=] { return lowest_core_volts(kMegahertz[i] * 1e6); }});
  }
  all.push_back(vector("vector IDLE", 0.43, {.cycles = 100, .idle_cycles = 100}));
  all.push_back(vector("vector NOP", 0.72, {.cycles = 100}));
  all.push_back(vector("vector APP, 30 % MAC, the rest loads, stores, NOPs alike", 0.88,
                       {.cycles = 300, .mac_operations = 90, .access_operations = 140}));
  all.push_back(vector("vector TYP, 75 % MAC, 25 % ALU", 1,
                       {.cycles = 100, .alu_operations = 25, .mac_operations = 75}));
  const CoreActivity multiplying = {.cycles = 100, .mac_operations = 100};
  all.push_back(vector("vector HIGH, 100 % MAC, all bits toggling", 1.29, multiplying, 1));
  all.push_back(vector("vector PEAK, 100 % MAC, and DMA, all bits toggling", 1.33, multiplying, 1));
  all.push_back(core_current(600, 120, 1.35, 824));
  all.push_back(core_current(500, 120, 1.25, 662));
  all.push_back(core_current(50, 50, 0.80, 104));
  all.push_back(core_current(600, 120, 1.30, 789));
  all.push_back({"core supply, both cores 80 % APP, 20 % IDLE, 1.30 V, 40 C", 740, "mA", "D 5.5",
                 [] { return core_milliamperes(600, 120, 1.30, 40, 0.8 * 0.88 + 0.2 * 0.43); }});
  all.push_back({"core supply, both cores TYP, 1.30 V, 60 C", 931, "mA", "D 5.5",
                 [] { return core_milliamperes(600, 120, 1.30, 60, 1); }});
  all.push_back({"36 pins at 133 MHz, 3.6 V, half in use", 116, "mW", "V 5.3", pins_of_ee297});
  all.push_back({"9 pins at 27 MHz, 3.6 V, all changing", 47, "mW", "V 5.3", camera_pins_of_ee297});
  all.push_back({"54 pins at 120 MHz, 3.3 V, all in use", 260, "mW", "D 5.3",
                 [] { return board_part(PowerParameters(), "io.external_bus", 120e6, 1); }});
  all.push_back({"two SDRAM clock pins at 120 MHz", 78, "mW", "D 5.3",
                 [] { return board_part(PowerParameters(), "io.sdram_clock", 120e6, 0); }});
  all.push_back({"an SDRAM in a burst without end at 133 MHz, most", 135 + 3.5, "mA", "V 5.4",
                 [] { return sdram_milliamperes(133e6, 1); }});
  all.push_back({"an SDRAM with an open row, most", 40 + 3.5, "mA", "V 5.4",
                 [] { return sdram_milliamperes(120e6, 0); }});
  all.push_back({"two SDRAMs, a tenth of the time in bursts, 120 MHz, most", 103, "mA", "D 5.5",
                 [] { return 2 * sdram_milliamperes(120e6, 0.1); }});
  return all;
}

TEST(PublishedPower, StandsOnThePageAsTheModelHasIt) { expect_on_page(figures()); }

TEST(PublishedPower, IsMetThroughout) { EXPECT_THAT(not_met(figures()), testing::IsEmpty()); }

}  // namespace
}  // namespace finback::power
