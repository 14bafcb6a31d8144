#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include <isa_sim/machine/device_bus.hpp>
#include <isa_sim/machine/registers_page.hpp>

namespace finback::machine {

namespace {

const char* sizes(RegisterWidth width) {
  switch (width) {
    case RegisterWidth::word:
      return "4";
    case RegisterWidth::half:
      return "2, or 4";
    default:
      return "4, or its halves";
  }
}

}  // namespace

std::string registers_as_markdown() {
  const MachineDescription description;
  memory::MemorySystem memory(description.map, description.memory, description.clock, {});
  const DeviceBus bus(
      description, memory,
      {.lines_changed = [](int, std::uint32_t, bool, Cycles) {}, .core_b_released = [](Cycles) {}});
  std::vector<DeviceMapping> mappings = bus.mappings();
  std::ranges::sort(mappings, {}, &DeviceMapping::base);
  std::string page =
      "# Device registers\n\n"
      "Every register on the peripheral bus that is modelled. Names are those of ADI's\n"
      "defBF561.h; `HOST_` registers are Finback's own. Bytes are the sizes of an access: a\n"
      "register of 16 bits reads with an upper half of 0. An access to anything else is a fault\n"
      "that names the nearest register. This page is generated from the devices' tables:\n"
      "`finback machine --registers` prints it. What they do: [devices.md](devices.md),\n"
      "[cameras.md](cameras.md), [clocks.md](clocks.md); the cores' own registers: "
      "[events.md](events.md).\n\n"
      "| address | register | bytes |\n|---|---|---|\n";
  for (const DeviceMapping& mapping : mappings) {
    for (std::uint32_t offset = 0; offset < mapping.size; offset += 4) {
      if (const DeviceRegister* found = mapping.device->find_register(offset)) {
        fmt::format_to(std::back_inserter(page), "| 0x{:08X} | `{}` | {} |\n",
                       mapping.base + offset, bus.register_name(mapping.base + offset),
                       sizes(found->width));
      }
    }
  }
  return page;
}

}  // namespace finback::machine
