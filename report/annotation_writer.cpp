#include <nlohmann/json.hpp>

#include <report/annotation_writer.hpp>
#include <report/named_numbers.hpp>

namespace finback::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kStallWidth = 32;
// The left columns, and where what stands beside them begins.
constexpr std::size_t kSourceColumn = 12 + 1 + 6 + 1 + 11 + 2 + kStallWidth + 1;
constexpr std::size_t kLabelColumn = kSourceColumn + 8;

// What the columns on the left say of a line or a packet.
template <class Row>
std::string columns(const Row& row, Cycles whole, const Style& style) {
  if (row.executions == 0 && row.cycles == 0) {
    return fmt::format("{:>12} {:>6} {:>11}  {:<{}}", "", "", "", "", kStallWidth);
  }
  const double share = percent(row.cycles, whole);
  return style.heat(fmt::format("{:>12} {:>6.1f}", row.cycles, share), share) +
         fmt::format(" {:>11}  {:<{}}", row.executions, largest_stalls(row.causes, row.cycles),
                     kStallWidth);
}

void write_head(Page& page, const Annotation& a, const Style& style) {
  const Function& f = a.cost;
  page.line("{} of {}: {} cycles of its own, {:.1f} % of the core's; {} with what it calls",
            style.bold(a.function), a.core, f.exclusive, percent(f.exclusive, a.core_cycles),
            f.inclusive);
  page.line("{} calls, {:.1f} cycles of its own each; {} bytes of code at {:#010x} in {}", f.calls,
            f.calls > 0 ? static_cast<double>(f.exclusive) / static_cast<double>(f.calls) : 0.0,
            f.code_bytes, a.address, a.region);
  std::string causes;
  for (const auto& [cause, cycles] : f.causes) {
    if (cycles > 0) {
      causes += fmt::format("{}{} {} ({:.1f} %)", causes.empty() ? "" : ", ", cause, cycles,
                            percent(cycles, f.exclusive));
    }
  }
  page.line("Cycles by cause: {}", causes.empty() ? "none, it never ran" : causes);
  std::string bytes;
  for (const auto& [level, count] : f.bytes) {
    bytes += fmt::format("{}{} {}", bytes.empty() ? "" : ", ", level, count);
  }
  page.line("Bytes by level: {}", bytes);
  for (const std::string& file : a.missing_sources) {
    page.line("The text of {} was not found; --source FOLDER tells where to look", file);
  }
}

void write_line(Page& page, const AnnotatedLine& line, Cycles whole, const Style& style) {
  const std::string number = line.line > 0 ? fmt::format("{:>5}", line.line) : "     ";
  page.line("{} {} {}", columns(line, whole, style), style.dim(number),
            line.source ? style.bold(*line.source) : "");
  for (const AnnotatedPacket& packet : line.code) {
    for (const std::string& label : packet.labels) {
      page.line("{:{}}{}", "", kLabelColumn, style.dim(label + ":"));
    }
    page.line("{}         {}", columns(packet, whole, style),
              style.dim(fmt::format("{:08x}  {}", packet.address, packet.text)));
  }
}

Json packet_json(const AnnotatedPacket& packet) {
  return {{"address", fmt::format("{:#010x}", packet.address)},
          {"labels", packet.labels},
          {"text", packet.text},
          {"executions", packet.executions},
          {"cycles", packet.cycles},
          {"causes", named_numbers(packet.causes)},
          {"bytes", named_numbers(packet.bytes)}};
}

Json line_json(const AnnotatedLine& line) {
  Json code = Json::array();
  for (const AnnotatedPacket& packet : line.code) {
    code.push_back(packet_json(packet));
  }
  return {{"file", line.file},
          {"line", line.line},
          {"source", line.source ? Json(*line.source) : Json()},
          {"executions", line.executions},
          {"packets", line.packets},
          {"cycles", line.cycles},
          {"causes", named_numbers(line.causes)},
          {"bytes", named_numbers(line.bytes)},
          {"code", std::move(code)}};
}

}  // namespace

std::string to_text(const Annotation& annotation, const Style& style) {
  Page page;
  write_head(page, annotation, style);
  const std::string* file = nullptr;
  int previous = 0;
  for (const AnnotatedLine& line : annotation.lines) {
    if (file == nullptr || *file != line.file) {
      page.line("\n{:>12} {:>6} {:>11}  {:<{}} {}", "cycles", "%", "executions", "stalled by",
                kStallWidth, line.file.empty() ? "(code without a line)" : line.file);
      file = &line.file;
    } else if (line.line > previous + 1) {
      page.line("{:{}}  ...", "", kSourceColumn);
    }
    previous = line.line;
    write_line(page, line, annotation.cost.exclusive, style);
  }
  return page.take();
}

std::string to_json(const Annotation& annotation) {
  const Function& f = annotation.cost;
  Json lines = Json::array();
  for (const AnnotatedLine& line : annotation.lines) {
    if (!line.code.empty()) {
      lines.push_back(line_json(line));
    }
  }
  const Json document = {{"schema_version", 1},
                         {"core", annotation.core},
                         {"function", annotation.function},
                         {"region", annotation.region},
                         {"address", fmt::format("{:#010x}", annotation.address)},
                         {"code_bytes", f.code_bytes},
                         {"calls", f.calls},
                         {"inclusive_cycles", f.inclusive},
                         {"exclusive_cycles", f.exclusive},
                         {"core_cycles", annotation.core_cycles},
                         {"causes", named_numbers(f.causes)},
                         {"bytes", named_numbers(f.bytes)},
                         {"lines", std::move(lines)}};
  return document.dump(2) + "\n";
}

}  // namespace finback::report
