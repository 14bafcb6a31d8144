#include <fmt/format.h>

#include <common/csv.hpp>
#include <explorer/csv_writer.hpp>

namespace finback::explorer {

namespace {

class Lines {
 public:
  void field(const std::string& text) {
    text_ += begun_ ? "," : "";
    text_ += csv_field(text);
    begun_ = true;
  }
  void end() {
    text_ += '\n';
    begun_ = false;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  bool begun_ = false;
};

}  // namespace

std::string to_csv(const Space& space, const Findings& findings) {
  const std::vector<ShownMetric> shown = shown_metrics(space);
  Lines lines;
  for (const char* name : {"point", "state", "front"}) {
    lines.field(name);
  }
  for (const Axis& axis : space.axes) {
    lines.field(axis.name);
  }
  for (const ShownMetric& metric : shown) {
    lines.field(metric.metric);
  }
  lines.field("reason");
  lines.field("command");
  lines.end();
  for (const Row& row : findings.rows) {
    lines.field(std::to_string(row.number));
    lines.field(name_of(row.state));
    lines.field(row.on_front ? "1" : "0");
    for (std::size_t axis = 0; axis < space.axes.size(); ++axis) {
      lines.field(space.axes[axis].choices[row.candidate->point[axis]].text);
    }
    for (const ShownMetric& metric : shown) {
      const auto value = row.value(metric.metric);
      lines.field(value ? number_text(*value) : "");
    }
    lines.field(row.reason);
    lines.field(run_command(space, row.candidate->point));
    lines.end();
  }
  return lines.take();
}

}  // namespace finback::explorer
