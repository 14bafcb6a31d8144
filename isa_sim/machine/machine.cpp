#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/core/core.hpp>
#include <isa_sim/ir/placement.hpp>
#include <isa_sim/machine/clock_log.hpp>
#include <isa_sim/machine/device_bus.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/program_host.hpp>
#include <isa_sim/machine/race_report.hpp>

namespace finback::machine {

namespace {

constexpr std::uint8_t kStackPattern = 0xA5;

std::vector<memory::ObjectPlace> places_of(const ir::Image& image, const memory::MemoryMap& map) {
  std::vector<memory::ObjectPlace> places;
  for (const ir::PlacedObject& object : image.objects) {
    places.push_back(
        {object.name, std::string(ir::owner_name(object.owner)), object.address, object.size});
  }
  // Code outside L1 lies among data; code in L1 instruction memory is out of reach of loads and
  // stores.
  for (std::size_t core = 0; core < image.cores.size(); ++core) {
    for (const ir::PlacedFunction& function : image.cores[core].functions) {
      const memory::Region* region = map.find(function.address);
      if (region != nullptr && region->level != memory::Level::l1) {
        places.push_back(
            {function.name, name_of(static_cast<CoreId>(core)), function.address, function.size});
      }
    }
  }
  return places;
}

}  // namespace

class Machine::Implementation final : public core::SystemPort {
 public:
  Implementation(const MachineDescription& description, const ir::Image& image, Begin begin)
      : image_(image),
        description_(description),
        core_hertz_(description.clock.cclk_mhz * 1e6),
        ratio_(description.clock.ratio()),
        lookahead_(static_cast<Cycles>(std::int64_t{description.devices.intercore_latency})),
        tick_(static_cast<Cycles>(std::llround(description.clock.cclk_mhz * 1000))),
        memory_(description.map, description.memory, description.clock,
                places_of(image, description.map)),
        bus_(description, memory_,
             {.lines_changed =
                  [this](int core, std::uint32_t pending_ivg, bool wake, Cycles at) {
                    if (!bus_.pll().asleep()) {
                      core_at(core).set_requests(pending_ivg, wake, at);
                    } else if (wake && core_at(core).started()) {
                      bus_.pll().wake(at);  // which tells of it again
                    }
                  },
              .core_b_released =
                  [this](Cycles at) {
                    if (image_.cores[1].present && !cores_[1]->started()) {
                      if (races_) {
                        races_->core_released(1);
                      }
                      cores_[1]->start(at);
                    }
                  },
              .latched =
                  [this](int core, int ivg, Cycles at) {
                    if (core_at(core).started()) {
                      core_at(core).latch_request(ivg, at);
                    }
                  },
              .software_reset =
                  [this](Cycles at) {
                    bus_.host().flush_line();
                    exit_ = StopInfo{Stop::exited, 0, at, {}};
                    running_->shorten_turn(0);
                  }}),
        clocks_(bus_.pll().point()) {
    for (std::size_t i = 0; i < cores_.size(); ++i) {
      cores_[i] = std::make_unique<core::Core>(
          static_cast<CoreId>(i), image.cores[i], description.core,
          static_cast<Cycles>(std::int64_t{description.devices.core_register_cycles}), memory_,
          *this);
    }
    for (const ir::PlacedObject& object : image.objects) {
      memory_.store_bytes(object.address, object.initial);
    }
    for (const ir::Owner owner : {ir::Owner::core_a, ir::Owner::core_b}) {
      if (const ir::PlacedObject* stack = image.stack_of(owner)) {
        memory_.store_bytes(stack->address, std::vector<std::uint8_t>(stack->size, kStackPattern));
      }
    }
    memory_.register_counters(counters_);
    bus_.register_counters(counters_);
    for (const auto& core : cores_) {
      core->register_counters(counters_);
    }
    bus_.set_writer([this] { return core_at(device_writer_).device_writer(); });
    bus_.host().set_exit([this](std::uint32_t status, Cycles at) {
      exit_ = StopInfo{Stop::exited, status, at, {}};
      running_->shorten_turn(0);
    });
    bus_.peripherals().set_watchdog_events(
        {.reset =
             [this](int core, Cycles at) {
               bus_.host().flush_line();
               exit_ = StopInfo{Stop::exited, 1, at,
                                fmt::format("watchdog {} reset the chip: nothing wrote WDOG{}_STAT "
                                            "in time",
                                            core == 0 ? 'A' : 'B', core == 0 ? 'A' : 'B')};
             },
         .non_maskable =
             [this](int core, Cycles at) {
               if (bus_.pll().asleep()) {
                 bus_.pll().wake(at);
               }
               core_at(core).latch_request(core::kNonMaskable, at);
             }});
    bus_.set_clocked([this](const clock::OperatingPoint& point, clock::ClockRatio ratio,
                            Cycles at) { change_clock(point, ratio, at); });
    core_at(0).start(
        0, begin == Begin::reset
               ? core::Core::Start{core::EventController::kAfterReset, core::kConfigAfterReset}
               : core::Core::Start{core::EventController::kSupervisor, core::kCyclesRun});
  }

