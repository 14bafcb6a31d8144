#include <array>
#include <bit>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/external_port.hpp>

namespace finback::machine {

namespace {

enum Register : std::uint32_t {
  kAsyncGlobal = 0x00,
  kAsyncBanks0 = 0x04,
  kAsyncBanks1 = 0x08,
  kGlobalControl = 0x10,
  kBankControl = 0x14,
  kRefreshRate = 0x18,
  kStatus = 0x1C,
};
constexpr std::array<DeviceRegister, 7> kRegisters = {{
    {kAsyncGlobal, "AMGCTL", RegisterWidth::half},
    {kAsyncBanks0, "AMBCTL0", RegisterWidth::word},
    {kAsyncBanks1, "AMBCTL1", RegisterWidth::word},
    {kGlobalControl, "SDGCTL", RegisterWidth::word},
    {kBankControl, "SDBCTL", RegisterWidth::word},
    {kRefreshRate, "SDRRC", RegisterWidth::half},
    {kStatus, "SDSTAT", RegisterWidth::half},
}};

// Fields of SDGCTL: first bit and mask.
struct Field {
  int shift;
  std::uint32_t mask;
  [[nodiscard]] Cycles get(std::uint32_t word) const { return word >> shift & mask; }
  [[nodiscard]] std::uint32_t put(Cycles value) const {
    return (static_cast<std::uint32_t>(value) & mask) << shift;
  }
};
constexpr Field kCl{2, 3}, kTras{6, 0xF}, kTrp{11, 7}, kTrcd{15, 7}, kTwr{19, 3};
constexpr std::uint32_t kTimeBits = 3U << 2 | 0xFU << 6 | 7U << 11 | 7U << 15 | 3U << 19;
constexpr std::uint32_t kSelfRefresh = 1U << 24;

constexpr std::uint32_t kDmaFirst = 1U << 8;         // CDPRIO of AMGCTL
constexpr std::uint32_t kIdle = 1U << 0;             // SDCI of SDSTAT
constexpr std::uint32_t kRefreshesItself = 1U << 1;  // SDSRA

}  // namespace

const DeviceRegister* ExternalPort::find_register(std::uint32_t offset) const {
  return finback::find_register(kRegisters, offset);
}

std::uint32_t ExternalPort::read(std::uint32_t offset, int /*bytes*/, Cycles /*now*/) {
  switch (offset) {
    case kAsyncGlobal:
      return memory_.asynchronous().global();
    case kAsyncBanks0:
    case kAsyncBanks1:
      return memory_.asynchronous().banks(offset == kAsyncBanks0 ? 0 : 1);
    case kGlobalControl:
      return global_control();
    case kBankControl:
      return bank_control();
    case kRefreshRate:
      return refresh_rate();
    default:
      return kIdle | ((other_control_ & kSelfRefresh) != 0 ? kRefreshesItself : 0);
  }
}

void ExternalPort::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles /*now*/) {
  switch (offset) {
    case kAsyncGlobal:
      memory_.external_bus().set_dma_first((value & kDmaFirst) != 0);
      memory_.asynchronous().set_global(value);
      break;
    case kAsyncBanks0:
    case kAsyncBanks1:
      memory_.asynchronous().set_banks(offset == kAsyncBanks0 ? 0 : 1, value);
      break;
    case kGlobalControl:
      set_global_control(value);
      break;
    case kBankControl:
      set_bank_control(value);
      break;
    case kRefreshRate: {
      memory::SdramSettings settings = memory_.sdram().settings();
      settings.refresh_period = (value & 0xFFFU) + settings.tras + settings.trp;
      memory_.sdram().set(settings);
      break;
    }
    default:
      break;  // SDSTAT: its error bits, which are never set, are cleared by writing 1
  }
}

std::uint32_t ExternalPort::global_control() const {
  const memory::SdramSettings& s = memory_.sdram().settings();
  return other_control_ | kCl.put(s.cl) | kTras.put(s.tras) | kTrp.put(s.trp) | kTrcd.put(s.trcd) |
         kTwr.put(s.twr);
}

void ExternalPort::set_global_control(std::uint32_t value) {
  memory::SdramSettings settings = memory_.sdram().settings();
  settings.cl = kCl.get(value);
  settings.tras = kTras.get(value);
  settings.trp = kTrp.get(value);
  settings.trcd = kTrcd.get(value);
  settings.twr = kTwr.get(value);
  const bool legal = (settings.cl == 2 || settings.cl == 3) && settings.tras > 0 &&
                     settings.trp > 0 && settings.trcd > 0 && settings.twr > 0;
  if (!legal) {
    throw GuestFault(
        fmt::format("EBIU_SDGCTL = {:#010x}: CL {} (2 or 3), tRAS {}, tRP {}, tRCD {}, "
                    "tWR {} (1 at least) are no times of an SDRAM",
                    value, settings.cl, settings.tras, settings.trp, settings.trcd, settings.twr));
  }
  other_control_ = value & ~kTimeBits;
  memory_.sdram().set(settings);
}

// Bank 0 holds all of the SDRAM: enabled, its size from 16 MB on, its columns from 8 on.
std::uint32_t ExternalPort::bank_control() const {
  constexpr std::uint32_t kSmallest = 16U << 20U;
  const memory::SdramTiming& sdram = memory_.sdram();
  const int size = std::countr_zero(std::bit_ceil(std::max(sdram.size(), kSmallest)) / kSmallest);
  const int columns = std::countr_zero(sdram.page_bytes() / sdram.bus_bytes()) - 8;
  return 1U | static_cast<std::uint32_t>(size) << 1U |
         static_cast<std::uint32_t>(std::clamp(columns, 0, 3)) << 4U;
}

void ExternalPort::set_bank_control(std::uint32_t value) const {
  if (value != bank_control()) {
    throw GuestFault(
        fmt::format("EBIU_SDBCTL = {:#010x}: the SDRAM on this board wants {:#010x} "
                    "(its size and columns are the machine file's)",
                    value, bank_control()));
  }
}

std::uint32_t ExternalPort::refresh_rate() const {
  const memory::SdramSettings& s = memory_.sdram().settings();
  const Cycles used = s.tras + s.trp;
  return static_cast<std::uint32_t>(s.refresh_period > used ? s.refresh_period - used : 0) & 0xFFFU;
}

}  // namespace finback::machine
