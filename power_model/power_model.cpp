#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

#include <clock_model/core_voltage.hpp>
#include <common/error.hpp>
#include <power_model/power_model.hpp>

namespace finback::power {

namespace {

// The clock at which the SDRAM's burst current is specified (-75 grade).
constexpr double kSdramSpecificationHertz = 133e6;

// The certainty letter and source of a component that rests on one parameter.
PowerComponent component(const std::string& name, double volts, double amperes,
                         const ParameterBase& basis) {
  return PowerComponent{.name = name,
                        .volts = volts,
                        .amperes = amperes,
                        .watts = volts * amperes,
                        .certainty = basis.declaration().certainty,
                        .source = std::string(basis.declaration().source)};
}

}  // namespace

double lowest_core_volts(double hertz) {
  if (const clock::SpeedGrade* grade = clock::grade_for(hertz / 1e6)) {
    return grade->volts;
  }
  throw InputError(
      fmt::format("core clock of {:g} MHz: the power model's voltage table ends at 600 MHz; set "
                  "power.core.volts",
                  hertz / 1e6));
}

double activity_factor(const PowerParameters& p, const CoreActivity& core) {
  if (core.cycles == 0) {
    return p.activity_idle;
  }
  const double busy = static_cast<double>(core.cycles - std::min(core.cycles, core.idle_cycles));
  const double asleep = static_cast<double>(core.cycles) - busy;
  const double nop = p.activity_nop;
  const double mac = p.activity_mac + p.activity_toggle * p.activity_mac_toggling;
  const auto above_nop = [nop](std::uint64_t operations, double factor) {
    return static_cast<double>(operations) * (factor - nop);
  };
  const double operations = above_nop(core.alu_operations, p.activity_alu) +
                            above_nop(core.mac_operations, mac) +
                            above_nop(core.access_operations, p.activity_access);
  const double dearest = std::max({double{p.activity_alu}, mac, double{p.activity_access}, nop});
  const double busy_activity = std::min(busy * nop + operations, busy * dearest);
  return (busy_activity + asleep * p.activity_idle) / static_cast<double>(core.cycles);
}

namespace {

double core_volts(const PowerParameters& p, const Activity& activity) {
  if (activity.mode == clock::Mode::hibernate) {
    return 0;
  }
  if (p.core_volts > 0) {
    return p.core_volts;
  }
  return activity.core_volts > 0 ? activity.core_volts : lowest_core_volts(activity.core_hertz);
}

}  // namespace

PowerEstimate estimate_power(const PowerParameters& p, const Activity& activity) {
  if (activity.cycles == 0) {
    throw std::logic_error("estimate_power: no time to average over");
  }
  const clock::Mode mode = activity.mode;
  const bool core_runs = mode == clock::Mode::full_on || mode == clock::Mode::active;
  const bool system_runs = core_runs || mode == clock::Mode::sleep;
  const double core_megahertz = core_runs ? activity.core_hertz / 1e6 : 0;
  const double system_hertz = system_runs ? activity.system_hertz : 0;
  const double system_megahertz = system_hertz / 1e6;
  const double seconds = static_cast<double>(activity.cycles) / activity.core_hertz;

  PowerEstimate estimate;
  auto& parts = estimate.components;
  const double volts = core_volts(p, activity);
  estimate.core_volts = volts;

  // Core supply, in amperes at the core's voltage.
  parts.push_back(component("core.leakage", volts,
                            1e-3 * p.leakage_milliamperes *
                                std::exp((p.junction_celsius - 25) / 50) * (volts / 1.25) *
                                (volts / 1.25),
                            p.leakage_milliamperes));
  for (int core = 0; core < kCoreCount; ++core) {
    const auto index = static_cast<std::size_t>(core);
    estimate.activity[index] = activity_factor(p, activity.cores[index]);
    parts.push_back(component(
        fmt::format("{}.dynamic", name_of(static_cast<CoreId>(core))), volts,
        1e-3 * estimate.activity[index] * p.core_dynamic * volts * core_megahertz, p.core_dynamic));
  }
  parts.push_back(component("core.shared", volts, 1e-3 * p.shared_dynamic * volts * core_megahertz,
                            p.shared_dynamic));
  parts.push_back(component("core.system_clock", volts,
                            1e-3 * p.system_dynamic * volts * system_megahertz, p.system_dynamic));
  double core_watts = 0;
  for (const PowerComponent& part : parts) {
    core_watts += part.watts;
  }
  const double io = p.io_volts;
  const double loss = core_watts / p.regulator_efficiency - core_watts;
  parts.push_back(component("core.regulator_loss", io, loss / io, p.regulator_efficiency));

  // External bus: I = toggle x pins x f/2 x V x C x utilisation (EE-297 equations 8 and 9).
  const double bus_cycles = seconds * activity.system_hertz;
  const double utilisation =
      std::min(1.0, static_cast<double>(activity.external_beats) / bus_cycles);
  estimate.bus_utilisation = utilisation;
  const double pin_amperes = io * p.pin_picofarads * 1e-12 * system_hertz;
  parts.push_back(component("io.external_bus", io,
                            p.bus_toggle * p.bus_pins * pin_amperes / 2 * utilisation, p.bus_pins));
  parts.push_back(component("io.sdram_clock", io, p.sdram_chips * pin_amperes, p.pin_picofarads));
  const double burst = p.sdram_burst_milliamperes * system_hertz / kSdramSpecificationHertz;
  parts.push_back(
      component("sdram", io,
                1e-3 * p.sdram_chips * p.sdram_typical_share *
                    (system_runs ? (1 - utilisation) * p.sdram_standby_milliamperes +
                                       utilisation * burst + p.sdram_refresh_milliamperes
                                 : p.sdram_self_refresh_milliamperes),
                p.sdram_typical_share));

  // The rest of the board.
  parts.push_back(component("cameras", io, p.cameras * p.camera_watts / io, p.camera_watts));
  parts.push_back(component("board", io, p.other_watts / io, p.other_watts));

  for (const PowerComponent& part : parts) {
    estimate.watts += part.watts;
  }
  estimate.amperes = estimate.watts / io;
  return estimate;
}

PowerEstimate average(std::span<const TimedEstimate> parts) {
  PowerEstimate sum = parts.front().estimate;
  if (parts.size() == 1) {
    return sum;
  }
  double seconds = 0;
  for (const TimedEstimate& part : parts) {
    seconds += part.seconds;
  }
  const auto mean = [&](const auto& value) {
    double total = 0;
    for (const TimedEstimate& part : parts) {
      total += value(part.estimate) * part.seconds;
    }
    return total / seconds;
  };
  sum.watts = mean([](const PowerEstimate& e) { return e.watts; });
  sum.amperes = mean([](const PowerEstimate& e) { return e.amperes; });
  sum.core_volts = mean([](const PowerEstimate& e) { return e.core_volts; });
  sum.bus_utilisation = mean([](const PowerEstimate& e) { return e.bus_utilisation; });
  for (std::size_t core = 0; core < sum.activity.size(); ++core) {
    sum.activity[core] = mean([core](const PowerEstimate& e) { return e.activity[core]; });
  }
  for (std::size_t i = 0; i < sum.components.size(); ++i) {
    PowerComponent& component = sum.components[i];
    component.watts = mean([i](const PowerEstimate& e) { return e.components[i].watts; });
    component.amperes = mean([i](const PowerEstimate& e) { return e.components[i].amperes; });
    if (component.amperes > 0) {
      component.volts = component.watts / component.amperes;
    }
  }
  return sum;
}

}  // namespace finback::power
