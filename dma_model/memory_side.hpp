// A channel's side towards memory: its bursts and its descriptor fetches, in time.
//
// Models: one burst at a time, between a FIFO and memory; the bytes move when the burst is
// complete; a burst ends with its row where rows interrupt; start-up; reading ahead into the next
// work unit, unless RESTART says that the FIFO must be empty first. Does not model: FIFO depth in
// elements (the FIFO of a stream holds two bursts of whatever width). Who has the bus is the
// controller's. Source: hardware.md 3.1, 3.2.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <common/units.hpp>
#include <dma_model/byte_fifo.hpp>
#include <dma_model/dma_channel.hpp>
#include <dma_model/dma_parameters.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::dma {

struct SideCounters {
  std::uint64_t units = 0;        // work units completed
  std::uint64_t descriptors = 0;  // fetched
};

class MemorySide {
 public:
  // `internal`: of IMDMA, at the core clock.
  MemorySide(DmaChannel channel, memory::Initiator initiator, bool internal, ByteFifo& fifo,
             const DmaParameters& parameters, clock::ClockRatio ratio,
             memory::MemorySystem& memory);

  // The other channel of a stream, which is at the FIFO's other end.
  void set_peer(MemorySide* peer) { peer_ = peer; }
  [[nodiscard]] DmaChannel& channel() { return channel_; }
  [[nodiscard]] const DmaChannel& channel() const { return channel_; }
  [[nodiscard]] memory::Initiator initiator() const { return initiator_; }
  [[nodiscard]] const SideCounters& counters() const { return counters_; }

  // CONFIG was written with DMAEN = 1. Throws DmaError.
  void start(Cycles now);
  // The channel was disabled, or has met an error: nothing is under way any more.
  void abandon();

  // Time of the next thing that it does by itself, or kNever.
  [[nodiscard]] Cycles next_event_time() const { return std::min(ready_at_, done_at_); }
  // Does it. Throws DmaError.
  void act(Cycles now);

  // What is under way goes on in the new clocks.
  void change_clock(const clock::ClockChange& change);

  // --- the bus ---
  struct Want {
    memory::DmaPort port = memory::DmaPort::none;
    memory::Direction direction = memory::Direction::read;
  };
  // What it would do now if it had the bus; nothing while it has it.
  [[nodiscard]] std::optional<Want> want(Cycles now);
  // It has the bus, for `most` elements: how many it takes (a descriptor's words count as such).
  // Throws DmaError for memory that it cannot reach.
  std::uint32_t grant(Cycles now, std::uint32_t most);
  // When what was granted is over.
  [[nodiscard]] Cycles done_at() const { return done_at_; }

 private:
  [[nodiscard]] std::uint32_t fifo_limit() const;
  [[nodiscard]] std::uint32_t possible_elements() const;
  void fetch_descriptor(Cycles now);
  void check(const memory::DmaRun& run, std::uint32_t element_bytes,
             std::uint32_t register_offset) const;
  void check_descriptor_space(Address address);
  void check_pair() const;
  [[nodiscard]] Cycles burst(memory::Direction direction, std::uint32_t element_bytes, bool further,
                             Cycles now);
  void begin_unit();
  void end_descriptor(Cycles now);
  void end_burst(Cycles now);

  DmaChannel channel_;
  memory::Initiator initiator_;
  bool internal_;
  ByteFifo& fifo_;
  MemorySide* peer_ = nullptr;
  memory::MemorySystem& memory_;
  std::uint32_t burst_elements_;
  clock::ClockRatio ratio_;     // of IMDMA, which counts core cycles: 1
  Cycles startup_;              // in SCLK
  Cycles descriptor_overhead_;  // in SCLK
  bool counts_must_match_;

  Cycles ready_at_ = kNever;  // start-up under way
  Cycles done_at_ = kNever;   // burst or fetch under way
  Cycles asked_at_ = kNever;
  bool fetching_ = false;    // what is under way is a descriptor
  bool chained_ = false;     // work units come by descriptors
  bool unit_begun_ = false;  // a burst of this work unit was granted
  std::uint32_t elements_ = 0;
  std::uint32_t rows_ = 0;
  std::optional<bool> descriptor_external_;  // where the last one lay
  std::vector<memory::DmaRun> runs_;
  std::vector<std::uint8_t> buffer_;
  SideCounters counters_;
};

}  // namespace finback::dma
