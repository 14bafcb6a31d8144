#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <map>

#include <common/error.hpp>
#include <common/parameter.hpp>
#include <explorer/table_writer.hpp>

namespace finback::explorer {

namespace {

constexpr std::size_t kWidest = 100;  // characters, beyond which columns are called by letters

struct TableColumn {
  std::string heading;
  std::string full;  // what a letter stands for
  bool number = false;
  bool named = false;  // keeps its heading
  std::vector<std::string> cells;
  [[nodiscard]] std::size_t width() const {
    std::size_t width = heading.size();
    for (const std::string& cell : cells) {
      width = std::max(width, cell.size());
    }
    return width;
  }
};

// What reasons are grouped by: the text without its numbers ("but of 32768 bytes 19200 are taken").
std::string gist_of(const std::string& reason) {
  std::string gist;
  for (const char c : reason) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 || (!gist.empty() && gist.back() != ' ')) {
      gist += c;
    }
  }
  return gist;
}

// The part of an axis's name that tells it from the others: "shd_scores" of "core_b.shd_scores".
std::string short_name(const Space& space, const Axis& axis) {
  const std::size_t dot = axis.kind == AxisKind::placement ? axis.name.find('.')
                          : axis.kind == AxisKind::machine ? axis.name.rfind('.')
                                                           : std::string::npos;
  if (dot == std::string::npos) {
    return axis.name;
  }
  const std::string ending = axis.name.substr(dot);
  const auto same = std::ranges::count_if(
      space.axes, [&](const Axis& other) { return other.name.ends_with(ending); });
  return same == 1 ? ending.substr(1) : axis.name;
}

class TableWriter {
 public:
  TableWriter(const Space& space, const Findings& findings, const TableOptions& options)
      : space_(space), findings_(findings), options_(options), shown_(shown_metrics(space)) {}

  std::string take() {
    sort_rows();
    write_table();
    write_reasons();
    write_front();
    write_goal();
    return std::move(text_);
  }

 private:
  template <class... Values>
  void line(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
    text_.erase(text_.find_last_not_of(' ') + 1);
    text_ += '\n';
  }

  // --- the order of the rows ---

  void sort_rows() {
    for (const Row& row : findings_.rows) {
      order_.push_back(&row);
    }
    const auto rank = [this](const Row& row) {
      return row.state != State::done ? 2 : options_.sort.empty() && !row.on_front ? 1 : 0;
    };
    const auto value = sort_value();
    const double sign = options_.descending ? -1 : 1;
    std::ranges::stable_sort(order_, [&](const Row* one, const Row* other) {
      return std::pair(rank(*one), sign * value(*one)) <
             std::pair(rank(*other), sign * value(*other));
    });
  }

  std::function<double(const Row&)> sort_value() const {
    const auto axis = std::ranges::find(space_.axes, options_.sort, &Axis::name);
    if (axis != space_.axes.end()) {
      return [index = axis - space_.axes.begin()](const Row& row) {
        return static_cast<double>(row.candidate->point[static_cast<std::size_t>(index)]);
      };
    }
    const std::string metric = options_.sort.empty() ? "power_watts" : metric_of(options_.sort);
    return [metric](const Row& row) {
      return row.value(metric).value_or(std::numeric_limits<double>::infinity());
    };
  }

  // --- the table ---

