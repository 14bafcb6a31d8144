#include <utility>

#include <isa_sim/core/trace.hpp>

namespace finback::core {

void CoreTrace::begin(Cycles at) {
  flush();
  stalls_.clear();
  block_begin_ = at;
  time_ = at;
}

void CoreTrace::retract() {
  pending_.clear();
  time_ = block_begin_;
}

void CoreTrace::block(const Block& block, bool taken) {
  packets(block);
  if (const Cycles extra = taken ? block.taken_extra : block.fall_extra; extra > 0) {
    append(pending_.back(),
           {.cause = taken ? block.taken_cause : block.fall_cause, .cycles = extra});
    time_ += extra;
  }
}

void CoreTrace::packets(const Block& block) {
  auto cost = block.costs.begin();
  auto stall = stalls_.begin();
  for (std::uint32_t i = 0; i < block.packet_count; ++i) {
    TraceRecord record;
    record.packet = block.first_packet + i;
    for (; cost != block.costs.end() && cost->packet == record.packet; ++cost) {
      append(record, {.cause = cost->cause, .cycles = cost->cycles, .reg = cost->reg});
    }
    for (; stall != stalls_.end() && stall->packet == record.packet; ++stall) {
      append(record, stall->cost);
    }
    add(std::move(record));
  }
}

void CoreTrace::undone(std::uint32_t packet) {
  TraceRecord record;
  record.kind = TraceRecord::Kind::undone;
  record.packet = packet;
  for (const Stall& stall : stalls_) {
    if (stall.packet == packet) {
      append(record, stall.cost);
    }
  }
  add(std::move(record));
}

void CoreTrace::event(TraceRecord::Kind kind, std::uint32_t packet, Cause cause, Cycles at,
                      Cycles cycles) {
  // A sleep is told in pieces by those who look at the time meanwhile.
  if (kind == TraceRecord::Kind::sleep && !pending_.empty() && pending_.back().kind == kind &&
      pending_.back().end() == at) {
    pending_.back().costs.back().cycles += cycles;
    pending_.back().cycles += cycles;
    return;
  }
  begin(at);
  TraceRecord record;
  record.kind = kind;
  record.packet = packet;
  append(record, {.cause = cause, .cycles = cycles});
  add(std::move(record));
}

void CoreTrace::add(TraceRecord record) {
  record.begin = time_;
  time_ = record.end();
  pending_.push_back(std::move(record));
}

void CoreTrace::append(TraceRecord& record, const TraceCost& cost) {
  record.costs.push_back(cost);
  record.cycles += cost.cycles;
}

void CoreTrace::flush() {
  for (const TraceRecord& record : pending_) {
    sink_(record);
  }
  pending_.clear();
}

}  // namespace finback::core
