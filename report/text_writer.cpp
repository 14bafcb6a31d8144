#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include <report/text_writer.hpp>

namespace finback::report {

namespace {

constexpr std::size_t kFunctionsShown = 12;
constexpr std::size_t kObjectsShown = 10;

// Appends lines to the report.
class Page {
 public:
  template <class... Values>
  void line(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
    while (!text_.empty() && text_.back() == ' ') {
      text_.pop_back();
    }
    text_ += '\n';
  }
  void title(std::string_view heading) { line("\n{}", heading); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

double percent(Cycles part, Cycles whole) {
  return percent(static_cast<double>(part), static_cast<double>(whole));
}

double per_frame(std::uint64_t count, const RunResult& result) {
  return static_cast<double>(count) /
         static_cast<double>(std::max<std::size_t>(1, result.frames.size()));
}

// "1.23 MB", "12.3 kB" or "123 B", by thousands.
std::string bytes_text(double bytes) {
  if (bytes >= 1e6) {
    return fmt::format("{:.2f} MB", bytes / 1e6);
  }
  return bytes >= 1e3 ? fmt::format("{:.1f} kB", bytes / 1e3) : fmt::format("{:.0f} B", bytes);
}

void write_head(Page& page, const RunResult& r) {
  page.line("Finback {}: firmware {}, scene {}, placement {}, machine {}",
            r.provenance.tool_version, r.provenance.firmware.name, r.provenance.scene.name,
            r.provenance.placement.name, r.provenance.machine.name);
  page.line("{} frames in {:.1f} ms of simulated time, CCLK {:.0f} MHz, SCLK {:.0f} MHz",
            r.frames.size(), r.seconds() * 1e3, r.core_hertz / 1e6, r.system_hertz / 1e6);
  page.line("");
  for (const Target& target : r.targets) {
    page.line("  {:<20} {:>8.2f} {:<5} target {} {:<6g} {}", target.name, target.value, target.unit,
              target.comparison, target.limit, target.passed() ? "pass" : "FAIL");
  }
  if (!r.frames.empty()) {
    const Frame& last = r.frames.back();
    page.line("  {:<20} {:>8.2f} ms    from the pair's arrival to its map, last frame", "latency",
              static_cast<double>(last.published - last.grabbed) / r.core_hertz * 1e3);
  }
  if (r.accuracy) {
    const Accuracy& a = *r.accuracy;
    page.line("  {:<20} {:>8.2f} %     of {} pixels with known truth, {} px border left out",
              "bad_pixels", a.bad, a.compared, a.border);
    page.line(
        "  {:<20} {:>8.2f} %     of the {:.1f} % that got a disparity (off by more than {:g})",
        "wrong_pixels", a.wrong, a.density, a.delta);
  }
}

void write_stages(Page& page, const RunResult& r) {
  if (r.stages.empty()) {
    return;
  }
  page.title("Stages                      core      cycles/frame       ms   of the core");
  for (const Stage& stage : r.stages) {
    const auto core = std::find_if(r.cores.begin(), r.cores.end(),
                                   [&](const Core& c) { return c.name == stage.core; });
    page.line("  {:<24}  {:<7} {:>14.0f} {:>8.2f} {:>8.1f} %", stage.name, stage.core,
              stage.cycles_per_frame, stage.cycles_per_frame / r.core_hertz * 1e3,
              core == r.cores.end() ? 0.0 : percent(stage.cycles, core->cycles));
  }
}

void write_cores(Page& page, const RunResult& r) {
  std::string heading = fmt::format("{:<24}", "Cores");
  for (const Core& core : r.cores) {
    heading += fmt::format("{:>24}", core.started ? core.name : core.name + " (never started)");
  }
  page.title(heading);
  const auto row = [&](std::string_view name, auto&& value) {
    std::string text = fmt::format("  {:<22}", name);
    for (const Core& core : r.cores) {
      text += fmt::format("{:>24}", value(core));
    }
    page.line("{}", text);
  };
  row("cycles", [](const Core& c) { return fmt::format("{}", c.cycles); });
  row("instructions", [](const Core& c) { return fmt::format("{}", c.instructions); });
  row("instructions/cycle",
      [](const Core& c) { return fmt::format("{:.3f}", percent(c.instructions, c.cycles) / 100); });
  const std::size_t causes = r.cores.empty() ? 0 : r.cores.front().causes.size();
  for (std::size_t cause = 0; cause < causes; ++cause) {
    const bool seen = std::any_of(r.cores.begin(), r.cores.end(),
                                  [&](const Core& c) { return c.causes.at(cause).second > 0; });
    if (seen) {
      row(r.cores.front().causes[cause].first, [&](const Core& c) {
        const Cycles cycles = c.causes.at(cause).second;
        return fmt::format("{} {:>5.1f} %", cycles, percent(cycles, c.cycles));
      });
    }
  }
}

void write_traffic(Page& page, const RunResult& r) {
  const bool any = std::any_of(r.traffic.begin(), r.traffic.end(),
                               [](const Traffic& row) { return row.read + row.written > 0; });
  if (!any) {
    return;
  }
  page.title("Traffic per frame       by             read       written");
  for (const Traffic& row : r.traffic) {
    if (row.read + row.written > 0) {
      page.line("  {:<20}  {:<8} {:>12}  {:>12}", row.level, row.initiator,
                bytes_text(per_frame(row.read, r)), bytes_text(per_frame(row.written, r)));
    }
  }
}

void write_functions(Page& page, const RunResult& r) {
  std::vector<const Function*> hottest;
  for (const Function& function : r.functions) {
    if (function.exclusive > 0) {
      hottest.push_back(&function);
    }
  }
  std::stable_sort(hottest.begin(), hottest.end(), [](const Function* a, const Function* b) {
    return a->exclusive > b->exclusive;
  });
  const std::size_t shown = std::min(hottest.size(), kFunctionsShown);
  page.title(
      fmt::format("Functions ({} hottest of {})        core       calls       exclusive"
                  "        inclusive  issue",
                  shown, hottest.size()));
  for (std::size_t i = 0; i < shown; ++i) {
    const Function& f = *hottest[i];
    const Cycles issue = f.causes.empty() ? 0 : f.causes.front().second;
    page.line("  {:<32} {:<7} {:>8} {:>15} {:>16} {:>4.0f} %", f.name.substr(0, 32), f.core,
              f.calls, f.exclusive, f.inclusive, percent(issue, f.exclusive));
  }
}

void write_objects(Page& page, const RunResult& r) {
  struct Row {
    const Object* object;
    Bytes bytes = 0;
    Cycles stalls = 0;
  };
  std::vector<Row> rows;
  for (const Object& object : r.objects) {
    Row row{&object};
    for (const ObjectAccess& access : object.accesses) {
      row.bytes += access.read_bytes + access.written_bytes;
      row.stalls += access.stall_cycles;
    }
    if (row.bytes > 0) {
      rows.push_back(row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return std::pair(a.stalls, a.bytes) > std::pair(b.stalls, b.bytes);
  });
  const std::size_t shown = std::min(rows.size(), kObjectsShown);
  if (shown == 0) {
    return;
  }
  page.title(
      fmt::format("Objects ({} of {}, by stalls)        owner    region          size"
                  "   bytes/frame  stalls/frame",
                  shown, rows.size()));
  for (std::size_t i = 0; i < shown; ++i) {
    const Row& row = rows[i];
    page.line("  {:<32} {:<8} {:<11} {:>9} {:>12} {:>13.0f}", row.object->name.substr(0, 32),
              row.object->owner, row.object->region,
              bytes_text(static_cast<double>(row.object->size)),
              bytes_text(per_frame(row.bytes, r)), per_frame(row.stalls, r));
  }
}

void write_regions(Page& page, const RunResult& r) {
  page.title("Memory                  core            used          size");
  for (const RegionUse& region : r.regions) {
    if (region.used > 0) {
      page.line("  {:<20}  {:<8} {:>12} {:>13}  {:>5.1f} %", region.name,
                region.core.empty() ? "shared" : region.core, region.used, region.size,
                percent(region.used, region.size));
    }
  }
}

void write_power(Page& page, const RunResult& r) {
  page.title(fmt::format("Power {:.2f} W ({:.0f} mA at the board's supply)", r.power.watts,
                         r.power.amperes * 1e3));
  for (const power::PowerComponent& part : r.power.components) {
    page.line("  {:<22} {:>7.3f} W {:>8.0f} mA at {:.2f} V   [{}] {}", part.name, part.watts,
              part.amperes * 1e3, part.volts, part.certainty, part.source);
  }
  page.line("  (V verified, D derived, M from memory, E estimate: docs/power.md)");
}

}  // namespace

std::string to_text(const RunResult& result) {
  Page page;
  write_head(page, result);
  write_stages(page, result);
  write_cores(page, result);
  write_traffic(page, result);
  write_functions(page, result);
  write_objects(page, result);
  write_regions(page, result);
  write_power(page, result);
  page.line("\nVerdict: {}", verdict(result));
  return page.take();
}

}  // namespace finback::report
