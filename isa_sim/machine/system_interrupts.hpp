// The system interrupt controllers: SICA for core A, SICB for core B.
//
// Models: 64 sources with masks, assignment to IVG7-15, wake-up masks; the two supplemental
// interrupts of each core raised and acknowledged through SICB_SYSCR; release of core B through
// SICA_SYSCR. A line that rises is seen by the core after a latency, one that falls at once. Does
// not model: SWRST, RVECT, boot mode, the PLL's interrupt (its wake-up alone). Source:
// hardware.md 3.1 (default IVGs), 4.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <clock_model/clock_ratio.hpp>
#include <common/device.hpp>
#include <common/units.hpp>
#include <isa_sim/machine/device_parameters.hpp>
#include <memory_model/access_observer.hpp>

namespace finback::machine {

// Numbers of the sources that the machine has.
enum InterruptSource : int {
  kPllWakeup = 0,
  kDma1Error = 1,
  kDma2Error = 2,
  kImdmaError = 3,
  kPpi0Error = 4,
  kPpi1Error = 5,
  kUartError = 9,
  kDma1Channel0 = 11,  // PPI0; PPI1 is the next one
  kDma2Channel0 = 23,
  kUartReceive = 28,  // with or without its channel of DMA2
  kUartTransmit = 29,
  kTimer0 = 35,   // to 46, TIMER11
  kFlags0A = 47,  // FIO0's A and B, FIO1's, FIO2's
  kMdma1Stream0 = 53,
  kMdma1Stream1 = 54,
  kMdma2Stream0 = 55,
  kMdma2Stream1 = 56,
  kImdmaStream0 = 57,
  kWatchdog = 59,  // of each core its own
  kSupplemental0 = 62,
  kSupplemental1 = 63,
};

class SystemInterrupts {
 public:
  static constexpr int kSourceCount = 64;

  struct Outputs {
    // Bit n: IVGn is requested of `core`. `wake`: a source that IWR admits is active, which ends
    // IDLE. Called at the very time that it takes effect, from advance() or from a register write.
    std::function<void(int core, std::uint32_t pending_ivg, bool wake, Cycles at)> lines_changed;
    std::function<void(Cycles at)> core_b_released;
    // A source's line that was up for a moment only has left an IVG pending.
    std::function<void(int core, int ivg, Cycles at)> latched = {};
    std::function<void(Cycles at)> software_reset = {};  // by SICA_SWRST
  };

  SystemInterrupts(const DeviceParameters& parameters, clock::ClockRatio ratio, Outputs outputs);

  // Registers of SICA (`core` 0) or SICB (`core` 1), by offset. Write throws GuestFault for ISR0
  // and ISR1.
  [[nodiscard]] std::uint32_t read(int core, std::uint32_t offset) const;
  void write(int core, std::uint32_t offset, std::uint32_t value, Cycles now);

  // A peripheral's line, seen by both cores' controllers. A source that two devices share is up
  // while either's line is: they are told apart by `driver`, 0 or 1.
  void set_line(int source, bool level, Cycles now, unsigned driver = 0);
  // One that only `core` sees.
  void set_core_line(int core, int source, bool level, Cycles now);

  // A source's line goes up for a moment: it wakes the cores whose wake-up masks admit it, and
  // stays pending as an interrupt of those whose masks do.
  void wake_up(int source, Cycles now);
  // Tells the outputs again: the cores' clock stood still, and they have not listened.
  void tell_again(Cycles now);
  // Lines that are on their way go on in the new clocks.
  void change_clock(const clock::ClockChange& change);

  // Told of lines that are raised and seen, from now on.
  void set_observer(memory::AccessObserver* observer) { observer_ = observer; }
  // `core` takes an interrupt: it sees the lines that ask for one.
  void note_taken(int core) const;

  // An actor: lines that become visible to a core.
  [[nodiscard]] Cycles next_event_time() const { return next_event_; }
  void advance(Cycles now);

 private:
  struct Controller {
    std::array<std::uint32_t, 2> mask{};  // IMASK0, 1
    std::array<std::uint32_t, 2> wake{0xFFFFFFFF, 0xFFFFFFFF};
    std::array<std::uint32_t, 8> assignment{};
    std::array<std::uint32_t, 2> line{};     // ISR0, 1
    std::array<std::uint32_t, 2> visible{};  // the part of `line` whose latency is over
    std::uint32_t pending_ivg = 0;
    bool waking = false;
  };
  struct Rise {
    Cycles at = 0;
    int core = 0;
    int source = 0;
  };

  void set(int core, int source, bool level, Cycles now, Cycles latency);
  void write_intercore(std::uint32_t value, Cycles now);
  void update(int core, Cycles at);
  void plan_next_event();

  Cycles intercore_latency_;
  clock::ClockRatio ratio_;
  Cycles peripheral_latency_;  // in SCLK
  Outputs outputs_;
  std::array<Controller, kCoreCount> controllers_;
  std::array<std::uint8_t, kSourceCount> drivers_{};  // bit by driver
  std::uint32_t sica_syscr_ = 0x20;                   // COREB_SRAM_INIT: core B held
  std::vector<Rise> rises_;                           // few; in the order in which they were raised
  Cycles next_event_ = kNever;
  memory::AccessObserver* observer_ = nullptr;
};

// The registers of one controller, as a device.
class InterruptRegisters final : public Device {
 public:
  static constexpr std::uint32_t kBytes = 0x44;

  // SICA for `core` 0, SICB for 1.
  InterruptRegisters(SystemInterrupts& interrupts, int core)
      : interrupts_(interrupts), core_(core) {}

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int /*bytes*/, Cycles /*now*/) override {
    return interrupts_.read(core_, offset);
  }
  void write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) override {
    interrupts_.write(core_, offset, value, now);
  }

 private:
  SystemInterrupts& interrupts_;
  int core_;
};

}  // namespace finback::machine
