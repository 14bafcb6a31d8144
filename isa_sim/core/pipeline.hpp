// The static timing of a ten-stage, in-order, interlocked pipeline: what a packet costs, given what
// went before it.
//
// Models: one packet a cycle, instructions that hold the pipeline, the interlocks of
// hardware.md 1.5 (load or move to a pointer, ALU result needed in EX1), and the alignment buffer:
// full in straight code and in loops, empty after a change of flow. Memory, branches and fetch from
// L2 and L3 are costed elsewhere. Does not model: stalls on RETS and on loop registers
// read back.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <isa_sim/core/core_parameters.hpp>
#include <isa_sim/core/profile.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/isa/instruction.hpp>

namespace finback::core {

// Results on their way: for each register, how many more cycles until it can be used in stage AC,
// and in EX1; and whether the alignment buffer was emptied by a change of flow.
class PipelineState {
 public:
  struct Wait {
    std::uint8_t address_stage = 0;
    std::uint8_t ex1 = 0;
    bool operator==(const Wait&) const = default;
  };

  [[nodiscard]] const Wait& wait(int reg) const { return waits_[static_cast<std::size_t>(reg)]; }
  void set(int reg, Wait wait) { waits_[static_cast<std::size_t>(reg)] = wait; }
  void advance(Cycles cycles);
  [[nodiscard]] bool refilled() const { return refilled_; }
  void set_refilled(bool refilled) { refilled_ = refilled; }
  bool operator==(const PipelineState&) const = default;
  // Some order, for a map.
  [[nodiscard]] bool operator<(const PipelineState& other) const {
    return refilled_ != other.refilled_
               ? other.refilled_
               : std::ranges::lexicographical_compare(waits_, other.waits_, {}, key, key);
  }

 private:
  static int key(const Wait& wait) { return wait.address_stage << 8 | wait.ex1; }
  std::array<Wait, isa::L3 + 1> waits_{};
  bool refilled_ = false;
};

// What a packet costs before its memory accesses: its issue and the stall before it.
struct PacketCost {
  Cycles issue = 1;
  Cycles stall = 0;
  Cause stall_cause = Cause::hazard_address;
  int stall_register = kNoRegister;  // that is waited for
};

class Pipeline {
 public:
  explicit Pipeline(const CoreParameters& parameters) : parameters_(parameters) {}

  // The cost of `packet` when it enters with `state`; `state` becomes what the next packet meets.
  PacketCost issue(const ir::PlacedPacket& packet, PipelineState& state) const;

  [[nodiscard]] Cycles issue_cycles(const ir::PlacedInstruction& instruction) const;

  // The stall before a packet in L1 that control was led to.
  [[nodiscard]] Cycles target_stall(const ir::PlacedPacket& packet) const {
    const auto line = static_cast<Address>(std::int64_t{parameters_.fetch_bytes});
    return packet.address % line + packet.length > line
               ? static_cast<Cycles>(std::int64_t{parameters_.split_target})
               : 0;
  }

 private:
  void note_results(const ir::PlacedInstruction& instruction, PipelineState& state) const;

  const CoreParameters& parameters_;
};

// Gives equal pipeline states one small number, so that a block is known by (address, number).
class PipelineStates {
 public:
  // Nothing is on its way; and so after a change of flow.
  static constexpr std::uint32_t kEmpty = 0;
  static constexpr std::uint32_t kRefilled = 1;
  PipelineStates();
  [[nodiscard]] std::uint32_t number_of(const PipelineState& state);
  [[nodiscard]] const PipelineState& state(std::uint32_t number) const { return *states_[number]; }

 private:
  std::map<PipelineState, std::uint32_t> numbers_;
  std::vector<const PipelineState*> states_;
};

}  // namespace finback::core
