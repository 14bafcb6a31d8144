#include <fmt/format.h>
#include <memory>
#include <optional>
#include <system_error>

#include <budget/numbers.hpp>
#include <budget/verdict.hpp>
#include <budget/writers.hpp>
#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <cli/watched_run.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <common/parameter.hpp>
#include <common/pattern.hpp>
#include <report/json_reader.hpp>
#include <report/json_writer.hpp>
#include <runner/run_table.hpp>

namespace finback::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCheckExamples =
    "Examples:\n"
    "  finback check budgets.toml\n"
    "  finback check budgets.toml --list 'core_b.*'\n"
    "  finback check budgets.toml --junit budget.xml --markdown comment.md --github\n"
    "  finback check budgets.toml --update-baseline\n"
    "Exits with 3 when a limit is broken. More: docs/finback-check.md";

struct CheckOptions {
  runner::RunRequest given;  // on the command line, over the file's [run]
  std::string budget;
  std::string result;
  std::string pattern;  // of --list
  std::string junit;
  std::string markdown;
  bool list = false;
  bool update = false;
  bool github = false;
  bool all = false;
};

// What is judged, and what messages call it.
struct Judged {
  report::RunResult result;
  std::string name;
};

// Runs what [run] and the command line say, or loads --result. Empty when interrupted.
std::optional<Judged> obtain(const CheckOptions& options, const runner::RunRequest& request) {
  if (!options.result.empty()) {
    return Judged{report::load_result(options.result), options.result};
  }
  std::optional<runner::RunOutcome> outcome = run_watched(runner::load_inputs(request));
  if (!outcome) {
    return std::nullopt;
  }
  return Judged{std::move(outcome->result), "this run"};
}

runner::RunRequest request_of(const CLI::App& command, const CheckOptions& options,
                              const TomlReader& reader, const budget::Budget& budget) {
  runner::RunRequest request;
  const toml::table* table = reader.table(reader.root(), "run");
  if (table != nullptr) {
    request = runner::read_run_request(reader, *table);
  }
  if (!budget.firmware.empty() && (table == nullptr || !table->contains("firmware"))) {
    request.firmware = budget.firmware;
  }
  return with_given_options(command, options.given, request);
}

report::RunResult load_baseline(const budget::Budget& budget) {
  std::error_code error;
  if (!fs::exists(budget.baseline, error)) {
    throw InputError(SourcePlace{budget.file},
                     fmt::format("the baseline {} is not there; finback check {} "
                                 "--update-baseline writes it",
                                 budget.baseline.string(), budget.file));
  }
  return report::load_result(budget.baseline);
}

int list(const CheckOptions& options, const report::RunResult& result) {
  std::size_t width = 0;
  std::vector<std::string> names;
  const budget::Metrics metrics = report::metrics_of(result);
  for (const auto& [name, metric] : metrics) {
    names.push_back(name);
    width = matches_pattern(options.pattern, name) ? std::max(width, name.size()) : width;
  }
  if (width == 0) {
    const std::string near = nearest_name(options.pattern, names);
    throw InputError(fmt::format("--list {}: no metric has such a name{}", options.pattern,
                                 near.empty() ? "; without a pattern it shows all"
                                              : fmt::format(", did you mean {}?", near)));
  }
  for (const auto& [name, metric] : metrics) {
    if (matches_pattern(options.pattern, name)) {
      fmt::print("{:<{}}  {}{}{}\n", name, width, budget::number_text(metric.value),
                 metric.unit.empty() ? "" : " ", metric.unit);
    }
  }
  return kFine;
}

// What the new baseline takes the place of.
struct Replaced {
  std::optional<report::RunResult> result;  // when the new one can be compared with it
  std::string how;
};

Replaced replaced_by(const budget::Budget& budget, const Judged& judged) {
  std::error_code error;
  if (!fs::exists(budget.baseline, error)) {
    return {std::nullopt, "a first baseline"};
  }
  try {
    report::RunResult old = report::load_result(budget.baseline);
    budget::require_comparable(budget, judged.result, judged.name, &old);
    const bool same = report::to_json(old) == report::to_json(judged.result);
    return {std::move(old), same ? "no change" : "before and now:"};
  } catch (const InputError&) {  // it is replaced because it is not what it should be
    return {std::nullopt, "in place of one that this result cannot be compared with"};
  }
}

