#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <common/error.hpp>
#include <common/parameter.hpp>
#include <isa_sim/ir/printer.hpp>
#include <isa_sim/isa/syntax.hpp>
#include <runner/annotate.hpp>
#include <runner/gather_program.hpp>
#include <runner/written_code.hpp>

namespace finback::runner {

namespace {

// Lines between two that have code are shown when they are at most so many.
constexpr int kContext = 8;

// A function by its place in a core's image, which is its place in the core's profile.
struct Found {
  CoreId core = CoreId::a;
  std::size_t index = 0;
  Cycles exclusive = 0;
};

[[noreturn]] void fail_unknown(const RunOutcome& outcome, const std::string& name,
                               std::optional<CoreId> core) {
  std::vector<std::string> names;
  for (const report::Function& function : outcome.result.functions) {
    names.push_back(function.name);
  }
  const bool elsewhere = std::ranges::find(names, name) != names.end();
  const std::string near = nearest_name(name, names);
  throw InputError(fmt::format(
      "{} has no function {}{}", core ? name_of(*core) : outcome.result.provenance.firmware.name,
      name,
      elsewhere ? ", but the other core has"
      : near.empty()
          ? "; finback profile lists them (functions that were inlined are part of their "
            "callers)"
          : fmt::format(", did you mean {}?", near)));
}

Found find_function(const RunOutcome& outcome, const std::string& name,
                    std::optional<CoreId> wanted) {
  std::optional<Found> best;
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    const auto number = static_cast<std::size_t>(core);
    const auto& functions = outcome.image.cores[number].functions;
    const auto found = std::ranges::find(functions, name, &ir::PlacedFunction::name);
    if ((wanted && *wanted != core) || found == functions.end()) {
      continue;
    }
    const auto index = static_cast<std::size_t>(found - functions.begin());
    const core::CoreProfile& profile = outcome.profiles[number];
    Found candidate{core, index, 0};
    if (profile.started) {
      const core::CauseCycles& cycles = profile.functions[index].exclusive;
      candidate.exclusive = std::accumulate(cycles.begin(), cycles.end(), Cycles{0});
    }
    if (!best || candidate.exclusive > best->exclusive) {
      best = candidate;
    }
  }
  if (!best) {
    fail_unknown(outcome, name, wanted);
  }
  return *best;
}

class Annotator {
 public:
  Annotator(const ir::FirmwareUnits& units, const RunOutcome& outcome, const Found& found,
            SourceText& sources)
      : outcome_(outcome),
        image_(outcome.image.cores[static_cast<std::size_t>(found.core)]),
        profile_(outcome.profiles[static_cast<std::size_t>(found.core)]),
        function_(image_.functions[found.index]),
        written_(written_function(units.cores[static_cast<std::size_t>(found.core)].units,
                                  function_, image_)),
        core_(name_of(found.core)),
        sources_(sources) {}

  report::Annotation take() {
    report::Annotation annotation;
    annotation.core = core_;
    annotation.function = function_.name;
    annotation.region = function_.region;
    annotation.address = function_.address;
    annotation.core_cycles = profile_.cycles;
    for (const report::Function& cost : outcome_.result.functions) {
      if (cost.core == core_ && cost.name == function_.name) {
        annotation.cost = cost;
      }
    }
    collect_lines();
    annotation.lines = ordered_lines();
    for (const report::AnnotatedLine& line : annotation.lines) {
      auto& missing = annotation.missing_sources;
      if (!line.file.empty() && !sources_.found(line.file) &&
          std::ranges::find(missing, line.file) == missing.end()) {
        missing.push_back(line.file);
      }
    }
    return annotation;
  }

 private:
  // Own file first, code without a line last.
  using Key = std::tuple<int, std::string, int>;

  [[nodiscard]] Key key_of(const ir::PlacedPacket& packet) const {
    if (packet.line <= 0) {
      return {2, "", 0};
    }
    const std::string& file = image_.source_files[static_cast<std::size_t>(packet.file)];
    return {file == own_file() ? 0 : 1, file, packet.line};
  }

  [[nodiscard]] std::string own_file() const {
    for (std::size_t i = 0; i < function_.packet_count; ++i) {
      const ir::PlacedPacket& packet = image_.packets[function_.first_packet + i];
      if (packet.line > 0) {
        return image_.source_files[static_cast<std::size_t>(packet.file)];
      }
    }
    return "";
  }

  void collect_lines() {
    for (const core::PacketProfile& packet : profile_.packet_profiles) {
      costs_[packet.packet] = &packet;
    }
    for (std::size_t i = 0; i < function_.packet_count; ++i) {
      add_packet(function_.first_packet + i);
    }
    // The sums were made when the result was gathered.
    for (const report::Line& cost : outcome_.result.lines) {
      if (cost.core != core_ || cost.function != function_.name) {
        continue;
      }
      for (auto& [key, line] : lines_) {
        if (line.file == cost.file && line.line == cost.line) {
          line.executions = cost.executions;
          line.packets = cost.packets;
          line.cycles = cost.cycles;
          line.causes = cost.causes;
          line.bytes = cost.bytes;
        }
      }
    }
  }

  void add_packet(std::size_t index) {
    const ir::PlacedPacket& placed = image_.packets[index];
    const Key key = key_of(placed);
    report::AnnotatedLine& line = lines_[key];
    line.file = std::get<1>(key);
    line.line = std::get<2>(key);
    line.source = sources_.line(line.file, line.line);
    report::AnnotatedPacket packet;
    packet.address = placed.address;
    const std::size_t number = index - function_.first_packet;
    for (const auto& [label, at] : written_.labels) {
      if (at == number) {
        packet.labels.push_back(label);
      }
    }
    packet.text = ir::print(written_.packets[number], isa::instruction_syntax()) + ";";
    if (const auto cost = costs_.find(index); cost != costs_.end()) {
      packet.executions = cost->second->executions;
      packet.cycles =
          std::accumulate(cost->second->cycles.begin(), cost->second->cycles.end(), Cycles{0});
      packet.causes = nonzero_causes(cost->second->cycles);
      packet.bytes = nonzero_levels(cost->second->bytes);
    }
    line.code.push_back(std::move(packet));
  }

  // With the lines of source between those that have code.
  std::vector<report::AnnotatedLine> ordered_lines() {
    std::vector<report::AnnotatedLine> ordered;
    for (auto& [key, line] : lines_) {
      if (!ordered.empty() && ordered.back().file == line.file &&
          line.line - ordered.back().line <= kContext + 1) {
        for (int number = ordered.back().line + 1; number < line.line; ++number) {
          report::AnnotatedLine between;
          between.file = line.file;
          between.line = number;
          between.source = sources_.line(line.file, number);
          ordered.push_back(std::move(between));
        }
      }
      ordered.push_back(std::move(line));
    }
    return ordered;
  }

  const RunOutcome& outcome_;
  const ir::CoreImage& image_;
  const core::CoreProfile& profile_;
  const ir::PlacedFunction& function_;
  ir::Function written_;
  std::string core_;
  SourceText& sources_;
  std::map<Key, report::AnnotatedLine> lines_;
  std::map<std::size_t, const core::PacketProfile*> costs_;
};

}  // namespace

report::Annotation annotate(const ir::FirmwareUnits& units, const RunOutcome& outcome,
                            const std::string& function, std::optional<CoreId> core,
                            SourceText& sources) {
  return Annotator(units, outcome, find_function(outcome, function, core), sources).take();
}

}  // namespace finback::runner
