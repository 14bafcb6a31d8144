// Which of the channels that want the same memory gets it: the priorities of a DMA controller.
//
// Models: urgent requests first; peripheral channels above memory streams, lower numbers first;
// DCB and DEB traffic periods (who goes on in the direction of the transfer before goes first,
// until the period is over, then who turns round); the round-robin period of the memory streams,
// which take turns of that many elements, with one idle SCLK a turn when only one of them runs.
// Does not model: the DAB period (peripherals meet nobody on their bus), TC_CNT within a burst.
// Source: hardware.md 3.2; HRM537 5-50 to 5-54.
#pragma once

#include <array>
#include <cstdint>

#include <common/units.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::dma {

class TrafficControl {
 public:
  // Lanes 0 to 11 are the peripheral channels; streams begin behind them: D0, S0, D1, S1.
  static constexpr std::uint32_t kPeripheralLanes = 12;
  static constexpr std::uint32_t kLaneCount = kPeripheralLanes + 4;

  // TC_PER: DCB 3:0, DEB 7:4, DAB 10:8, MDMA round robin 15:11. Writing it starts all counts anew.
  void set_periods(std::uint32_t value);
  [[nodiscard]] std::uint32_t periods() const { return periods_; }
  // TC_CNT: what is left of each.
  [[nodiscard]] std::uint32_t counts() const;

  // Lower goes first; no two lanes have the same.
  [[nodiscard]] std::uint32_t rank(std::uint32_t lane, memory::DmaPort port,
                                   memory::Direction direction, bool urgent) const;
  // The most elements of a burst that `lane` is granted: `opposed`, somebody waits on the same bus
  // in the other direction; `contested`, the other stream runs.
  [[nodiscard]] std::uint32_t most_elements(std::uint32_t lane, memory::DmaPort port, bool opposed,
                                            bool contested) const;
  // `lane` was granted `elements`. Returns the idle SCLK behind it.
  std::uint32_t granted(std::uint32_t lane, memory::DmaPort port, memory::Direction direction,
                        std::uint32_t elements, bool contested);

 private:
  struct Bus {
    std::uint32_t period = 0;
    std::uint32_t count = 0;
    memory::Direction direction = memory::Direction::read;
  };
  static constexpr int kFree = -1;

  [[nodiscard]] const Bus& bus(memory::DmaPort port) const {
    return buses_[port == memory::DmaPort::external ? 1 : 0];
  }
  static int stream_of(std::uint32_t lane) {
    return lane < kPeripheralLanes ? kFree : static_cast<int>(lane - kPeripheralLanes) / 2;
  }
  void take_turn(int stream, std::uint32_t elements);

  std::uint32_t periods_ = 0;
  std::array<Bus, 2> buses_{};  // DCB: L1 and L2; DEB: external
  std::uint32_t turn_ = 0;      // the round-robin period
  std::uint32_t turn_left_ = 0;
  int turn_of_ = kFree;
  std::array<std::uint32_t, 2> alone_{};  // elements of a turn of a stream that runs alone
};

}  // namespace finback::dma