  Read device_read(int core, Address address, int bytes, Cycles now) override {
    const DeviceRead read = bus_.read(core, address, bytes, now);
    core_at(core).shorten_turn(bus_.next_event_time());
    return {read.value, read.stall};
  }
  Cycles device_write(int core, Address address, int bytes, std::uint32_t value,
                      Cycles now) override {
    device_writer_ = core;
    const Cycles stall = bus_.write(core, address, bytes, value, now);
    core_at(core).shorten_turn(bus_.next_event_time());
    return stall;
  }
  [[nodiscard]] Cycles device_writes_drained_at(int core) const override {
    return bus_.writes_drained_at(core);
  }

  void interrupt_taken(int core) override {
    memory_.observer()->acts(static_cast<memory::Initiator>(core));
    bus_.interrupts().note_taken(core);
  }

  void print(int, std::string_view text) override {
    if (program_host_) {
      program_host_->print(text);
    } else {
      bus_.host().print(text);
    }
  }
  void halt(int, std::uint32_t status, const std::string& why, Cycles now) override {
    bus_.host().flush_line();
    exit_ = StopInfo{Stop::exited, status, now, why};
  }
  HostCall host_call(int, isa::ExecutionState& state, Cycles now) override {
    if (!program_host_) {
      return HostCall::none;
    }
    const auto status = program_host_->call(state, real_time_.to_reference(now));
    if (status) {
      exit_ = StopInfo{Stop::exited, *status, now, {}};
    }
    return status ? HostCall::ended : HostCall::done;
  }
  void serve_programs(ProgramHostOptions options) {
    options.core_hertz = core_hertz_;
    program_host_ = std::make_unique<ProgramHost>(std::move(options), memory_);
  }

  void check_races() {
    races_ = std::make_unique<races::RaceDetector>(flags_of(image_));
    memory_.set_observer(races_.get());
    bus_.interrupts().set_observer(races_.get());
  }
  [[nodiscard]] std::vector<RaceReport> races() const {
    std::vector<RaceReport> reports;
    if (races_) {
      for (const races::Race& race : races_->races()) {
        reports.push_back(describe(race, image_, [this](int core, std::uint32_t packet) {
          return cores_[static_cast<std::size_t>(core)]->place(packet);
        }));
      }
    }
    return reports;
  }

  StopInfo run(const RunLimits& limits) {
    Cycles next_question = 0;
    for (;;) {
      if (exit_) {
        return stopped(*exit_);
      }
      core::Core* runner = earliest_core();
      const Cycles event = std::min(
          {bus_.next_event_time(), core_at(0).next_event_time(), core_at(1).next_event_time()});
      if (bus_.pll().waits_for_idle() && idle_for_clocks()) {
        bus_.begin_clock_change(latest_time());
        continue;
      }
      if (runner == nullptr && event == kNever) {
        return stopped({Stop::deadlock, 0, latest_time(), {}});
      }
      const Cycles limit =
          std::min(limits.cycles, real_time_.from_reference(limits.reference_cycles));
      const Cycles now = runner == nullptr ? event : std::min(runner->time(), event);
      if (now >= limit) {
        return stopped({Stop::cycle_limit, 0, limit, {}});
      }
      if (limits.cancelled && now >= next_question) {
        if (limits.cancelled(now)) {
          return stopped({Stop::cancelled, 0, now, {}});
        }
        next_question = now + tick_;
      }
      if (runner == nullptr || event <= runner->time()) {
        advance(event);
        continue;
      }
      running_ = runner;
      runner->run(
          turn_of(*runner, std::min({event, limit, limits.cancelled ? next_question : kNever})));
    }
  }

  [[nodiscard]] core::Core& core_at(int number) {
    return *cores_[static_cast<std::size_t>(number)];
  }

  void end_trace() {
    for (const auto& core : cores_) {
      core->end_trace();
    }
  }

  [[nodiscard]] std::vector<std::string> stale_reports() const {
    std::vector<std::string> lines;
    for (const memory::StaleReport& report : memory_.stale_watch().reports()) {
      lines.push_back(stale_line(report));
    }
    return lines;
  }

