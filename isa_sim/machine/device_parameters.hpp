// The declared numbers of memory-mapped registers and of interrupts on their way to a core.
#pragma once

#include <common/parameter.hpp>

namespace finback::machine {

struct DeviceParameters final : ParameterGroup {
  IntegerParameter read_sclk{
      this,
      {"devices.read_sclk", "SCLK", 4, 0, 100, 'M', "hardware.md 1.6",
       "a core's read of a system register over the peripheral bus, during which it waits"}};
  IntegerParameter write_sclk{
      this,
      {"devices.write_sclk", "SCLK", 2, 0, 100, 'M', "hardware.md 1.6",
       "peripheral bus time of a posted write; a core waits only for an earlier one"}};
  IntegerParameter core_register_cycles{
      this,
      {"devices.core_register_cycles", "CCLK", 1, 0, 100, 'E', "hardware.md 1.6",
       "stall of an access to a register of the core itself (0xFFE00000 up)"}};
  IntegerParameter intercore_latency{
      this,
      {"events.intercore_latency_cycles", "CCLK", 40, 1, 10000, 'E', "hardware.md 4",
       "from raising a supplemental interrupt to the other core's event controller seeing it"}};
  IntegerParameter peripheral_latency{
      this,
      {"events.peripheral_latency_sclk", "SCLK", 3, 1, 1000, 'E', "hardware.md 4",
       "from a peripheral's interrupt line to the core's event controller seeing it"}};
};

}  // namespace finback::machine
