#include <nlohmann/json.hpp>

#include <report/json_writer.hpp>
#include <report/named_numbers.hpp>

namespace finback::report {

namespace {

using Json = nlohmann::ordered_json;

Json ingredient(const Ingredient& item) { return {{"name", item.name}, {"hash", item.hash}}; }

Json provenance(const Provenance& p) {
  return {{"tool_version", p.tool_version},       {"firmware", ingredient(p.firmware)},
          {"placement", ingredient(p.placement)}, {"machine", ingredient(p.machine)},
          {"power", ingredient(p.power)},         {"scene", ingredient(p.scene)}};
}

// Everything but work is a stall; `issue` stands beside them as its own key.
Json stalls(const CyclesByCause& causes) {
  Json object = Json::object();
  for (const auto& [name, cycles] : causes) {
    if (name != "issue") {
      object[name] = cycles;
    }
  }
  return object;
}

Cycles issue_cycles(const CyclesByCause& causes) {
  for (const auto& [name, cycles] : causes) {
    if (name == "issue") {
      return cycles;
    }
  }
  return 0;
}

Json frames(const RunResult& result) {
  Json list = Json::array();
  for (const Frame& frame : result.frames) {
    list.push_back({{"number", frame.number},
                    {"grabbed_cycle", frame.grabbed},
                    {"published_cycle", frame.published},
                    {"latency_seconds", result.seconds(frame.grabbed, frame.published)}});
  }
  return list;
}

Json clocks(const RunResult& result) {
  const auto put_point = [](Json& row, const clock::OperatingPoint& point) {
    row["mode"] = clock::name_of(point.mode);
    row["core_hertz"] = point.core_hertz;
    row["system_hertz"] = point.system_hertz;
    row["core_volts"] = point.core_volts;
  };
  Json changes = Json::array();
  for (const clock::ClockSegment& segment : result.clocks.segments()) {
    Json row = {{"from_cycle", segment.from}};
    put_point(row, segment.point);
    changes.push_back(std::move(row));
  }
  Json points = Json::array();
  for (const PointUse& use : result.points) {
    Json row = Json::object();
    put_point(row, use.point);
    row["cycles"] = use.cycles;
    row["seconds"] = use.seconds;
    row["watts"] = use.watts;
    row["joules"] = use.joules();
    points.push_back(std::move(row));
  }
  return {{"segments", std::move(changes)}, {"points", std::move(points)}};
}

Json cores(const RunResult& result) {
  Json object = Json::object();
  for (const Core& core : result.cores) {
    object[core.name] = {{"started", core.started},
                         {"cycles", core.cycles},
                         {"instructions", core.instructions},
                         {"packets", core.packets},
                         {"issue_cycles", issue_cycles(core.causes)},
                         {"stall_cycles", stalls(core.causes)},
                         {"operations", named_numbers(core.operations)},
                         {"code_bytes", core.code_bytes},
                         {"stack_bytes", core.stack_bytes},
                         {"stack_used_bytes", core.stack_used_bytes}};
  }
  return object;
}

Json stages(const RunResult& result) {
  Json list = Json::array();
  for (const Stage& stage : result.stages) {
    list.push_back({{"name", stage.name},
                    {"core", stage.core},
                    {"function", stage.function},
                    {"cycles", stage.cycles},
                    {"cycles_per_frame", stage.cycles_per_frame}});
  }
  return list;
}

Json functions(const RunResult& result) {
  Json list = Json::array();
  for (const Function& function : result.functions) {
    list.push_back({{"core", function.core},
                    {"name", function.name},
                    {"calls", function.calls},
                    {"instructions", function.instructions},
                    {"inclusive_cycles", function.inclusive},
                    {"exclusive_cycles", function.exclusive},
                    {"issue_cycles", issue_cycles(function.causes)},
                    {"stall_cycles", stalls(function.causes)},
                    {"code_bytes", function.code_bytes},
                    {"bytes", named_numbers(function.bytes)}});
  }
  return list;
}

Json lines(const RunResult& result) {
  Json list = Json::array();
  for (const Line& line : result.lines) {
    list.push_back({{"core", line.core},
                    {"function", line.function},
                    {"file", line.file},
                    {"line", line.line},
                    {"executions", line.executions},
                    {"packets", line.packets},
                    {"cycles", line.cycles},
                    {"causes", named_numbers(line.causes)},
                    {"bytes", named_numbers(line.bytes)}});
  }
  return list;
}

Json traffic(const RunResult& result) {
  Json object = Json::object();
  for (const Traffic& row : result.traffic) {
    object[row.level][row.initiator] = {{"read_bytes", row.read}, {"write_bytes", row.written}};
  }
  return object;
}

Json objects(const RunResult& result) {
  Json list = Json::array();
  for (const Object& object : result.objects) {
    Json accesses = Json::object();
    for (const ObjectAccess& access : object.accesses) {
      accesses[access.initiator] = {{"reads", access.reads},
                                    {"writes", access.writes},
                                    {"read_bytes", access.read_bytes},
                                    {"write_bytes", access.written_bytes},
                                    {"stall_cycles", access.stall_cycles}};
    }
    list.push_back({{"name", object.name},
                    {"owner", object.owner},
                    {"region", object.region},
                    {"level", object.level},
                    {"size", object.size},
                    {"accesses", std::move(accesses)}});
  }
  return list;
}

Json regions(const RunResult& result) {
  Json list = Json::array();
  for (const RegionUse& region : result.regions) {
    list.push_back({{"core", region.core.empty() ? Json() : Json(region.core)},
                    {"name", region.name},
                    {"level", region.level},
                    {"used_bytes", region.used},
                    {"size_bytes", region.size}});
  }
  return list;
}

Json power(const power::PowerEstimate& estimate) {
  Json components = Json::array();
  for (const power::PowerComponent& part : estimate.components) {
    components.push_back({{"name", part.name},
                          {"watts", part.watts},
                          {"volts", part.volts},
                          {"amperes", part.amperes},
                          {"certainty", std::string(1, part.certainty)},
                          {"source", part.source}});
  }
  Json activity = Json::object();
  for (std::size_t core = 0; core < estimate.activity.size(); ++core) {
    activity[name_of(static_cast<CoreId>(core))] = estimate.activity[core];
  }
  return {{"watts", estimate.watts},
          {"amperes", estimate.amperes},
          {"core_volts", estimate.core_volts},
          {"bus_utilisation", estimate.bus_utilisation},
          {"activity_factor", std::move(activity)},
          {"components", std::move(components)}};
}

Json targets(const RunResult& result) {
  Json object = Json::object();
  for (const Target& target : result.targets) {
    object[target.name] = {{"comparison", target.comparison},
                           {"limit", target.limit},
                           {"value", target.value},
                           {"verdict", target.passed() ? "pass" : "fail"}};
  }
  return object;
}

Json accuracy(const RunResult& result) {
  if (!result.accuracy) {
    return nullptr;
  }
  const Accuracy& a = *result.accuracy;
  return {{"frame", a.frame},
          {"delta_pixels", a.delta},
          {"border_pixels", a.border},
          {"compared_pixels", a.compared},
          {"density_percent", a.density},
          {"bad_percent", a.bad},
          {"wrong_percent", a.wrong}};
}

}  // namespace

std::string to_json(const RunResult& result) {
  const Json document = {
      {"schema_version", kResultSchemaVersion},
      {"provenance", provenance(result.provenance)},
      {"stopped", result.stopped},
      {"frames_per_second", frames_per_second(result)},
      {"power_watts", result.power.watts},
      {"targets", targets(result)},
      {"accuracy", accuracy(result)},
      {"core_hertz", result.core_hertz},
      {"system_hertz", result.system_hertz},
      {"cycles", result.cycles},
      {"seconds", result.seconds()},
      {"clocks", clocks(result)},
      {"frames", frames(result)},
      {"stages", stages(result)},
      {"cores", cores(result)},
      {"traffic", traffic(result)},
      {"memory", regions(result)},
      {"objects", objects(result)},
      {"functions", functions(result)},
      {"lines", lines(result)},
      {"power", power(result.power)},
      {"counters", named_numbers(result.counters)},
  };
  return document.dump(2) + "\n";
}

}  // namespace finback::report
