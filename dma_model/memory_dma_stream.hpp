// One memory-to-memory DMA stream: a source and a destination channel and the transfer between
// them, in time.
//
// Models: bursts read into a FIFO of two and written out of it, so that reading and writing overlap
// when the memories differ and share the time when they do not; the interrupt when the last word
// (of a row) has been written. Does not model: traffic control (round robin periods), priorities
// among streams beyond the order in which they ask. Source: hardware.md 3.2.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <common/units.hpp>
#include <dma_model/dma_channel.hpp>
#include <dma_model/dma_parameters.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::dma {

class MemoryDmaStream {
 public:
  // `controller` "MDMA1", `number` 0 or 1: channels MDMA1_D0 and MDMA1_S0.
  MemoryDmaStream(const std::string& controller, int number, memory::Initiator initiator,
                  const DmaParameters& parameters, Cycles ratio, memory::MemorySystem& memory);

  [[nodiscard]] const DmaChannel& destination() const { return destination_; }
  [[nodiscard]] const DmaChannel& source() const { return source_; }

  // Writes a register of the destination or the source channel. CONFIG starts the transfer when
  // both are enabled, and ends it at once when one is disabled. Throws GuestFault for what cannot
  // be started.
  void write(bool to_destination, std::uint32_t offset, int bytes, std::uint32_t value, Cycles now);

  // A core reads a register of either channel.
  void note_read() const;

  // Time of the next thing that this stream does by itself, or kNever.
  [[nodiscard]] Cycles next_event_time() const { return next_event_; }
  // Does everything that is due up to and including `now`. Throws GuestFault when the transfer
  // leaves memory that DMA can reach.
  void advance(Cycles now);

  [[nodiscard]] bool interrupt_pending() const {
    return source_.interrupt_pending() || destination_.interrupt_pending();
  }

 private:
  struct Burst {
    std::vector<std::uint8_t> bytes;
    std::uint32_t elements = 0;
  };

  void config_written(DmaChannel& channel, Cycles now);
  void start(Cycles at);
  void abandon();
  void ask_read(Cycles now);
  void ask_write(Cycles now);
  void read_done(Cycles now);
  void write_done(Cycles now);
  void finish(Cycles now);
  void plan_next_event();
  static void note_rows(DmaChannel& channel, std::uint32_t& rows);
  void check_pair() const;
  void check(const DmaChannel& channel, const std::vector<memory::DmaRun>& runs) const;

  DmaChannel destination_;
  DmaChannel source_;
  memory::Initiator initiator_;
  std::uint32_t burst_elements_;
  Cycles startup_;
  memory::MemorySystem& memory_;

  Cycles next_event_ = kNever;
  Cycles read_at_ = kNever;        // start-up over: ask for the first read
  Cycles read_done_at_ = kNever;   // burst under way into the FIFO
  Cycles write_done_at_ = kNever;  // burst under way out of it
  std::vector<memory::DmaRun> read_runs_;
  std::vector<memory::DmaRun> write_runs_;
  std::array<Burst, 2> fifo_;
  std::size_t fifo_first_ = 0;
  std::size_t fifo_count_ = 0;  // bursts read whole and not yet written
  std::uint32_t source_rows_ = 0;
  std::uint32_t destination_rows_ = 0;
};

}  // namespace finback::dma
