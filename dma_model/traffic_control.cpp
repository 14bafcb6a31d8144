#include <algorithm>
#include <limits>

#include <dma_model/traffic_control.hpp>

namespace finback::dma {

namespace {

// As the hardware reference has it: what is against the traffic loses 16 places, what is not urgent
// 32 when something else is.
constexpr std::uint32_t kAgainstTraffic = 16;
constexpr std::uint32_t kNotUrgent = 32;

}  // namespace

void TrafficControl::set_periods(std::uint32_t value) {
  periods_ = value & 0xFFFFU;
  buses_[0] = {.period = periods_ & 0xFU};
  buses_[1] = {.period = periods_ >> 4U & 0xFU};
  turn_ = periods_ >> 11U;
  turn_left_ = 0;
  turn_of_ = kFree;
  alone_.fill(0);
}

std::uint32_t TrafficControl::counts() const {
  return buses_[0].count | buses_[1].count << 4U | turn_left_ << 11U;
}

std::uint32_t TrafficControl::rank(std::uint32_t lane, memory::DmaPort port,
                                   memory::Direction direction, bool urgent) const {
  std::uint32_t rank = lane;
  if (turn_of_ == 1 && lane >= kPeripheralLanes) {
    rank = lane ^ 2U;  // the two streams change places
  }
  const Bus& b = bus(port);
  const bool same = direction == b.direction;
  if (b.period > 0 && same != (b.count > 0)) {
    rank += kAgainstTraffic;
  }
  return urgent ? rank : rank + kNotUrgent;
}

std::uint32_t TrafficControl::most_elements(std::uint32_t lane, memory::DmaPort port, bool opposed,
                                            bool contested) const {
  std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  const Bus& b = bus(port);
  if (opposed && b.period > 0) {
    most = b.period;
  }
  const int stream = stream_of(lane);
  if (stream != kFree && turn_ > 0 && contested) {
    most = std::min(most, stream == turn_of_ ? turn_left_ : turn_);
  }
  return most;
}

std::uint32_t TrafficControl::granted(std::uint32_t lane, memory::DmaPort port,
                                      memory::Direction direction, std::uint32_t elements,
                                      bool contested) {
  Bus& b = buses_[port == memory::DmaPort::external ? 1 : 0];
  if (b.direction != direction) {
    b.direction = direction;
    b.count = b.period;
  }
  b.count -= std::min(b.count, elements);
  const int stream = stream_of(lane);
  if (stream == kFree || turn_ == 0) {
    return 0;
  }
  if (!contested) {  // at the end of every turn the other stream has its chance, and does not want
                     // it
    std::uint32_t& alone = alone_[direction == memory::Direction::write ? 1 : 0];
    alone += elements;
    const std::uint32_t idle = alone / turn_;
    alone %= turn_;
    turn_of_ = kFree;
    return idle;
  }
  if (direction == memory::Direction::write) {  // what a turn is counted in
    take_turn(stream, elements);
  }
  return 0;
}

void TrafficControl::take_turn(int stream, std::uint32_t elements) {
  if (stream != turn_of_) {
    turn_of_ = stream;
    turn_left_ = turn_;
  }
  turn_left_ -= std::min(turn_left_, elements);
  if (turn_left_ == 0) {
    turn_of_ = 1 - stream;
    turn_left_ = turn_;
  }
}

}  // namespace finback::dma
