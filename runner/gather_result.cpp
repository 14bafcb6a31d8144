#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/ir/linker.hpp>
#include <isa_sim/isa/instruction.hpp>
#include <isa_sim/machine/clock_log.hpp>
#include <memory_model/memory_system.hpp>
#include <power_model/power_model.hpp>
#include <report/metrics.hpp>
#include <runner/gather_program.hpp>
#include <runner/gather_result.hpp>
#include <runner/identity.hpp>
#include <stereo_reference/evaluation.hpp>

namespace finback::runner {

namespace {

// What the camera was built for (stereo-system.md, "The device"): 20 frames a second at 2.3 W.
constexpr double kTargetFramesPerSecond = 20;
constexpr double kTargetWatts = 2.3;

// Accuracy as in the thesis: off by more than one pixel is wrong, 8 border pixels do not count.
constexpr double kAccuracyDelta = 1.0;
constexpr int kAccuracyBorder = 8;

std::string core_name(int core) { return name_of(static_cast<CoreId>(core)); }

void gather_stack(CoreId core, const ir::Image& image, const machine::Machine& machine,
                  report::Core& row) {
  const ir::PlacedObject* stack = image.stack_of(static_cast<ir::Owner>(core));
  if (stack != nullptr) {
    row.stack_bytes = stack->size;
    row.stack_used_bytes = machine.stack_used(core);
  }
}

void gather_traffic(const memory::MemorySystem& memory, report::RunResult& result) {
  for (std::size_t level = 0; level < memory::kLevelNames.size(); ++level) {
    for (std::size_t initiator = 0; initiator < memory::kInitiatorNames.size(); ++initiator) {
      const auto bytes = [&](memory::Direction direction) {
        return memory
            .level_traffic(static_cast<memory::Level>(level),
                           static_cast<memory::Initiator>(initiator), direction)
            .bytes;
      };
      result.traffic.push_back({std::string(memory::kLevelNames[level]),
                                std::string(memory::kInitiatorNames[initiator]),
                                bytes(memory::Direction::read), bytes(memory::Direction::write)});
    }
  }
}

void gather_objects(const memory::MemorySystem& memory, report::RunResult& result) {
  for (const memory::ObjectTraffic& object : memory.objects()) {
    report::Object row;
    row.name = object.name;
    row.owner = object.owner;
    row.region = object.region;
    row.level = memory::kLevelNames[static_cast<std::size_t>(object.level)];
    row.size = object.size;
    for (std::size_t initiator = 0; initiator < object.traffic.size(); ++initiator) {
      const auto& [read, write] = object.traffic[initiator];
      if (read.accesses + write.accesses > 0) {
        row.accesses.push_back({std::string(memory::kInitiatorNames[initiator]), read.accesses,
                                write.accesses, read.bytes, write.bytes,
                                read.stall_cycles + write.stall_cycles});
      }
    }
    result.objects.push_back(std::move(row));
  }
}

void gather_regions(const ir::Image& image, const memory::MemoryMap& map,
                    report::RunResult& result) {
  for (const ir::RegionUse& use : ir::link_report(image, map)) {
    const memory::Region* region = map.find(std::max(use.core, 0), use.region);
    result.regions.push_back(
        {use.core < 0 ? "" : core_name(use.core), use.region,
         std::string(memory::kLevelNames[static_cast<std::size_t>(region->level)]), use.used,
         use.size});
  }
}

power::CoreActivity core_activity(const core::CoreProfile& profile, Cycles end) {
  const auto operations = [&](isa::Energy energy) {
    return profile.by_energy_class[static_cast<std::size_t>(energy)];
  };
  const Cycles asleep = profile.causes[static_cast<std::size_t>(core::Cause::idle)];
  return {.cycles = end,
          .idle_cycles = asleep + (end - std::min(end, profile.cycles)),  // before it was started
          .alu_operations = operations(isa::Energy::alu),
          .mac_operations = operations(isa::Energy::mac),
          .access_operations = operations(isa::Energy::access)};
}

// A core that did not run slept.
power::CoreActivity core_activity(const core::CoreWork& work, Cycles cycles) {
  const auto operations = [&](isa::Energy energy) {
    return work.by_energy_class[static_cast<std::size_t>(energy)];
  };
  return {.cycles = cycles,
          .idle_cycles = cycles - std::min(cycles, work.busy),
          .alu_operations = operations(isa::Energy::alu),
          .mac_operations = operations(isa::Energy::mac),
          .access_operations = operations(isa::Energy::access)};
}

// By operating point, and their average.
void gather_power(const power::PowerParameters& parameters, const machine::ClockLog& clocks,
                  report::RunResult& result) {
  std::vector<power::TimedEstimate> parts;
  for (const machine::PointUse& use : clocks.uses()) {
    if (use.cycles == 0) {
      continue;
    }
    power::Activity activity;
    activity.core_hertz = use.point.core_hertz;
    activity.system_hertz = use.point.system_hertz;
    activity.core_volts = use.point.core_volts;
    activity.mode = use.point.mode;
    activity.cycles = use.cycles;
    activity.external_beats = use.work.external_transfers;
    for (std::size_t core = 0; core < activity.cores.size(); ++core) {
      activity.cores[core] = core_activity(use.work.cores[core], use.cycles);
    }
    parts.push_back({power::estimate_power(parameters, activity), use.seconds});
    result.points.push_back({use.point, use.cycles, use.seconds, parts.back().estimate.watts});
  }
  result.power = power::average(parts);
}

std::optional<report::Accuracy> gather_accuracy(const scenes::FloatImage& truth,
                                                const std::vector<machine::PublishedMap>& maps) {
  if (maps.empty() || static_cast<int>(maps.back().width) != truth.width() ||
      static_cast<int>(maps.back().height) != truth.height()) {
    return std::nullopt;
  }
  const machine::PublishedMap& last = maps.back();
  scenes::ByteImage map(truth.width(), truth.height());
  std::copy(last.bytes.begin(), last.bytes.end(), map.data());
  const stereo_reference::MapQuality quality = stereo_reference::evaluate(
      map, truth, stereo_reference::inner_region(truth.width(), truth.height(), kAccuracyBorder),
      kAccuracyDelta);
  report::Accuracy accuracy;
  accuracy.frame = last.frame_number;
  accuracy.delta = kAccuracyDelta;
  accuracy.border = kAccuracyBorder;
  accuracy.compared = quality.compared;
  accuracy.density =
      quality.compared > 0 ? 100.0 * (quality.compared - quality.invalid) / quality.compared : 0;
  accuracy.bad = quality.bad_percent();
  accuracy.wrong = quality.wrong_percent();
  return accuracy;
}

scenes::FloatImage truth_of_last_map(const RunInputs& inputs, machine::Machine& machine) {
  const std::vector<machine::PublishedMap>& maps = machine.host().maps();
  return inputs.sequence && !maps.empty() ? inputs.sequence->truth(maps.back().picture)
                                          : inputs.scene.truth;
}

}  // namespace

report::RunResult gather_result(const RunInputs& inputs, const ir::Image& image,
                                machine::Machine& machine,
                                const std::array<core::CoreProfile, kCoreCount>& profiles,
                                Cycles end) {
  const machine::MachineDescription& description = *inputs.machine;
  const memory::MemorySystem& memory = machine.memory();
  report::RunResult result;
  result.provenance = {
      FINBACK_VERSION,
      inputs.firmware.identity,
      inputs.firmware.placement,
      {description.name, machine_hash(description)},
      {inputs.power_name, power_hash(*inputs.power)},
      {inputs.scene.name, inputs.sequence ? inputs.sequence_hash : scene_hash(inputs.scene)}};
  result.core_hertz = description.clock.cclk_mhz * 1e6;
  result.system_hertz = description.clock.sclk_mhz * 1e6;
  result.cycles = end;
  for (const machine::PublishedMap& map : machine.host().maps()) {
    result.frames.push_back({map.frame_number, map.grabbed_at, map.published_at});
  }

  power::Activity activity;
  activity.core_hertz = result.core_hertz;
  activity.system_hertz = result.system_hertz;
  activity.cycles = std::max<Cycles>(1, end);
  activity.external_beats = memory.external_transfers();
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    const core::CoreProfile& profile = profiles[static_cast<std::size_t>(core)];
    gather_program(core, image.cores[static_cast<std::size_t>(core)], profile, result);
    gather_stack(core, image, machine, result.cores.back());
    activity.cores[static_cast<std::size_t>(core)] = core_activity(profile, end);
  }
  const machine::ClockLog& clocks = machine.clocks();
  result.clocks = clocks.history();
  if (result.clocks.changed()) {
    gather_power(*inputs.power, clocks, result);
  } else {
    result.power = power::estimate_power(*inputs.power, activity);
    const double seconds = static_cast<double>(end) / result.core_hertz;
    result.points = {{clocks.history().segments().front().point, end, seconds, result.power.watts}};
  }

