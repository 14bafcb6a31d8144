#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <system_error>
#include <thread>

#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <explorer/csv_writer.hpp>
#include <explorer/exploration.hpp>
#include <explorer/plot.hpp>
#include <explorer/table_writer.hpp>

namespace finback::cli {

namespace {

namespace fs = std::filesystem;
using namespace explorer;

constexpr const char* kExploreExamples =
    "Examples:\n"
    "  finback explore space.toml\n"
    "  finback explore space.toml --csv points.csv --plot points.svg\n"
    "  finback explore space.toml --dry-run\n"
    "  finback explore space.toml --sort level.l3.bytes_per_frame --limit 10\n"
    "Results are kept: what was simulated once is not simulated again. More: "
    "docs/finback-explore.md";

struct ExploreOptions {
  std::string space;
  std::string database;
  std::string csv;
  std::string plot;
  std::vector<std::string> columns;
  TableOptions table;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::uint64_t point = 0;
  bool dry_run = false;
};

std::string duration_text(double seconds) {
  const auto whole = std::lround(seconds);
  return whole < 60     ? fmt::format("{} s", whole)
         : whole < 3600 ? fmt::format("{} min {:02} s", whole / 60, whole % 60)
                        : fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

// "12/64 points, 480 a minute, 7 s left"
std::string progress_text(std::size_t done, std::size_t points, double seconds) {
  std::string text = fmt::format("{}/{} points", done, points);
  if (done > 0) {
    const double rate = static_cast<double>(done) / seconds;
    text += fmt::format(", {:.0f} a minute, {} left", rate * 60,
                        duration_text(static_cast<double>(points - done) / rate));
  }
  return text;
}

// What would fail at the end is better known at the beginning.
void check_output(const char* option, const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!path.empty() && !folder.empty() && !fs::is_directory(folder, error)) {
    throw InputError(
        fmt::format("{} {}: there is no folder {}; make it first", option, path, folder.string()));
  }
  if (fs::is_directory(path, error)) {
    throw InputError(fmt::format("{} {}: is a folder, a file is wanted", option, path));
  }
}

fs::path database_of(const ExploreOptions& options) {
  return options.database.empty()
             ? fs::path("out") / (fs::path(options.space).stem().string() + ".sqlite")
             : fs::path(options.database);
}

bool is_axis(const Space& space, const std::string& name) {
  return std::ranges::find(space.axes, name, &Axis::name) != space.axes.end();
}

int print_point(const ExploreOptions& options, const Space& space,
                const std::vector<Point>& points) {
  if (options.point > points.size()) {
    throw InputError(
        fmt::format("--point {}: {} has {} points", options.point, options.space, points.size()));
  }
  fmt::print("{}\n", run_command(space, points[options.point - 1]));
  return kFine;
}

int dry_run(const ExploreOptions& options, const std::vector<Candidate>& candidates) {
  const Plan plan = plan_of(candidates, Store::peek(database_of(options)));
  fmt::print("{}: {}\n{}", options.space, plan.to_string(), misfits_text(candidates));
  return kFine;
}

// Simulates what is missing; false: interrupted.
bool fill(const ExploreOptions& options, const Space& space,
          const std::vector<Candidate>& candidates, const std::vector<Column>& asked,
          Store& store) {
  const Plan plan = plan_of(candidates, store.keys());
  fmt::print(stderr, "{}: {}\n", options.space, plan.to_string());
  // A firmware's metrics are known with its first result: a name with a slip ends it then.
  bool to_check = space.firmwares.size() == 1;
  if (to_check && plan.known > 0 && !store.metric_names().empty()) {
    check_metrics(asked, store.metric_names());
  }
  const std::size_t points = plan.to_simulate.size();
  ProgressBar progress(points);
  Observer observer;
  observer.watch = [&](std::size_t done) {
    progress.show(done, [&] { return progress_text(done, points, progress.seconds()); });
    return interrupted();
  };
  observer.finished = [&](const Candidate&, const Result& result) {
    if (to_check && result.fault.empty()) {
      to_check = false;
      check_metrics(asked, store.metric_names());
    }
  };
  const std::size_t done = simulate(space, candidates, plan, store, options.jobs, observer);
  if (done == points) {
    return true;
  }
  progress.wipe();
  fmt::print(stderr,
             "finback: interrupted; {} of {} simulations are kept in {}; the same "
             "command goes on from there\n",
             done, points, database_of(options).string());
  return false;
}

int explore(const ExploreOptions& options) {
  catch_interrupts();
  check_output("--csv", options.csv);
  check_output("--plot", options.plot);
  if (!options.plot.empty()) {
    check_plot(options.plot);
  }
  Space space = load_space(options.space);
  for (const std::string& column : options.columns) {
    space.columns.push_back({column, SourcePlace{"--column " + column}});
  }
  const std::vector<Point> points = points_of(space);
  if (options.point > 0) {
    return print_point(options, space, points);
  }
  const std::vector<Candidate> candidates = prepare(space, points, interrupted);
  if (interrupted()) {
    fmt::print(stderr, "finback: interrupted; nothing was simulated\n");
    return kInterrupted;
  }
  if (options.dry_run) {
    return dry_run(options, candidates);
  }
  std::vector<Column> asked = asked_metrics(space);
  if (!options.table.sort.empty() && !is_axis(space, options.table.sort)) {
    asked.push_back({metric_of(options.table.sort), SourcePlace{"--sort " + options.table.sort}});
  }

  Store store(database_of(options));
  if (!fill(options, space, candidates, asked, store)) {
    return kInterrupted;
  }
  const std::vector<std::string> known = store.metric_names();
  const Findings findings = findings_of(space, candidates, store, asked);
  store.finish();
  if (!known.empty()) {
    check_metrics(asked, known);
  }
  if (!options.csv.empty()) {
    write_file_whole(options.csv, to_csv(space, findings));
  }
  if (!options.plot.empty()) {
    write_plot(space, findings, options.plot);
  }
  fmt::print("{}", to_table(space, findings, options.table));
  return kFine;
}

}  // namespace

void add_explore_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExploreOptions>();
  CLI::App* command = app.add_subcommand(
      "explore", "Run many placements, machines and clocks: which is fast, which is thrifty?");
  command->footer(kExploreExamples);
  command->add_option("space", options->space, "The space to explore (TOML)")
      ->type_name("SPACE.toml")
      ->required();
  command
      ->add_option("--db", options->database,
                   "Where results are kept (SQLite) (default: out/SPACE.sqlite)")
      ->type_name("FILE");
  command->add_option("--jobs", options->jobs, "Simulations at a time")
      ->capture_default_str()
      ->check(CLI::Range(1U, kMostJobs));
  command->add_option("--csv", options->csv, "Also write all points to this file")
      ->type_name("FILE");
  command->add_option("--plot", options->plot, "Also draw frames a second against watts")
      ->type_name("FILE.svg|FILE.png");
  command
      ->add_option("--column", options->columns,
                   "Show another metric (docs/metrics.md); repeatable")
      ->type_name("METRIC")
      ->allow_extra_args(false);
  command
      ->add_option("--sort", options->table.sort,
                   "Order the table by a metric, fps, watts, energy, latency or an axis "
                   "(default: the front, then by watts)")
      ->type_name("COLUMN");
  command->add_flag("--descending", options->table.descending, "The largest first");
  command->add_option("--limit", options->table.limit, "Rows of the table; 0: all")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->add_option("--point", options->point, "Only print the command that runs this point")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->add_flag("--dry-run", options->dry_run, "Count the points and what does not fit");
  command->callback([&action, options] { action = [options] { return explore(*options); }; });
}

}  // namespace finback::cli
