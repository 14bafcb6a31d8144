// A block: straight-line code decoded for execution, with its time decided in advance.
//
// Entered in a given pipeline state a block always costs the same but for memory and its exit, so a
// run adds one to `executions` and every count by cause, line or energy class is executions x
// constants, summed when somebody asks. The block is data of its own (operations, constants,
// exits), ready for a translator to native code.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <isa_sim/core/profile.hpp>
#include <isa_sim/isa/operation.hpp>

namespace finback::core {

// How control leaves a block, for the profile's call stack.
enum class BlockEnd : std::uint8_t { falls_through, jump, branch, call, ret, ret_event };

// `cycles` of `cause` spent on `packet` each time the block runs; an interlock's, waiting for
// `reg`.
struct StaticCost {
  std::uint32_t packet = 0;
  Cause cause = Cause::issue;
  std::uint32_t cycles = 0;
  int reg = kNoRegister;
};

struct Block {
  Address address = 0;
  Address end = 0;  // where control falls through to
  std::uint32_t function = 0;
  std::uint32_t first_packet = 0;
  std::uint32_t packet_count = 0;
  std::uint32_t entry_state = 0;  // of the pipeline
  BlockEnd ends = BlockEnd::falls_through;
  bool may_end_loop = false;  // its last packet is the bottom of a hardware loop
  Address last_packet_address = 0;

  Cycles cycles = 0;      // issue, interlocks and fetch of all packets
  Cycles fall_extra = 0;  // the exit's cost when control falls through, and when it does not
  Cycles taken_extra = 0;
  Cause fall_cause = Cause::branch_mispredict;
  Cause taken_cause = Cause::branch_taken;
  std::uint32_t exit_state = 0;  // pipeline state of the packet that follows without a refill

  std::unique_ptr<isa::Operation[]> operations;  // the last one leaves the block

  // The successors met so far, by address. A taken change of flow finds an empty pipeline.
  struct Exit {
    Address address = 0;
    Block* block = nullptr;
  };
  std::array<Exit, 2> exits{};

  std::uint64_t executions = 0;
  std::uint64_t taken = 0;

  std::vector<StaticCost> costs;
  std::uint32_t instructions = 0;
  std::array<std::uint32_t, 6> by_energy_class{};
};

}  // namespace finback::core
