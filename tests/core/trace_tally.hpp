// Holds what a trace told against what the core counted.
#pragma once

#include <gtest/gtest.h>
#include <map>

#include <isa_sim/core/profile.hpp>
#include <isa_sim/core/trace.hpp>

namespace finback::core {

class TraceTally {
 public:
  [[nodiscard]] TraceSink sink() {
    return [this](const TraceRecord& record) { add(record); };
  }

  // The records cover the core's time without gap or overlap, and say of each packet what the
  // profile says.
  void check(const CoreProfile& profile) const {
    EXPECT_EQ(gaps_, 0U) << "the first at cycle " << first_gap_;
    EXPECT_EQ(end_ - begin_, profile.cycles);
    std::map<std::size_t, Packet> expected;
    for (const PacketProfile& packet : profile.packet_profiles) {
      expected[packet.packet] = {packet.executions, packet.cycles};
    }
    EXPECT_EQ(packets_.size(), expected.size());
    for (const auto& [index, packet] : packets_) {
      EXPECT_EQ(packet.executions, expected[index].executions) << "packet " << index;
      EXPECT_EQ(packet.cycles, expected[index].cycles) << "packet " << index;
    }
  }

 private:
  struct Packet {
    std::uint64_t executions = 0;
    CauseCycles cycles{};
  };

  void add(const TraceRecord& record) {
    if (begun_ && record.begin != end_ && gaps_++ == 0) {
      first_gap_ = record.begin;
    }
    begin_ = begun_ ? begin_ : record.begin;
    begun_ = true;
    end_ = record.end();
    Cycles sum = 0;
    for (const TraceCost& cost : record.costs) {
      sum += cost.cycles;
    }
    EXPECT_EQ(sum, record.cycles);
    if (record.kind == TraceRecord::Kind::undone && record.cycles == 0) {
      return;  // it left nothing behind
    }
    Packet& packet = packets_[record.packet];
    packet.executions += record.kind == TraceRecord::Kind::packet ? 1 : 0;
    for (const TraceCost& cost : record.costs) {
      packet.cycles[static_cast<std::size_t>(cost.cause)] += cost.cycles;
    }
  }

  bool begun_ = false;
  Cycles begin_ = 0;
  Cycles end_ = 0;
  std::uint64_t gaps_ = 0;
  Cycles first_gap_ = 0;
  std::map<std::size_t, Packet> packets_;
};

}  // namespace finback::core
