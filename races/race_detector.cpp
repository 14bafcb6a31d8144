#include <algorithm>
#include <races/race_detector.hpp>

namespace finback::races {

using memory::Direction;

namespace {

constexpr Address kWordBytes = 4;

std::uint32_t line_key(int core, int source) {
  constexpr std::uint32_t kSources = 64;
  return static_cast<std::uint32_t>(core) * kSources + static_cast<std::uint32_t>(source);
}

}  // namespace

RaceDetector::RaceDetector(std::vector<Range> flags) : flags_(std::move(flags)) {
  std::ranges::sort(flags_, {}, &Range::base);
  for (std::size_t actor = 0; actor < kActorCount; ++actor) {
    clocks_[actor].step(actor);  // step 0 is before everything
  }
}

std::uint32_t RaceDetector::place_index(const Place& place) {
  const auto [found, added] =
      place_indices_.try_emplace(place, static_cast<std::uint32_t>(places_.size()));
  if (added) {
    places_.push_back(place);
  }
  return found->second;
}

void RaceDetector::release(std::size_t actor, VectorClock& clock) {
  clock.join(clocks_[actor]);
  clocks_[actor].step(actor);
}

// --- accesses ---

void RaceDetector::core_access(int core, std::uint32_t packet, Address address, int bytes,
                               Direction direction, Cycles now) {
  const auto actor = static_cast<std::size_t>(core);
  const auto size = static_cast<std::uint32_t>(bytes);
  if (VectorClock* flag = flag_at(address, size)) {
    through_flag(actor, *flag, direction);
    return;
  }
  access({actor, place_index({core, packet}), direction, now}, address, size);
}

void RaceDetector::core_lock(int core, std::uint32_t packet, Address address, Cycles now) {
  const auto actor = static_cast<std::size_t>(core);
  VectorClock* flag = flag_at(address, 1);
  if (flag == nullptr) {
    // The first TESTSET makes it a lock; who initialised it comes before everybody.
    access({actor, place_index({core, packet}), Direction::read, now}, address, 1);
    const Range lock{address, 1};
    flags_.insert(std::ranges::upper_bound(flags_, lock.base, {}, &Range::base), lock);
    flag = flag_at(address, 1);
  }
  through_flag(actor, *flag, Direction::read);
  through_flag(actor, *flag, Direction::write);
}

void RaceDetector::dma_access(memory::Initiator stream, std::span<const memory::DmaRun> runs,
                              std::uint32_t element_bytes, Direction direction, Cycles now) {
  const auto number = static_cast<std::size_t>(stream);
  const Actor actor{number, stream_places_[number], direction, now};
  for (const memory::DmaRun& run : runs) {
    Address address = run.address;
    for (std::uint32_t i = 0; i < run.count; ++i) {
      access(actor, address, element_bytes);
      address += static_cast<Address>(run.stride);
    }
  }
}

void RaceDetector::host_access(Address address, std::uint32_t size, Direction direction) {
  if (acting_) {
    access({*acting_, acting_place_, direction, acting_since_}, address, size);
  }
}

void RaceDetector::access(const Actor& actor, Address address, std::uint32_t bytes) {
  for (std::uint32_t i = 0; i < bytes; ++i) {
    Cell& cell = shadow_.cell(address + i);
    actor.direction == Direction::read ? read_byte(actor, address + i, cell)
                                       : write_byte(actor, address + i, cell);
  }
}

bool RaceDetector::unordered(const Actor& actor, const Mark& mark) const {
  return mark.step > clocks_[actor.number][mark.actor] && mark.actor != actor.number;
}

void RaceDetector::read_byte(const Actor& actor, Address address, Cell& cell) {
  check(actor, cell.write, Direction::write, address);
  if (cell.read.actor == kSeveral) {
    shadow_.readers(address)[actor.number] = mark_of(actor);
  } else if (unordered(actor, cell.read)) {
    ShadowMemory::Readers& readers = shadow_.readers(address);
    readers[cell.read.actor] = cell.read;
    readers[actor.number] = mark_of(actor);
    cell.read.actor = kSeveral;
  } else {
    cell.read = mark_of(actor);
  }
}

void RaceDetector::write_byte(const Actor& actor, Address address, Cell& cell) {
  check(actor, cell.write, Direction::write, address);
  if (cell.read.actor == kSeveral) {
    for (const Mark& reader : shadow_.readers(address)) {
      check(actor, reader, Direction::read, address);
    }
    shadow_.forget_readers(address);
  } else {
    check(actor, cell.read, Direction::read, address);
  }
  cell.write = mark_of(actor);
  cell.read = {};
}

Mark RaceDetector::mark_of(const Actor& actor) const {
  return {clocks_[actor.number][actor.number], actor.place,
          static_cast<std::uint8_t>(actor.number)};
}

void RaceDetector::check(const Actor& actor, const Mark& earlier, Direction direction,
                         Address address) {
  if (!unordered(actor, earlier)) {
    return;
  }
  const RaceSide first{static_cast<memory::Initiator>(earlier.actor), direction,
                       places_[earlier.place]};
  const RaceSide second{static_cast<memory::Initiator>(actor.number), actor.direction,
                        places_[actor.place]};
  const auto [known, added] = known_.try_emplace({first, second}, races_.size());
  if (added) {
    races_.push_back(
        {.earlier = first, .later = second, .address = address, .at = actor.now, .bytes = 0});
  }
  ++races_[known->second].bytes;
}

// --- order ---

VectorClock* RaceDetector::flag_at(Address address, std::uint32_t bytes) {
  const auto next = std::ranges::upper_bound(flags_, address, {}, &Range::base);
  const bool inside =
      next != flags_.begin() && address - std::prev(next)->base < std::prev(next)->size;
  const bool reaches = next != flags_.end() && next->base - address < bytes;
  if (!inside && !reaches) {
    return nullptr;
  }
  return &flag_clocks_[address / kWordBytes];
}

void RaceDetector::through_flag(std::size_t actor, VectorClock& flag, Direction direction) {
  if (direction == Direction::read) {
    clocks_[actor].join(flag);
  } else {
    release(actor, flag);
  }
}

void RaceDetector::acts(std::optional<memory::Initiator> who) {
  acting_.reset();
  if (who) {
    acting_ = static_cast<std::size_t>(*who);
  }
}

void RaceDetector::device_access(int core, std::uint32_t packet, Address address,
                                 Direction direction, Cycles now) {
  acting_ = static_cast<std::size_t>(core);
  acting_place_ = place_index({core, packet});
  acting_since_ = now;
  through_flag(*acting_, flag_clocks_[address / kWordBytes], direction);
}

void RaceDetector::channel_access(memory::Initiator stream, Direction direction) {
  const auto number = static_cast<std::size_t>(stream);
  if (!acting_) {
    return;
  }
  if (direction == Direction::read) {
    release(number, clocks_[*acting_]);
  } else {
    release(*acting_, clocks_[number]);
    stream_places_[number] = acting_place_;
  }
}

void RaceDetector::line_raised(int core, int source) {
  if (acting_) {
    release(*acting_, lines_[line_key(core, source)]);
  }
}

void RaceDetector::lines_seen(int core, int word, std::uint32_t lines) {
  constexpr int kWordLines = 32;
  if (!acting_) {
    return;
  }
  for (int line = 0; line < kWordLines; ++line) {
    const auto found = (lines >> line & 1U) != 0
                           ? lines_.find(line_key(core, word * kWordLines + line))
                           : lines_.end();
    if (found != lines_.end()) {
      clocks_[*acting_].join(found->second);
    }
  }
}

void RaceDetector::core_released(int core) {
  if (acting_) {
    release(*acting_, clocks_[static_cast<std::size_t>(core)]);
  }
}

}  // namespace finback::races