int update_baseline(const budget::Budget& budget, const Judged& judged) {
  budget::require_firmware(budget, judged.result, judged.name);
  const budget::Metrics now = report::metrics_of(judged.result);
  budget::require_known(budget, now, nullptr);
  const Replaced old = replaced_by(budget, judged);
  const budget::Metrics before = old.result ? report::metrics_of(*old.result) : budget::Metrics();
  write_file_whole(budget.baseline, report::to_json(judged.result));

  fmt::print("Written: {}, {}\n", budget.baseline.string(), old.how);
  for (const budget::Headline& headline :
       budget::headlines_of(now, old.result ? &before : nullptr)) {
    fmt::print("  {:<20} {}\n", headline.name, budget::headline_text(headline));
  }
  budget::Budget absolute = budget;
  std::erase_if(absolute.limits, [](const auto& limit) { return limit.demand.relative; });
  for (const budget::Check& check : budget::check_limits(absolute, now, nullptr)) {
    if (!check.holds) {
      const budget::CheckRow row = budget::row_of(check);
      fmt::print("Still broken: {} is {}, limit {}\n", row.metric, row.value, row.limit);
    }
  }
  return kFine;
}

// Also makes the folder that it is to go to; write_file_whole says when that could not be done.
void write_report(const fs::path& path, const std::string& text) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  write_file_whole(path, text);
}

// The terminal first: a report that cannot be written must not hide the verdict.
int report_verdict(const CheckOptions& options, const budget::Verdict& verdict) {
  fmt::print("{}", budget::to_text(verdict, options.all));
  if (options.github) {
    fmt::print("{}", budget::to_github(verdict));
  }
  if (!options.junit.empty()) {
    write_report(options.junit, budget::to_junit(verdict));
  }
  if (!options.markdown.empty()) {
    write_report(options.markdown, budget::to_markdown(verdict));
  }
  return verdict.passed() ? kFine : kBudgetBroken;
}

int check(const CLI::App& command, const CheckOptions& options) {
  catch_interrupts();
  const TomlReader reader(read_text_file(options.budget), options.budget);
  const budget::Budget budget = budget::read_budget(reader);
  const runner::RunRequest request = request_of(command, options, reader, budget);
  std::optional<report::RunResult> baseline;
  if (!options.list) {
    if (budget.limits.empty() && !options.update) {
      throw InputError(SourcePlace{budget.file},
                       "no [limits]: nothing would be checked; --list shows what can be limited");
    }
    if (options.update && budget.baseline.empty()) {
      throw InputError(SourcePlace{budget.file},
                       "no baseline to update: add baseline = \"FILE.json\"");
    }
    if (!options.update && !budget.baseline.empty()) {
      baseline = load_baseline(budget);
    }
    const budget::Metrics then = baseline ? report::metrics_of(*baseline) : budget::Metrics();
    budget::require_consistent(budget, baseline ? &then : nullptr);
  }
  const std::optional<Judged> judged = obtain(options, request);
  if (!judged) {
    return kInterrupted;
  }
  if (options.list) {
    return list(options, judged->result);
  }
  if (options.update) {
    return update_baseline(budget, *judged);
  }
  return report_verdict(options, budget::judge(budget, judged->result, judged->name,
                                               baseline ? &*baseline : nullptr));
}

}  // namespace

void add_check_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "Hold a run against budgets: does it still fit, and if not, why?");
  command->footer(kCheckExamples);
  command->add_option("budgets", options->budget, "Budgets file (TOML)")->required();
  CLI::Option* list =
      command
          ->add_option("--list", options->pattern, "Only print metrics and their values; * and ?")
          ->type_name("[PATTERN]")
          ->expected(0, 1);
  CLI::Option* update = command->add_flag("--update-baseline", options->update,
                                          "Write the result as the new baseline, judge nothing");
  CLI::Option* junit = command->add_option("--junit", options->junit, "Also write JUnit XML");
  CLI::Option* markdown =
      command->add_option("--markdown", options->markdown, "Also write a comment in Markdown");
  CLI::Option* github = command->add_flag("--github", options->github,
                                          "Also print GitHub's workflow commands (annotations)");
  CLI::Option* all = command->add_flag("--all", options->all, "Show the limits that hold, too");
  for (CLI::Option* report : {junit, markdown, github, all}) {
    report->excludes(list)->excludes(update);
  }
  list->excludes(update);
  CLI::Option* result = command->add_option(
      "--result", options->result, "Judge this result.json of an earlier run instead of running");
  add_run_options(*command, options->given);
  exclude_run_options(*command, *result);
  command->callback([&action, options, command, list] {
    options->list = list->count() > 0;
    options->pattern = options->pattern.empty() ? "*" : options->pattern;
    action = [options, command] { return check(*command, *options); };
  });
}

}  // namespace finback::cli
