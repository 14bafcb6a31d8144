#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/memory_side.hpp>

namespace finback::dma {

namespace {

constexpr std::uint32_t kMostDescriptorWords = 9;

}  // namespace

MemorySide::MemorySide(DmaChannel channel, memory::Initiator initiator, bool internal,
                       ByteFifo& fifo, const DmaParameters& parameters, clock::ClockRatio ratio,
                       memory::MemorySystem& memory)
    : channel_(std::move(channel)),
      initiator_(initiator),
      internal_(internal),
      fifo_(fifo),
      memory_(memory),
      burst_elements_(static_cast<std::uint32_t>(parameters.burst_elements)),
      ratio_(internal ? clock::ClockRatio(1) : ratio),
      startup_(static_cast<Cycles>(internal ? parameters.imdma_startup_cycles
                                            : parameters.startup_sclk)),
      descriptor_overhead_(internal ? 0 : static_cast<Cycles>(parameters.descriptor_overhead_sclk)),
      counts_must_match_(parameters.errors_fault != 0),
      buffer_(std::size_t{burst_elements_} * 4) {}

void MemorySide::start(Cycles now) {
  channel_.start();
  rows_ = 0;
  chained_ = channel_.by_descriptors();
  if (!channel_.wants_descriptor()) {
    begin_unit();
  }
  ready_at_ = now + ratio_.cycles(startup_);
  if (peer_ != nullptr && peer_->channel_.running()) {
    peer_->ready_at_ = ready_at_;  // both sides begin together
  }
}

void MemorySide::abandon() {
  channel_.stop();
  fifo_.clear();
  ready_at_ = done_at_ = asked_at_ = kNever;
  descriptor_external_.reset();
}

void MemorySide::change_clock(const clock::ClockChange& change) {
  if (!internal_) {
    ratio_ = change.to;
    ready_at_ = change.system_time(ready_at_);
    done_at_ = change.system_time(done_at_);
  }
}

void MemorySide::act(Cycles now) {
  if (ready_at_ <= now) {
    ready_at_ = kNever;
  }
  if (done_at_ <= now) {
    done_at_ = kNever;
    if (fetching_) {
      end_descriptor(now);
    } else {
      end_burst(now);
    }
  }
}

// A stream's FIFO has room for two bursts, whatever their width.
std::uint32_t MemorySide::fifo_limit() const {
  return peer_ == nullptr ? fifo_.capacity() : 2 * burst_elements_ * channel_.shape().element_bytes;
}

// Elements of the next burst, by what the FIFO holds or has room for; 0: it must wait.
std::uint32_t MemorySide::possible_elements() const {
  const std::uint32_t width = channel_.shape().element_bytes;
  const AddressGenerator& walk = channel_.walk();
  std::uint64_t most = std::min<std::uint64_t>(burst_elements_, walk.elements_left());
  if (channel_.interrupts_per_row()) {
    most = std::min<std::uint64_t>(most, walk.columns_left());
  }
  if (channel_.writes_memory()) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(most, fifo_.size() / width));
  }
  if ((peer_ != nullptr && !peer_->channel_.running()) ||
      (!unit_begun_ && channel_.restarts() && fifo_.size() > 0)) {
    return 0;
  }
  most = std::min<std::uint64_t>(most, fifo_limit() / (2 * width));
  return fifo_.size() + most * width <= fifo_limit() ? static_cast<std::uint32_t>(most) : 0;
}

std::optional<MemorySide::Want> MemorySide::want(Cycles now) {
  if (!channel_.running() || ready_at_ != kNever || done_at_ != kNever) {
    return std::nullopt;
  }
  Want want;
  if (channel_.wants_descriptor()) {
    want.port = memory_.dma_port(channel_.descriptor().address);
  } else if (channel_.finishing() || possible_elements() == 0) {
    return std::nullopt;
  } else {
    want.port = memory_.dma_port(channel_.walk().address());
    want.direction = channel_.writes_memory() ? memory::Direction::write : memory::Direction::read;
  }
  asked_at_ = std::min(asked_at_, now);
  return want;
}

Cycles MemorySide::burst(memory::Direction direction, std::uint32_t element_bytes, bool further,
                         Cycles now) {
  const Cycles asked_at = asked_at_;
  asked_at_ = kNever;
  return internal_ ? memory_.internal_dma_burst(initiator_, direction, runs_, element_bytes, now,
                                                asked_at)
                   : memory_.dma_burst(initiator_, direction, runs_, element_bytes, now, asked_at,
                                       further);
}

std::uint32_t MemorySide::grant(Cycles now, std::uint32_t most) {
  runs_.clear();
  fetching_ = channel_.wants_descriptor();
  if (fetching_) {
    fetch_descriptor(now);
    return runs_.front().count;
  }
  elements_ = std::min(possible_elements(), most);
  const std::uint32_t width = channel_.shape().element_bytes;
  channel_.walk().take(elements_, runs_);
  for (const memory::DmaRun& run : runs_) {
    check(run, width, kCurrentAddress);
  }
  done_at_ = burst(channel_.writes_memory() ? memory::Direction::write : memory::Direction::read,
                   width, unit_begun_, now);
  unit_begun_ = true;
  return elements_;
}

