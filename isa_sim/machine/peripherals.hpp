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
#include <peripheral_model/camera.hpp>
#include <peripheral_model/flags.hpp>
#include <peripheral_model/general_timers.hpp>
#include <peripheral_model/parallel_port.hpp>
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
    // The DMA channels of PPI0 and PPI1, as ParallelPort::Outputs says.
    std::function<bool(int port, std::span<const std::uint8_t> bytes, Cycles now)> capture;
    std::function<std::uint32_t(int port)> capture_element;
    // PPI0, the left camera's, has read a whole frame.
    std::function<void(std::uint32_t frame, Cycles at)> captured;
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

  // Connects a camera, which none is before; before the run.
  void connect_camera(peripheral::Camera::Side side, peripheral::Camera::Pictures pictures,
                      const std::vector<peripheral::FrameTrouble>& troubles) {
    camera(side).connect(std::move(pictures), troubles);
  }
  [[nodiscard]] peripheral::Camera& camera(peripheral::Camera::Side side) {
    return cameras_.at(static_cast<std::size_t>(side));
  }
  [[nodiscard]] peripheral::Uart& uart() { return uart_; }
  // Drives flags that are inputs, in the order of time, in cycles of the clock at the start; before
  // the run. Throws InputError for a pin that there is not.
  void drive_flags(const std::vector<peripheral::PinChange>& changes);
  // Gets every change of a flag that is an output.
  void set_flag_listener(std::function<void(const peripheral::PinChange&)> listener) {
    flag_listener_ = std::move(listener);
  }
  // All of them, from now on.
  void change_clock(const clock::ClockChange& change);
  void register_counters(CounterRegistry& registry) const;

 private:
  peripheral::Flags::Outputs flag_outputs(int port);
  peripheral::Watchdog::Outputs watchdog_outputs(int core);
  peripheral::ParallelPort::Outputs port_outputs(int port);

  Wires wires_;
  WatchdogEvents watchdog_events_;
  std::function<void(const peripheral::PinChange&)> flag_listener_;
  std::array<peripheral::Camera, 2> cameras_;
  std::array<peripheral::ParallelPort, 2> ports_;
  std::array<peripheral::Watchdog, kCoreCount> watchdogs_;
  peripheral::Uart uart_;
  peripheral::GeneralTimers timers8_;
  peripheral::GeneralTimers timers4_;
  std::array<peripheral::Flags, 3> flags_;
};

}  // namespace finback::machine
