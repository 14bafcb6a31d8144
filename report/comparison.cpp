#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>

#include <common/csv.hpp>
#include <report/comparison.hpp>
#include <report/metrics.hpp>
#include <report/page.hpp>

namespace finback::report {

namespace {

constexpr int kNameWidth = 24;
constexpr std::size_t kLeastColumn = 12;
constexpr double kMilli = 1e3;

using Number = std::function<double(const RunResult&)>;

double cause_cycles(const RunResult& r, std::size_t cause) {
  Cycles sum = 0;
  for (const Core& core : r.cores) {
    sum += core.causes.at(cause).second;
  }
  return per_frame(sum, r);
}

// Awake cycles of both cores that were waited, as a share of all awake ones.
double waiting_percent(const RunResult& r) {
  Cycles busy = 0;
  Cycles work = 0;
  for (const Core& core : r.cores) {
    busy += awake(core.cycles, core.causes);
    work += core.causes.empty() ? 0 : core.causes.front().second;
  }
  return percent(busy - work, busy);
}

enum class Mover : std::uint8_t { core, dma };

// Bytes a frame at a level.
double moved(const RunResult& r, const std::string& level, Mover mover) {
  Bytes sum = 0;
  for (const Traffic& row : r.traffic) {
    const bool core = row.initiator.starts_with("core_");
    const bool counts = mover == Mover::core ? core : !core && row.initiator != "host";
    sum += row.level == level && counts ? row.read + row.written : 0;
  }
  return per_frame(sum, r);
}

// Objects and stacks, as they are placed.
double data_bytes(const RunResult& r, const std::string& level) {
  Bytes sum = 0;
  for (const RegionUse& region : r.regions) {
    const bool code = region.name.find("code") != std::string::npos;
    sum += region.level == level && !code ? region.used : 0;
  }
  return static_cast<double>(sum);
}

double code_bytes(const RunResult& r) {
  Bytes sum = 0;
  for (const Core& core : r.cores) {
    sum += core.code_bytes;
  }
  return static_cast<double>(sum);
}

double instructions(const RunResult& r) {
  std::uint64_t sum = 0;
  for (const Core& core : r.cores) {
    sum += core.instructions;
  }
  return per_frame(sum, r);
}

double millijoules(const RunResult& r) {
  return kMilli * r.power.watts * r.seconds() /
         static_cast<double>(std::max<std::size_t>(1, r.frames.size()));
}

class Rows {
 public:
  explicit Rows(const std::vector<NamedResult>& runs) : runs_(runs) {}

  void add(const std::string& section, const std::string& name, const std::string& unit,
           const Number& number) {
    ComparisonRow row{section, name, unit, {}};
    for (const NamedResult& run : runs_) {
      row.values.push_back(number(run.result));
    }
    if (std::ranges::any_of(row.values, [](double value) { return value != 0; })) {
      rows_.push_back(std::move(row));
    }
  }
  std::vector<ComparisonRow> take() { return std::move(rows_); }

