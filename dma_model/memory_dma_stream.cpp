#include <algorithm>
#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/memory_dma_stream.hpp>

namespace finback::dma {

MemoryDmaStream::MemoryDmaStream(const std::string& controller, int number,
                                 memory::Initiator initiator, const DmaParameters& parameters,
                                 Cycles ratio, memory::MemorySystem& memory)
    : destination_(fmt::format("{}_D{}", controller, number), true),
      source_(fmt::format("{}_S{}", controller, number), false),
      initiator_(initiator),
      burst_elements_(static_cast<std::uint32_t>(parameters.burst_elements)),
      startup_(static_cast<Cycles>(parameters.startup_sclk) * ratio),
      memory_(memory) {
  for (Burst& burst : fifo_) {
    burst.bytes.resize(std::size_t{burst_elements_} * 4);
  }
}

void MemoryDmaStream::write(bool to_destination, std::uint32_t offset, int bytes,
                            std::uint32_t value, Cycles now) {
  DmaChannel& channel = to_destination ? destination_ : source_;
  if (memory::AccessObserver* observer = memory_.observer()) {
    observer->channel_access(initiator_, memory::Direction::write);
  }
  if (channel.write(offset, bytes, value)) {
    config_written(channel, now);
  }
}

void MemoryDmaStream::note_read() const {
  if (memory::AccessObserver* observer = memory_.observer()) {
    observer->channel_access(initiator_, memory::Direction::read);
  }
}

void MemoryDmaStream::config_written(DmaChannel& channel, Cycles now) {
  if (!channel.enabled()) {
    channel.stop();
    abandon();
    return;
  }
  if (channel.running()) {
    throw GuestFault(fmt::format(
        "DMA: {}_CONFIG was written while the channel runs; wait for DONE or write 0 first",
        channel.name()));
  }
  channel.start();
  if (source_.running() && destination_.running()) {
    start(now + startup_);
  }
}

void MemoryDmaStream::abandon() {
  read_at_ = read_done_at_ = write_done_at_ = kNever;
  fifo_count_ = 0;
  plan_next_event();
}

void MemoryDmaStream::check_pair() const {
  const TransferShape& from = source_.shape();
  const TransferShape& to = destination_.shape();
  if (from.element_bytes != to.element_bytes) {
    throw GuestFault(fmt::format(
        "DMA: WDSIZE of {}_CONFIG ({} bits) and {}_CONFIG ({} bits) differ: they must be equal",
        source_.name(), from.element_bytes * 8, destination_.name(), to.element_bytes * 8));
  }
  if (from.elements() != to.elements()) {
    throw GuestFault(fmt::format("DMA: {} moves {} x {} elements, {} {} x {}: they must be as many",
                                 source_.name(), from.x_count, from.y_count, destination_.name(),
                                 to.x_count, to.y_count));
  }
}

void MemoryDmaStream::check(const DmaChannel& channel,
                            const std::vector<memory::DmaRun>& runs) const {
  for (const memory::DmaRun& run : runs) {
    const std::string why = memory_.dma_fault(run, channel.shape().element_bytes);
    if (!why.empty()) {
      throw GuestFault(fmt::format("DMA: {}_CURR_ADDR = {} ({}_START_ADDR = {:#010x})",
                                   channel.name(), why, channel.name(), channel.shape().start));
    }
  }
}

void MemoryDmaStream::start(Cycles at) {
  check_pair();
  // One side may have stayed enabled when the other was stopped half-way.
  source_.rewind();
  destination_.rewind();
  source_rows_ = destination_rows_ = 0;
  fifo_count_ = 0;
  read_at_ = at;
  plan_next_event();
}

void MemoryDmaStream::plan_next_event() {
  next_event_ = std::min({read_at_, read_done_at_, write_done_at_});
}

void MemoryDmaStream::advance(Cycles now) {
  if (memory::AccessObserver* observer = memory_.observer()) {
    observer->acts(initiator_);
  }
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    // What ends comes before what begins: it makes room.
    if (write_done_at_ == at) {
      write_done(at);
    } else if (read_done_at_ == at) {
      read_done(at);
    } else {
      read_at_ = kNever;
      ask_read(at);
    }
    plan_next_event();
  }
}

// Asks for the next burst of the source, if the FIFO has room for it.
void MemoryDmaStream::ask_read(Cycles now) {
  if (read_done_at_ != kNever || fifo_count_ == fifo_.size() || source_.walk().finished()) {
    return;
  }
  read_runs_.clear();
  source_.walk().take(burst_elements_, read_runs_);
  check(source_, read_runs_);
  read_done_at_ = memory_.dma_burst(initiator_, memory::Direction::read, read_runs_,
                                    source_.shape().element_bytes, now);
}

// Asks to write the oldest burst in the FIFO.
void MemoryDmaStream::ask_write(Cycles now) {
  if (write_done_at_ != kNever || fifo_count_ == 0) {
    return;
  }
  write_runs_.clear();
  destination_.walk().take(fifo_[fifo_first_].elements, write_runs_);
  check(destination_, write_runs_);
  write_done_at_ = memory_.dma_burst(initiator_, memory::Direction::write, write_runs_,
                                     destination_.shape().element_bytes, now);
}

void MemoryDmaStream::read_done(Cycles now) {
  Burst& burst = fifo_[(fifo_first_ + fifo_count_) % fifo_.size()];
  burst.elements = 0;
  for (const memory::DmaRun& run : read_runs_) {
    burst.elements += run.count;
  }
  memory_.gather(read_runs_, source_.shape().element_bytes, burst.bytes.data());
  ++fifo_count_;
  read_done_at_ = kNever;
  note_rows(source_, source_rows_);
  ask_write(now);
  ask_read(now);
}

void MemoryDmaStream::write_done(Cycles now) {
  memory_.scatter(write_runs_, destination_.shape().element_bytes, fifo_[fifo_first_].bytes.data());
  fifo_first_ = (fifo_first_ + 1) % fifo_.size();
  --fifo_count_;
  write_done_at_ = kNever;
  note_rows(destination_, destination_rows_);
  if (destination_.walk().finished()) {
    finish(now);
    return;
  }
  ask_write(now);
  ask_read(now);
}

// DONE with every row that has been passed, where the channel wants that.
void MemoryDmaStream::note_rows(DmaChannel& channel, std::uint32_t& rows) {
  const std::uint32_t done = channel.walk().rows_done();
  if (done != rows && channel.interrupts_per_row()) {
    channel.set_done();
  }
  rows = done;
}

void MemoryDmaStream::finish(Cycles now) {
  for (DmaChannel* channel : {&source_, &destination_}) {
    channel->set_done();
    if (channel->autobuffer()) {
      channel->start();
    } else {
      channel->stop();
    }
  }
  if (source_.running() && destination_.running()) {
    start(now);
  }
}

}  // namespace finback::dma
