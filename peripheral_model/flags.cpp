#include <peripheral_model/flags.hpp>

namespace finback::peripheral {

namespace {

constexpr std::uint32_t kAll = 0xFFFF;
constexpr std::uint32_t kFirstSetting = 0x30;
enum Action : std::uint32_t { kWrite, kClear, kSet, kToggle };

}  // namespace

Flags::Flags(int port, Outputs outputs) : port_(port), outputs_(std::move(outputs)) {}

const DeviceRegister* Flags::find_register(std::uint32_t offset) const {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 17> kRegisters = {{{0x00, "FLAG_D", half},
                                                                 {0x04, "FLAG_C", half},
                                                                 {0x08, "FLAG_S", half},
                                                                 {0x0C, "FLAG_T", half},
                                                                 {0x10, "MASKA_D", half},
                                                                 {0x14, "MASKA_C", half},
                                                                 {0x18, "MASKA_S", half},
                                                                 {0x1C, "MASKA_T", half},
                                                                 {0x20, "MASKB_D", half},
                                                                 {0x24, "MASKB_C", half},
                                                                 {0x28, "MASKB_S", half},
                                                                 {0x2C, "MASKB_T", half},
                                                                 {0x30, "DIR", half},
                                                                 {0x34, "POLAR", half},
                                                                 {0x38, "EDGE", half},
                                                                 {0x3C, "BOTH", half},
                                                                 {0x40, "INEN", half}}};
  return finback::find_register(kRegisters, offset);
}

void Flags::drive(std::vector<PinChange> changes) {
  changes_ = std::move(changes);
  next_change_ = 0;
  plan_next_event();
}

std::uint32_t Flags::data() const {
  const std::uint32_t levels = inputs_ ^ settings_[kPolarity];
  const std::uint32_t seen = (settings_[kEdge] & groups_[kData]) | (~settings_[kEdge] & levels);
  return (settings_[kDirection] & groups_[kData]) |
         (~settings_[kDirection] & settings_[kInputEnable] & seen);
}

std::uint32_t Flags::read(std::uint32_t offset, int /*bytes*/, Cycles /*now*/) {
  if (offset >= kFirstSetting) {
    return settings_[(offset - kFirstSetting) / 4];
  }
  const std::uint32_t group = offset / 0x10;
  return (group == kData ? data() : groups_[group]) & kAll;
}

void Flags::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  value &= kAll;
  if (offset >= kFirstSetting) {
    settings_[(offset - kFirstSetting) / 4] = value;
  } else {
    write_group(offset / 0x10, offset % 0x10 / 4, value);
  }
  update(now);
}

void Flags::write_group(std::uint32_t group, std::uint32_t action, std::uint32_t value) {
  std::uint32_t& bits = groups_[group];
  switch (action) {
    case kWrite:
      bits = value;
      break;
    case kClear:
      bits &= ~value;
      break;
    case kSet:
      bits |= value;
      break;
    default:
      bits ^= value;
      break;
  }
}

void Flags::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    const PinChange& change = changes_[next_change_++];
    const std::uint32_t bit = 1U << (change.pin % kFlagsOfAPort);
    const std::uint32_t before = inputs_;
    inputs_ = change.level ? inputs_ | bit : inputs_ & ~bit;
    note_edges(before, inputs_);
    plan_next_event();
    update(at);
  }
}

void Flags::plan_next_event() {
  next_event_ =
      next_change_ < changes_.size() ? time_.from_reference(changes_[next_change_].at) : kNever;
}

// An edge counts where POLAR wants it (0: rising), or both do.
void Flags::note_edges(std::uint32_t before, std::uint32_t after) {
  const std::uint32_t changed = before ^ after;
  const std::uint32_t wanted = settings_[kBoth] | (after ^ settings_[kPolarity]);
  groups_[kData] |=
      changed & wanted & settings_[kEdge] & settings_[kInputEnable] & ~settings_[kDirection];
}

void Flags::update(Cycles now) {
  const std::uint32_t driven = groups_[kData] & settings_[kDirection];
  for (int i = 0; i < kFlagsOfAPort; ++i) {
    if (((driven ^ driven_) >> i & 1U) != 0 && outputs_.changed) {
      outputs_.changed({now, port_ * kFlagsOfAPort + i, (driven >> i & 1U) != 0});
    }
  }
  driven_ = driven;
  for (const int mask : {0, 1}) {
    const bool level =
        (data() & groups_[static_cast<std::size_t>(kMaskA) + static_cast<std::size_t>(mask)]) != 0;
    bool& line = lines_[static_cast<std::size_t>(mask)];
    if (level != line) {
      line = level;
      outputs_.line(mask, level, now);
    }
  }
}

}  // namespace finback::peripheral
