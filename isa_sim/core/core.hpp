// One core: decodes code into blocks, runs them, and keeps its time.
//
// Models: the instruction table's meanings; issue, interlocks, branches and hardware loops
// (pipeline.hpp); stalls on L2, L3, device registers and instruction fetch; interrupts, taken
// between blocks; IDLE. Does not model: caches, the store buffer within L1, speculation. Source:
// hardware.md 1, 4; the way to speed: docs/architecture.md.
//
// The core runs ahead on what is its own. What others can see or change (L2, L3, devices) it
// touches only before the time `shared_until` of its turn, to which the machine knows that nobody
// else will act.
#pragma once

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

#include <common/counters.hpp>
#include <common/error.hpp>
#include <isa_sim/core/block_builder.hpp>
#include <isa_sim/core/call_profile.hpp>
#include <isa_sim/core/event_controller.hpp>
#include <isa_sim/core/profile.hpp>
#include <isa_sim/core/system_port.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::core {

class Core {
 public:
  // How far a core may go before it gives the others their turn.
  struct Turn {
    Cycles horizon = kNever;       // returns at the first block's end at or after it
    Cycles shared_until = kNever;  // may act on shared things before this time
  };

  // All must outlive the core. `core_register_stall`: of an access to the event controller's
  // registers.
  Core(CoreId id, const ir::CoreImage& image, const CoreParameters& parameters,
       Cycles core_register_stall, memory::MemorySystem& memory, SystemPort& port);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  void start(Cycles at);
  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] bool sleeping() const { return sleeping_; }
  // Where the core is: an access that waits for its turn is at this time.
  [[nodiscard]] Cycles time() const {
    return state_.retry != nullptr ? state_.time + state_.retry->cycle : state_.time;
  }

  // Runs at least one step, to the turn's end or to sleep. Throws GuestFault.
  void run(const Turn& turn);
  // Shortens the running turn: something that the core did makes others act sooner.
  void shorten_turn(Cycles until);
  // Requests of the system interrupt controller, as of `at`; ends IDLE where they should.
  void set_requests(std::uint32_t ivg_lines, bool wake, Cycles at);
  // A core that sleeps is charged its sleep until `at`; for reading the profile.
  void settle(Cycles at);

  [[nodiscard]] CoreProfile profile() const;
  void register_counters(CounterRegistry& registry) const;
  [[nodiscard]] isa::ExecutionState& state() { return state_; }

 private:
  struct Hooks;

  [[nodiscard]] Block* block_at(Address address, std::uint32_t state);
  [[nodiscard]] Block* successor(Block& block, Address next, bool refill);
  [[nodiscard]] bool loop_back(const Block& block);
  void finish_block(Block& block);
  void note_call_or_return(const Block& block, Address next);
  void take_interrupt();
  void wake(Cycles at);
  void add_stall(const isa::Operation& operation, Cause cause, Cycles cycles);
  void add_far_bytes(const isa::Operation& operation, std::size_t where, int bytes) {
    far_bytes_[operation.site][where] += static_cast<Bytes>(bytes);
  }
  [[nodiscard]] LevelBytes bytes_of(std::uint32_t packet, std::uint64_t executions) const;
  [[nodiscard]] bool wait_for_turn(const isa::Operation& operation);
  [[nodiscard]] Cycles now(const isa::Operation& operation) const {
    return state_.time + operation.cycle;
  }
  [[noreturn]] void fault(const isa::Operation& operation, const std::string& what) const;
  [[nodiscard]] std::string place(std::uint32_t packet) const;
  [[nodiscard]] bool in_own_l1(Address address);
  // Runs `body`; a GuestFault of the memory or a device gets this core and the operation's place in
  // front.
  template <class Body>
  void guarded(const isa::Operation& operation, const Body& body) const {
    try {
      body();
    } catch (const GuestFault& problem) {
      fault(operation, problem.what());
    }
  }
  void act(const isa::Operation& operation, isa::SystemAction action, std::uint32_t value);

  CoreId id_;
  int number_;
  const ir::CoreImage& image_;
  const CoreParameters& parameters_;
  Cycles core_register_stall_;
  memory::MemorySystem& memory_;
  SystemPort& port_;
  isa::EngineHooks hooks_;
  isa::ExecutionState state_;
  EventController events_;
  CallProfile calls_;
  BlockBuilder builder_;

  std::unordered_map<std::uint64_t, Block*> block_index_;  // by address and pipeline state
  std::vector<std::unique_ptr<Block>> blocks_;             // in the order of their making
  std::vector<CauseCycles> dynamic_;  // by packet: stalls that were met, not planned
  // By packet: bytes moved outside the core's L1, to and from L2, L3 and (last) device registers.
  static constexpr std::size_t kDeviceBytes = memory::kLevelCount;
  std::vector<std::array<Bytes, memory::kLevelCount + 1>> far_bytes_;

  Block* current_ = nullptr;
  bool started_ = false;
  bool sleeping_ = false;
  bool wake_line_ = false;
  std::uint32_t idle_packet_ = 0;
  Cycles started_at_ = 0;
  Turn turn_;
};

}  // namespace finback::core
