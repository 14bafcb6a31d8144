// The declared numbers of the DMA controllers. What a burst costs at either end is the memories'
// (memory_parameters.hpp).
#pragma once

#include <common/parameter.hpp>

namespace finback::dma {

struct DmaParameters final : ParameterGroup {
  IntegerParameter startup_sclk{
      this,
      {"dma.startup_sclk", "SCLK", 8, 0, 1000, 'E', "hardware.md 3.2",
       "from the CONFIG write that enables the second side to the first read of memory"}};
  IntegerParameter burst_elements{
      this,
      {"dma.burst_elements", "", 16, 1, 64, 'E', "hardware.md 3.2",
       "elements that a stream moves before others may have the bus; its FIFO holds two bursts"}};
};

}  // namespace finback::dma
