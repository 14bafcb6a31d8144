#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/peripherals.hpp>
#include <isa_sim/machine/system_interrupts.hpp>

namespace finback::machine {

using peripheral::Camera;
using peripheral::Flags;
using peripheral::GeneralTimers;
using peripheral::ParallelPort;
using peripheral::PinChange;
using peripheral::Uart;
using peripheral::Watchdog;

namespace {

int source_of(Uart::Line line) {
  switch (line) {
    case Uart::Line::received:
      return kUartReceive;
    case Uart::Line::transmitted:
      return kUartTransmit;
    default:
      return kUartError;
  }
}

}  // namespace

Peripherals::Peripherals(const MachineDescription& description, const Wires& wires)
    : wires_(wires),
      cameras_{{{Camera::Side::left, description.camera, description.clock.cclk_mhz},
                {Camera::Side::right, description.camera, description.clock.cclk_mhz}}},
      ports_{{{"PPI0", cameras_[0], description.peripherals, description.clock.sclk_mhz,
               port_outputs(0)},
              {"PPI1", cameras_[1], description.peripherals, description.clock.sclk_mhz,
               port_outputs(1)}}},
      watchdogs_{{{"WDOGA", description.clock.ratio(), watchdog_outputs(0)},
                  {"WDOGB", description.clock.ratio(), watchdog_outputs(1)}}},
      uart_(description.peripherals, description.clock.ratio(),
            [this](Uart::Line line, bool level, Cycles at) {
              wires_.line(source_of(line), level, at);
            }),
      timers8_(
          0, 8, description.peripherals, description.clock.ratio(),
          [this](int timer, bool level, Cycles at) { wires_.line(kTimer0 + timer, level, at); }),
      timers4_(
          8, 4, description.peripherals, description.clock.ratio(),
          [this](int timer, bool level, Cycles at) { wires_.line(kTimer0 + timer, level, at); }),
      flags_{{{0, flag_outputs(0)}, {1, flag_outputs(1)}, {2, flag_outputs(2)}}} {}

Watchdog::Outputs Peripherals::watchdog_outputs(int core) {
  return {.reset = [this, core](Cycles at) { watchdog_events_.reset(core, at); },
          .non_maskable = [this, core](Cycles at) { watchdog_events_.non_maskable(core, at); },
          .line = [this, core](bool level, Cycles at) { wires_.watchdog_line(core, level, at); }};
}

ParallelPort::Outputs Peripherals::port_outputs(int port) {
  return {.push = [this, port](std::span<const std::uint8_t> bytes,
                               Cycles now) { return wires_.capture(port, bytes, now); },
          .element_bytes = [this, port] { return wires_.capture_element(port); },
          .error_line = [this, port](bool level,
                                     Cycles at) { wires_.line(kPpi0Error + port, level, at); },
          .captured =
              [this, port](std::uint32_t frame, Cycles at) {
                if (port == 0) {
                  wires_.captured(frame, at);
                }
              }};
}

Flags::Outputs Peripherals::flag_outputs(int port) {
  return {.line = [this, port](int mask, bool level,
                               Cycles at) { wires_.line(kFlags0A + 2 * port + mask, level, at); },
          .changed =
              [this](const PinChange& change) {
                if (flag_listener_) {
                  flag_listener_(change);
                }
              }};
}

std::vector<DeviceMapping> Peripherals::mappings() {
  return {{0xFFC01000, ParallelPort::kRegisterBytes, "PPI0_", ports_.data()},
          {0xFFC01300, ParallelPort::kRegisterBytes, "PPI1_", &ports_[1]},
          {0xFFC00200, Watchdog::kRegisterBytes, "WDOGA_", &watchdogs_[0]},
          {0xFFC01200, Watchdog::kRegisterBytes, "WDOGB_", &watchdogs_[1]},
          {0xFFC00400, Uart::kRegisterBytes, "UART_", &uart_},
          {0xFFC00600, GeneralTimers::register_bytes(8), "", &timers8_},
          {0xFFC01600, GeneralTimers::register_bytes(4), "", &timers4_},
          {0xFFC00700, Flags::kRegisterBytes, "FIO0_", flags_.data()},
          {0xFFC01500, Flags::kRegisterBytes, "FIO1_", &flags_[1]},
          {0xFFC01700, Flags::kRegisterBytes, "FIO2_", &flags_[2]}};
}

void Peripherals::drive_flags(const std::vector<PinChange>& changes) {
  std::array<std::vector<PinChange>, 3> by_port;
  for (const PinChange& change : changes) {
    if (change.pin < 0 || change.pin >= 3 * peripheral::kFlagsOfAPort) {
      throw InputError(fmt::format("flag {}: the flags are PF0 to PF47", change.pin));
    }
    by_port.at(static_cast<std::size_t>(change.pin / peripheral::kFlagsOfAPort)).push_back(change);
  }
  for (std::size_t port = 0; port < flags_.size(); ++port) {
    flags_.at(port).drive(std::move(by_port.at(port)));
  }
}

void Peripherals::change_clock(const clock::ClockChange& change) {
  for (ParallelPort& port : ports_) {
    port.change_clock(change);
  }
  for (Watchdog& watchdog : watchdogs_) {
    watchdog.change_clock(change);
  }
  for (Flags& flags : flags_) {
    flags.change_clock(change);
  }
  uart_.change_clock(change);
  timers8_.change_clock(change);
  timers4_.change_clock(change);
}

void Peripherals::register_counters(CounterRegistry& registry) const {
  for (const ParallelPort& port : ports_) {
    port.register_counters(registry);
  }
}

}  // namespace finback::machine
