// One core: decodes code into blocks, runs them, and keeps its time.
//
// Models: the instruction table's meanings; issue, interlocks, branches and hardware loops
// (pipeline.hpp); stalls on L2, L3, device registers, the store buffer and fetch; interrupts,
// taken between blocks, and exceptions, taken between packets; user mode and page protection; IDLE;
// single steps; the caches (core_cache.cpp); DMA that takes an L1 sub-bank from the core. Does not
// model: speculation. Source: hardware.md 1, 2, 4; Programming Reference, chapters 3, 4 and 6; the
// way to speed: docs/architecture.md.
//
// The core runs ahead on what is its own. What others can see or change (L2, L3, devices) it
// touches only before the time `shared_until` of its turn, to which the machine knows that nobody
// else will act.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include <common/counters.hpp>
#include <common/error.hpp>
#include <isa_sim/core/block_builder.hpp>
#include <isa_sim/core/call_profile.hpp>
#include <isa_sim/core/core_timer.hpp>
#include <isa_sim/core/event_controller.hpp>
#include <isa_sim/core/exception_cause.hpp>
#include <isa_sim/core/profile.hpp>
#include <isa_sim/core/protection.hpp>
#include <isa_sim/core/store_buffer.hpp>
#include <isa_sim/core/system_port.hpp>
#include <isa_sim/core/trace.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::core {

class Core {
 public:
  // How far a core may go before it gives the others their turn.
  struct Turn {
    Cycles horizon = kNever;       // returns at the first block's end at or after it
    Cycles shared_until = kNever;  // may act on shared things before this time
  };

  // How a core starts.
  struct Start {
    std::uint32_t pending = EventController::kSupervisor;  // IPEND
    std::uint32_t system_config = kCyclesRun;              // SYSCFG
  };

  // All must outlive the core. `core_register_stall`: of an access to the event controller's
  // registers.
  Core(CoreId id, const ir::CoreImage& image, const CoreParameters& parameters,
       Cycles core_register_stall, memory::MemorySystem& memory, SystemPort& port);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  void start(Cycles at, const Start& how = {EventController::kSupervisor, kCyclesRun});
  [[nodiscard]] bool started() const { return started_; }
  // In IDLE, or its program has ended.
  [[nodiscard]] bool sleeping() const { return sleeping_ || halted_; }
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
  // A request from outside that stays until it is taken: a watchdog's NMI.
  void latch_request(int event, Cycles at);
  // An actor while it sleeps: its timer may wake it. kNever when nothing of its own will.
  [[nodiscard]] Cycles next_event_time() const;
  void advance(Cycles now);
  // A core that sleeps is charged its sleep until `at`; for reading the profile.
  void settle(Cycles at);
  // CCLK stands still while the core sleeps: so do CYCLES and the core timer, and nothing but
  // set_requests and latch_request wakes it then, after the clock has been started.
  void stop_clock(Cycles at);
  void start_clock(Cycles at);

  // From now on `sink` gets all that is issued, in order; call before the start. The last records
  // come with end_trace().
  void trace(TraceSink sink) { trace_ = std::make_unique<CoreTrace>(std::move(sink)); }
  void end_trace() {
    if (trace_) {
      trace_->flush();
    }
  }

  [[nodiscard]] CoreProfile profile() const;
  // What the power model wants to know, cheaper; of a core that sleeps as of its last settle().
  [[nodiscard]] CoreWork work() const;
  // "function (address, file:line)" of a packet.
  [[nodiscard]] std::string place(std::uint32_t packet) const;
  void register_counters(CounterRegistry& registry) const;
  [[nodiscard]] isa::ExecutionState& state() { return state_; }
  // The instruction that wrote a device register last: "core_a in main (0xffa00010, main.c:7)".
  [[nodiscard]] std::string device_writer() const;

 private:
  struct Hooks;

  [[nodiscard]] Block* block_at(Address address, std::uint32_t state);
  [[nodiscard]] Block* successor(Block& block, Address next, bool refill);
  [[nodiscard]] bool loop_back(const Block& block);
  template <bool traced>
  void finish_block(Block& block);
  void note_call_or_return(const Block& block, Address next);
  void wake(Cycles at);
  template <bool traced>
  void run_blocks();

