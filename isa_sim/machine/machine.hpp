// The whole machine: two cores, memories, DMA, interrupts and the host port, run in time order.
//
// Models: actors (core A, core B, devices) ordered by (time, number). A core runs ahead on its
// own L1 memory; at the first access that others can see it waits until everybody has reached that
// time, so that results do not depend on the host. Time is in core cycles, whatever their length:
// when the program changes the clocks, what counts in other units is planned anew. Does not model:
// the exact time of a change for the other core, which may have run ahead a few cycles in the
// clock before (docs/architecture.md).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <common/counters.hpp>
#include <common/units.hpp>
#include <isa_sim/core/profile.hpp>
#include <isa_sim/core/trace.hpp>
#include <isa_sim/ir/image.hpp>

namespace finback::isa {
struct ExecutionState;
}

namespace finback::memory {
class MemorySystem;
}

namespace finback::machine {

class ClockLog;
class HostPort;
struct RaceReport;
class Peripherals;
struct ProgramHostOptions;
struct MachineDescription;

enum class Stop : std::uint8_t {
  exited,       // the program ended itself: the host port's EXIT register, HLT, a failed assertion
  cycle_limit,  // RunLimits::cycles were reached
  cancelled,    // RunLimits::cancelled answered true
  deadlock,     // both cores sleep and nothing is going to wake them
};

struct RunLimits {
  Cycles cycles = kNever;
  Cycles reference_cycles = kNever;  // real time, in cycles of the clock at the start
  // Asked about every millisecond of simulated time; true stops the run (Ctrl-C, a progress bar's
  // owner).
  std::function<bool(Cycles now)> cancelled;
};

struct StopInfo {
  Stop reason = Stop::exited;
  std::uint32_t exit_status = 0;
  Cycles time = 0;
  std::string message = {};  // why a program that ended itself did, where something went wrong; of
                             // a deadlock, what makes it one, where that is not IDLE alone
};

// How core A begins.
enum class Begin : std::uint8_t {
  program,  // as a boot loader starts a program: supervisor at IVG15, which any interrupt
            // interrupts
  reset,    // as the chip comes out of reset: interrupts held back, exceptions are double faults
};

class Machine {
 public:
  // Both must outlive the machine. The image's initial data is loaded.
  Machine(const MachineDescription& description, const ir::Image& image,
          Begin begin = Begin::program);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  [[nodiscard]] HostPort& host();
  [[nodiscard]] Peripherals& peripherals();
  // Serves the programs' EXCPT 0 and gets what they print by debug instructions (which is lines of
  // the host port's console otherwise).
  void serve_programs(ProgramHostOptions options);
  [[nodiscard]] memory::MemorySystem& memory();

  // `sink` gets all that `core` issues, in order, as long as this machine runs. Before the run;
  // costs a run without it nothing.
  void trace(CoreId core, core::TraceSink sink);

  // Watches all accesses for races, from now on: before the run, which gets slower by it. Flags are
  // the image's.
  void check_races();
  // Those met so far, in their order.
  [[nodiscard]] std::vector<RaceReport> races() const;

  // Runs until something of `Stop` happens; may be called again after cycle_limit. Throws
  // GuestFault, with core, function, source line and address, when the program does what the
  // machine cannot.
  StopInfo run(const RunLimits& limits = {});

  [[nodiscard]] const CounterRegistry& counters() const;
  [[nodiscard]] core::CoreProfile profile(CoreId core) const;
  // Which clocks ran when, and what was done in each operating point, up to the stop.
  [[nodiscard]] const ClockLog& clocks() const;
  // A time from the last change of the clocks on, in cycles of the clock at the start: real time.
  [[nodiscard]] Cycles reference_time(Cycles time) const;
  // What the data caches hid from somebody, a line for each combination of object and places, in
  // the order in which it happened first (memory_model/stale_watch.hpp).
  [[nodiscard]] std::vector<std::string> stale_reports() const;
  // A core's registers and flags, for whoever looks at them when it stands still.
  [[nodiscard]] const isa::ExecutionState& state(CoreId core) const;
  // Bytes of a core's stack, from its top down to the deepest that was ever changed; 0 when the
  // core has none. Stacks begin filled with a pattern: a push of just that pattern goes unseen.
  [[nodiscard]] std::uint32_t stack_used(CoreId core) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace finback::machine
