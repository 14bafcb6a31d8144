#include <algorithm>
#include <vector>

#include <report/sections.hpp>

namespace finback::report {

namespace {

constexpr std::size_t kChangesShown = 8;

struct ObjectRow {
  const Object* object;
  std::uint64_t accesses = 0;
  Bytes bytes = 0;
  Cycles stalls = 0;
};

// Those that anybody touched, what costs most first.
std::vector<ObjectRow> touched_objects(const RunResult& r) {
  std::vector<ObjectRow> rows;
  for (const Object& object : r.objects) {
    ObjectRow row{&object};
    for (const ObjectAccess& access : object.accesses) {
      row.accesses += access.reads + access.writes;
      row.bytes += access.read_bytes + access.written_bytes;
      row.stalls += access.stall_cycles;
    }
    if (row.bytes > 0) {
      rows.push_back(row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const ObjectRow& a, const ObjectRow& b) {
    return std::pair(a.stalls, a.bytes) > std::pair(b.stalls, b.bytes);
  });
  return rows;
}

Cycles stalls_of(const Function& function) {
  return awake(function.exclusive, function.causes) -
         (function.causes.empty() ? 0 : function.causes.front().second);
}

Cycles key_of(const Function& function, FunctionOrder order) {
  switch (order) {
    case FunctionOrder::exclusive:
      break;
    case FunctionOrder::inclusive:
      return function.inclusive;
    case FunctionOrder::stalls:
      return stalls_of(function);
  }
  return awake(function.exclusive, function.causes);
}

Cycles cycles_of_core(const RunResult& r, const std::string& name) {
  const auto core = std::ranges::find(r.cores, name, &Core::name);
  return core == r.cores.end() ? 0 : core->cycles;
}

std::string point_text(const clock::OperatingPoint& point) {
  return fmt::format("{:<10} {:>6.4g} {:>6.4g} {:>6.2f}", clock::name_of(point.mode),
                     point.core_hertz / 1e6, point.system_hertz / 1e6, point.core_volts);
}

}  // namespace

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

void write_functions(Page& page, const RunResult& r, std::size_t most, FunctionOrder order,
                     const std::string& core, const Style& style) {
  std::vector<const Function*> rows;
  for (const Function& function : r.functions) {
    if (function.exclusive > 0 && (core.empty() || function.core == core)) {
      rows.push_back(&function);
    }
  }
  std::ranges::stable_sort(rows, [order](const Function* a, const Function* b) {
    return key_of(*a, order) > key_of(*b, order);
  });
  const std::size_t shown = std::min(rows.size(), most);
  page.title(fmt::format("{:<28} {:<6} {:>7} {:>12} {:>6} {:>12}  {}",
                         fmt::format("Functions ({} of {})", shown, rows.size()), "core", "calls",
                         "exclusive", "core %", "inclusive", "stalled by"));
  for (std::size_t i = 0; i < shown; ++i) {
    const Function& f = *rows[i];
    const double share = percent(f.exclusive, cycles_of_core(r, f.core));
    page.line("  {:<26} {:<6} {:>7} {:>12} {} {:>12}  {}", f.name.substr(0, 26), f.core, f.calls,
              f.exclusive, style.heat(fmt::format("{:>6.1f}", share), share), f.inclusive,
              largest_stalls(f.causes, f.exclusive));
  }
}

void write_objects(Page& page, const RunResult& r, std::size_t most) {
  const std::vector<ObjectRow> rows = touched_objects(r);
  const std::size_t shown = std::min(rows.size(), most);
  if (shown == 0) {
    return;
  }
  page.title(fmt::format("{:<28} {:<7} {:<11} {:>9} {:>13} {:>11} {:>13}",
                         fmt::format("Objects ({} of {})", shown, rows.size()), "owner", "region",
                         "size", "accesses/f", "bytes/f", "stall cyc./f"));
  for (std::size_t i = 0; i < shown; ++i) {
    const ObjectRow& row = rows[i];
    page.line("  {:<26} {:<7} {:<11} {:>9} {:>13.0f} {:>11} {:>13.0f}",
              row.object->name.substr(0, 26), row.object->owner, row.object->region,
              bytes_text(static_cast<double>(row.object->size)), per_frame(row.accesses, r),
              bytes_text(per_frame(row.bytes, r)), per_frame(row.stalls, r));
  }
}

void write_clocks(Page& page, const RunResult& r) {
  if (!r.clocks.changed()) {
    return;
  }
  page.title("Clocks       CCLK   SCLK      V           ms       W         mJ");
  for (const PointUse& use : r.points) {
    page.line("  {} {:>12.4f} {:>7.3f} {:>10.4f}", point_text(use.point), use.seconds * 1e3,
              use.watts, use.joules() * 1e3);
  }
  const auto& segments = r.clocks.segments();
  const std::size_t shown = std::min(segments.size() - 1, kChangesShown);
  page.line("  changed {} times, {} of them shown:", segments.size() - 1, shown);
  for (std::size_t i = 1; i <= shown; ++i) {
    page.line("  {} from {:.4f} ms on (cycle {})", point_text(segments[i].point),
              r.seconds(0, segments[i].from) * 1e3, segments[i].from);
  }
}

}  // namespace finback::report
