// What one core issued, packet by packet, for those who want to look at it.
//
// Models nothing of its own: the records of a core, one after the other, cover its time without gap
// or overlap, and their cycles by packet and cause are those of its profile (profile.hpp), because
// both are made from the same blocks and the same stalls. A core that nobody traces pays nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <common/units.hpp>
#include <isa_sim/core/block.hpp>
#include <isa_sim/core/profile.hpp>
#include <isa_sim/ir/image.hpp>

namespace finback::core {

// `cycles` of `cause`, in the order in which they were spent.
struct TraceCost {
  Cause cause = Cause::issue;
  Cycles cycles = 0;
  int reg = kNoRegister;  // hazards: the register that was waited for
  Address address = 0;    // memory and device registers: what was accessed
};

struct TraceRecord {
  enum class Kind : std::uint8_t {
    packet,  // issued and completed
    undone,  // an exception took it back: its stalls remain
    entry,   // the way into a handler, whose first packet it is
    sleep,   // IDLE, until the wake-up
  };
  Kind kind = Kind::packet;
  std::uint32_t packet = 0;  // index into ir::CoreImage::packets
  Cycles begin = 0;
  Cycles cycles = 0;  // sum of the costs
  std::vector<TraceCost> costs;

  [[nodiscard]] Cycles end() const { return begin + cycles; }
};

using TraceSink = std::function<void(const TraceRecord& record)>;

// Turns what a core tells of its blocks into records. Each is handed on when the next begins.
class CoreTrace {
 public:
  explicit CoreTrace(TraceSink sink) : sink_(std::move(sink)) {}

  // A block begins at `at`.
  void begin(Cycles at);
  // A stall that `packet` of the running block met.
  void stall(std::uint32_t packet, const TraceCost& cost) { stalls_.push_back({packet, cost}); }
  // The running block is done.
  void block(const Block& block, bool taken);
  // Of the running block only its beginning was done, which is `part`.
  void part(const Block& part) { packets(part); }
  // `packet` of the running block, behind the last that was done, was taken back.
  void undone(std::uint32_t packet);
  // The last block does not count after all.
  void retract();
  // Between blocks.
  void event(TraceRecord::Kind kind, std::uint32_t packet, Cause cause, Cycles at, Cycles cycles);
  // Hands on what is still held back.
  void flush();

 private:
  struct Stall {
    std::uint32_t packet = 0;
    TraceCost cost;
  };
  void packets(const Block& block);
  void add(TraceRecord record);
  static void append(TraceRecord& record, const TraceCost& cost);

  TraceSink sink_;
  Cycles block_begin_ = 0;
  Cycles time_ = 0;  // where the next record begins
  std::vector<Stall> stalls_;
  std::vector<TraceRecord> pending_;
};

}  // namespace finback::core
