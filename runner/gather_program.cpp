#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

#include <isa_sim/isa/instruction.hpp>
#include <runner/gather_program.hpp>

namespace finback::runner {

namespace {

// By isa::Energy.
constexpr std::array<std::string_view, 6> kEnergyNames = {"nop",    "alu",     "mac",
                                                          "access", "control", "idle"};

// Names beside values, with or without those that are 0.
template <class Names, class Values>
std::vector<std::pair<std::string, std::uint64_t>> named(const Names& names, const Values& values,
                                                         bool zeros) {
  std::vector<std::pair<std::string, std::uint64_t>> pairs;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (zeros || values[i] != 0) {
      pairs.emplace_back(names[i], values[i]);
    }
  }
  return pairs;
}

void gather_core(CoreId core, const ir::CoreImage& image, const core::CoreProfile& profile,
                 report::RunResult& result) {
  report::Core row;
  row.name = name_of(core);
  row.started = profile.started;
  row.cycles = profile.cycles;
  row.instructions = profile.instructions;
  row.packets = profile.packets;
  row.causes = named(core::kCauseNames, profile.causes, true);
  row.operations = named(kEnergyNames, profile.by_energy_class, true);
  for (const ir::PlacedFunction& function : image.functions) {
    row.code_bytes += function.size;
  }
  result.cores.push_back(std::move(row));
}

void gather_functions(CoreId core, const ir::CoreImage& image, const core::CoreProfile& profile,
                      report::RunResult& result) {
  for (std::size_t i = 0; i < profile.functions.size(); ++i) {
    const core::FunctionProfile& function = profile.functions[i];
    report::Function row;
    row.core = name_of(core);
    row.name = function.name;
    row.calls = function.calls;
    row.instructions = function.instructions;
    row.inclusive = function.inclusive;
    row.exclusive =
        std::accumulate(function.exclusive.begin(), function.exclusive.end(), Cycles{0});
    row.causes = named(core::kCauseNames, function.exclusive, true);
    row.code_bytes = image.functions[i].size;
    row.bytes = named(memory::kLevelNames, function.bytes, true);
    result.functions.push_back(std::move(row));
  }
}

struct LineCost {
  std::uint64_t executions = 0;
  std::uint64_t packets = 0;
  core::CauseCycles cycles{};
  core::LevelBytes bytes{};
};

void gather_lines(CoreId core, const ir::CoreImage& image, const core::CoreProfile& profile,
                  report::RunResult& result) {
  std::map<std::tuple<std::uint32_t, int, int>, LineCost> lines;  // function, file, line
  for (const core::PacketProfile& packet : profile.packet_profiles) {
    const ir::PlacedPacket& placed = image.packets[packet.packet];
    LineCost& line = lines[{placed.function, placed.line > 0 ? placed.file : 0, placed.line}];
    line.executions = std::max(line.executions, packet.executions);
    line.packets += packet.executions;
    for (std::size_t cause = 0; cause < line.cycles.size(); ++cause) {
      line.cycles[cause] += packet.cycles[cause];
    }
    for (std::size_t level = 0; level < line.bytes.size(); ++level) {
      line.bytes[level] += packet.bytes[level];
    }
  }
  for (const auto& [place, cost] : lines) {
    const auto& [function, file, number] = place;
    report::Line row;
    row.core = name_of(core);
    row.function = image.functions[function].name;
    row.file = number > 0 ? image.source_files[static_cast<std::size_t>(file)] : "";
    row.line = number;
    row.executions = cost.executions;
    row.packets = cost.packets;
    row.cycles = std::accumulate(cost.cycles.begin(), cost.cycles.end(), Cycles{0});
    row.causes = nonzero_causes(cost.cycles);
    row.bytes = nonzero_levels(cost.bytes);
    result.lines.push_back(std::move(row));
  }
}

}  // namespace

report::CyclesByCause nonzero_causes(const core::CauseCycles& cycles) {
  return named(core::kCauseNames, cycles, false);
}
report::BytesByLevel nonzero_levels(const core::LevelBytes& bytes) {
  return named(memory::kLevelNames, bytes, false);
}

void gather_program(CoreId core, const ir::CoreImage& image, const core::CoreProfile& profile,
                    report::RunResult& result) {
  gather_core(core, image, profile, result);
  gather_functions(core, image, profile, result);
  gather_lines(core, image, profile, result);
}

void gather_stages(const std::vector<ir::Stage>& stages, report::RunResult& result) {
  const double frames = static_cast<double>(std::max<std::size_t>(1, result.frames.size()));
  for (const ir::Stage& stage : stages) {
    report::Stage row{stage.name, std::string(ir::owner_name(stage.core)), stage.function, 0, 0};
    for (const report::Function& function : result.functions) {
      if (function.core == row.core && function.name == row.function) {
        row.cycles = function.inclusive;
      }
    }
    row.cycles_per_frame = static_cast<double>(row.cycles) / frames;
    result.stages.push_back(std::move(row));
  }
}

}  // namespace finback::runner
