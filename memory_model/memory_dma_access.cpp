// The side of the memory system that DMA uses: bursts in time, and their bytes.
#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include <memory_model/memory_system.hpp>
#include <memory_model/strided.hpp>

namespace finback::memory {

namespace {

// The lowest and the highest address that a run touches.
struct Extent {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

Extent extent_of(const DmaRun& run, std::uint32_t element_bytes) {
  const std::int64_t first = run.address;
  const std::int64_t last = first + std::int64_t{run.stride} * (std::int64_t{run.count} - 1);
  return {std::min(first, last), std::max(first, last) + element_bytes - 1};
}

// Calls `visit(address, bytes)` for each stretch of neighbouring bytes of a run.
template <class Visit>
void for_each_stretch(const DmaRun& run, std::uint32_t element_bytes, const Visit& visit) {
  if (run.stride == static_cast<std::int32_t>(element_bytes)) {
    visit(run.address, run.count * element_bytes);
    return;
  }
  Address address = run.address;
  for (std::uint32_t i = 0; i < run.count; ++i) {
    visit(address, element_bytes);
    address += static_cast<Address>(run.stride);
  }
}

}  // namespace

std::string MemorySystem::dma_fault(const DmaRun& run, std::uint32_t element_bytes,
                                    Direction direction) const {
  const Region* region = map_.find(run.address);
  if (region == nullptr) {
    return fmt::format("{:#010x}: no memory is mapped there", run.address);
  }
  if (!region->dma_reachable) {
    return fmt::format("{:#010x}: DMA does not reach {}", run.address, region->name);
  }
  const Extent extent = extent_of(run, element_bytes);
  const std::int64_t low = region->base;
  const std::int64_t high = low + region->size - 1;
  if (extent.low < low || extent.high > high) {
    const std::int64_t past = extent.low < low ? extent.low : extent.high;
    return fmt::format("{:#010x}: the transfer leaves {}, which ends at {:#010x}",
                       static_cast<std::uint32_t>(past), region->name,
                       static_cast<std::uint32_t>(past < low ? low : high));
  }
  if (region->level == Level::l3 && is_asynchronous(run.address) && !async_.enabled(run.address)) {
    return fmt::format("{:#010x}: {}", run.address, async_.fault(run.address));
  }
  if (direction == Direction::write && region->read_only) {
    return fmt::format("{:#010x}: {} is read-only", run.address, region->name);
  }
  for (const std::int64_t end : {extent.low, extent.high}) {
    if (is_cache(*region, static_cast<Address>(end))) {
      return fmt::format("{:#010x}: DMA does not reach that part of {}, which is cache",
                         static_cast<Address>(end), region->name);
    }
  }
  return "";
}

Cycles MemorySystem::dma_free_at(const Span& span, Address address) const {
  switch (span.level) {
    case Level::l2:
      return l2_.dma_free_at(address);
    case Level::l3:
      return bus_.free_at();
    case Level::l1:
      break;
  }
  return l1_dma_free_at_[static_cast<std::size_t>(span.core)];
}

Cycles MemorySystem::dma_start(const Span& span, Address address, Initiator initiator,
                               Direction direction, bool further, Cycles now) {
  switch (span.level) {
    case Level::l2:
      return l2_.dma_start(further, address, now);
    case Level::l3:
      return is_asynchronous(span.base)
                 ? async_.dma_start(initiator, direction, further, span.base, now)
                 : sdram_.dma_start(initiator, direction, further, now);
    case Level::l1:
      break;
  }
  return std::max(now, dma_free_at(span, address)) +
         (further ? 0 : ratio_.cycles(l1_dma_overhead_));
}

Cycles MemorySystem::dma_words(const Span& span, Direction direction, const DmaRun& run,
                               std::uint32_t element_bytes, Cycles start) {
  switch (span.level) {
    case Level::l2: {
      const Extent extent = extent_of(run, element_bytes);
      return l2_.dma_words(static_cast<Address>(extent.low), static_cast<Address>(extent.high),
                           run.count, start);
    }
    case Level::l3:
      return is_asynchronous(run.address)
                 ? async_.dma_words(direction, run.address, run.count, element_bytes, start)
                 : sdram_.dma_words(direction, run.address, run.stride, run.count, element_bytes,
                                    start);
    case Level::l1:
      break;
  }
  const auto core = static_cast<std::size_t>(span.core);
  Cycles& free_at = l1_dma_free_at_[core];
  free_at = start + ratio_.cycles(run.count * l1_dma_word_);
  pass_through_l1(span, run, start, ratio_.cycles(l1_dma_word_));
  return free_at;
}

// Lets the core meet the words of a run, of which one passes every `word` cycles.
void MemorySystem::pass_through_l1(const Span& span, const DmaRun& run, Cycles start, Cycles word) {
  const auto core = static_cast<std::size_t>(span.core);
  if (sub_bank_bytes_[core] != 0 && span.core_access) {
    l1_bursts_[core].add({.first = run.address,
                          .stride = run.stride,
                          .words = run.count,
                          .start = start,
                          .word = word});
    set_windows(span.core);
  }
}

void MemorySystem::set_windows(int core) {
  const auto number = static_cast<std::size_t>(core);
  for (Span* span : l1_data_spans_[number]) {
    const bool closed = !span->core_access ||
                        (!l1_bursts_[number].empty() &&
                         l1_bursts_[number].near(span->base, span->size, sub_bank_bytes_[number]));
    span->window.size = closed ? 0 : span->size;
  }
}

DmaPort MemorySystem::dma_port(Address address) {
  const Span* span = find_any(address);
  if (span == nullptr || !span->dma_reachable) {
    return DmaPort::none;
  }
  switch (span->level) {
    case Level::l2:
      return DmaPort::l2;
    case Level::l3:
      return DmaPort::external;
    case Level::l1:
      break;
  }
  return span->core == 0 ? DmaPort::l1_a : DmaPort::l1_b;
}

void MemorySystem::count_wait(Span& span, Initiator initiator, Direction direction, Cycles cycles) {
  span.traffic[static_cast<std::size_t>(initiator)][static_cast<std::size_t>(direction)]
      .stall_cycles += cycles;
}

Cycles MemorySystem::dma_burst(Initiator initiator, Direction direction,
                               std::span<const DmaRun> runs, std::uint32_t element_bytes,
                               Cycles now, Cycles asked_at, bool further) {
  if (observer_ != nullptr) {
    observer_->dma_access(initiator, runs, element_bytes, direction, now);
  }
  Cycles time = now;
  const Span* previous = nullptr;
  for (const DmaRun& run : runs) {
    Span* span = find_any(run.address);
    if (previous == nullptr && span->level == Level::l1) {
      l1_bursts_[static_cast<std::size_t>(span->core)].prune(now);
    }
    if (previous == nullptr) {
      count_wait(*span, initiator, direction,
                 std::max(now, dma_free_at(*span, run.address)) - asked_at);
    }
    if (previous == nullptr || previous->region != span->region) {
      time = dma_start(*span, run.address, initiator, direction, further, time);
    }
    time = dma_words(*span, direction, run, element_bytes, time);
    count_run(initiator, direction, run, element_bytes);
    previous = span;
  }
  return time;
}

Cycles MemorySystem::internal_dma_burst(Initiator initiator, Direction direction,
                                        std::span<const DmaRun> runs, std::uint32_t element_bytes,
                                        Cycles now, Cycles asked_at) {
  if (observer_ != nullptr) {
    observer_->dma_access(initiator, runs, element_bytes, direction, now);
  }
  Cycles time = now;
  bool first = true;
  for (const DmaRun& run : runs) {
    Span* span = find_any(run.address);
    const bool l2 = span->level == Level::l2;
    Cycles& l1_free_at = l1_dma_free_at_[static_cast<std::size_t>(l2 ? 0 : span->core)];
    const Cycles start = std::max(time, l2 ? l2_.port_free_at() : l1_free_at);
    const Cycles overhead = first ? imdma_overhead_ : 0;
    if (first) {
      count_wait(*span, initiator, direction, start - asked_at);
    }
    if (!l2) {
      l1_bursts_[static_cast<std::size_t>(span->core)].prune(now);
      pass_through_l1(*span, run, start + overhead, imdma_word_);
    }
    const Cycles cycles = overhead + run.count * imdma_word_;
    time = l2 ? l2_.internal_dma(cycles, start) : l1_free_at = start + cycles;
    count_run(initiator, direction, run, element_bytes);
    first = false;
  }
  return time;
}

void MemorySystem::count_run(Initiator initiator, Direction direction, const DmaRun& run,
                             std::uint32_t element_bytes) {
  Address address = run.address;
  std::uint32_t left = run.count;
  while (left > 0) {
    Span* span = find_any(address);
    const std::uint32_t here = elements_within(address, run.stride, left, span->base,
                                               std::uint64_t{span->base} + span->size);
    Traffic& traffic =
        span->traffic[static_cast<std::size_t>(initiator)][static_cast<std::size_t>(direction)];
    traffic.accesses += here;
    traffic.bytes += Bytes{here} * element_bytes;
    left -= here;
    address += here * static_cast<std::uint32_t>(run.stride);
  }
}

void MemorySystem::gather(std::span<const DmaRun> runs, std::uint32_t element_bytes,
                          std::uint8_t* to, Initiator initiator, Cycles now) {
  for (const DmaRun& run : runs) {
    if (watching_) {
      const Accessor who{initiator};
      for_each_stretch(run, element_bytes,
                       [&](Address at, std::uint32_t bytes) { note_read(at, bytes, who, now); });
    }
    const std::uint8_t* from = find_any(run.address)->at(run.address);
    if (run.stride == static_cast<std::int32_t>(element_bytes)) {
      const std::size_t bytes = std::size_t{run.count} * element_bytes;
      std::memcpy(to, from, bytes);
      to += bytes;
      continue;
    }
    for (std::uint32_t i = 0; i < run.count; ++i, to += element_bytes) {
      std::memcpy(to, from + std::ptrdiff_t{run.stride} * i, element_bytes);
    }
  }
}

void MemorySystem::scatter(std::span<const DmaRun> runs, std::uint32_t element_bytes,
                           const std::uint8_t* from, Initiator initiator) {
  for (const DmaRun& run : runs) {
    if (watching_) {
      const Accessor who{initiator};
      for_each_stretch(run, element_bytes,
                       [&](Address at, std::uint32_t bytes) { note_write(at, bytes, who); });
    }
    std::uint8_t* to = find_any(run.address)->at(run.address);
    if (run.stride == static_cast<std::int32_t>(element_bytes)) {
      const std::size_t bytes = std::size_t{run.count} * element_bytes;
      std::memcpy(to, from, bytes);
      from += bytes;
      continue;
    }
    for (std::uint32_t i = 0; i < run.count; ++i, from += element_bytes) {
      std::memcpy(to + std::ptrdiff_t{run.stride} * i, from, element_bytes);
    }
  }
}

}  // namespace finback::memory
