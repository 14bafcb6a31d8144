#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

#include <report/metrics.hpp>

namespace finback::report {

namespace {

class Collector {
 public:
  explicit Collector(const RunResult& result)
      : result_(result),
        frames_(static_cast<double>(std::max<std::size_t>(1, result.frames.size()))) {}

  std::map<std::string, Metric> take() {
    for (const auto& [name, value] : result_.counters) {
      add(name, static_cast<double>(value), unit_of_counter(name));
    }
    add_run();
    add_accuracy();
    add_cores();
    add_stages();
    add_functions();
    add_levels();
    add_objects();
    add_regions();
    return std::move(metrics_);
  }

 private:
  void add(const std::string& name, double value, const std::string& unit) {
    metrics_[name] = {value, unit};
  }
  // A count over the run, and what that is a frame.
  void add_with_frame(const std::string& name, std::uint64_t value, const std::string& unit) {
    add(name, static_cast<double>(value), unit);
    add(name + "_per_frame", static_cast<double>(value) / frames_, unit);
  }

  // Counters end in their unit.
  static std::string unit_of_counter(const std::string& name) {
    return name.substr(name.rfind('.') + 1);
  }

  void add_run() {
    const double rate = frames_per_second(result_);
    add("frames_per_second", rate, "fps");
    add("power_watts", result_.power.watts, "W");
    add("seconds", result_.seconds(), "s");
    add("cycles", static_cast<double>(result_.cycles), "cycles");
    add("core_megahertz", result_.core_hertz / 1e6, "MHz");
    add("energy_joules", result_.power.watts * result_.seconds(), "J");
    add("bus_utilisation", result_.power.bus_utilisation, "");
    for (const power::PowerComponent& component : result_.power.components) {
      add(fmt::format("power.{}.watts", metric_word(component.name)), component.watts, "W");
    }
    if (rate > 0) {
      add("energy_per_frame_joules", result_.power.watts / rate, "J");
    }
    if (!result_.frames.empty()) {
      double longest = 0;
      for (const Frame& frame : result_.frames) {
        longest = std::max(longest, result_.seconds(frame.grabbed, frame.published));
      }
      add("latency_seconds", longest, "s");
    }
  }

  void add_accuracy() {
    if (result_.accuracy) {
      add("accuracy.bad_percent", result_.accuracy->bad, "%");
      add("accuracy.wrong_percent", result_.accuracy->wrong, "%");
      add("accuracy.density_percent", result_.accuracy->density, "%");
    }
  }

  void add_cores() {
    for (const Core& core : result_.cores) {
      add(core.name + ".code.bytes", static_cast<double>(core.code_bytes), "bytes");
      add(core.name + ".stack.size_bytes", static_cast<double>(core.stack_bytes), "bytes");
      add(core.name + ".stack.used_bytes", static_cast<double>(core.stack_used_bytes), "bytes");
    }
  }

  void add_stages() {
    for (const Stage& stage : result_.stages) {
      const std::string name = fmt::format("stage.{}.{}", stage.core, metric_word(stage.name));
      add_with_frame(name + ".cycles", stage.cycles, "cycles");
    }
  }

  void add_functions() {
    for (const Function& function : result_.functions) {
      const std::string name = fmt::format("function.{}.{}", function.core, function.name);
      Cycles stalls = 0;
      for (const auto& [cause, cycles] : function.causes) {
        stalls += cause == "issue" ? 0 : cycles;
      }
      add(name + ".calls", static_cast<double>(function.calls), "calls");
      add(name + ".instructions", static_cast<double>(function.instructions), "instructions");
      add(name + ".code_bytes", static_cast<double>(function.code_bytes), "bytes");
      add_with_frame(name + ".inclusive_cycles", function.inclusive, "cycles");
      add_with_frame(name + ".exclusive_cycles", function.exclusive, "cycles");
      add_with_frame(name + ".stall_cycles", stalls, "cycles");
      for (const auto& [level, bytes] : function.bytes) {
        add_with_frame(fmt::format("{}.{}_bytes", name, level), bytes, "bytes");
      }
    }
  }

  void add_levels() {
    struct Sum {
      Bytes read = 0;
      Bytes written = 0;
    };
    std::map<std::string, Sum> levels;
    for (const Traffic& row : result_.traffic) {
      levels[row.level].read += row.read;
      levels[row.level].written += row.written;
    }
    for (const auto& [level, sum] : levels) {
      const std::string name = "level." + level;
      add_with_frame(name + ".read_bytes", sum.read, "bytes");
      add_with_frame(name + ".write_bytes", sum.written, "bytes");
      add_with_frame(name + ".bytes", sum.read + sum.written, "bytes");
    }
  }

  void add_objects() {
    for (const Object& object : result_.objects) {
      if (object.name == "(free)") {
        continue;
      }
      ObjectAccess sum;
      for (const ObjectAccess& access : object.accesses) {
        sum.reads += access.reads;
        sum.writes += access.writes;
        sum.read_bytes += access.read_bytes;
        sum.written_bytes += access.written_bytes;
        sum.stall_cycles += access.stall_cycles;
      }
      const std::string name = fmt::format("object.{}.{}", object.owner, object.name);
      add(name + ".size_bytes", static_cast<double>(object.size), "bytes");
      add_with_frame(name + ".accesses", sum.reads + sum.writes, "accesses");
      add_with_frame(name + ".bytes", sum.read_bytes + sum.written_bytes, "bytes");
      add_with_frame(name + ".stall_cycles", sum.stall_cycles, "cycles");
    }
  }

  void add_regions() {
    for (const RegionUse& region : result_.regions) {
      const std::string name =
          fmt::format("memory.{}.{}", region.core.empty() ? "shared" : region.core, region.name);
      add(name + ".used_bytes", static_cast<double>(region.used), "bytes");
      add(name + ".free_bytes", static_cast<double>(region.size - region.used), "bytes");
    }
  }

  const RunResult& result_;
  double frames_;
  std::map<std::string, Metric> metrics_;
};

}  // namespace

std::map<std::string, Metric> metrics_of(const RunResult& result) {
  return Collector(result).take();
}

std::string metric_word(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) {
      word += static_cast<char>(std::tolower(byte));
    } else if (!word.empty() && word.back() != '_') {
      word += '_';
    }
  }
  if (!word.empty() && word.back() == '_') {
    word.pop_back();
  }
  return word;
}

std::string metric_text(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (value == std::floor(value) && std::abs(value) < kExact) {
    return fmt::format("{:.0f}", value);
  }
  return std::abs(value) >= 1e5 ? fmt::format("{:.1f}", value) : fmt::format("{:.5g}", value);
}

}  // namespace finback::report
