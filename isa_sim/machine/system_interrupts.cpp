#include <algorithm>
#include <bit>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/system_interrupts.hpp>

namespace finback::machine {

namespace {

// Offsets within SICA and SICB.
constexpr std::uint32_t kReset = 0x00;  // SWRST, of SICA only
constexpr std::uint32_t kSyscr = 0x04;
constexpr std::uint32_t kMask0 = 0x0C, kMask1 = 0x10;
constexpr std::uint32_t kStatus0 = 0x14, kStatus1 = 0x18;
constexpr std::uint32_t kWakeup0 = 0x1C, kWakeup1 = 0x20;
constexpr std::uint32_t kAssignment0 = 0x24;

constexpr std::uint32_t kSystemReset = 7;   // of SWRST
constexpr std::uint32_t kCoreBHeld = 0x20;  // SICA_SYSCR: COREB_SRAM_INIT
// SICB_SYSCR: raise and acknowledge bits of core A; core B's are one higher.
constexpr int kRaise0 = 6, kRaise1 = 8, kAcknowledge0 = 10, kAcknowledge1 = 12;
constexpr int kFirstIvg = 7;

// IVG by source after reset (hardware.md 3.1; the rest as the BF561's Linux port lists it).
int default_ivg(int source) {
  struct Group {
    int last;
    int ivg;
  };
  constexpr std::array<Group, 10> kGroups = {{{10, 7},    // PLL, error interrupts
                                              {22, 8},    // DMA1
                                              {34, 9},    // DMA2
                                              {46, 10},   // timers
                                              {52, 11},   // flags
                                              {54, 8},    // MDMA1
                                              {56, 9},    // MDMA2
                                              {58, 12},   // IMDMA
                                              {59, 13},   // watchdog
                                              {63, 7}}};  // supplemental
  return std::find_if(kGroups.begin(), kGroups.end(),
                      [source](const Group& group) { return source <= group.last; })
      ->ivg;
}

bool bit(const std::array<std::uint32_t, 2>& words, int source) {
  return (words[static_cast<std::size_t>(source / 32)] >> (source % 32) & 1U) != 0;
}

void set_bit(std::array<std::uint32_t, 2>& words, int source, bool level) {
  std::uint32_t& word = words[static_cast<std::size_t>(source / 32)];
  const std::uint32_t mask = 1U << (source % 32);
  word = level ? word | mask : word & ~mask;
}

}  // namespace

const DeviceRegister* InterruptRegisters::find_register(std::uint32_t offset) const {
  static constexpr DeviceRegister kSoftwareReset = {kReset, "SWRST", RegisterWidth::half};
  static constexpr std::array<DeviceRegister, 15> kRegisters = {
      {{kSyscr, "SYSCR", RegisterWidth::half},
       {kMask0, "IMASK0"},
       {kMask1, "IMASK1"},
       {kStatus0, "ISR0"},
       {kStatus1, "ISR1"},
       {kWakeup0, "IWR0"},
       {kWakeup1, "IWR1"},
       {kAssignment0, "IAR0"},
       {kAssignment0 + 0x04, "IAR1"},
       {kAssignment0 + 0x08, "IAR2"},
       {kAssignment0 + 0x0C, "IAR3"},
       {kAssignment0 + 0x10, "IAR4"},
       {kAssignment0 + 0x14, "IAR5"},
       {kAssignment0 + 0x18, "IAR6"},
       {kAssignment0 + 0x1C, "IAR7"}}};
  return offset == kReset && core_ == 0 ? &kSoftwareReset
                                        : finback::find_register(kRegisters, offset);
}

SystemInterrupts::SystemInterrupts(const DeviceParameters& parameters, clock::ClockRatio ratio,
                                   Outputs outputs)
    : intercore_latency_(static_cast<Cycles>(parameters.intercore_latency)),
      ratio_(ratio),
      peripheral_latency_(static_cast<Cycles>(parameters.peripheral_latency)),
      outputs_(std::move(outputs)) {
  for (Controller& controller : controllers_) {
    for (int source = 0; source < kSourceCount; ++source) {
      controller.assignment[static_cast<std::size_t>(source / 8)] |=
          static_cast<std::uint32_t>(default_ivg(source) - kFirstIvg) << (source % 8 * 4);
    }
  }
}

void SystemInterrupts::note_taken(int core) const {
  if (observer_ == nullptr) {
    return;
  }
  const Controller& controller = controllers_[static_cast<std::size_t>(core)];
  for (int word = 0; word < 2; ++word) {
    const auto w = static_cast<std::size_t>(word);
    observer_->lines_seen(core, word, controller.visible[w] & controller.mask[w]);
  }
}

std::uint32_t SystemInterrupts::read(int core, std::uint32_t offset) const {
  const Controller& controller = controllers_[static_cast<std::size_t>(core)];
  if (observer_ != nullptr && (offset == kStatus0 || offset == kStatus1)) {
    const int word = offset == kStatus0 ? 0 : 1;
    observer_->lines_seen(core, word, controller.line[static_cast<std::size_t>(word)]);
  }
  switch (offset) {
    case kReset:
      return 0;  // nothing has reset the chip
    case kSyscr:
      // The inter-core bits act when written as 1 and read as 0, so that setting one by reading,
      // or-ing and writing does not repeat the others; what is pending stands in ISR1.
      return core == 0 ? sica_syscr_ : 0;
    case kMask0:
      return controller.mask[0];
    case kMask1:
      return controller.mask[1];
    case kStatus0:
      return controller.line[0];
    case kStatus1:
      return controller.line[1];
    case kWakeup0:
      return controller.wake[0];
    case kWakeup1:
      return controller.wake[1];
    default:
      break;
  }
  return controller.assignment.at((offset - kAssignment0) / 4);
}

void SystemInterrupts::write(int core, std::uint32_t offset, std::uint32_t value, Cycles now) {
  Controller& controller = controllers_[static_cast<std::size_t>(core)];
  switch (offset) {
    case kReset:
      if ((value & kSystemReset) == kSystemReset) {
        outputs_.software_reset(now);
      }
      return;
    case kSyscr:
      if (core == 1) {
        write_intercore(value, now);
      } else {
        const bool released = (sica_syscr_ & ~value & kCoreBHeld) != 0;
        sica_syscr_ = value;
        if (released) {
          outputs_.core_b_released(now);
        }
      }
      return;
    case kMask0:
      controller.mask[0] = value;
      break;
    case kMask1:
      controller.mask[1] = value;
      break;
    case kStatus0:
    case kStatus1:
      throw GuestFault(fmt::format("SIC{}_ISR{} is read-only", core == 0 ? 'A' : 'B',
                                   offset == kStatus0 ? 0 : 1));
    case kWakeup0:
      controller.wake[0] = value;
      break;
    case kWakeup1:
      controller.wake[1] = value;
      break;
    default:
      controller.assignment.at((offset - kAssignment0) / 4) = value;
      break;
  }
  update(core, now);
}

void SystemInterrupts::write_intercore(std::uint32_t value, Cycles now) {
  for (int core = 0; core < kCoreCount; ++core) {
    const auto written = [&](int first_bit) { return (value >> (first_bit + core) & 1U) != 0; };
    // Acknowledging comes first: a write that does both leaves the new request standing.
    if (written(kAcknowledge0)) {
      set(core, kSupplemental0, false, now, 0);
    }
    if (written(kAcknowledge1)) {
      set(core, kSupplemental1, false, now, 0);
    }
    if (written(kRaise0)) {
      set(core, kSupplemental0, true, now, intercore_latency_);
    }
    if (written(kRaise1)) {
      set(core, kSupplemental1, true, now, intercore_latency_);
    }
  }
}

void SystemInterrupts::set_core_line(int core, int source, bool level, Cycles now) {
  set(core, source, level, now, ratio_.cycles(peripheral_latency_));
}

void SystemInterrupts::set_line(int source, bool level, Cycles now, unsigned driver) {
  std::uint8_t& drivers = drivers_.at(static_cast<std::size_t>(source));
  const auto mine = static_cast<std::uint8_t>(1U << driver);
  drivers = static_cast<std::uint8_t>(level ? drivers | mine : drivers & ~mine);
  for (int core = 0; core < kCoreCount; ++core) {
    set(core, source, drivers != 0, now, ratio_.cycles(peripheral_latency_));
  }
}

void SystemInterrupts::set(int core, int source, bool level, Cycles now, Cycles latency) {
  Controller& controller = controllers_[static_cast<std::size_t>(core)];
  if (bit(controller.line, source) == level) {
    return;
  }
  set_bit(controller.line, source, level);
  if (level && observer_ != nullptr) {
    observer_->line_raised(core, source);
  }
  if (level) {
    rises_.push_back({.at = now + latency, .core = core, .source = source});
  } else {
    set_bit(controller.visible, source, false);
    std::erase_if(rises_, [core, source](const Rise& rise) {
      return rise.core == core && rise.source == source;
    });
    update(core, now);
  }
  plan_next_event();
}

void SystemInterrupts::wake_up(int source, Cycles now) {
  for (int core = 0; core < kCoreCount; ++core) {
    const Controller& controller = controllers_[static_cast<std::size_t>(core)];
    if (bit(controller.wake, source)) {
      outputs_.lines_changed(core, controller.pending_ivg, true, now);
      outputs_.lines_changed(core, controller.pending_ivg, controller.waking, now);
    }
    if (bit(controller.mask, source)) {
      const auto group = static_cast<std::size_t>(source / 8);
      const std::uint32_t level = controller.assignment[group] >> (source % 8 * 4) & 0xFU;
      outputs_.latched(core, kFirstIvg + static_cast<int>(level), now);
    }
  }
}

void SystemInterrupts::tell_again(Cycles now) {
  for (int core = 0; core < kCoreCount; ++core) {
    const Controller& controller = controllers_[static_cast<std::size_t>(core)];
    outputs_.lines_changed(core, controller.pending_ivg, controller.waking, now);
  }
}

void SystemInterrupts::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  for (Rise& rise : rises_) {
    rise.at = change.system_time(rise.at);
  }
  plan_next_event();
}

