#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include <report/json_writer.hpp>
#include <report/profile_writer.hpp>

namespace finback::report {

namespace {

// Every core has its own cycles: rows of both are compared by their share of their core's.
void write_lines(Page& page, const RunResult& r, const ProfileView& view) {
  std::vector<const Line*> rows;
  for (const Line& line : r.lines) {
    if (view.core.empty() || line.core == view.core) {
      rows.push_back(&line);
    }
  }
  std::ranges::stable_sort(rows, std::greater<>(),
                           [](const Line* line) { return awake(line->cycles, line->causes); });
  const std::size_t shown = std::min(rows.size(), view.most);
  page.title(fmt::format("{:<28} {:<24} {:<6} {:>12} {:>6}  {}",
                         fmt::format("Lines ({} of {})", shown, rows.size()), "in function", "core",
                         "cycles", "core %", "stalled by"));
  for (std::size_t i = 0; i < shown; ++i) {
    const Line& line = *rows[i];
    const auto core = std::ranges::find(r.cores, line.core, &Core::name);
    const double share = core == r.cores.end() ? 0 : percent(line.cycles, core->cycles);
    const std::string place =
        line.line > 0 ? fmt::format("{}:{}", line.file, line.line) : "(no line)";
    page.line("  {:<26} {:<24} {:<6} {:>12} {}  {}", place, line.function.substr(0, 24), line.core,
              line.cycles, view.style.heat(fmt::format("{:>6.1f}", share), share),
              largest_stalls(line.causes, line.cycles));
  }
}

Bytes all_bytes(const Function& function) {
  Bytes sum = 0;
  for (const auto& [level, bytes] : function.bytes) {
    sum += bytes;
  }
  return sum;
}

// Bytes beyond L1 cost most, so they come first.
Bytes far_bytes(const Function& function) {
  return all_bytes(function) - (function.bytes.empty() ? 0 : function.bytes.front().second);
}

void write_function_bytes(Page& page, const RunResult& r, const ProfileView& view) {
  std::vector<const Function*> rows;
  for (const Function& function : r.functions) {
    if (all_bytes(function) > 0 && (view.core.empty() || function.core == view.core)) {
      rows.push_back(&function);
    }
  }
  std::ranges::stable_sort(rows, std::greater<>(), [](const Function* function) {
    return std::pair(far_bytes(*function), all_bytes(*function));
  });
  const std::size_t shown = std::min(rows.size(), view.most);
  if (shown == 0) {
    return;
  }
  std::string heading = fmt::format(
      "{:<28} {:<6}", fmt::format("Bytes per frame ({} of {})", shown, rows.size()), "core");
  for (const auto& [level, bytes] : rows.front()->bytes) {
    heading += fmt::format(" {:>11}", level);
  }
  page.title(heading);
  for (std::size_t i = 0; i < shown; ++i) {
    std::string cells;
    for (const auto& [level, bytes] : rows[i]->bytes) {
      cells += fmt::format(" {:>11}", bytes_text(per_frame(bytes, r)));
    }
    page.line("  {:<26} {:<6}{}", rows[i]->name.substr(0, 26), rows[i]->core, cells);
  }
}

}  // namespace

std::string profile_text(const RunResult& result, const ProfileView& view) {
  Page page;
  page.line("Firmware {}, scene {}, placement {}, machine {}: {} frames, {:.2f} fps",
            result.provenance.firmware.name, result.provenance.scene.name,
            result.provenance.placement.name, result.provenance.machine.name, result.frames.size(),
            frames_per_second(result));
  write_functions(page, result, view.most, view.order, view.core, view.style);
  write_lines(page, result, view);
  write_cores(page, result);
  write_objects(page, result, view.most);
  write_traffic(page, result);
  write_function_bytes(page, result, view);
  return page.take();
}

std::string profile_json(const RunResult& result) {
  constexpr std::array<const char*, 10> kKeys = {
      "schema_version", "provenance", "core_hertz", "cycles",    "frames",
      "cores",          "traffic",    "objects",    "functions", "lines"};
  const auto whole = nlohmann::ordered_json::parse(to_json(result));
  nlohmann::ordered_json part;
  for (const char* key : kKeys) {
    part[key] = whole.at(key);
  }
  return part.dump(2) + "\n";
}

}  // namespace finback::report
