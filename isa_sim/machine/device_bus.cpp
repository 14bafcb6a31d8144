#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/device_bus.hpp>

namespace finback::machine {

namespace {

std::string name_in(const Device& device, const char* prefix, std::uint32_t offset) {
  const std::string name = device.register_name(offset);
  return name.empty() ? "" : prefix + name;
}

// Does an access of `bytes` at `address` fit a register of that width?
bool fits(RegisterWidth width, Address address, int bytes) {
  if (bytes == 4) {
    return address % 4 == 0;
  }
  return bytes == 2 && ((width == RegisterWidth::half && address % 4 == 0) ||
                        (width == RegisterWidth::word_or_halves && address % 2 == 0));
}

}  // namespace

DeviceBus::DeviceBus(const MachineDescription& description, memory::MemorySystem& memory,
                     SystemInterrupts::Outputs interrupt_outputs)
    : memory_(memory),
      read_sclk_(static_cast<Cycles>(description.devices.read_sclk)),
      write_sclk_(static_cast<Cycles>(description.devices.write_sclk)),
      ratio_(description.clock.ratio()),
      interrupts_(description.devices, ratio_, std::move(interrupt_outputs)),
      host_(memory),
      external_port_(memory),
      dma1_(dma::Controller::dma1, description.dma, description.clock, memory,
            {.channel_0 = kDma1Channel0, .stream_0 = kMdma1Stream0, .error = kDma1Error},
            line_setter()),
      dma2_(dma::Controller::dma2, description.dma, description.clock, memory,
            {.channel_0 = kDma2Channel0, .stream_0 = kMdma2Stream0, .error = kDma2Error},
            line_setter()),
      imdma_(dma::Controller::imdma, description.dma, description.clock, memory,
             {.stream_0 = kImdmaStream0, .error = kImdmaError}, line_setter()),
      peripherals_(description,
                   {.line = [this](int source, bool level,
                                   Cycles at) { interrupts_.set_line(source, level, at, 1); },
                    .watchdog_line =
                        [this](int core, bool level, Cycles at) {
                          interrupts_.set_core_line(core, kWatchdog, level, at);
                        },
                    .capture =
                        [this](int port, std::span<const std::uint8_t> bytes, Cycles now) {
                          return dma1_.port(static_cast<std::uint32_t>(port)).push(bytes, now);
                        },
                    .capture_element =
                        [this](int port) {
                          return dma1_.port(static_cast<std::uint32_t>(port)).element_bytes();
                        },
                    .captured = [this](std::uint32_t frame,
                                       Cycles at) { host_.frame_captured(frame, at); }}),
      pll_(description.pll, description.clock.cclk_mhz, description.clock.sclk_mhz,
           description.clock.ratio(),
           {.changed =
                [this](const clock::OperatingPoint& point, clock::ClockRatio ratio, Cycles at) {
                  if (clocked_) {
                    clocked_(point, ratio, at);
                  }
                },
            .wake = [this](Cycles at) { interrupts_.wake_up(kPllWakeup, at); }}),
      mappings_{{0xFFC00A00, ExternalPort::kRegisterBytes, "EBIU_", &external_port_},
                {0xFFC00100, InterruptRegisters::kBytes, "SICA_", &sica_},
                {0xFFC01100, InterruptRegisters::kBytes, "SICB_", &sicb_},
                {0xFFC01B00, dma::DmaController::kRegisterBytes, "", &dma1_},
                {0xFFC00B00, dma::DmaController::kRegisterBytes, "", &dma2_},
                {0xFFC01800, dma::DmaController::kInternalRegisterBytes, "", &imdma_},
                {0xFFC0F000, HostPort::kRegisterBytes, "HOST_", &host_}} {
  const std::vector<Mapping> more = peripherals_.mappings();
  mappings_.insert(mappings_.end(), more.begin(), more.end());
  mappings_.push_back({0xFFC00000, clock::Pll::kRegisterBytes, "", &pll_});
}

std::function<void(int, bool, Cycles)> DeviceBus::line_setter() {
  return [this](int source, bool level, Cycles at) { interrupts_.set_line(source, level, at); };
}

void DeviceBus::set_writer(const std::function<std::string()>& who) {
  for (dma::DmaController* controller : {&dma1_, &dma2_, &imdma_}) {
    controller->set_writer(who);
  }
}

void DeviceBus::register_counters(CounterRegistry& registry) const {
  for (const dma::DmaController* controller : {&dma1_, &dma2_, &imdma_}) {
    controller->register_counters(registry);
  }
  peripherals_.register_counters(registry);
}

const DeviceBus::Mapping* DeviceBus::find_mapping(Address address) const {
  const auto found = std::ranges::find_if(mappings_, [address](const Mapping& mapping) {
    return address - mapping.base < mapping.size;
  });
  return found == mappings_.end() ? nullptr : &*found;
}

std::string DeviceBus::register_name(Address address) const {
  const Mapping* mapping = find_mapping(address);
  return mapping == nullptr ? ""
                            : name_in(*mapping->device, mapping->prefix, address - mapping->base);
}

// The known register nearest to `address`, with its address: " (the nearest is X at 0x...)".
std::string DeviceBus::nearest_register(Address address) const {
  std::string best;
  Address best_distance = 0x40;  // further away is no help
  for (const Mapping& mapping : mappings_) {
    for (std::uint32_t offset = 0; offset < mapping.size; offset += 4) {
      const Address at = mapping.base + offset;
      const Address distance = at > address ? at - address : address - at;
      if (distance < best_distance && mapping.device->find_register(offset) != nullptr) {
        best_distance = distance;
        best = fmt::format(" (the nearest is {} at {:#010x})", register_name(at), at);
      }
    }
  }
  return best;
}

// Checks that there is a register at `address` and that it takes an access of that size.
const DeviceBus::Mapping& DeviceBus::check(Address address, int bytes, bool write) const {
  const Mapping* mapping = find_mapping(address);
  const DeviceRegister* found =
      mapping == nullptr ? nullptr
                         : mapping->device->find_register((address & ~3U) - mapping->base);
  if (found == nullptr) {
    throw GuestFault(fmt::format("{:#010x}: no device register is modelled there{}", address,
                                 nearest_register(address)));
  }
  if (!fits(found->width, address, bytes)) {
    throw GuestFault(fmt::format("{} of {} byte{} at {:#010x}: {} at {:#010x} takes {}",
                                 write ? "store" : "load", bytes, bytes == 1 ? "" : "s", address,
                                 register_name(address & ~3U), address & ~3U,
                                 found->width == RegisterWidth::word ? "4 bytes" : "2 or 4 bytes"));
  }
  return *mapping;
}

DeviceRead DeviceBus::read(int core, Address address, int bytes, Cycles now) {
  const Mapping& mapping = check(address, bytes, false);
  const Cycles free_at = bus_free_at_[static_cast<std::size_t>(core)];
  return {.value = mapping.device->read(address - mapping.base, bytes, now),
          .stall = std::max(now, free_at) + ratio_.cycles(read_sclk_) - now};
}

Cycles DeviceBus::write(int core, Address address, int bytes, std::uint32_t value, Cycles now) {
  const Mapping& mapping = check(address, bytes, true);
  Cycles& free_at = bus_free_at_[static_cast<std::size_t>(core)];
  const Cycles stall = std::max(now, free_at) - now;
  free_at = now + stall + ratio_.cycles(write_sclk_);
  mapping.device->write(address - mapping.base, bytes, value, now);
  plan_next_event();
  return stall;
}

void DeviceBus::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    if (memory::AccessObserver* observer = memory_.observer()) {
      observer->acts(std::nullopt);
    }
    if (interrupts_.next_event_time() == at) {
      interrupts_.advance(at);
    } else {
      std::ranges::find_if(mappings_, [at](const Mapping& mapping) {
        return mapping.device->next_event_time() == at;
      })->device->advance(at);
    }
    plan_next_event();
  }
}

void DeviceBus::begin_clock_change(Cycles at) {
  pll_.idle(at);
  plan_next_event();
}

void DeviceBus::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  for (Cycles& free_at : bus_free_at_) {
    free_at = change.system_time(free_at);
  }
  interrupts_.change_clock(change);
  for (dma::DmaController* controller : {&dma1_, &dma2_, &imdma_}) {
    controller->change_clock(change);
  }
  peripherals_.change_clock(change);
  plan_next_event();
}

void DeviceBus::plan_next_event() {
  next_event_ = interrupts_.next_event_time();
  for (const Mapping& mapping : mappings_) {
    next_event_ = std::min(next_event_, mapping.device->next_event_time());
  }
}

}  // namespace finback::machine
