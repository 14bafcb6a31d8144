// The devices around the cores but DMA, interrupt controllers and host port: made, wired, and at
// their addresses.
//
// Models: which interrupt source each drives (Linux mach-bf561/irq.h, hardware.md 4), watchdogs
// that interrupt, or reset, their own core. What a device does is in peripheral_model/.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <common/counters.hpp>
#include <common/device.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <peripheral_model/flags.hpp>
#include <peripheral_model/general_timers.hpp>
#include <peripheral_model/uart.hpp>
#include <peripheral_model/watchdog.hpp>

namespace finback::machine {

// Where a device's registers lie, and what stands before their names.
struct DeviceMapping {
  Address base = 0;
  std::uint32_t size = 0;
  const char* prefix = "";
  Device* device = nullptr;
};

class Peripherals {
 public:
  // What the machine does for them.
  struct Wires {
    std::function<void(int source, bool level, Cycles at)> line;
    std::function<void(int core, bool level, Cycles at)> watchdog_line;  // to its core alone
  };

  Peripherals(const MachineDescription& description, const Wires& wires);
  Peripherals(const Peripherals&) = delete;
  Peripherals& operator=(const Peripherals&) = delete;

  [[nodiscard]] std::vector<DeviceMapping> mappings();

  // A watchdog's other events. Called at their time, between the cores' turns.
  struct WatchdogEvents {
    std::function<void(int core, Cycles at)> reset;
    std::function<void(int core, Cycles at)> non_maskable;
  };
  void set_watchdog_events(WatchdogEvents events) { watchdog_events_ = std::move(events); }

  [[nodiscard]] peripheral::Uart& uart() { return uart_; }
  // Drives flags that are inputs, in the order of time; before the run. Throws InputError for a pin
  // that there is not.
  void drive_flags(const std::vector<peripheral::PinChange>& changes);
  // Gets every change of a flag that is an output.
  void set_flag_listener(std::function<void(const peripheral::PinChange&)> listener) {
    flag_listener_ = std::move(listener);
  }

 private:
  peripheral::Flags::Outputs flag_outputs(int port);
  peripheral::Watchdog::Outputs watchdog_outputs(int core);

  Wires wires_;
  WatchdogEvents watchdog_events_;
  std::function<void(const peripheral::PinChange&)> flag_listener_;
  std::array<peripheral::Watchdog, kCoreCount> watchdogs_;
  peripheral::Uart uart_;
  peripheral::GeneralTimers timers8_;
  peripheral::GeneralTimers timers4_;
  std::array<peripheral::Flags, 3> flags_;
};

}  // namespace finback::machine
