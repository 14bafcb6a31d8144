#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <set>

#include <common/error.hpp>
#include <dma_model/dma_controller.hpp>

namespace finback::dma {

namespace {

constexpr std::uint32_t kPeripheralLanes = TrafficControl::kPeripheralLanes;
constexpr std::uint32_t kNoLane = TrafficControl::kLaneCount;
// Anomaly 05000182: IMDMA corrupts data above this core clock, on all silicon.
constexpr double kImdmaMaximumMhz = 500;

struct Identity {
  const char* name;
  const char* stream_name;
  memory::Initiator first_stream;
};

const Identity& identity(Controller which) {
  using memory::Initiator;
  static constexpr std::array<Identity, 3> kIdentities = {{{"DMA1", "MDMA1", Initiator::mdma1_0},
                                                           {"DMA2", "MDMA2", Initiator::mdma2_0},
                                                           {"IMDMA", "IMDMA", Initiator::imdma_0}}};
  return kIdentities[static_cast<std::size_t>(which)];
}

// The lanes whose bits are set in `mask`, lowest first.
template <class Body>
void for_each_bit(std::uint32_t mask, const Body& body) {
  for (; mask != 0; mask &= mask - 1) {
    body(static_cast<std::uint32_t>(std::countr_zero(mask)));
  }
}

}  // namespace

DmaController::DmaController(Controller which, const DmaParameters& parameters,
                             const memory::ClockParameters& clock, memory::MemorySystem& memory,
                             const Sources& sources, InterruptLine interrupt)
    : which_(which),
      cclk_mhz_(clock.cclk_mhz),
      ratio_(clock.ratio()),
      errors_fault_(parameters.errors_fault != 0),
      memory_(memory),
      sources_(sources),
      interrupt_(std::move(interrupt)) {
  for (auto& fifo : stream_fifos_) {
    fifo = std::make_unique<ByteFifo>(8 * static_cast<std::uint32_t>(parameters.burst_elements));
  }
  for (std::uint32_t lane = which == Controller::imdma ? kPeripheralLanes : 0; lane < kLaneCount;
       ++lane) {
    make_lane(lane, parameters);
  }
  for (std::uint32_t lane = kPeripheralLanes; lane < kLaneCount; lane += 2) {
    lanes_[lane].side->set_peer(lanes_[lane + 1].side.get());
    lanes_[lane + 1].side->set_peer(lanes_[lane].side.get());
  }
  for (std::uint32_t i = 0; i < kPeripheralLanes; ++i) {
    ports_[i] = PeripheralPort(*this, i);
  }
  map_peripherals();
}

void DmaController::make_lane(std::uint32_t lane, const DmaParameters& parameters) {
  ByteFifo* fifo = nullptr;
  if (lane < kPeripheralLanes) {
    lanes_[lane].own_fifo =
        std::make_unique<ByteFifo>(static_cast<std::uint32_t>(parameters.peripheral_fifo_bytes));
    fifo = lanes_[lane].own_fifo.get();
  } else {
    fifo = stream_fifos_[(lane - kPeripheralLanes) / 2].get();
  }
  lanes_[lane].side =
      std::make_unique<MemorySide>(make_channel(lane), initiator_of(lane),
                                   which_ == Controller::imdma, *fifo, parameters, ratio_, memory_);
}

DmaChannel DmaController::make_channel(std::uint32_t lane) const {
  const Identity& id = identity(which_);
  if (lane < kPeripheralLanes) {
    return {fmt::format("{}_{}", id.name, lane), ChannelKind::peripheral, lane};
  }
  const std::uint32_t number = lane - kPeripheralLanes;
  const bool destination = number % 2 == 0;
  return {fmt::format("{}_{}{}", id.stream_name, destination ? 'D' : 'S', number / 2),
          destination ? ChannelKind::destination : ChannelKind::source};
}

memory::Initiator DmaController::initiator_of(std::uint32_t lane) const {
  using memory::Initiator;
  if (lane >= kPeripheralLanes) {
    const int first = static_cast<int>(identity(which_).first_stream);
    return static_cast<Initiator>(first + static_cast<int>(lane - kPeripheralLanes) / 2);
  }
  if (which_ == Controller::dma2) {
    return Initiator::dma2;
  }
  return lane == 0 ? Initiator::ppi0 : lane == 1 ? Initiator::ppi1 : Initiator::dma1;
}

std::uint32_t DmaController::lane_at(std::uint32_t offset) const {
  return which_ == Controller::imdma ? kPeripheralLanes + offset / kChannelBytes
                                     : (offset - kChannels) / kChannelBytes;
}

const DeviceRegister* DmaController::find_register(std::uint32_t offset) const {
  static constexpr std::array<DeviceRegister, 2> kTraffic = {
      {{kTrafficPeriods, "TC_PER", RegisterWidth::half},
       {kTrafficCounts, "TC_CNT", RegisterWidth::half}}};
  if (which_ == Controller::imdma) {
    const std::uint32_t in_channel = offset % kChannelBytes;
    return in_channel == kPeripheralMap ? nullptr : find_channel_register(in_channel);
  }
  return offset < kChannels ? finback::find_register(kTraffic, offset)
                            : find_channel_register(offset % kChannelBytes);
}

std::string DmaController::register_name(std::uint32_t offset) const {
  const DeviceRegister* found = find_register(offset);
  if (found == nullptr) {
    return "";
  }
  const bool traffic = which_ != Controller::imdma && offset < kChannels;
  return fmt::format(
      "{}_{}", traffic ? identity(which_).name : lanes_[lane_at(offset)].side->channel().name(),
      found->name);
}

std::uint32_t DmaController::read(std::uint32_t offset, int bytes, Cycles /*now*/) {
  if (which_ != Controller::imdma && offset < kChannels) {
    return offset == kTrafficPeriods ? traffic_.periods() : traffic_.counts();
  }
  const std::uint32_t lane = lane_at(offset);
  note_access(lane, memory::Direction::read);
  return lanes_[lane].side->channel().read(offset % kChannelBytes, bytes);
}

void DmaController::note_access(std::uint32_t lane, memory::Direction direction) const {
  if (memory::AccessObserver* observer = memory_.observer()) {
    observer->channel_access(lanes_[lane].side->initiator(), direction);
  }
}

void DmaController::write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) {
  if (which_ != Controller::imdma && offset < kChannels) {
    if (offset != kTrafficPeriods) {
      throw GuestFault(
          fmt::format("DMA: {} = {:#x}: it is read-only", register_name(offset), value));
    }
    traffic_.set_periods(value);
    return;
  }
  const std::uint32_t lane = lane_at(offset);
  MemorySide& side = *lanes_[lane].side;
  note_access(lane, memory::Direction::write);
  try {
    switch (side.channel().write(offset % kChannelBytes, bytes, value)) {
      case DmaChannel::Written::enabled:
        start(lane, now);
        break;
      case DmaChannel::Written::disabled:
        side.abandon();
        break;
      case DmaChannel::Written::map:
        map_peripherals();
        break;
      case DmaChannel::Written::nothing:
        break;
    }
  } catch (const DmaError& error) {
    fail(lane, error.what(), now);
  }
  update_line(lane, now);
  update_error_line(now);
  settle(now);
}

