#include <algorithm>
#include <fmt/format.h>

#include <report/sections.hpp>
#include <report/text_writer.hpp>

namespace finback::report {

namespace {

constexpr std::size_t kFunctionsShown = 12;
constexpr std::size_t kObjectsShown = 10;

void write_head(Page& page, const RunResult& r) {
  page.line("Finback {}: firmware {}, scene {}, placement {}, machine {}",
            r.provenance.tool_version, r.provenance.firmware.name, r.provenance.scene.name,
            r.provenance.placement.name, r.provenance.machine.name);
  page.line("{} frames in {:.1f} ms of simulated time, CCLK {:.0f} MHz, SCLK {:.0f} MHz{}",
            r.frames.size(), r.seconds() * 1e3, r.core_hertz / 1e6, r.system_hertz / 1e6,
            r.clocks.changed() ? " at first (see Clocks)" : "");
  page.line("");
  for (const Target& target : r.targets) {
    page.line("  {:<20} {:>8.2f} {:<5} target {} {:<6g} {}", target.name, target.value, target.unit,
              target.comparison, target.limit, target.passed() ? "pass" : "FAIL");
  }
  if (!r.frames.empty()) {
    const Frame& last = r.frames.back();
    page.line("  {:<20} {:>8.2f} ms    from the pair's arrival to its map, last frame", "latency",
              r.seconds(last.grabbed, last.published) * 1e3);
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
              stage.cycles_per_frame, stage.cycles_per_frame / r.hertz(0, r.cycles) * 1e3,
              core == r.cores.end() ? 0.0 : percent(stage.cycles, core->cycles));
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
  write_functions(page, result, kFunctionsShown);
  write_objects(page, result, kObjectsShown);
  write_regions(page, result);
  write_clocks(page, result);
  write_power(page, result);
  page.line("\nVerdict: {}", verdict(result));
  return page.take();
}

}  // namespace finback::report