  [[nodiscard]] std::uint32_t stack_used(CoreId core) const {
    const ir::PlacedObject* stack = image_.stack_of(static_cast<ir::Owner>(core));
    if (stack == nullptr) {
      return 0;
    }
    const auto bytes = memory_.view_bytes(stack->address, stack->size);
    const auto deepest =
        std::ranges::find_if(bytes, [](std::uint8_t byte) { return byte != kStackPattern; });
    return static_cast<std::uint32_t>(bytes.end() - deepest);
  }

  HostPort& host() { return bus_.host(); }
  Peripherals& peripherals() { return bus_.peripherals(); }
  memory::MemorySystem& memory() { return memory_; }
  [[nodiscard]] const CounterRegistry& counters() const { return counters_; }
  [[nodiscard]] const ClockLog& clocks() const { return clocks_; }
  [[nodiscard]] Cycles reference_time(Cycles time) const { return real_time_.to_reference(time); }

 private:
  // "core_b in census (0xffa00010, census.c:12)", "mdma1_0".
  [[nodiscard]] std::string who(const memory::Accessor& accessor) const {
    std::string text(memory::kInitiatorNames[static_cast<std::size_t>(accessor.initiator)]);
    if (accessor.site != memory::kNoSite) {
      text += " in " + cores_[static_cast<std::size_t>(accessor.initiator)]->place(accessor.site);
    }
    return text;
  }
  [[nodiscard]] std::string stale_line(const memory::StaleReport& report) const {
    const std::string what =
        fmt::format("{} at {:#010x}", memory_.object_name(report.object), report.address);
    const std::string reader = who(report.reader);
    const std::string other = who(report.other);
    const std::string often = fmt::format("{} time{}, first at cycle {}", report.times,
                                          report.times == 1 ? "" : "s", report.at);
    switch (report.kind) {
      case memory::StaleKind::old_in_cache:
        return fmt::format(
            "{}: {} read an old copy in its data cache; {} has changed it since ({})", what, reader,
            other, often);
      case memory::StaleKind::old_in_memory:
        return fmt::format("{}: {} read old memory; {} stored what is still in its data cache ({})",
                           what, reader, other, often);
      case memory::StaleKind::overwritten:
        return fmt::format("{}: {} wrote a line back over what {} has changed ({})", what, reader,
                           other, often);
      case memory::StaleKind::dropped:
        return fmt::format("{}: {} turned the data cache off and lost what {} stored ({})", what,
                           reader, other, often);
    }
    return "";
  }

  [[nodiscard]] static bool active(const core::Core& core) {
    return core.started() && !core.sleeping();
  }

  // Devices before the cores' own timers.
  void advance(Cycles event) {
    if (bus_.next_event_time() == event) {
      bus_.advance(event);
      return;
    }
    for (const auto& core : cores_) {
      if (core->next_event_time() == event) {
        core->advance(event);
      }
    }
  }

  // Of equal times core A's comes first.
  [[nodiscard]] core::Core* earliest_core() {
    core::Core& a = *cores_[0];
    core::Core& b = *cores_[1];
    if (active(a) && active(b)) {
      return b.time() < a.time() ? &b : &a;
    }
    return active(a) ? &a : active(b) ? &b : nullptr;
  }

  // How far `runner` may go: to the next event; no further beyond the other core than a signal from
  // there takes; and on shared things only while it is the earliest.
  [[nodiscard]] core::Core::Turn turn_of(const core::Core& runner, Cycles until) {
    core::Core::Turn turn{until, until};
    const bool is_a = &runner == cores_[0].get();
    const core::Core& other = *cores_[is_a ? 1 : 0];
    if (active(other)) {
      turn.horizon = std::min(turn.horizon, other.time() + lookahead_);
      turn.shared_until = std::min(turn.shared_until, other.time() + (is_a ? 1 : 0));
    }
    return turn;
  }

  [[nodiscard]] Cycles latest_time() const {
    return std::max(cores_[0]->time(), cores_[1]->time());
  }

  // Whether a change that waits for IDLE need not wait any longer.
  [[nodiscard]] bool idle_for_clocks() {
    const bool both = description_.pll.both_cores_idle != 0 || bus_.pll().will_stop_cores();
    const auto idle = [this](std::size_t core) { return !active(*cores_[core]); };
    return both ? idle(0) && idle(1) : idle(static_cast<std::size_t>(device_writer_));
  }

