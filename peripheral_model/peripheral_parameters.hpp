// The declared numbers of the ports and timers around the cores.
#pragma once

#include <common/parameter.hpp>

namespace finback::peripheral {

struct PeripheralParameters final : ParameterGroup {
  RealParameter ppi_clock_share{this,
                                {"ppi.clock_share", "SCLK", 0.5, 0.01, 1, 'M', "hardware.md 3.3",
                                 "the fastest pixel clock that a port takes, as a part of SCLK"}};
  IntegerParameter ppi_burst_bytes{
      this,
      {"ppi.burst_bytes", "bytes", 32, 4, 64, 'E', "hardware.md 3.3",
       "what a port gathers before it hands it to its DMA channel: a multiple of 4"}};
  IntegerParameter timer_start{
      this,
      {"timer.start_sclk", "SCLK", 3, 0, 100, 'M', "ADSP-BF533 Hardware Reference, timers",
       "from the write that enables a general-purpose timer to its first count"}};
  IntegerParameter uart_input_gap{this,
                                  {"uart.input_gap_sclk", "SCLK", 0, 0, 1e9, 'E', "none",
                                   "pause between two characters that the UART receives"}};
};

}  // namespace finback::peripheral