  // Blocks that end early: core_traps.cpp.
  struct Trap;
  void handle(const Trap& trap);
  void handle_fetch(const Trap& trap);
  std::uint32_t cut_block(std::uint32_t end_packet, const isa::Operation* unfinished);
  [[nodiscard]] Block* part_of(const Block& block, std::uint32_t packets);
  void end_block_after(const isa::Operation& operation);
  static const isa::Operation* stop_here(isa::ExecutionState& state,
                                         const isa::Operation* operation);
  static const isa::Operation* save_packet(isa::ExecutionState& state,
                                           const isa::Operation* operation);
  void uproot();
  void undo_packet(std::uint32_t packet);
  void forget_blocks();
  void unchain_blocks();
  // Ends the operation with an exception; where no handler is installed, the program with `what`.
  [[noreturn]] void raise_exception(const isa::Operation& operation, int cause,
                                    const std::string& what) const;

  // Events: core_events.cpp.
  void take_due_events();
  void check_timer(Cycles at);
  void stop_at_timer();
  // Registers of the core itself, from 0xFFE00000. False: there is none, or not of that size.
  [[nodiscard]] bool read_register(const isa::Operation& operation, Address address, int bytes,
                                   std::uint32_t& value);
  [[nodiscard]] bool write_register(const isa::Operation& operation, Address address, int bytes,
                                    std::uint32_t value);
  void enter(int event, Address back);
  void enter_exception(int cause, Address back);
  void leave_event(const isa::Operation& operation, isa::SystemAction action);
  void check_access(const isa::Operation& operation, Address address, int bytes, bool write);
  void no_register(const isa::Operation& operation, Address address, int bytes, bool write);
  void check_every_access();
  [[nodiscard]] std::uint8_t* no_memory(const isa::Operation& operation, const std::string& what);
  void require_supervisor(const isa::Operation& operation, const char* what) const;
  // An interrupt may have become due: it is taken after this packet.
  void look_for_events(const isa::Operation& operation);
  void raise(const isa::Operation& operation, int event);
  void except(const isa::Operation& operation, int cause);
  void set_hardware_error(std::uint32_t cause);
  void configure(const isa::Operation& operation);
  void choose_block_style(const isa::Operation& operation);
  [[nodiscard]] Cycles cycle_count(const isa::Operation& operation) const {
    return cycles_run_ ? now(operation) - cycle_base_ : cycle_base_;
  }
  void set_cycle_count(const isa::Operation& operation, Cycles count);

  // Caches: core_cache.cpp.
  [[nodiscard]] memory::CachePolicy cache_policy(memory::Level level, Address address);
  [[nodiscard]] std::uint8_t* cached_access(const isa::Operation& operation, memory::Span* span,
                                            Address address, int bytes, bool write, bool continued,
                                            memory::CachePolicy policy);
  void move_line(const isa::Operation& operation, isa::SystemAction action, Address address);
  void charge(const isa::Operation& operation, const memory::CachedAccess& access, Cause cause,
              Address address);
  [[nodiscard]] memory::Accessor accessor(const isa::Operation& operation) const {
    return {static_cast<memory::Initiator>(number_), operation.site};
  }
  // Where in the core's own L1 an access to `address` goes; nothing when it goes elsewhere.
  [[nodiscard]] std::optional<Address> place_in_l1(Address address);

  // Fetches code outside L1; false: it has to wait for its turn.
  [[nodiscard]] bool fetch_code(const isa::Operation& operation);
  // As IMEM_CONTROL says. Throws GuestFault when code lies in the half that shall be cache.
  void configure_code_cache();

  // Debug instructions: core_debug.cpp.
  void debug(const isa::Operation& operation, isa::SystemAction action, std::uint32_t value);
  [[noreturn]] void halt(const isa::Operation& operation, std::uint32_t status,
                         const std::string& why);
  [[nodiscard]] std::string register_text(const isa::Operation& operation, std::int32_t reg);

