#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <tracing/writers.hpp>

#include <isa_sim/isa/syntax.hpp>

namespace finback::tracing {

using core::Cause;
using core::TraceCost;
using core::TraceRecord;

namespace {

// Widths of the columns that hold names: as wide as the widest, within reason.
struct Widths {
  std::size_t where = 5;
  std::size_t line = 4;
  std::size_t code = 4;
};
constexpr std::size_t kMostWhere = 36;
constexpr std::size_t kMostLine = 24;
constexpr std::size_t kMostCode = 56;

struct Row {
  std::string where;
  std::string line;
  std::string code;
  std::string why;
};

Row row_of(const Recorded& recorded, Code& code) {
  const TraceRecord& record = recorded.record;
  Row row{code.where(recorded.core, record.packet), code.line(recorded.core, record.packet), "",
          ""};
  switch (record.kind) {
    case TraceRecord::Kind::packet:
      row.code = code.text(recorded.core, record.packet);
      break;
    case TraceRecord::Kind::undone:
      row.code = "(undone by an exception) " + code.text(recorded.core, record.packet);
      break;
    case TraceRecord::Kind::entry:
      row.code = "(on the way into the handler)";
      break;
    case TraceRecord::Kind::sleep:
      row.code = "(asleep)";
      break;
  }
  for (const TraceCost& cost : record.costs) {
    if (cost.cause != Cause::issue) {
      row.why += (row.why.empty() ? "" : ", ") + describe(cost, recorded.core, code);
    }
  }
  return row;
}

void write_sums(report::Page& page, CoreId core, std::span<const Recorded> records) {
  core::CauseCycles causes{};
  Cycles cycles = 0;
  std::uint64_t packets = 0;
  for (const Recorded& recorded : records) {
    if (recorded.core != core) {
      continue;
    }
    packets += recorded.record.kind == TraceRecord::Kind::packet ? 1 : 0;
    cycles += recorded.record.cycles;
    for (const TraceCost& cost : recorded.record.costs) {
      causes[static_cast<std::size_t>(cost.cause)] += cost.cycles;
    }
  }
  if (cycles == 0) {
    return;
  }
  std::string text;
  for (std::size_t cause = 0; cause < causes.size(); ++cause) {
    if (causes[cause] > 0) {
      text +=
          fmt::format("{}{} {}", text.empty() ? "" : ", ", core::kCauseNames[cause], causes[cause]);
    }
  }
  page.line("{}: {} packets in {} cycles: {}", name_of(core), packets, cycles, text);
}

}  // namespace

std::string describe(const TraceCost& cost, CoreId core, const Code& code) {
  std::string text =
      fmt::format("{} {}", cost.cycles, core::kCauseNames[static_cast<std::size_t>(cost.cause)]);
  if (cost.reg != core::kNoRegister) {
    text += fmt::format(" of {}", isa::register_name(static_cast<isa::Register>(cost.reg)));
  } else if (cost.address != 0) {
    text += fmt::format(" of {}", code.data(core, cost.address));
  }
  return text;
}

std::string to_text(std::span<const Recorded> records, Code& code, const report::Style& style) {
  std::vector<Row> rows;
  rows.reserve(records.size());
  Widths widths;
  for (const Recorded& recorded : records) {
    rows.push_back(row_of(recorded, code));
    const Row& row = rows.back();
    widths.where = std::max(widths.where, std::min(kMostWhere, row.where.size()));
    widths.line = std::max(widths.line, std::min(kMostLine, row.line.size()));
    widths.code = std::max(widths.code, std::min(kMostCode, row.code.size()));
  }
  report::Page page;
  page.line("{}",
            style.dim(fmt::format("core       cycle cycles  {:<{}}  {:<{}}  {:<{}}  waits", "where",
                                  widths.where, "line", widths.line, "code", widths.code)));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TraceRecord& record = records[i].record;
    const Row& row = rows[i];
    page.line("{}    {:>11} {:>6}  {:<{}}  {:<{}}  {:<{}}  {}",
              records[i].core == CoreId::a ? 'a' : 'b', record.begin, record.cycles, row.where,
              widths.where, row.line, widths.line, row.code, widths.code,
              row.why.empty() ? "" : style.heat(row.why, record.cycles > 9 ? 10 : 1));
  }
  page.line("");
  for (const CoreId core : {CoreId::a, CoreId::b}) {
    write_sums(page, core, records);
  }
  return page.take();
}

}  // namespace finback::tracing
