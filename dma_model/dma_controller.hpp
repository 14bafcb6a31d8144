// A DMA controller: DMA1 or DMA2 with 12 peripheral channels and two memory streams, or IMDMA with
// two streams between L1 and L2.
//
// Models: all channels' registers, TC_PER and TC_CNT; on each memory one burst of this controller
// at a time, granted by traffic_control.hpp's order whenever one ends; interrupt lines by channel
// or stream, and one for errors; IMDMA's limit of 500 MHz (anomaly 05000182, a GuestFault). What
// meets the cores, the other controllers and refresh is the memories'. Does not model: a burst
// broken off for somebody more urgent; SPORT and SPI, which no channel of DMA2 has behind it.
// Source: hardware.md 0.1, 2.5, 3; docs/dma.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <common/counters.hpp>
#include <common/device.hpp>
#include <common/units.hpp>
#include <dma_model/memory_side.hpp>
#include <dma_model/peripheral_port.hpp>
#include <dma_model/traffic_control.hpp>

namespace finback::dma {

enum class Controller : std::uint8_t { dma1, dma2, imdma };

class DmaController final : public Device {
 public:
  // Offsets: DMA1 and DMA2 from 0xFFC01B00 and 0xFFC00B00, IMDMA from its D0. Names are whole:
  // "DMA1_0_CONFIG", "MDMA1_D0_CONFIG", "DMA1_TC_PER".
  static constexpr std::uint32_t kTrafficPeriods = 0x0C;
  static constexpr std::uint32_t kTrafficCounts = 0x10;
  static constexpr std::uint32_t kChannels = 0x100;
  static constexpr std::uint32_t kStreams =
      kChannels + TrafficControl::kPeripheralLanes * kChannelBytes;
  static constexpr std::uint32_t kRegisterBytes = kStreams + 4 * kChannelBytes;
  static constexpr std::uint32_t kInternalRegisterBytes = 4 * kChannelBytes;

  // Numbers of its interrupt sources.
  struct Sources {
    int channel_0 = 0;
    int stream_0 = 0;
    int error = 0;
  };
  // Told about every change of an interrupt line, by the number of its source.
  using InterruptLine = std::function<void(int source, bool level, Cycles at)>;

  DmaController(Controller which, const DmaParameters& parameters,
                const memory::ClockParameters& clock, memory::MemorySystem& memory,
                const Sources& sources, InterruptLine interrupt);

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::string register_name(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  // Throws GuestFault for what cannot be started, unless dma.errors_fault is 0.
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  // Throws GuestFault when a transfer leaves memory that DMA can reach or meets a descriptor that
  // makes no sense; the message tells who started it.
  void advance(Cycles now) override;

  // From now on. Throws GuestFault for a stream of IMDMA that runs and would be too fast.
  void change_clock(const clock::ClockChange& change);

  // Peripheral 0 to 11, as PERIPHERAL_MAP counts: of DMA1 0 is PPI0, 1 is PPI1; of DMA2 0 to 3 are
  // SPORT0 and SPORT1 receive and transmit, 4 is SPI, 5 and 6 are UART receive and transmit.
  [[nodiscard]] PeripheralPort& port(std::uint32_t peripheral) { return ports_[peripheral]; }
  // `who` describes the instruction that is writing a register now: "core_a in main (...)".
  void set_writer(std::function<std::string()> who) { writer_ = std::move(who); }
  // dma.<initiator>.units.events and .descriptors.events.
  void register_counters(CounterRegistry& registry) const;

 private:
  friend class PeripheralPort;

  static constexpr std::uint32_t kLaneCount = TrafficControl::kLaneCount;
  static constexpr std::size_t kPortCount = memory::kDmaPortCount + 1;  // with `none`

  struct Lane {
    std::unique_ptr<ByteFifo> own_fifo;  // of a peripheral channel
    std::unique_ptr<MemorySide> side;    // none: IMDMA has no peripheral channels
    std::uint32_t last_chunk = 0;        // of its peripheral: urgent without room for another
    std::string started_by;
  };
  struct Choice {
    std::uint32_t lane = kLaneCount;
    std::uint32_t rank = 0;
    memory::Direction direction = memory::Direction::read;
    std::uint32_t wanted = 0;  // bit by direction: somebody wants it
  };
  static constexpr std::uint32_t kErrorLine = TrafficControl::kPeripheralLanes + 2;

  void make_lane(std::uint32_t lane, const DmaParameters& parameters);
  [[nodiscard]] DmaChannel make_channel(std::uint32_t lane) const;
  [[nodiscard]] memory::Initiator initiator_of(std::uint32_t lane) const;
  [[nodiscard]] std::uint32_t lane_at(std::uint32_t offset) const;
  void note_access(std::uint32_t lane, memory::Direction direction) const;
  void start(std::uint32_t lane, Cycles now);
  void check_core_clock(std::uint32_t lane) const;
  void check_map(std::uint32_t lane) const;
  void map_peripherals();

  void act(std::uint32_t lane, Cycles now);
  void arbitrate(Cycles now);
  void ask_for_bus(Choice& choice, Cycles now);
  bool grant(const Choice& choice, memory::DmaPort port, Cycles now);
  [[nodiscard]] bool urgent(std::uint32_t lane) const;
  [[nodiscard]] bool other_stream_runs(std::uint32_t lane) const;
  [[nodiscard]] std::string began(std::uint32_t lane, const DmaError& error) const;
  void fail(std::uint32_t lane, const std::string& message, Cycles now);
  void update_line(std::uint32_t lane, Cycles now);
  void update_error_line(Cycles now);
  void set_line(std::uint32_t index, int source, bool level, Cycles now);
  void settle(Cycles now);
  void plan_next_event(Cycles now);

  // For the ports: peripheral_port.cpp.
  [[nodiscard]] Lane* lane_for(std::uint32_t peripheral, bool receives);
  bool push(std::uint32_t peripheral, std::span<const std::uint8_t> bytes, Cycles now);
  bool pull(std::uint32_t peripheral, std::span<std::uint8_t> bytes, Cycles now);
  [[nodiscard]] bool running(std::uint32_t peripheral) const;
  [[nodiscard]] std::uint32_t element_bytes(std::uint32_t peripheral) const;

  Controller which_;
  double cclk_mhz_;
  clock::ClockRatio ratio_;
  bool errors_fault_;
  memory::MemorySystem& memory_;
  Sources sources_;
  InterruptLine interrupt_;
  std::function<std::string()> writer_;
  std::array<std::unique_ptr<ByteFifo>, 2> stream_fifos_;
  std::array<Lane, kLaneCount> lanes_;
  std::array<PeripheralPort, TrafficControl::kPeripheralLanes> ports_;
  std::array<std::uint32_t, TrafficControl::kPeripheralLanes> lane_by_peripheral_{};
  TrafficControl traffic_;
  std::array<Cycles, kPortCount> busy_until_{};
  std::array<bool, kPortCount> waited_for_{};
  Cycles ask_again_at_ = kNever;             // for the external bus
  std::array<bool, kErrorLine + 1> line_{};  // peripheral channels, two streams, errors
  std::uint32_t active_ = 0;                 // bit by lane: its channel may run
};

}  // namespace finback::dma