void DmaController::start(std::uint32_t lane, Cycles now) {
  MemorySide& side = *lanes_[lane].side;
  check_core_clock(lane);
  if (lane < kPeripheralLanes) {
    check_map(lane);
  }
  lanes_[lane].started_by = writer_ ? writer_() : "";
  side.start(now);
  active_ |= 1U << lane;
}

void DmaController::check_core_clock(std::uint32_t lane) const {
  const DmaChannel& channel = lanes_[lane].side->channel();
  if (which_ == Controller::imdma && cclk_mhz_ > kImdmaMaximumMhz) {
    throw GuestFault(
        fmt::format("DMA: {}_CONFIG = {:#x}: IMDMA corrupts data above {} MHz CCLK (anomaly "
                    "05000182) and CCLK is {} MHz; use MDMA1 or MDMA2",
                    channel.name(), channel.read(kConfig, 2), kImdmaMaximumMhz, cclk_mhz_));
  }
}

void DmaController::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  cclk_mhz_ = change.core_mhz;
  for (std::uint32_t lane = 0; lane < kLaneCount; ++lane) {
    if (lanes_[lane].side != nullptr) {
      lanes_[lane].side->change_clock(change);
      if (lanes_[lane].side->channel().running()) {
        check_core_clock(lane);
      }
    }
  }
  if (which_ != Controller::imdma) {
    for (Cycles& until : busy_until_) {
      until = change.system_time(until);
    }
    ask_again_at_ = ask_again_at_ == kNever ? kNever : change.at;
  }
  plan_next_event(change.at);
}