  void write_table() {
    shown_rows_ = options_.limit == 0 ? order_.size() : std::min(options_.limit, order_.size());
    std::vector<TableColumn> columns = table_columns();
    std::size_t width = 0;
    for (const TableColumn& column : columns) {
      width += column.width() + 2;
    }
    if (width > kWidest) {
      name_by_letters(columns);
    }
    const std::size_t numbers = first_metric_;
    for (std::size_t row = 0; row <= shown_rows_; ++row) {
      std::string text;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const TableColumn& column = columns[i];
        const bool ran = row == 0 || order_[row - 1]->state == State::done;
        if (!ran && i == numbers) {
          text += "  " + why(*order_[row - 1]);
          break;
        }
        const std::string& cell = row == 0 ? column.heading : column.cells[row - 1];
        text += fmt::format(fmt::runtime(column.number ? "  {:>{}}" : "  {:<{}}"), cell,
                            column.width());
      }
      line("{}", text);
    }
    if (shown_rows_ < order_.size()) {
      line("  ... and {} more; --limit 0 shows all, --csv FILE keeps them",
           order_.size() - shown_rows_);
    }
  }

  std::vector<TableColumn> table_columns() {
    std::vector<TableColumn> columns = {{"point", "", true, true, {}}, {"", "", false, true, {}}};
    for (std::size_t row = 0; row < shown_rows_; ++row) {
      columns[0].cells.push_back(std::to_string(order_[row]->number));
      columns[1].cells.emplace_back(order_[row]->on_front ? "*" : "");
    }
    for (std::size_t i = 0; i < space_.axes.size(); ++i) {
      const Axis& axis = space_.axes[i];
      if (axis.choices.size() < 2) {
        continue;
      }
      TableColumn column{short_name(space_, axis),
                         axis.name,
                         axis.kind == AxisKind::machine,
                         axis.kind == AxisKind::clock,
                         {}};
      for (std::size_t row = 0; row < shown_rows_; ++row) {
        column.cells.push_back(axis.choices[order_[row]->candidate->point[i]].text);
      }
      columns.push_back(std::move(column));
    }
    first_metric_ = columns.size();
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      TableColumn column{shown_[i].heading, shown_[i].metric, true, shown_[i].decimals >= 0, {}};
      for (std::size_t row = 0; row < shown_rows_; ++row) {
        column.cells.push_back(order_[row]->state == State::done
                                   ? shown_[i].text(order_[row]->value(shown_[i].metric))
                                   : "");
      }
      columns.push_back(std::move(column));
    }
    return columns;
  }

  void name_by_letters(std::vector<TableColumn>& columns) {
    int next = 0;
    line("Columns");
    for (TableColumn& column : columns) {
      if (!column.named && next < 26) {
        column.heading = std::string(1, static_cast<char>('a' + next++));
        line("  {}  {}", column.heading, column.full);
      }
    }
    line("");
  }

  // --- what did not run ---

  struct Reason {
    std::size_t number = 0;
    std::size_t points = 0;
    std::string first;  // as the first point tells it
  };

  Reason& reason_of(const Row& row) {
    const auto [found, is_new] = reasons_.try_emplace({row.state, gist_of(row.reason)});
    if (is_new) {
      found->second = {reasons_.size(), 0, row.reason};
    }
    return found->second;
  }

  // "does not fit [1]": the reasons stand below the table.
  std::string why(const Row& row) {
    return fmt::format("{} [{}]", name_of(row.state), reason_of(row).number);
  }

  void write_reasons() {
    for (const Row* row : order_) {
      if (row->state != State::done) {
        ++reason_of(*row).points;
      }
    }
    std::vector<std::string> lines(reasons_.size());
    for (const auto& [key, reason] : reasons_) {
      lines[reason.number - 1] =
          fmt::format("  [{}] {}, {} point{}: {}", reason.number, name_of(key.first), reason.points,
                      reason.points == 1 ? "" : "s", reason.first);
    }
    if (!lines.empty()) {
      line("\n{}", fmt::join(lines, "\n"));
    }
  }

  // --- the summary ---

  [[nodiscard]] std::string describe(const Row& row) const {
    return fmt::format(
        "point {}: {} W at {} fps, {} mJ a frame, latency {} ms", row.number,
        shown_[1].text(row.value(shown_[1].metric)), shown_[0].text(row.value(shown_[0].metric)),
        shown_[2].text(row.value(shown_[2].metric)), shown_[3].text(row.value(shown_[3].metric)));
  }

  void write_front() {
    const auto done = std::ranges::count(findings_.rows, State::done, &Row::state);
    if (done == 0) {
      line("\nNo point has run to its end.");
      return;
    }
    std::vector<std::size_t> numbers;
    for (const std::size_t index : findings_.front) {
      numbers.push_back(findings_.rows[index].number);
    }
    line("\nFront (*): {} of {} points, from the thriftiest to the fastest: {}", numbers.size(),
         done, fmt::join(numbers, " "));
    const Row& fastest = first_as_fast_as(findings_.rows[findings_.front.back()]);
    line("  thriftiest  {}", describe(findings_.rows[findings_.front.front()]));
    line("  fastest     {}", describe(fastest));
    if (space_.goal.empty()) {
      write_command(fastest);
    }
  }

  // Of equal points of the front the one with the smallest number.
  [[nodiscard]] const Row& first_as_fast_as(const Row& row) const {
    const auto found = std::ranges::find_if(findings_.front, [&](std::size_t index) {
      return findings_.rows[index].value("frames_per_second") == row.value("frames_per_second");
    });
    return findings_.rows[*found];
  }

  void write_goal() {
    if (space_.goal.empty()) {
      return;
    }
    if (!findings_.best) {
      line("\nGoal {}: no point makes it{}", goal_text(space_), nearest_to_goal());
      return;
    }
    line("\nGoal {}, with the least watts:", goal_text(space_));
    line("  {}", describe(findings_.rows[*findings_.best]));
    write_command(findings_.rows[*findings_.best]);
  }

  // Of a goal with one bound: how near the nearest comes.
  [[nodiscard]] std::string nearest_to_goal() const {
    const Requirement& bound = space_.goal.front();
    const Row* nearest = nullptr;
    for (const Row& row : findings_.rows) {
      const auto value = row.value(bound.metric);
      const auto best = nearest == nullptr ? value : nearest->value(bound.metric);
      if (value && (nearest == nullptr || (bound.at_least ? *value > *best : *value < *best))) {
        nearest = &row;
      }
    }
    return space_.goal.size() > 1 || nearest == nullptr
               ? ""
               : fmt::format("; the nearest is point {} with {}", nearest->number,
                             report::metric_text(*nearest->value(bound.metric)));
  }

  void write_command(const Row& row) {
    line("\nTo run point {} again (--point N tells it of others):\n  {}", row.number,
         run_command(space_, row.candidate->point));
  }

  const Space& space_;
  const Findings& findings_;
  const TableOptions& options_;
  std::vector<ShownMetric> shown_;
  std::vector<const Row*> order_;
  std::size_t shown_rows_ = 0;
  std::size_t first_metric_ = 0;
  std::map<std::pair<State, std::string>, Reason> reasons_;  // by their gist
  std::string text_;
};

}  // namespace

std::string to_table(const Space& space, const Findings& findings, const TableOptions& options) {
  return TableWriter(space, findings, options).take();
}

std::string misfits_text(const std::vector<Candidate>& candidates) {
  struct Group {
    std::string first;
    std::vector<std::size_t> points;
  };
  std::map<std::string, Group> groups;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!candidates[i].misfit.empty()) {
      Group& group = groups[gist_of(candidates[i].misfit)];
      group.first = group.points.empty() ? candidates[i].misfit : group.first;
      group.points.push_back(i + 1);
    }
  }
  constexpr std::size_t kShown = 12;
  std::string text;
  for (auto& [gist, group] : groups) {
    const std::size_t count = group.points.size();
    group.points.resize(std::min(count, kShown));
    fmt::format_to(std::back_inserter(text), "Does not fit, {} point{} ({}{}): {}\n", count,
                   count == 1 ? "" : "s", fmt::join(group.points, " "),
                   count > kShown ? " ..." : "", group.first);
  }
  return text;
}

}  // namespace finback::explorer
