// The declared numbers of the DMA controllers. What a burst costs at either end is the memories'
// (memory_parameters.hpp).
#pragma once

#include <common/parameter.hpp>

namespace finback::dma {

struct DmaParameters final : ParameterGroup {
  IntegerParameter startup_sclk{
      this,
      {"dma.startup_sclk", "SCLK", 8, 0, 1000, 'E', "hardware.md 3.2",
       "from the CONFIG write that enables a channel (of a stream: the second side) to its first "
       "wish for the memory"}};
  IntegerParameter imdma_startup_cycles{this,
                                        {"dma.imdma_startup_cycles", "CCLK", 20, 0, 1000, 'E',
                                         "hardware.md 3.2", "the same for a stream of IMDMA"}};
  IntegerParameter burst_elements{
      this,
      {"dma.burst_elements", "", 16, 1, 64, 'E', "hardware.md 3.2",
       "elements that a channel moves before others may have the bus; the FIFO of a memory stream "
       "holds two bursts"}};
  IntegerParameter descriptor_overhead_sclk{
      this,
      {"dma.descriptor_overhead_sclk", "SCLK", 1, 0, 100, 'E', "hardware.md 3.2",
       "of a descriptor fetch, besides what a burst of its 16-bit words takes in that memory"}};
  IntegerParameter peripheral_fifo_bytes{
      this,
      {"dma.peripheral_fifo_bytes", "bytes", 64, 32, 1024, 'E', "hardware.md 3.2",
       "what a peripheral and its DMA channel hold between them before data is lost"}};
  IntegerParameter errors_fault{
      this,
      {"dma.errors_fault", "", 1, 0, 1, 'E', "hardware.md 3.1",
       "1: what the chip flags as a DMA error ends the run with a message; 0: it sets DMA_ERR, "
       "stops the channel and raises the controller's error interrupt, as on the chip"}};
};

}  // namespace finback::dma
