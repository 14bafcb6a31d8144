// Where a peripheral meets its DMA channel: it pushes what it has received, or pulls what it shall
// send.
//
// Models: a FIFO of `dma.peripheral_fifo_bytes` between the two, and urgency: a FIFO that has no
// room for another push like the last one (or no bytes for another pull) asks above the others.
// Does not model: the DAB bus: a push arrives whole, at once. Which channel serves the peripheral
// is PERIPHERAL_MAP's matter.
//
// A capturing peripheral, in its own event at `now`:
//     if (!port.push(bytes, now)) { overrun: these bytes are lost; set the status bit }
// A transmitting one: when it needs bytes and port.pull() says false it is an underrun, or it waits
// for its `refilled`.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <common/units.hpp>

namespace finback::dma {

class DmaController;

class PeripheralPort {
 public:
  // Pushes and pulls of more bytes than this never fit.
  static constexpr std::size_t kMostBytes = 32;

  PeripheralPort() = default;
  PeripheralPort(DmaController& controller, std::uint32_t peripheral)
      : controller_(&controller), peripheral_(peripheral) {}

  // All of `bytes` go into the FIFO; false: there is no room for them, and none of them goes. A
  // channel that is not enabled takes bytes until the FIFO is full, too. Throws GuestFault when the
  // channel is set to transmit (WNR = 0).
  bool push(std::span<const std::uint8_t> bytes, Cycles now);
  // Takes bytes.size() bytes out of the FIFO; false: there are not as many, and none is taken.
  // Throws GuestFault when the channel is set to receive (WNR = 1).
  bool pull(std::span<std::uint8_t> bytes, Cycles now);
  // Its channel is enabled and has not come to its end.
  [[nodiscard]] bool running() const;
  // Bytes of the channel's element, WDSIZE; 0 while it does not run.
  [[nodiscard]] std::uint32_t element_bytes() const;
  // Called when a burst has come from memory into the FIFO.
  void set_refilled(std::function<void(Cycles now)> refilled) { refilled_ = std::move(refilled); }
  void refilled(Cycles now) const {
    if (refilled_) {
      refilled_(now);
    }
  }

 private:
  DmaController* controller_ = nullptr;
  std::uint32_t peripheral_ = 0;
  std::function<void(Cycles)> refilled_;
};

}  // namespace finback::dma
