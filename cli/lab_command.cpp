// `finback lab`: the ladder of optimisations, rung by rung and side by side.
#include <cstdio>
#include <fmt/format.h>
#include <memory>

#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <cli/watched_run.hpp>
#include <common/gnuplot.hpp>
#include <report/climb_plot.hpp>
#include <report/comparison.hpp>
#include <report/sections.hpp>
#include <runner/ladder.hpp>

namespace finback::cli {

namespace {

using runner::Rung;

constexpr const char* kLabExamples =
    "Examples:\n"
    "  finback lab list\n"
    "  finback lab run modular\n"
    "  finback lab diff modular popcount\n"
    "  finback lab compare naive packed two_cores\n"
    "  finback lab climb --plot ladder.svg\n"
    "More: docs/finback-lab.md";

constexpr std::size_t kFunctionsShown = 6;
constexpr std::size_t kObjectsShown = 5;
constexpr double kSecondsPerFrame = 100;  // the bottom rung needs 33

struct LabOptions {
  runner::RunRequest request;
  std::vector<std::string> rungs;
  std::string plot;
  bool json = false;
  bool csv = false;
};

struct Runs {
  std::vector<report::NamedResult> results;
  std::string differing;  // as runner::differing_maps says
};

runner::RunInputs inputs_of(const LabOptions& options, const Rung& rung) {
  runner::RunRequest request = options.request;
  request.firmware = rung.firmware;
  if (request.max_seconds == 0) {
    request.max_seconds = kSecondsPerFrame * request.frames;
  }
  return runner::load_inputs(request);
}

// Runs every rung; nothing when Ctrl-C ended it.
std::optional<Runs> run_all(const LabOptions& options, const std::vector<Rung>& rungs) {
  catch_interrupts();
  std::vector<runner::RunInputs> inputs;  // all before the first run: what is wrong shows at once
  inputs.reserve(rungs.size());
  for (const Rung& rung : rungs) {
    inputs.push_back(inputs_of(options, rung));
  }
  Runs runs;
  std::vector<std::string> names;
  std::vector<std::vector<machine::PublishedMap>> maps;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    std::optional<runner::RunOutcome> outcome = run_watched(inputs[i]);
    if (!outcome) {
      return std::nullopt;
    }
    names.push_back(rungs[i].name);
    maps.push_back(std::move(outcome->maps));
    runs.results.push_back({rungs[i].name, std::move(outcome->result)});
  }
  runs.differing = runner::differing_maps(names, maps);
  return runs;
}

// The end of every command: maps that should be equal and are not.
int verdict_on(const Runs& runs, bool say_equal) {
  if (!runs.differing.empty()) {
    fmt::print(stderr, "finback: {}\n", runs.differing);
    return kBadInput;
  }
  const std::size_t count = runs.results.size();
  if (say_equal && count > 1) {
    fmt::print("\nThe maps of {} are equal in every pixel.\n",
               count == 2 ? "both" : fmt::format("all {}", count));
  }
  return kFine;
}

// Prints the runs as they are wanted: for programs, or as `text` makes a page of them.
template <class Text>
int tell(const LabOptions& options, const Runs& runs, const Text& text) {
  fmt::print("{}", options.json  ? report::comparison_json(runs.results)
                   : options.csv ? report::comparison_csv(runs.results)
                                 : text());
  return verdict_on(runs, !options.json && !options.csv);
}

// What was run, and a table below it.
std::string under_setting(const report::RunResult& r, const std::string& table) {
  return fmt::format("Scene {}, machine {}, {} frame{}, CCLK {:.0f} MHz\n\n{}",
                     r.provenance.scene.name, r.provenance.machine.name, r.frames.size(),
                     r.frames.size() == 1 ? "" : "s", r.core_hertz / 1e6, table);
}

int list_rungs() {
  const std::vector<Rung> ladder = runner::load_ladder();
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    fmt::print("{:>3} {:<11} {}\n", i + 1, ladder[i].name, ladder[i].change);
  }
  return kFine;
}

