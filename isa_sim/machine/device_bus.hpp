// The peripheral bus and everything on it: system registers from 0xFFC00000 to 0xFFDFFFFF.
//
// Models: DMA1, DMA2, IMDMA, SICA and SICB, parallel ports, watchdogs, timers, flags, the UART, the
// PLL, the external port, the host port; reads that hold the core, posted writes. A write takes
// effect at the time it is made, though the bus is busy with it for a while; SSYNC waits for that.
// Does not model: SPORT, SPI: an access there is a GuestFault that names the nearest register there
// is. Source: hardware.md 1.6, 3.1, 4.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <clock_model/pll.hpp>
#include <common/counters.hpp>
#include <common/device.hpp>
#include <common/units.hpp>
#include <dma_model/dma_controller.hpp>
#include <isa_sim/machine/external_port.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/peripherals.hpp>
#include <isa_sim/machine/system_interrupts.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::machine {

inline constexpr Address kSystemRegisterBase = 0xFFC00000;
inline constexpr Address kCoreRegisterBase = 0xFFE00000;  // not this bus: each core's own

struct DeviceRead {
  std::uint32_t value = 0;
  Cycles stall = 0;  // beyond the issue cycle
};

class DeviceBus {
 public:
  DeviceBus(const MachineDescription& description, memory::MemorySystem& memory,
            SystemInterrupts::Outputs interrupt_outputs);
  DeviceBus(const DeviceBus&) = delete;
  DeviceBus& operator=(const DeviceBus&) = delete;

  // Access of `core` to a system register at `now`; 2 or 4 bytes. The bus must have been advanced
  // to `now`. Throws GuestFault naming address and register; the caller adds who and where.
  DeviceRead read(int core, Address address, int bytes, Cycles now);
  // Returns the stall beyond the issue cycle.
  Cycles write(int core, Address address, int bytes, std::uint32_t value, Cycles now);
  // When the posted writes of `core` have all arrived (SSYNC); may be in the past.
  [[nodiscard]] Cycles writes_drained_at(int core) const {
    return bus_free_at_[static_cast<std::size_t>(core)];
  }

  // One actor for all devices: DMA streams and interrupt lines on their way.
  [[nodiscard]] Cycles next_event_time() const { return next_event_; }
  // Does everything due up to and including `now`, in the order of time (on equal times interrupts
  // first, then the devices in the order of their mappings).
  void advance(Cycles now);

  // The name of the register at `address`, "" when there is none: "SICA_IMASK0", "MDMA1_D0_CONFIG".
  [[nodiscard]] std::string register_name(Address address) const;

  // All devices, in the order in which they act on equal times.
  [[nodiscard]] const std::vector<DeviceMapping>& mappings() const { return mappings_; }

  [[nodiscard]] HostPort& host() { return host_; }
  [[nodiscard]] SystemInterrupts& interrupts() { return interrupts_; }
  [[nodiscard]] Peripherals& peripherals() { return peripherals_; }
  // The PLL waits for the cores' IDLE; its change begins when they have come to it.
  [[nodiscard]] clock::Pll& pll() { return pll_; }
  void begin_clock_change(Cycles at);
  // Gets every change of the clocks; it is to call change_clock().
  using Clocked =
      std::function<void(const clock::OperatingPoint& point, clock::ClockRatio ratio, Cycles at)>;
  void set_clocked(Clocked clocked) { clocked_ = std::move(clocked); }
  // Everything on the bus, and the bus itself, from now on.
  void change_clock(const clock::ClockChange& change);
  // `who` describes the instruction that is writing a register now, for faults that come of it
  // later.
  void set_writer(const std::function<std::string()>& who);
  void register_counters(CounterRegistry& registry) const;

 private:
  using Mapping = DeviceMapping;

  // What devices call when one of their interrupt lines changes.
  [[nodiscard]] std::function<void(int source, bool level, Cycles at)> line_setter();
  [[nodiscard]] const Mapping* find_mapping(Address address) const;
  [[nodiscard]] std::string nearest_register(Address address) const;
  const Mapping& check(Address address, int bytes, bool write) const;
  void plan_next_event();

  memory::MemorySystem& memory_;
  Cycles read_sclk_;
  Cycles write_sclk_;
  clock::ClockRatio ratio_;
  std::array<Cycles, kCoreCount> bus_free_at_{};
  Cycles next_event_ = kNever;
  SystemInterrupts interrupts_;
  InterruptRegisters sica_{interrupts_, 0};
  InterruptRegisters sicb_{interrupts_, 1};
  HostPort host_;
  ExternalPort external_port_;
  dma::DmaController dma1_;
  dma::DmaController dma2_;
  dma::DmaController imdma_;
  Peripherals peripherals_;
  Clocked clocked_;
  clock::Pll pll_;
  std::vector<Mapping> mappings_;
};

}  // namespace finback::machine
