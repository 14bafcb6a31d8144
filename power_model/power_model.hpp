// Where the watts go: activity counts x an energy table.
//
// Models the board's average power over a run: core leakage by voltage and temperature, dynamic
// current of each core by what it executed (activity factors of EE-297), shared and system clock
// domains, the regulator's loss, external bus pins and SDRAM by their utilisation, cameras and the
// rest of the board; sleep, deep sleep and hibernation. A run that changes its clocks is the sum of
// its operating points. Does not model: what a change itself costs, data-dependent toggling, L2's
// own accesses, self-heating. Source: hardware.md section 5; docs/power.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <clock_model/operating_point.hpp>
#include <common/units.hpp>
#include <power_model/power_parameters.hpp>

namespace finback::power {

// What a core did. `operations` may exceed `cycles`: up to three issue in one cycle.
struct CoreActivity {
  Cycles cycles = 0;       // of the whole time looked at, asleep or not
  Cycles idle_cycles = 0;  // of these, asleep; a core that was never started sleeps all the time
  std::uint64_t alu_operations = 0;
  std::uint64_t mac_operations = 0;
  std::uint64_t access_operations = 0;
};

struct Activity {
  double core_hertz = 600e6;
  double system_hertz = 120e6;
  double core_volts = 0;  // as software set them; 0: the lowest that the core clock allows
  clock::Mode mode = clock::Mode::full_on;
  Cycles cycles = 0;  // CCLK cycles of the time looked at; must not be 0
  std::array<CoreActivity, kCoreCount> cores;
  std::uint64_t external_beats = 0;  // transfers of up to 32 bits on the external bus
};

struct PowerComponent {
  std::string name;    // "core_a.dynamic"
  double volts = 0;    // of its supply
  double amperes = 0;  // at that supply
  double watts = 0;
  char certainty = 'E';  // as in hardware.md: V verified, D derived, M from memory, E estimate
  std::string source;
};

struct PowerEstimate {
  double watts = 0;    // of the whole board: the sum of the components
  double amperes = 0;  // the same at the board's supply
  double core_volts = 0;
  double bus_utilisation = 0;                 // 0 to 1
  std::array<double, kCoreCount> activity{};  // activity factor of each core
  std::vector<PowerComponent> components;     // in the order of the model's page
};

// The lowest supply, in volts, at which the core may be clocked at `hertz` (hardware.md 5.1, column
// SBB600). Throws InputError above 600 MHz.
[[nodiscard]] double lowest_core_volts(double hertz);

// The activity factor of a core over its cycles: the idle ones at `activity_idle`, the others at
// `activity_nop` and, for each operation, what its class costs above that; a cycle costs at most
// what its dearest class does. 0 cycles count as asleep.
[[nodiscard]] double activity_factor(const PowerParameters& parameters, const CoreActivity& core);

// Throws std::logic_error when `activity.cycles` is 0, InputError for an impossible clock.
[[nodiscard]] PowerEstimate estimate_power(const PowerParameters& parameters,
                                           const Activity& activity);

struct TimedEstimate {
  PowerEstimate estimate;
  double seconds = 0;
};
// Over all of them, which are of one board; at least one, with a time above 0.
[[nodiscard]] PowerEstimate average(std::span<const TimedEstimate> parts);

}  // namespace finback::power
