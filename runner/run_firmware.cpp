#include <fmt/format.h>
#include <utility>

#include <common/error.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/machine/clock_log.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/peripherals.hpp>
#include <runner/gather_result.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

namespace {

// Why a run that stopped so has no result; "" when it has.
std::string complaint(const machine::StopInfo& stop, machine::HostPort& host, double seconds) {
  switch (stop.reason) {
    case machine::Stop::exited:
      if (!stop.message.empty()) {
        return fmt::format("ended after {:.6f} s: {}", seconds, stop.message);
      }
      if (stop.exit_status != 0) {
        return fmt::format("exited with status {} after {:.6f} s", stop.exit_status, seconds);
      }
      if (host.maps().size() < host.frames_grabbed()) {
        return fmt::format("exited after publishing {} maps of {} grabbed frames",
                           host.maps().size(), host.frames_grabbed());
      }
      return "";
    case machine::Stop::cycle_limit:
      return fmt::format(
          "does not end: {} of its maps are published after {:.3f} s of simulated time; if it only "
          "needs longer, raise --max-seconds",
          host.maps().size(), seconds);
    case machine::Stop::deadlock:
      if (!stop.message.empty()) {
        return fmt::format("stands still after {:.6f} s: {}", seconds, stop.message);
      }
      return fmt::format(
          "both cores sleep after {:.6f} s and no event is due that would wake them: a wait for "
          "an interrupt that is masked or was never started",
          seconds);
    case machine::Stop::cancelled:
      return "";
  }
  return "";
}

machine::StereoFrame pair_of(const RunInputs& inputs, std::uint32_t number) {
  if (!inputs.sequence) {
    return {inputs.scene.left.pixels(), inputs.scene.right.pixels()};
  }
  const scenes::LumaPair& pair = inputs.sequence->pair(number);
  return {pair.left.pixels(), pair.right.pixels()};
}

// A camera shows pair n in frame n; one that stands still is converted once.
void connect_camera(const RunInputs& inputs, peripheral::Camera::Side side,
                    machine::Peripherals& peripherals) {
  const peripheral::Camera& camera = peripherals.camera(side);
  const bool left = side == peripheral::Camera::Side::left;
  auto pictures = [&inputs, left, width = camera.width(), height = camera.height(),
                   kept =
                       std::shared_ptr<const peripheral::Picture>()](std::uint32_t number) mutable {
    if (!kept || inputs.sequence) {
      const scenes::LumaPair* pair = inputs.sequence ? &inputs.sequence->pair(number) : nullptr;
      const scenes::ByteImage& view = pair == nullptr
                                          ? (left ? inputs.scene.left : inputs.scene.right)
                                          : (left ? pair->left : pair->right);
      kept = std::make_shared<peripheral::Picture>(peripheral::Picture{
          width, height,
          view.width() == width ? view.pixels() : scenes::resize(view, width, height).pixels()});
    }
    return kept;
  };
  peripherals.connect_camera(side, std::move(pictures),
                             inputs.camera_troubles.at(static_cast<std::size_t>(side)));
}

machine::StopInfo run(machine::Machine& machine, const machine::RunLimits& limits, PortFiles& ports,
                      const RunObserver& observer) {
  const auto tell = [&] {
    if (observer.stale) {
      observer.stale(machine.stale_reports());
    }
  };
  try {
    machine::StopInfo stop = run_with_ports(machine, limits, ports);
    tell();
    return stop;
  } catch (const GuestFault&) {
    tell();
    throw;
  }
}

}  // namespace

RunOutcome run_firmware(const RunInputs& inputs, const RunObserver& observer) {
  const ir::FirmwareUnits& units = inputs.firmware.firmware.units;
  ir::Image image =
      ir::link(units, inputs.firmware.firmware.placement, inputs.machine->placement_map());
  machine::Machine machine(*inputs.machine, image);
  machine::HostPort& host = machine.host();
  host.set_frame_source([&](std::uint32_t number) { return pair_of(inputs, number); },
                        inputs.frames);
  for (const peripheral::Camera::Side side :
       {peripheral::Camera::Side::left, peripheral::Camera::Side::right}) {
    connect_camera(inputs, side, machine.peripherals());
  }
  PortFiles ports(inputs.ports, inputs.machine->clock.cclk_mhz);
  ports.attach(machine);
  if (inputs.check_races) {
    machine.check_races();
  }
  if (observer.console) {
    host.set_console(observer.console);
  }
  if (observer.ready) {
    observer.ready(machine, image);
  }

  machine::RunLimits limits;
  limits.reference_cycles = inputs.cycle_limit;
  if (observer.cancelled) {
    limits.cancelled = [&](Cycles now) {
      return observer.cancelled(now, static_cast<std::uint32_t>(host.maps().size()));
    };
  }
  const machine::StopInfo stop = run(machine, limits, ports, observer);
  RunOutcome outcome;
  if (stop.reason == machine::Stop::cancelled) {
    outcome.cancelled = true;
    return outcome;
  }
  const std::string trouble =
      complaint(stop, host, machine.clocks().history().seconds(0, stop.time));
  if (!trouble.empty()) {
    throw GuestFault(fmt::format("firmware {} {}", units.name, trouble));
  }
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    outcome.profiles[static_cast<std::size_t>(core)] = machine.profile(core);
  }
  outcome.result = gather_result(inputs, image, machine, outcome.profiles, stop.time);
  outcome.maps = host.maps();
  outcome.races = machine.races();
  outcome.image = std::move(image);
  return outcome;
}

}  // namespace finback::runner
