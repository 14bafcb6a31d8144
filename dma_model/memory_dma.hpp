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

#include <common/device.hpp>
#include <common/units.hpp>
#include <dma_model/memory_dma_stream.hpp>

namespace finback::dma {

inline constexpr std::uint32_t kChannelBytes = 0x40;

enum class Controller : std::uint8_t { mdma1, mdma2 };

// Told about every change of a stream's interrupt line: stream 0 or 1.
using InterruptLine = std::function<void(int stream, bool level, Cycles at)>;

// What both kinds have alike: four channels, D0, S0, D1, S1.
class MemoryDmaRegisters : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x100;

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::string register_name(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;

 protected:
  [[nodiscard]] virtual const DmaChannel& channel(std::uint32_t offset) const = 0;
};

class MemoryDma final : public MemoryDmaRegisters {
 public:
  MemoryDma(Controller controller, const DmaParameters& parameters, Cycles ratio,
            memory::MemorySystem& memory, InterruptLine interrupt);

  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;

 private:
  [[nodiscard]] const DmaChannel& channel(std::uint32_t offset) const override;
  void plan_next_event();
  void update_line(std::size_t stream, Cycles now);

  std::array<MemoryDmaStream, 2> streams_;
  std::array<bool, 2> line_{};
  InterruptLine interrupt_;
};

class InternalMemoryDma final : public MemoryDmaRegisters {
 public:
  explicit InternalMemoryDma(double cclk_mhz);

  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;

 private:
  [[nodiscard]] const DmaChannel& channel(std::uint32_t offset) const override {
    return channels_.at(offset / kChannelBytes);
  }

  double cclk_mhz_;
  std::array<DmaChannel, 4> channels_;
};

}  // namespace finback::dma
