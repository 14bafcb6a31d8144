// The plain evaluator: one packet after the other, every stall decided when it is met. The truth
// that the fast engine is held against; slow, and so simple that it can be believed.
//
// Models: the same instruction table and pipeline parameters on one core and its own L1. All slots
// of a packet read the state before any of them writes. Stops at IDLE. Does not model: L2, L3,
// devices, interrupts (it throws GuestFault).
#pragma once

#include <array>

#include <isa_sim/core/core_parameters.hpp>
#include <isa_sim/core/store_buffer.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/isa/instruction.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::core {

class Evaluator {
 public:
  Evaluator(int core, const ir::CoreImage& image, const CoreParameters& parameters,
            memory::MemorySystem& memory);

  // Runs from the image's entry to IDLE, or until `max_packets` have been issued. True when IDLE
  // was reached.
  bool run(std::uint64_t max_packets);

  [[nodiscard]] Cycles cycles() const { return next_issue_; }
  [[nodiscard]] std::uint64_t packets() const { return packets_; }
  [[nodiscard]] const isa::ExecutionState& state() const { return state_; }

 private:
  struct Hooks;

  void execute(const ir::PlacedPacket& packet);
  void end_pass(const ir::PlacedPacket& packet, isa::Flow flow, bool taken);
  void merge(const isa::ExecutionState& before, const isa::ExecutionState& after);
  void stall_for_operands(const ir::PlacedInstruction& instruction, Cycles& issue_at) const;
  void note_results(const ir::PlacedInstruction& instruction, Cycles done);
  [[nodiscard]] Cycles sub_bank_stall(const ir::PlacedPacket& packet) const;
  [[nodiscard]] const ir::PlacedPacket& packet_at(Address address) const;

  int core_;
  const ir::CoreImage& image_;
  const CoreParameters& parameters_;
  memory::MemorySystem& memory_;
  StoreBuffer store_buffer_;
  isa::EngineHooks hooks_;
  isa::ExecutionState state_;
  std::array<Cycles, isa::kRegisterCount>
      address_ready_{};  // when a register can be used in stage AC, in EX1
  std::array<Cycles, isa::kRegisterCount> ex1_ready_{};
  Cycles next_issue_ = 0;
  Cycles stall_ = 0;  // of the packet that executes, by its accesses
  std::uint64_t packets_ = 0;
  bool refilled_ = false;  // the packet before was left by a change of flow
  bool idle_ = false;
};

}  // namespace finback::core