  // `address`: of the access that stalls.
  void add_stall(const isa::Operation& operation, Cause cause, Cycles cycles, Address address = 0);
  // Cycles between blocks.
  void pass(TraceRecord::Kind kind, std::uint32_t packet, Cause cause, Cycles cycles);
  void add_far_bytes(const isa::Operation& operation, std::size_t where, int bytes) {
    far_bytes_[operation.site][where] += static_cast<Bytes>(bytes);
  }
  [[nodiscard]] LevelBytes bytes_of(std::uint32_t packet, std::uint64_t executions) const;
  [[nodiscard]] bool wait_for_turn(const isa::Operation& operation);
  // Whether a read of L3 gives way to DMA: it then waits, by `cause`, and is to be repeated.
  // `span`: of uncached data.
  [[nodiscard]] bool give_way(const isa::Operation& operation, memory::Span* span, Address address,
                              Cause cause);
  [[nodiscard]] Cycles now(const isa::Operation& operation) const {
    return state_.time + operation.cycle;
  }
  [[noreturn]] void fault(const isa::Operation& operation, const std::string& what) const;
  // Somebody wants to know of every access.
  [[nodiscard]] bool watched() const { return memory_.observer() != nullptr; }
  void tell_access(const isa::Operation& operation, Address address, int bytes, bool write);
  void tell_device_access(const isa::Operation& operation, Address address, bool write);
  // Runs `body`; a GuestFault of the memory or a device gets this core and the operation's place in
  // front.
  template <class Body>
  void guarded(const isa::Operation& operation, const Body& body) {
    try {
      body();
    } catch (const GuestFault& problem) {
      raise_exception(operation, kSupervisorResource, problem.what());
    }
  }
  void fall_asleep(const isa::Operation& operation);
  void drain_writes(const isa::Operation& operation);
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
  CoreTimer timer_;
  Protection protection_;
  StoreBuffer store_buffer_;
  CallProfile calls_;
  BlockBuilder builder_;

  std::unordered_map<std::uint64_t, Block*> block_index_;  // by address and pipeline state
  std::vector<std::unique_ptr<Block>> blocks_;             // in the order of their making
  std::vector<CauseCycles> dynamic_;  // by packet: stalls that were met, not planned
  // By packet: bytes moved outside the core's L1, to and from L2, L3 and (last) device registers.
  static constexpr std::size_t kDeviceBytes = memory::kLevelCount;
  std::vector<std::array<Bytes, memory::kLevelCount + 1>> far_bytes_;
  // By packet: bytes of lines that it moved between the data cache and L2, L3.
  std::map<std::uint32_t, LevelBytes> line_bytes_;

  Block* current_ = nullptr;
  bool started_ = false;
  bool sleeping_ = false;
  Cycles clock_stopped_at_ = kNever;
  bool wake_line_ = false;
  bool halted_ = false;
  int exception_due_ = -1;     // by EXCPT: its code
  bool step_due_ = false;      // the block that runs is a single step
  bool single_step_ = false;   // SYSCFG.SSSTEP
  Address kernel_sp_ = 0;      // the supervisor's SP while in user mode
  bool cycles_run_ = true;     // SYSCFG.CCEN
  Cycles cycle_base_ = 0;      // time when CYCLES was 0; while it stands still, its value
  isa::ExecutionState saved_;  // before packet saved_packet_, which may have to be undone
  std::uint32_t saved_packet_ = BlockBuilder::kNoPacket;
  std::map<std::pair<const Block*, std::uint32_t>, Block*> parts_;  // beginnings of blocks
  isa::Operation* planted_ = nullptr;  // where the block shall end, and what stood there
  isa::Execute uprooted_ = nullptr;
  std::map<std::uint32_t, Bytes> killed_bytes_;  // by packet: moved, but not completed
  std::uint32_t nowhere_ = 0;                    // what an access to no memory moves
  std::uint32_t idle_packet_ = 0;
  std::uint32_t device_write_packet_ = 0;
  Cycles started_at_ = 0;
  Turn turn_;
  std::unique_ptr<CoreTrace> trace_;  // nullptr: nobody looks
};

}  // namespace finback::core
