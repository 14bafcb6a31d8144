#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/device_bus.hpp>

namespace finback::machine {

namespace {

enum class Device : std::uint8_t { sica, sicb, mdma1, mdma2, imdma, host };

struct DeviceRange {
  Device device;
  Address base;
  std::uint32_t size;
  const char* name;
};

constexpr std::array<DeviceRange, 6> kRanges = {
    {{Device::sica, 0xFFC00100, SystemInterrupts::kRegisterBytes, "SICA_"},
     {Device::mdma2, 0xFFC00F00, dma::MemoryDma::kRegisterBytes, "MDMA2_"},
     {Device::sicb, 0xFFC01100, SystemInterrupts::kRegisterBytes, "SICB_"},
     {Device::imdma, 0xFFC01800, dma::MemoryDma::kRegisterBytes, "IMDMA_"},
     {Device::mdma1, 0xFFC01F00, dma::MemoryDma::kRegisterBytes, "MDMA1_"},
     {Device::host, 0xFFC0F000, HostPort::kRegisterBytes, "HOST_"}}};

const DeviceRange* find_range(Address address) {
  const auto found = std::find_if(
      kRanges.begin(), kRanges.end(),
      [address](const DeviceRange& range) { return address - range.base < range.size; });
  return found == kRanges.end() ? nullptr : &*found;
}

std::string name_in(const DeviceRange& range, std::uint32_t offset) {
  std::string name;
  switch (range.device) {
    case Device::sica:
    case Device::sicb:
      name = interrupt_register_name(offset);
      break;
    case Device::host:
      name = host_register_name(offset);
      break;
    case Device::mdma1:
    case Device::mdma2:
    case Device::imdma: {
      name = dma::channel_register_name(offset % 0x40);
      if (!name.empty()) {
        name = fmt::format("{}{}_{}", offset / 0x40 % 2 == 0 ? 'D' : 'S', offset / 0x80, name);
      }
      break;
    }
  }
  return name.empty() ? "" : range.name + name;
}

// The known register nearest to `address`, with its address: " (the nearest is X at 0x...)".
std::string nearest_register(Address address) {
  std::string best;
  Address best_distance = 0x40;  // further away is no help
  for (const DeviceRange& range : kRanges) {
    for (std::uint32_t offset = 0; offset < range.size; offset += 4) {
      const Address at = range.base + offset;
      const Address distance = at > address ? at - address : address - at;
      if (distance < best_distance && !name_in(range, offset).empty()) {
        best_distance = distance;
        best = fmt::format(" (the nearest is {} at {:#010x})", name_in(range, offset), at);
      }
    }
  }
  return best;
}

[[noreturn]] void no_register(Address address) {
  throw GuestFault(fmt::format("{:#010x}: no device register is modelled there{}", address,
                               nearest_register(address)));
}

}  // namespace

std::string register_name(Address address) {
  const DeviceRange* range = find_range(address);
  return range == nullptr ? "" : name_in(*range, address - range->base);
}

DeviceBus::DeviceBus(const MachineDescription& description, memory::MemorySystem& memory,
                     SystemInterrupts::Outputs interrupt_outputs)
    : read_cycles_(static_cast<Cycles>(description.devices.read_sclk) * description.clock.ratio()),
      write_cycles_(static_cast<Cycles>(description.devices.write_sclk) *
                    description.clock.ratio()),
      interrupts_(description.devices, description.clock.ratio(), std::move(interrupt_outputs)),
      host_(memory),
      mdma1_(dma::Controller::mdma1, description.dma, description.clock.ratio(), memory,
             [this](int stream, bool level, Cycles at) {
               interrupts_.set_line(kMdma1Stream0 + stream, level, at);
             }),
      mdma2_(dma::Controller::mdma2, description.dma, description.clock.ratio(), memory,
             [this](int stream, bool level, Cycles at) {
               interrupts_.set_line(kMdma2Stream0 + stream, level, at);
             }),
      imdma_(description.clock.cclk_mhz) {}

// Checks that there is a register at `address` and that it takes an access of that size.
void DeviceBus::check(Address address, int bytes, bool write) {
  const std::string name = register_name(address & ~3U);
  if (name.empty()) {
    no_register(address);
  }
  // 32-bit DMA registers may be accessed by halves, and SYSCR is a 16-bit register.
  const bool dma = name.find("DMA") != std::string::npos;
  const bool half = dma || name.ends_with("_SYSCR");
  const bool fits =
      bytes == 4 ? address % 4 == 0 : bytes == 2 && half && address % (dma ? 2 : 4) == 0;
  if (!fits) {
    throw GuestFault(fmt::format("{} of {} byte{} at {:#010x}: {} at {:#010x} takes {}",
                                 write ? "store" : "load", bytes, bytes == 1 ? "" : "s", address,
                                 name, address & ~3U, half ? "2 or 4 bytes" : "4 bytes"));
  }
}

DeviceRead DeviceBus::read(int core, Address address, int bytes, Cycles now) {
  check(address, bytes, false);
  const DeviceRange& range = *find_range(address);
  const std::uint32_t offset = address - range.base;
  Cycles& free_at = bus_free_at_[static_cast<std::size_t>(core)];
  DeviceRead result;
  result.stall = std::max(now, free_at) + read_cycles_ - now;
  switch (range.device) {
    case Device::sica:
      result.value = interrupts_.read(0, offset);
      break;
    case Device::sicb:
      result.value = interrupts_.read(1, offset);
      break;
    case Device::mdma1:
      result.value = mdma1_.read(offset, bytes);
      break;
    case Device::mdma2:
      result.value = mdma2_.read(offset, bytes);
      break;
    case Device::imdma:
      result.value = imdma_.read(offset, bytes);
      break;
    case Device::host:
      result.value = host_.read(offset);
      break;
  }
  return result;
}

Cycles DeviceBus::write(int core, Address address, int bytes, std::uint32_t value, Cycles now) {
  check(address, bytes, true);
  const DeviceRange& range = *find_range(address);
  const std::uint32_t offset = address - range.base;
  Cycles& free_at = bus_free_at_[static_cast<std::size_t>(core)];
  const Cycles stall = std::max(now, free_at) - now;
  free_at = now + stall + write_cycles_;
  switch (range.device) {
    case Device::sica:
      interrupts_.write(0, offset, value, now);
      break;
    case Device::sicb:
      interrupts_.write(1, offset, value, now);
      break;
    case Device::mdma1:
      mdma1_.write(offset, bytes, value, now);
      break;
    case Device::mdma2:
      mdma2_.write(offset, bytes, value, now);
      break;
    case Device::imdma:
      imdma_.write(offset, bytes, value);
      break;
    case Device::host:
      host_.write(offset, value, now);
      break;
  }
  plan_next_event();
  return stall;
}

void DeviceBus::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    if (interrupts_.next_event_time() == at) {
      interrupts_.advance(at);
    } else if (mdma1_.next_event_time() == at) {
      mdma1_.advance(at);
    } else {
      mdma2_.advance(at);
    }
    plan_next_event();
  }
}

void DeviceBus::plan_next_event() {
  next_event_ =
      std::min({interrupts_.next_event_time(), mdma1_.next_event_time(), mdma2_.next_event_time()});
}

}  // namespace finback::machine