// No two running channels may serve the same peripheral.
void DmaController::check_map(std::uint32_t lane) const {
  const DmaChannel& channel = lanes_[lane].side->channel();
  for (std::uint32_t other = 0; other < kPeripheralLanes; ++other) {
    const DmaChannel& its = lanes_[other].side->channel();
    if (other != lane && its.running() && its.peripheral() == channel.peripheral()) {
      throw channel.error(
          kPeripheralMap, channel.read(kPeripheralMap, 2),
          fmt::format("{} runs for that peripheral; give each its own PMAP", its.name()));
    }
  }
}

void DmaController::map_peripherals() {
  lane_by_peripheral_.fill(kNoLane);
  if (which_ == Controller::imdma) {
    return;
  }
  for (std::uint32_t lane = kPeripheralLanes; lane-- > 0;) {
    lane_by_peripheral_[lanes_[lane].side->channel().peripheral()] = lane;
  }
}

void DmaController::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    for_each_bit(active_, [this, at](std::uint32_t lane) {
      if (lanes_[lane].side->next_event_time() <= at) {
        act(lane, at);
      }
    });
    arbitrate(at);
    plan_next_event(at);
  }
}

void DmaController::act(std::uint32_t lane, Cycles now) {
  MemorySide& side = *lanes_[lane].side;
  if (memory::AccessObserver* observer = memory_.observer()) {
    observer->acts(side.initiator());
  }
  const std::uint32_t held = lane < kPeripheralLanes ? lanes_[lane].own_fifo->size() : 0;
  try {
    side.act(now);
  } catch (const DmaError& error) {
    fail(lane, began(lane, error), now);
  }
  update_line(lane, now);
  if (lane < kPeripheralLanes && lanes_[lane].own_fifo->size() > held) {
    ports_[side.channel().peripheral()].refilled(now);
  }
}

// Gives every memory that this controller has no burst on to the first of those who want it.
void DmaController::arbitrate(Cycles now) {
  constexpr auto kExternal = static_cast<std::size_t>(memory::DmaPort::external);
  std::array<Choice, kPortCount> choices;
  waited_for_.fill(false);
  bool urgent_waits = false;
  for_each_bit(active_, [&](std::uint32_t lane) {
    const std::optional<MemorySide::Want> want = lanes_[lane].side->want(now);
    if (!want) {
      if (!lanes_[lane].side->channel().running()) {
        active_ &= ~(1U << lane);
      }
      return;
    }
    const auto port = static_cast<std::size_t>(want->port);
    if (busy_until_[port] > now) {
      waited_for_[port] = true;
      urgent_waits = urgent_waits || (port == kExternal && urgent(lane));
      return;
    }
    Choice& choice = choices[port];
    const std::uint32_t rank = traffic_.rank(lane, want->port, want->direction, urgent(lane));
    choice.wanted |= 1U << static_cast<unsigned>(want->direction);
    if (choice.lane == kNoLane || rank < choice.rank) {
      choice.lane = lane;
      choice.rank = rank;
      choice.direction = want->direction;
    }
  });
  if (which_ != Controller::imdma) {
    memory_.external_bus().set_urgent(static_cast<std::size_t>(which_), urgent_waits);
    ask_for_bus(choices[kExternal], now);
  }
  bool failed = false;
  for (std::size_t port = 0; port < kPortCount; ++port) {
    if (choices[port].lane != kNoLane) {
      failed = !grant(choices[port], static_cast<memory::DmaPort>(port), now) || failed;
    }
  }
  if (failed) {
    arbitrate(now);
  }
}

// Takes the choice back when others go before it on the external bus.
void DmaController::ask_for_bus(Choice& choice, Cycles now) {
  const auto number = static_cast<std::size_t>(which_);
  ask_again_at_ = kNever;
  if (choice.lane == kNoLane) {
    memory_.external_bus().nothing_asked(number);
    return;
  }
  const Cycles from = memory_.external_bus().dma_from(number, urgent(choice.lane), now);
  if (from > now) {
    ask_again_at_ = from;
    choice.lane = kNoLane;
  }
}

// False: the lane met an error instead.
bool DmaController::grant(const Choice& choice, memory::DmaPort port, Cycles now) {
  MemorySide& side = *lanes_[choice.lane].side;
  const bool contested = choice.lane >= kPeripheralLanes && other_stream_runs(choice.lane);
  const bool opposed = choice.wanted == 3;
  try {
    const std::uint32_t elements =
        side.grant(now, traffic_.most_elements(choice.lane, port, opposed, contested));
    const std::uint32_t idle =
        traffic_.granted(choice.lane, port, choice.direction, elements, contested);
    busy_until_[static_cast<std::size_t>(port)] = side.done_at() + ratio_.cycles(idle);
    waited_for_[static_cast<std::size_t>(port)] = idle > 0;  // else the burst's end is an event
  } catch (const DmaError& error) {
    fail(choice.lane, began(choice.lane, error), now);
    update_error_line(now);
    return false;
  }
  return true;
}