void MemorySide::fetch_descriptor(Cycles now) {
  runs_.push_back(channel_.descriptor());
  check(runs_.front(), 2, kCurrentDescriptorPointer);
  check_descriptor_space(runs_.front().address);
  done_at_ = burst(memory::Direction::read, 2, false, now) + ratio_.cycles(descriptor_overhead_);
  ++counters_.descriptors;
}

void MemorySide::check(const memory::DmaRun& run, std::uint32_t element_bytes,
                       std::uint32_t register_offset) const {
  const bool writes = register_offset == kCurrentAddress && channel_.writes_memory();
  std::string why = memory_.dma_fault(run, element_bytes,
                                      writes ? memory::Direction::write : memory::Direction::read);
  if (why.empty() && internal_ && memory_.map().find(run.address)->level == memory::Level::l3) {
    why = fmt::format("{:#010x}: IMDMA reaches L1 and L2 only; use MDMA1 or MDMA2", run.address);
  }
  if (why.empty()) {
    return;
  }
  std::string message = fmt::format("DMA: {}_{} = {}", channel_.name(),
                                    find_channel_register(register_offset)->name, why);
  if (register_offset == kCurrentAddress) {
    message += fmt::format(" ({}_START_ADDR = {:#010x})", channel_.name(), channel_.shape().start);
  }
  throw DmaError(message);
}

// Anomaly 05000301: the descriptors of a stream's two sides must lie in the same kind of memory.
void MemorySide::check_descriptor_space(Address address) {
  descriptor_external_ = memory_.dma_port(address) == memory::DmaPort::external;
  if (peer_ != nullptr &&
      peer_->descriptor_external_.value_or(*descriptor_external_) != *descriptor_external_) {
    throw DmaError(
        fmt::format("DMA: {}_CURR_DESC_PTR = {:#010x}: the descriptors of {} lie {} the chip and "
                    "those of {} do "
                    "not (anomaly 05000301); put all of them into L1 and L2, or all into SDRAM",
                    channel_.name(), address, channel_.name(),
                    *descriptor_external_ ? "outside" : "on", peer_->channel_.name()));
  }
}

// A work unit begins: the registers hold it.
void MemorySide::begin_unit() {
  unit_begun_ = false;
  if (peer_ == nullptr) {
    if (channel_.writes_memory() && channel_.restarts()) {
      fifo_.clear();
    }
  } else if (peer_->channel_.running() && !peer_->channel_.wants_descriptor()) {
    check_pair();
  }
}

void MemorySide::check_pair() const {
  const bool is_source = !channel_.writes_memory();
  const DmaChannel& source = is_source ? channel_ : peer_->channel_;
  const DmaChannel& destination = is_source ? peer_->channel_ : channel_;
  const TransferShape& from = source.shape();
  const TransferShape& to = destination.shape();
  if (from.element_bytes != to.element_bytes) {
    throw DmaError(fmt::format(
        "DMA: WDSIZE of {}_CONFIG ({} bits) and {}_CONFIG ({} bits) differ: they must be equal",
        source.name(), from.element_bytes * 8, destination.name(), to.element_bytes * 8));
  }
  // Chains of work units may be cut differently at either end; single ones wait for ever.
  const bool single = source.flow() == Flow::stop && destination.flow() == Flow::stop &&
                      !chained_ && !peer_->chained_;
  if (counts_must_match_ && single && from.elements() != to.elements()) {
    throw DmaError(fmt::format("DMA: {} moves {} x {} elements, {} {} x {}: they must be as many",
                               source.name(), from.x_count, from.y_count, destination.name(),
                               to.x_count, to.y_count));
  }
}

void MemorySide::end_descriptor(Cycles now) {
  std::array<std::uint8_t, std::size_t{2} * kMostDescriptorWords> bytes{};
  std::array<std::uint16_t, kMostDescriptorWords> words{};
  const std::uint32_t count = runs_.front().count;
  memory_.gather(runs_, 2, bytes.data(), initiator_, now);
  for (std::size_t i = 0; i < count; ++i) {
    words[i] = static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8U);
  }
  channel_.load_descriptor(std::span(words).first(count));
  if (channel_.running()) {
    begin_unit();
  }
}

void MemorySide::end_burst(Cycles now) {
  const std::uint32_t width = channel_.shape().element_bytes;
  const std::uint32_t bytes = elements_ * width;
  if (channel_.writes_memory()) {
    fifo_.peek(buffer_.data(), bytes);
    memory_.scatter(runs_, width, buffer_.data(), initiator_);
    fifo_.drop(bytes);
  } else {
    memory_.gather(runs_, width, buffer_.data(), initiator_, now);
    fifo_.push(buffer_.data(), bytes);
  }
  const std::uint32_t rows = channel_.walk().rows_done();
  if (rows != rows_) {
    channel_.row_done();
  }
  rows_ = rows;
  if (channel_.walk().finished()) {
    ++counters_.units;
    rows_ = 0;
    channel_.finish_unit();
    if (channel_.writes_memory()) {
      channel_.drained();
    }
    if (channel_.running() && !channel_.wants_descriptor() && !channel_.finishing()) {
      begin_unit();
    }
  }
  if (channel_.writes_memory() && peer_ != nullptr && fifo_.size() == 0) {
    peer_->channel_.drained();
  }
}

}  // namespace finback::dma
