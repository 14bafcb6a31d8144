#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/dma_controller.hpp>
#include <dma_model/peripheral_port.hpp>

namespace finback::dma {

bool PeripheralPort::push(std::span<const std::uint8_t> bytes, Cycles now) {
  return controller_->push(peripheral_, bytes, now);
}

bool PeripheralPort::pull(std::span<std::uint8_t> bytes, Cycles now) {
  return controller_->pull(peripheral_, bytes, now);
}

bool PeripheralPort::running() const { return controller_->running(peripheral_); }

std::uint32_t PeripheralPort::element_bytes() const {
  return controller_->element_bytes(peripheral_);
}

// The lane that serves `peripheral`, checked for its direction; nullptr: none does.
DmaController::Lane* DmaController::lane_for(std::uint32_t peripheral, bool receives) {
  const std::uint32_t number = lane_by_peripheral_[peripheral];
  if (number == kLaneCount) {
    return nullptr;
  }
  const DmaChannel& channel = lanes_[number].side->channel();
  if (channel.running() && channel.writes_memory() != receives) {
    throw GuestFault(fmt::format("DMA: {}_CONFIG = {:#x}: WNR = {}, but its peripheral {}",
                                 channel.name(), channel.read(kConfig, 2), receives ? 0 : 1,
                                 receives ? "receives: it needs 1" : "transmits: it needs 0"));
  }
  return &lanes_[number];
}

bool DmaController::push(std::uint32_t peripheral, std::span<const std::uint8_t> bytes,
                         Cycles now) {
  Lane* lane = lane_for(peripheral, true);
  if (lane == nullptr || lane->own_fifo->room() < bytes.size()) {
    return false;
  }
  lane->last_chunk = static_cast<std::uint32_t>(bytes.size());
  lane->own_fifo->push(bytes.data(), lane->last_chunk);
  settle(now);
  return true;
}

bool DmaController::pull(std::uint32_t peripheral, std::span<std::uint8_t> bytes, Cycles now) {
  Lane* lane = lane_for(peripheral, false);
  if (lane == nullptr) {
    return false;
  }
  lane->last_chunk = static_cast<std::uint32_t>(bytes.size());
  const bool enough = lane->own_fifo->size() >= bytes.size();
  if (enough) {
    lane->own_fifo->peek(bytes.data(), lane->last_chunk);
    lane->own_fifo->drop(lane->last_chunk);
    if (lane->own_fifo->size() == 0) {
      lane->side->channel().drained();
    }
  }
  settle(now);
  return enough;
}

bool DmaController::running(std::uint32_t peripheral) const {
  const std::uint32_t number = lane_by_peripheral_[peripheral];
  if (number == kLaneCount) {
    return false;
  }
  const DmaChannel& channel = lanes_[number].side->channel();
  return channel.running() && !channel.finishing();
}

std::uint32_t DmaController::element_bytes(std::uint32_t peripheral) const {
  return running(peripheral)
             ? lanes_[lane_by_peripheral_[peripheral]].side->channel().shape().element_bytes
             : 0;
}

}  // namespace finback::dma
