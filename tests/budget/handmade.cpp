#include "handmade.hpp"

#include <algorithm>

#include <common/toml_reader.hpp>

namespace finback::budget {

namespace {

void add(report::CyclesByCause& causes, const std::string& cause, Cycles cycles) {
  const auto found = std::ranges::find(causes, cause, &report::CyclesByCause::value_type::first);
  if (found == causes.end()) {
    causes.emplace_back(cause, cycles);
  } else {
    found->second += cycles;
  }
}

report::Core& core(report::RunResult& result, const std::string& name) {
  return *std::ranges::find(result.cores, name, &report::Core::name);
}

report::Function function_of(const std::string& core, const std::string& name, std::uint64_t calls,
                             const report::CyclesByCause& causes) {
  report::Function row;
  row.core = core;
  row.name = name;
  row.calls = calls;
  row.causes = causes;
  for (const auto& [cause, cycles] : causes) {
    row.exclusive += cycles;
  }
  row.inclusive = row.exclusive;
  return row;
}

}  // namespace

report::Line line_of(const std::string& function, const std::string& file, int number,
                     const std::string& cause, Cycles cycles) {
  report::Line row;
  row.core = "core_b";
  row.function = function;
  row.file = file;
  row.line = number;
  row.packets = cycles;
  row.cycles = cycles;
  row.causes = {{cause, cycles}};
  return row;
}

report::RunResult handmade_result() {
  report::RunResult r;
  r.provenance = {"0.1.0",        {"camera", "f"},  {"placement.toml", "p"},
                  {"bf561", "m"}, {"default", "w"}, {"aloe", "s"}};
  r.core_hertz = 1e6;
  r.system_hertz = 1e6;
  r.cycles = 30'000;
  r.frames = {{0, 0, 20'000}, {1, 10'000, 30'000}};
  r.cores.resize(2);
  r.cores[0].name = "core_a";
  r.cores[0].cycles = 30'000;
  r.cores[0].causes = {{"issue", 1'000}, {"idle", 29'000}};
  r.cores[1].name = "core_b";
  r.cores[1].cycles = 30'000;
  r.cores[1].causes = {{"issue", 29'000}, {"l3_read", 0}, {"idle", 1'000}};
  r.functions = {
      function_of("core_a", "wait", 2, {{"issue", 1'000}, {"idle", 29'000}}),
      function_of("core_b", "census", 2, {{"issue", 9'000}}),
      function_of("core_b", "match", 480, {{"issue", 20'000}, {"l3_read", 0}, {"idle", 1'000}})};
  r.functions[2].code_bytes = 200;
  r.lines = {line_of("census", "census.c", 5, "issue", 9'000),
             line_of("match", "match.c", 10, "issue", 5'000),
             line_of("match", "match.c", 11, "issue", 15'000)};
  r.stages = {{"matching: scores", "core_b", "match", 21'000, 10'500}};
  r.traffic = {{"l1", "core_b", 4'000, 0}, {"l3", "core_b", 0, 0}};
  r.objects = {{"scores", "core_b", "l1.data.a", "l1", 800, {{"core_b", 1'000, 0, 4'000, 0, 0}}}};
  r.regions = {{"core_b", "l1.data.a", "l1", 800, 32'768}};
  r.power.watts = 2.0;
  r.power.components.resize(2);
  r.power.components[0].name = "core_b.dynamic";
  r.power.components[0].watts = 1.5;
  r.power.components[1].name = "sdram";
  r.power.components[1].watts = 0.5;
  r.counters = {
      {"core_a.cycles", 30'000}, {"core_b.cycles", 30'000}, {"core_b.stall.l3_read.cycles", 0}};
  return r;
}

report::Function& function(report::RunResult& result, const std::string& name) {
  return *std::ranges::find(result.functions, name, &report::Function::name);
}

report::Line& line(report::RunResult& result, int number) {
  return *std::ranges::find(result.lines, number, &report::Line::line);
}

void slow_down(report::RunResult& result, const std::string& name, int line_number,
               const std::string& cause, Cycles cycles) {
  report::Function& slowed = function(result, name);
  slowed.inclusive += cycles;
  slowed.exclusive += cycles;
  add(slowed.causes, cause, cycles);
  line(result, line_number).cycles += cycles;
  add(line(result, line_number).causes, cause, cycles);
  add(core(result, slowed.core).causes, cause, cycles);
  report::Function& waiting = function(result, "wait");
  waiting.inclusive += cycles;
  waiting.exclusive += cycles;
  add(waiting.causes, "idle", cycles);
  add(core(result, "core_a").causes, "idle", cycles);
  for (report::Core& each : result.cores) {
    each.cycles += cycles;
    result.counters[each.name + ".cycles"] += cycles;
  }
  result.cycles += cycles;
  result.frames.back().published += cycles;
  for (report::Stage& stage : result.stages) {
    stage.cycles += stage.function == name ? cycles : 0;
  }
}

void move_scores(report::RunResult& result, Cycles stalls) {
  report::Object& scores = result.objects.front();
  scores.region = "l3";
  scores.level = "l3";
  scores.accesses.front().stall_cycles = stalls;
  result.traffic = {{"l1", "core_b", 0, 0}, {"l3", "core_b", 4'000, 0}};
  result.provenance.placement = {"placement.toml + 1 moved", "q"};
  result.counters["core_b.stall.l3_read.cycles"] = stalls;
  slow_down(result, "match", 11, "l3_read", stalls);
}

Budget budget_of(const std::string& limits) {
  return read_budget(TomlReader(
      "firmware = \"camera\"\nbaseline = \"base.json\"\nsources = \"../firmware\"\n[limits]\n" +
          limits,
      "ci/b.toml"));
}

}  // namespace finback::budget
