// A memory DMA controller: MDMA1 or MDMA2 with two streams, or IMDMA with its registers only.
//
// Models: four channels at D0 +0, S0 +0x40, D1 +0x80, S1 +0xC0; one interrupt line a stream. IMDMA:
// its registers can be read and written, enabling a channel is a GuestFault (above 500 MHz CCLK by
// anomaly 05000182, below because its transfers are not modelled). Source: hardware.md 0.1, 3.1.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

#include <common/units.hpp>
#include <dma_model/memory_dma_stream.hpp>

namespace finback::dma {

enum class Controller : std::uint8_t { mdma1, mdma2 };

// Told about every change of a stream's interrupt line: stream 0 or 1.
using InterruptLine = std::function<void(int stream, bool level, Cycles at)>;

class MemoryDma {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x100;

  MemoryDma(Controller controller, const DmaParameters& parameters, Cycles ratio,
            memory::MemorySystem& memory, InterruptLine interrupt);

  // Registers: `offset` below kRegisterBytes, 2 or 4 bytes. Throw GuestFault as DmaChannel does.
  // The controller must have been advanced to `now`.
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes) const;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now);

  // An actor: acts by itself at next_event_time(), when advanced.
  [[nodiscard]] Cycles next_event_time() const {
    return std::min(streams_[0].next_event_time(), streams_[1].next_event_time());
  }
  void advance(Cycles now);

 private:
  [[nodiscard]] const DmaChannel& channel(std::uint32_t offset) const;
  void update_line(std::size_t stream, Cycles now);

  std::array<MemoryDmaStream, 2> streams_;
  std::array<bool, 2> line_{};
  InterruptLine interrupt_;
};

class InternalMemoryDma {
 public:
  explicit InternalMemoryDma(double cclk_mhz);

  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes) const;
  void write(std::uint32_t offset, int bytes, std::uint32_t value);

 private:
  double cclk_mhz_;
  std::array<DmaChannel, 4> channels_;
};

}  // namespace finback::dma