  void change_clock(const clock::OperatingPoint& point, clock::ClockRatio ratio, Cycles at) {
    using clock::Mode;
    const clock::OperatingPoint last = clocks_.history().segments().back().point;
    for (const auto& core : cores_) {
      core->settle(at);
    }
    if (last.mode == Mode::sleep) {
      for (const auto& core : cores_) {
        core->start_clock(at);
      }
    }
    const clock::ClockChange change{.at = at,
                                    .from = ratio_,
                                    .to = ratio,
                                    .from_hertz = whole_hertz(last.core_hertz),
                                    .to_hertz = whole_hertz(point.core_hertz),
                                    .core_mhz = point.core_hertz / 1e6,
                                    .system_mhz = point.system_hertz / 1e6};
    clocks_.change(at, point, work());
    ratio_ = ratio;
    real_time_.change(change);
    memory_.change_clock(change);
    bus_.change_clock(change);
    if (point.mode == Mode::sleep) {
      for (const auto& core : cores_) {
        core->stop_clock(at);
      }
    } else if (last.mode == Mode::sleep) {
      bus_.interrupts().tell_again(at);
    } else if (point.mode == Mode::deep_sleep || point.mode == Mode::hibernate) {
      power_down(point, at);
    }
  }

  // Nothing but RESET ends it, and the run.
  void power_down(const clock::OperatingPoint& point, Cycles at) {
    const double microseconds = description_.pll.reset_after_us;
    bus_.host().flush_line();
    if (microseconds > 0) {
      const auto cycles = static_cast<Cycles>(std::llround(microseconds * point.core_hertz / 1e6));
      exit_ = StopInfo{Stop::exited, 0, at + cycles, {}};
    } else {
      exit_ = StopInfo{Stop::deadlock, 0, at,
                       fmt::format("the chip is in {}, which only RESET ends: set "
                                   "clock.reset_after_us to when the board pulls it",
                                   clock::name_of(point.mode))};
    }
  }

  [[nodiscard]] ChipWork work() const {
    return {.cores = {cores_[0]->work(), cores_[1]->work()},
            .external_transfers = memory_.external_transfers()};
  }

  static std::uint64_t whole_hertz(double hertz) {
    return static_cast<std::uint64_t>(std::llround(hertz));
  }

  StopInfo stopped(const StopInfo& info) {
    for (const auto& core : cores_) {
      core->settle(info.time);
    }
    clocks_.settle(info.time, work());
    return info;
  }

  const ir::Image& image_;
  const MachineDescription& description_;
  double core_hertz_;
  clock::ClockRatio ratio_;
  clock::RealTime real_time_;
  std::unique_ptr<ProgramHost> program_host_;
  std::unique_ptr<races::RaceDetector> races_;  // nullptr: nobody asked
  Cycles lookahead_;
  Cycles tick_;  // a millisecond
  memory::MemorySystem memory_;
  std::array<std::unique_ptr<core::Core>, kCoreCount> cores_;
  DeviceBus bus_;
  ClockLog clocks_;
  CounterRegistry counters_;
  std::optional<StopInfo> exit_;
  core::Core* running_ = nullptr;
  int device_writer_ = 0;  // the core that wrote a device register last
};

Machine::Machine(const MachineDescription& description, const ir::Image& image, Begin begin)
    : implementation_(std::make_unique<Implementation>(description, image, begin)) {}
Machine::~Machine() = default;

void Machine::serve_programs(ProgramHostOptions options) {
  implementation_->serve_programs(std::move(options));
}
HostPort& Machine::host() { return implementation_->host(); }
Peripherals& Machine::peripherals() { return implementation_->peripherals(); }
memory::MemorySystem& Machine::memory() { return implementation_->memory(); }
void Machine::trace(CoreId core, core::TraceSink sink) {
  implementation_->core_at(static_cast<int>(core)).trace(std::move(sink));
}
void Machine::check_races() { implementation_->check_races(); }
std::vector<RaceReport> Machine::races() const { return implementation_->races(); }
StopInfo Machine::run(const RunLimits& limits) {
  try {
    StopInfo stop = implementation_->run(limits);
    implementation_->end_trace();
    return stop;
  } catch (const GuestFault&) {
    implementation_->end_trace();
    throw;
  }
}
const ClockLog& Machine::clocks() const { return implementation_->clocks(); }
Cycles Machine::reference_time(Cycles time) const { return implementation_->reference_time(time); }
const CounterRegistry& Machine::counters() const { return implementation_->counters(); }
core::CoreProfile Machine::profile(CoreId core) const {
  return implementation_->core_at(static_cast<int>(core)).profile();
}

const isa::ExecutionState& Machine::state(CoreId core) const {
  return implementation_->core_at(static_cast<int>(core)).state();
}

std::vector<std::string> Machine::stale_reports() const { return implementation_->stale_reports(); }

std::uint32_t Machine::stack_used(CoreId core) const { return implementation_->stack_used(core); }

}  // namespace finback::machine
