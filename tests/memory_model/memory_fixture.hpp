// A memory system of the BF561 with a few placed objects, and short names for its parts.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>

#include <common/error.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::memory {

inline constexpr Address kL2 = 0xFEB00000;
inline constexpr Address kL1A = 0xFF800000;  // core A, data bank A
inline constexpr Address kL1B = 0xFF400000;  // core B, data bank A
inline constexpr Address kL3 = 0;
inline constexpr Cycles kSclk = 5;

class MemoryTest : public testing::Test {
 protected:
  // After changing parameters or places.
  void build() { memory_ = std::make_unique<MemorySystem>(map_, parameters_, clock_, places_); }

  MemorySystem& memory() {
    if (!memory_) {
      build();
    }
    return *memory_;
  }
  Span* span(int core, Address address) {
    Span* found = memory().find_span(core, address);
    if (found == nullptr) {
      throw std::logic_error("test address is not mapped");
    }
    return found;
  }
  Cycles read(int core, Address address, Cycles now) {
    return memory().core_read(core, span(core, address), address, 4, now);
  }
  Cycles write(int core, Address address, Cycles now) {
    return memory().core_write(core, span(core, address), address, 4, now);
  }
  Cycles dma(Direction direction, Address address, std::uint32_t words, Cycles now,
             Initiator initiator = Initiator::mdma1_0, bool further = false) {
    const DmaRun run{.address = address, .stride = 4, .count = words};
    return memory().dma_burst(initiator, direction, {&run, 1}, 4, now, now, further);
  }

  MemoryMap map_ = bf561_map();
  MemoryParameters parameters_;
  ClockParameters clock_;
  std::vector<ObjectPlace> places_;
  std::unique_ptr<MemorySystem> memory_;
};

}  // namespace finback::memory