bool DmaController::urgent(std::uint32_t lane) const {
  if (lane >= kPeripheralLanes) {
    return false;
  }
  const ByteFifo& fifo = *lanes_[lane].own_fifo;
  return (lanes_[lane].side->channel().writes_memory() ? fifo.room() : fifo.size()) <
         lanes_[lane].last_chunk;
}

bool DmaController::other_stream_runs(std::uint32_t lane) const {
  const std::uint32_t other = kPeripheralLanes + ((lane - kPeripheralLanes) / 2 == 0 ? 2 : 0);
  return lanes_[other].side->channel().running() && lanes_[other + 1].side->channel().running();
}

// What an error that came while nobody wrote a register says of its origin.
std::string DmaController::began(std::uint32_t lane, const DmaError& error) const {
  const std::string& who = lanes_[lane].started_by;
  return who.empty() ? error.what()
                     : fmt::format("{}; the channel was started by {}", error.what(), who);
}

void DmaController::fail(std::uint32_t lane, const std::string& message, Cycles now) {
  MemorySide& side = *lanes_[lane].side;
  side.channel().set_error();
  side.abandon();
  if (errors_fault_) {
    throw GuestFault(message);
  }
  update_error_line(now);
}

void DmaController::update_line(std::uint32_t lane, Cycles now) {
  if (lane < kPeripheralLanes) {
    set_line(lane, sources_.channel_0 + static_cast<int>(lane),
             lanes_[lane].side->channel().interrupt_pending(), now);
    return;
  }
  const std::uint32_t stream = (lane - kPeripheralLanes) / 2;
  const std::uint32_t destination = kPeripheralLanes + 2 * stream;
  set_line(kPeripheralLanes + stream, sources_.stream_0 + static_cast<int>(stream),
           lanes_[destination].side->channel().interrupt_pending() ||
               lanes_[destination + 1].side->channel().interrupt_pending(),
           now);
}

void DmaController::update_error_line(Cycles now) {
  const bool level = std::ranges::any_of(lanes_, [](const Lane& lane) {
    return lane.side != nullptr && lane.side->channel().error_pending();
  });
  set_line(kErrorLine, sources_.error, level, now);
}

void DmaController::set_line(std::uint32_t index, int source, bool level, Cycles now) {
  if (level != line_[index]) {
    line_[index] = level;
    interrupt_(source, level, now);
  }
}

// Something changed from outside at `now`; what is due by itself at this time comes in advance().
void DmaController::settle(Cycles now) {
  if (next_event_ > now) {
    arbitrate(now);
    plan_next_event(now);
  }
}

void DmaController::plan_next_event(Cycles now) {
  next_event_ = ask_again_at_;
  for_each_bit(active_, [this](std::uint32_t lane) {
    next_event_ = std::min(next_event_, lanes_[lane].side->next_event_time());
  });
  for (std::size_t port = 0; port < kPortCount; ++port) {
    if (waited_for_[port] && busy_until_[port] > now) {
      next_event_ = std::min(next_event_, busy_until_[port]);
    }
  }
}

void DmaController::register_counters(CounterRegistry& registry) const {
  std::set<memory::Initiator> initiators;
  for (std::uint32_t lane = 0; lane < kLaneCount; ++lane) {
    if (lanes_[lane].side != nullptr) {
      initiators.insert(lanes_[lane].side->initiator());
    }
  }
  for (const memory::Initiator initiator : initiators) {
    const auto sum = [this, initiator](std::uint64_t SideCounters::*counter) {
      std::uint64_t total = 0;
      for (const Lane& lane : lanes_) {
        total += lane.side != nullptr && lane.side->initiator() == initiator
                     ? lane.side->counters().*counter
                     : 0;
      }
      return total;
    };
    const auto name = memory::kInitiatorNames[static_cast<std::size_t>(initiator)];
    registry.add(fmt::format("dma.{}.units.events", name), "events",
                 fmt::format("Work units that the channels of {} completed.", name),
                 [sum] { return sum(&SideCounters::units); });
    registry.add(fmt::format("dma.{}.descriptors.events", name), "events",
                 fmt::format("Descriptors that the channels of {} fetched.", name),
                 [sum] { return sum(&SideCounters::descriptors); });
  }
}

}  // namespace finback::dma