 private:
  const std::vector<NamedResult>& runs_;
  std::vector<ComparisonRow> rows_;
};

void add_time(const RunResult& first, Rows& rows) {
  rows.add("", "cycles", "", cycles_per_frame);
  rows.add("", "times faster", "x",
           [&](const RunResult& r) { return cycles_per_frame(first) / cycles_per_frame(r); });
  rows.add("", "frames a second", "fps", [](const RunResult& r) { return frames_per_second(r); });
  rows.add("", "instructions", "", instructions);
  rows.add("", "power", "W", [](const RunResult& r) { return r.power.watts; });
  rows.add("", "energy", "mJ", millijoules);
}

void add_bytes(Rows& rows) {
  for (const char* name : {"l1", "l2", "l3"}) {
    const std::string level = name;
    rows.add("Bytes moved", level + " by cores", "B",
             [&](const RunResult& r) { return moved(r, level, Mover::core); });
    rows.add("Bytes moved", level + " by DMA", "B",
             [&](const RunResult& r) { return moved(r, level, Mover::dma); });
  }
}

// Whole numbers as such.
nlohmann::ordered_json json_number(double value) {
  return value == std::floor(value) ? nlohmann::ordered_json(static_cast<std::uint64_t>(value))
                                    : nlohmann::ordered_json(value);
}

std::string cell(const ComparisonRow& row, double value) {
  if (row.unit.empty() || row.unit == "B") {
    return value == 0 ? "-" : fmt::format("{:.0f}", value);
  }
  return fmt::format("{:.{}f}", value, value < 100 ? 2 : 1);
}

}  // namespace

double cycles_per_frame(const RunResult& result) { return per_frame(result.cycles, result); }

std::vector<ComparisonRow> comparison_rows(const std::vector<NamedResult>& runs) {
  Rows rows(runs);
  const RunResult& first = runs.front().result;
  add_time(first, rows);
  for (std::size_t cause = 0; cause < first.cores.front().causes.size(); ++cause) {
    rows.add("Cycles by cause", first.cores.front().causes[cause].first, "",
             [&](const RunResult& r) { return cause_cycles(r, cause); });
  }
  add_bytes(rows);
  rows.add("Size", "code", "B", code_bytes);
  for (const char* level : {"l1", "l2", "l3"}) {
    rows.add("Size", std::string("data in ") + level, "B",
             [&](const RunResult& r) { return data_bytes(r, level); });
  }
  return rows.take();
}

std::string comparison_text(const std::vector<NamedResult>& runs) {
  const std::vector<ComparisonRow> rows = comparison_rows(runs);
  std::vector<std::size_t> widths;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    std::size_t width = std::max(kLeastColumn, runs[run].name.size());
    for (const ComparisonRow& row : rows) {
      width = std::max(width, cell(row, row.values[run]).size());
    }
    widths.push_back(width);
  }
  Page page;
  const auto line = [&](const std::string& head, auto&& text_of) {
    std::string text = fmt::format("{:<{}}", head, kNameWidth);
    for (std::size_t run = 0; run < runs.size(); ++run) {
      text += fmt::format("  {:>{}}", text_of(run), widths[run]);
    }
    page.line("{}", text);
  };
  line("A frame", [&](std::size_t run) { return runs[run].name; });
  std::string section;
  for (const ComparisonRow& row : rows) {
    if (row.section != section) {
      section = row.section;
      page.title(section);
    }
    const bool shown = !row.unit.empty() && row.unit != "B" && row.unit != "x";
    line("  " + row.name + (shown ? ", " + row.unit : ""),
         [&](std::size_t run) { return cell(row, row.values[run]); });
  }
  return page.take();
}

std::string comparison_json(const std::vector<NamedResult>& runs) {
  const std::vector<ComparisonRow> rows = comparison_rows(runs);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    nlohmann::ordered_json object = {{"name", runs[run].name}};
    for (const ComparisonRow& row : rows) {
      object[row.section.empty() ? "summary" : metric_word(row.section)][metric_word(row.name)] =
          json_number(row.values[run]);
    }
    list.push_back(std::move(object));
  }
  const nlohmann::ordered_json document = {{"schema_version", 1}, {"runs", std::move(list)}};
  return document.dump(2) + "\n";
}

std::string comparison_csv(const std::vector<NamedResult>& runs) {
  std::string text = "section,name,unit";
  for (const NamedResult& run : runs) {
    text += "," + csv_field(run.name);
  }
  text += '\n';
  for (const ComparisonRow& row : comparison_rows(runs)) {
    text += fmt::format("{},{},{}", row.section.empty() ? "summary" : metric_word(row.section),
                        metric_word(row.name), row.unit);
    for (const double value : row.values) {
      text += "," + metric_text(value);
    }
    text += '\n';
  }
  return text;
}

std::string climb_text(const std::vector<NamedResult>& runs) {
  std::size_t width = 0;
  for (const NamedResult& run : runs) {
    width = std::max(width, run.name.size());
  }
  Page page;
  page.line("    {:<{}}  {:>13}  {:>12}  {:>11}  {:>7}  {:>7}  {:>11}  {:>9}", "rung", width,
            "cycles/frame", "than before", "than first", "fps", "waiting", "L3 bytes/f", "mJ/f");
  double before = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunResult& r = runs[i].result;
    const double cycles = cycles_per_frame(r);
    const double first = cycles_per_frame(runs.front().result);
    const std::string gain = i == 0 ? "" : fmt::format("{:.2f} x", before / cycles);
    const std::string all = i == 0 ? "" : fmt::format("{:.1f} x", first / cycles);
    page.line("{:>3} {:<{}}  {:>13.0f}  {:>12}  {:>11}  {:>7.2f}  {:>5.1f} %  {:>11.0f}  {:>9.2f}",
              i + 1, runs[i].name, width, cycles, gain, all, frames_per_second(r),
              waiting_percent(r), moved(r, "l3", Mover::core) + moved(r, "l3", Mover::dma),
              millijoules(r));
    before = cycles;
  }
  return page.take();
}

}  // namespace finback::report