  gather_stages(inputs.firmware.firmware.units.stages, result);
  gather_traffic(memory, result);
  gather_objects(memory, result);
  gather_regions(image, description.map, result);
  result.accuracy = gather_accuracy(truth_of_last_map(inputs, machine), machine.host().maps());
  if (!result.frames.empty()) {  // a program that shows no maps has no rate to miss
    result.targets.push_back({"frames_per_second", ">=", kTargetFramesPerSecond,
                              report::frames_per_second(result), "fps"});
  }
  result.targets.push_back({"power_watts", "<=", kTargetWatts, result.power.watts, "W"});
  for (const auto& [name, reading] : machine.counters().snapshot()) {
    result.counters[name] = reading.value;
  }
  return result;
}

std::map<std::string, std::uint64_t> trace_counters(const report::RunResult& result) {
  std::map<std::string, std::uint64_t> counters = result.counters;
  counters["run.cycles"] = result.cycles;
  for (const report::Frame& frame : result.frames) {
    const std::string name = fmt::format("frame.{:04}", frame.number);
    counters[name + ".grabbed_cycle"] = frame.grabbed;
    counters[name + ".published_cycle"] = frame.published;
  }
  for (const report::Stage& stage : result.stages) {
    counters[fmt::format("stage.{}.{}.cycles", stage.core, report::metric_word(stage.name))] =
        stage.cycles;
  }
  return counters;
}

}  // namespace finback::runner
