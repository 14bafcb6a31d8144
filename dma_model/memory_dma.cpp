#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/memory_dma.hpp>

namespace finback::dma {

namespace {

// Anomaly 05000182: IMDMA corrupts data above this core clock, on all silicon.
constexpr double kImdmaMaximumMhz = 500;

memory::Initiator initiator_of(Controller controller, int stream) {
  const int first = static_cast<int>(controller == Controller::mdma1 ? memory::Initiator::mdma1_0
                                                                     : memory::Initiator::mdma2_0);
  return static_cast<memory::Initiator>(first + stream);
}

const char* name_of(Controller controller) {
  return controller == Controller::mdma1 ? "MDMA1" : "MDMA2";
}

}  // namespace

const DeviceRegister* MemoryDmaRegisters::find_register(std::uint32_t offset) const {
  return find_channel_register(offset % kChannelBytes);
}

std::string MemoryDmaRegisters::register_name(std::uint32_t offset) const {
  const DeviceRegister* found = find_register(offset);
  return found == nullptr ? ""
                          : fmt::format("{}{}_{}", offset / kChannelBytes % 2 == 0 ? 'D' : 'S',
                                        offset / (2 * kChannelBytes), found->name);
}

std::uint32_t MemoryDmaRegisters::read(std::uint32_t offset, int bytes, Cycles /*now*/) {
  return channel(offset).read(offset % kChannelBytes, bytes);
}

MemoryDma::MemoryDma(Controller controller, const DmaParameters& parameters, Cycles ratio,
                     memory::MemorySystem& memory, InterruptLine interrupt)
    : streams_{MemoryDmaStream(name_of(controller), 0, initiator_of(controller, 0), parameters,
                               ratio, memory),
               MemoryDmaStream(name_of(controller), 1, initiator_of(controller, 1), parameters,
                               ratio, memory)},
      interrupt_(std::move(interrupt)) {}

const DmaChannel& MemoryDma::channel(std::uint32_t offset) const {
  const MemoryDmaStream& stream = streams_.at(offset / (2 * kChannelBytes));
  return offset / kChannelBytes % 2 == 0 ? stream.destination() : stream.source();
}

std::uint32_t MemoryDma::read(std::uint32_t offset, int bytes, Cycles now) {
  streams_.at(offset / (2 * kChannelBytes)).note_read();
  return MemoryDmaRegisters::read(offset, bytes, now);
}

void MemoryDma::write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) {
  const std::size_t stream = offset / (2 * kChannelBytes);
  streams_.at(stream).write(offset / kChannelBytes % 2 == 0, offset % kChannelBytes, bytes, value,
                            now);
  update_line(stream, now);
  plan_next_event();
}

void MemoryDma::plan_next_event() {
  next_event_ = std::min(streams_[0].next_event_time(), streams_[1].next_event_time());
}

void MemoryDma::advance(Cycles now) {
  while (next_event_ <= now) {
    // One event at a time, so that the two streams meet the memories in the order of time.
    const std::size_t first =
        streams_[0].next_event_time() <= streams_[1].next_event_time() ? 0 : 1;
    const Cycles at = streams_[first].next_event_time();
    streams_[first].advance(at);
    update_line(first, at);
    plan_next_event();
  }
}

void MemoryDma::update_line(std::size_t stream, Cycles now) {
  const bool level = streams_[stream].interrupt_pending();
  if (level != line_[stream]) {
    line_[stream] = level;
    interrupt_(static_cast<int>(stream), level, now);
  }
}

InternalMemoryDma::InternalMemoryDma(double cclk_mhz)
    : cclk_mhz_(cclk_mhz),
      channels_{DmaChannel("IMDMA_D0", true), DmaChannel("IMDMA_S0", false),
                DmaChannel("IMDMA_D1", true), DmaChannel("IMDMA_S1", false)} {}

void InternalMemoryDma::write(std::uint32_t offset, int bytes, std::uint32_t value,
                              Cycles /*now*/) {
  DmaChannel& channel = channels_.at(offset / kChannelBytes);
  channel.write(offset % kChannelBytes, bytes, value);
  if (!channel.enabled()) {
    return;
  }
  if (cclk_mhz_ > kImdmaMaximumMhz) {
    throw GuestFault(
        fmt::format("DMA: {}_CONFIG = {:#x}: IMDMA corrupts data above {} MHz CCLK (anomaly "
                    "05000182) and CCLK is {} MHz; use MDMA1 or MDMA2",
                    channel.name(), value, kImdmaMaximumMhz, cclk_mhz_));
  }
  throw GuestFault(
      fmt::format("DMA: {}_CONFIG = {:#x}: IMDMA transfers are not modelled; use MDMA1 or MDMA2",
                  channel.name(), value));
}

}  // namespace finback::dma