void SystemInterrupts::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    const auto due = std::find_if(rises_.begin(), rises_.end(),
                                  [at](const Rise& rise) { return rise.at == at; });
    const Rise rise = *due;
    rises_.erase(due);
    set_bit(controllers_[static_cast<std::size_t>(rise.core)].visible, rise.source, true);
    plan_next_event();
    update(rise.core, at);
  }
}

void SystemInterrupts::plan_next_event() {
  next_event_ = kNever;
  for (const Rise& rise : rises_) {
    next_event_ = std::min(next_event_, rise.at);
  }
}

void SystemInterrupts::update(int core, Cycles at) {
  Controller& controller = controllers_[static_cast<std::size_t>(core)];
  std::uint32_t pending = 0;
  bool waking = false;
  for (std::size_t word = 0; word < 2; ++word) {
    waking = waking || (controller.visible[word] & controller.wake[word]) != 0;
    for (std::uint32_t left = controller.visible[word] & controller.mask[word]; left != 0;
         left &= left - 1) {
      const auto source = word * 32 + static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t level = controller.assignment[source / 8] >> (source % 8 * 4) & 0xFU;
      pending |= 1U << (kFirstIvg + level);
    }
  }
  if (pending != controller.pending_ivg || waking != controller.waking) {
    controller.pending_ivg = pending;
    controller.waking = waking;
    outputs_.lines_changed(core, pending, waking, at);
  }
}

}  // namespace finback::machine
