#include <fmt/format.h>
#include <map>
#include <memory>

#include <cli/colour.hpp>
#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <cli/watched_run.hpp>
#include <report/json_reader.hpp>
#include <report/profile_writer.hpp>

namespace finback::cli {

namespace {

constexpr const char* kProfileExamples =
    "Examples:\n"
    "  finback profile\n"
    "  finback profile --place core_b.shd_scores=l3 --by stalls --core b\n"
    "  finback profile --result out/result.json --top 5\n"
    "More: docs/finback-profile.md";

struct ProfileOptions {
  runner::RunRequest request;
  std::string result;
  std::string core;
  std::string colour = "auto";
  std::size_t top = 20;
  report::FunctionOrder order = report::FunctionOrder::exclusive;
  bool json = false;
};

int profile(const ProfileOptions& options) {
  report::RunResult result;
  if (options.result.empty()) {
    catch_interrupts();
    std::optional<runner::RunOutcome> outcome = run_watched(runner::load_inputs(options.request));
    if (!outcome) {
      return kInterrupted;
    }
    result = std::move(outcome->result);
  } else {
    result = report::load_result(options.result);
  }
  const report::ProfileView view{options.top == 0 ? report::kAll : options.top, options.order,
                                 options.core.empty() ? "" : "core_" + options.core,
                                 style_for(options.colour)};
  fmt::print("{}",
             options.json ? report::profile_json(result) : report::profile_text(result, view));
  return kFine;
}

}  // namespace

void add_profile_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command = app.add_subcommand(
      "profile", "Where the cycles and bytes go: functions, lines, causes, levels, objects");
  command->footer(kProfileExamples);
  CLI::Option* result = command->add_option("--result", options->result,
                                            "Show this result.json instead of running something");
  command->add_option("--top", options->top, "Rows of each table; 0: all")->capture_default_str();
  const std::map<std::string, report::FunctionOrder> orders = {
      {"exclusive", report::FunctionOrder::exclusive},
      {"inclusive", report::FunctionOrder::inclusive},
      {"stalls", report::FunctionOrder::stalls}};
  command
      ->add_option("--by", options->order,
                   "Order of the functions: exclusive (default), inclusive or stalls")
      ->type_name("ORDER")
      ->transform(CLI::CheckedTransformer(orders).description(""));
  command->add_option("--core", options->core, "Functions and lines of this core only: a or b")
      ->check(CLI::IsMember({"a", "b"}));
  command->add_flag("--json", options->json, "Print JSON: the keys of result.json, whole");
  add_colour_option(*command, options->colour);
  add_run_options(*command, options->request);
  exclude_run_options(*command, *result);
  command->callback([&action, options] { action = [options] { return profile(*options); }; });
}

}  // namespace finback::cli