int run_one(const LabOptions& options) {
  const std::vector<Rung> ladder = runner::load_ladder();
  const Rung rung = runner::find_rung(ladder, options.rungs.front());
  const auto at = std::ranges::find(ladder, rung.name, &Rung::name);
  std::vector<Rung> rungs{rung};
  if (at != ladder.end() && at != ladder.begin()) {
    rungs.insert(rungs.begin(), *std::prev(at));
  }
  const std::optional<Runs> runs = run_all(options, rungs);
  if (!runs) {
    return kInterrupted;
  }
  return tell(options, *runs, [&] {
    const report::RunResult& result = runs->results.back().result;
    report::Page page;
    report::write_functions(page, result, kFunctionsShown);
    report::write_objects(page, result, kObjectsShown);
    return fmt::format("{}{}{}\n{}{}", rung.name, rung.change.empty() ? "" : ": ", rung.change,
                       under_setting(result, report::comparison_text(runs->results)), page.take());
  });
}

int compare(const LabOptions& options) {
  const std::vector<Rung> ladder = runner::load_ladder();
  std::vector<Rung> rungs;
  for (const std::string& name : options.rungs) {
    rungs.push_back(runner::find_rung(ladder, name));
  }
  const std::optional<Runs> runs = run_all(options, rungs);
  if (!runs) {
    return kInterrupted;
  }
  return tell(options, *runs, [&] {
    return under_setting(runs->results.front().result, report::comparison_text(runs->results));
  });
}

int climb(const LabOptions& options) {
  if (!options.plot.empty()) {
    check_plot_path("--plot", options.plot);
  }
  const std::optional<Runs> runs = run_all(options, runner::load_ladder());
  if (!runs) {
    return kInterrupted;
  }
  if (!options.plot.empty()) {
    draw_plot([&](const auto& output) { return report::climb_plot(runs->results, output); },
              options.plot);
  }
  return tell(options, *runs, [&] {
    return under_setting(runs->results.front().result, report::climb_text(runs->results));
  });
}

int diff(const LabOptions& options) {
  const std::vector<Rung> ladder = runner::load_ladder();
  fmt::print("{}", runner::rung_diff(runner::find_rung(ladder, options.rungs.front()),
                                     runner::find_rung(ladder, options.rungs.back())));
  return kFine;
}

CLI::App* add_running(CLI::App& lab, const std::string& name, const std::string& what,
                      LabOptions& options) {
  CLI::App* command = lab.add_subcommand(name, what);
  options.request.frames = 1;
  CLI::Option* json = command->add_flag("--json", options.json, "Print JSON instead");
  command->add_flag("--csv", options.csv, "Print CSV instead")->excludes(json);
  add_run_options(*command, options.request);
  command->remove_option(command->get_option("--firmware"));
  return command;
}

}  // namespace

void add_lab_command(CLI::App& app, Action& action) {
  CLI::App* lab = app.add_subcommand(
      "lab", "The ladder for teaching: one matching in ten rungs, each faster than the last");
  lab->require_subcommand(1);
  lab->footer(kLabExamples);
  const auto options = std::make_shared<LabOptions>();
  const auto acts = [&action, options](CLI::App* command, int (*what)(const LabOptions&)) {
    command->callback([&action, options, what] { action = [=] { return what(*options); }; });
  };

  lab->add_subcommand("list", "The rungs, and what each changes")->callback([&action] {
    action = list_rungs;
  });
  CLI::App* run = add_running(*lab, "run", "One rung beside the one before", *options);
  run->add_option("RUNG", options->rungs, "Its name, or the path of a firmware")
      ->required()
      ->expected(1);
  acts(run, run_one);
  CLI::App* side = add_running(*lab, "compare", "Rungs side by side", *options);
  side->add_option("RUNG", options->rungs, "Their names, or paths of firmwares")
      ->required()
      ->expected(2, 16);
  acts(side, compare);
  CLI::App* all = add_running(*lab, "climb", "All rungs, a line each", *options);
  all->add_option("--plot", options->plot, "Also draw cycles a frame of every rung")
      ->type_name("FILE.svg|FILE.png");
  acts(all, climb);
  CLI::App* changes = lab->add_subcommand("diff", "What to change to get from one rung to another");
  changes->add_option("RUNG", options->rungs, "Two names, or paths of firmwares")
      ->required()
      ->expected(2);
  acts(changes, diff);
}

}  // namespace finback::cli
