// A memory system with DMA1 and DMA2 on it, and transfers told in one line.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include <common/error.hpp>
#include <dma_model/dma_controller.hpp>

namespace finback::dma {

inline constexpr Address kL3 = 0x10000;
inline constexpr Address kL2 = 0xFEB00000;
inline constexpr Address kL1A = 0xFF800000;   // core A, data bank A
inline constexpr Address kL1A2 = 0xFF900000;  // core A, data bank B
inline constexpr Address kL1B = 0xFF400000;   // core B, data bank A
inline constexpr Cycles kSclk = 5;

inline constexpr std::uint32_t kBits8 = 0U << 2;
inline constexpr std::uint32_t kBits16 = 1U << 2;
inline constexpr std::uint32_t kBits32 = 2U << 2;
inline constexpr std::uint32_t kAutobuffer = 1U << 12;

// Channel offsets in DMA1 and DMA2.
inline constexpr std::uint32_t kD0 = DmaController::kStreams, kS0 = kD0 + 0x40, kD1 = kD0 + 0x80,
                               kS1 = kD0 + 0xC0;
inline constexpr std::uint32_t kPpi0 = DmaController::kChannels, kPpi1 = kPpi0 + 0x40;

// Interrupt sources, as on the BF561.
inline constexpr DmaController::Sources kSources1 = {.channel_0 = 11, .stream_0 = 53, .error = 1};
inline constexpr DmaController::Sources kSources2 = {.channel_0 = 23, .stream_0 = 55, .error = 2};

struct LineChange {
  int source;
  bool level;
  Cycles at;
  friend bool operator==(const LineChange&, const LineChange&) = default;
};

class DmaTest : public testing::Test {
 protected:
  void build() {
    memory_ = std::make_unique<memory::MemorySystem>(memory::bf561_map(), memory_parameters_,
                                                     clock_, places_);
    lines_.clear();
    const auto note = [this](int source, bool level, Cycles at) {
      lines_.push_back({source, level, at});
    };
    dma1_ = std::make_unique<DmaController>(Controller::dma1, parameters_, clock_, *memory_,
                                            kSources1, note);
    dma2_ = std::make_unique<DmaController>(Controller::dma2, parameters_, clock_, *memory_,
                                            kSources2, note);
  }
  void SetUp() override { build(); }

  // Programs a channel of one dimension; enabling it is separate.
  static void program(DmaController& dma, std::uint32_t channel, Address start, std::uint32_t count,
                      std::int32_t modify) {
    dma.write(channel + kStartAddress, 4, start, 0);
    dma.write(channel + kXCount, 2, count, 0);
    dma.write(channel + kXModify, 2, static_cast<std::uint16_t>(modify), 0);
  }
  static void program_rows(DmaController& dma, std::uint32_t channel, std::uint32_t rows,
                           std::int32_t modify) {
    dma.write(channel + kYCount, 2, rows, 0);
    dma.write(channel + kYModify, 2, static_cast<std::uint16_t>(modify), 0);
  }
  static void enable(DmaController& dma, std::uint32_t stream, std::uint32_t config, Cycles now) {
    dma.write(0x80 * stream + kS0 + kConfig, 2, (config & ~kInterruptEnable) | kEnable, now);
    dma.write(0x80 * stream + kD0 + kConfig, 2, config | kEnable | kWriteMemory, now);
  }
  // A contiguous copy on stream 0 or 1; returns when the last word is written.
  Cycles copy(DmaController& dma, std::uint32_t stream, Address from, Address to,
              std::uint32_t count, std::uint32_t width, Cycles now) {
    const std::int32_t bytes = 1 << (width >> 2U);
    program(dma, 0x80 * stream + kS0, from, count, bytes);
    program(dma, 0x80 * stream + kD0, to, count, bytes);
    enable(dma, stream, width, now);
    return finish(dma);
  }
  static Cycles finish(DmaController& dma) {
    Cycles last = 0;
    while (dma.next_event_time() != kNever) {
      last = dma.next_event_time();
      dma.advance(last);
    }
    return last;
  }
  static std::uint32_t status(DmaController& dma, std::uint32_t channel) {
    return dma.read(channel + kIrqStatus, 2, 0);
  }
  std::vector<std::uint8_t> pattern(std::size_t size, std::uint32_t seed = 1) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) {
      seed = seed * 1664525 + 1013904223;
      byte = static_cast<std::uint8_t>(seed >> 24);
    }
    return bytes;
  }
  std::vector<std::uint8_t> bytes_at(Address address, std::uint32_t size) {
    const auto view = memory_->view_bytes(address, size);
    return {view.begin(), view.end()};
  }

  memory::MemoryParameters memory_parameters_;
  memory::ClockParameters clock_;
  DmaParameters parameters_;
  std::vector<memory::ObjectPlace> places_;
  std::unique_ptr<memory::MemorySystem> memory_;
  std::unique_ptr<DmaController> dma1_;
  std::unique_ptr<DmaController> dma2_;
  std::vector<LineChange> lines_;
};

}  // namespace finback::dma
