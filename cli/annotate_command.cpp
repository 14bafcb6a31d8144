#include <fmt/format.h>
#include <memory>

#include <cli/colour.hpp>
#include <cli/commands.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <cli/watched_run.hpp>
#include <report/annotation_writer.hpp>
#include <runner/annotate.hpp>

namespace finback::cli {

namespace {

constexpr const char* kAnnotateExamples =
    "Examples:\n"
    "  finback annotate shd_update_row\n"
    "  finback annotate memory_copy --core b --place core_b.shd_scores=l3\n"
    "  finback annotate census_row --color always | less -R\n"
    "finback profile tells which functions are worth it. More: docs/finback-annotate.md";

struct AnnotateOptions {
  runner::RunRequest request;
  std::string function;
  std::string core;
  std::string colour = "auto";
  std::vector<std::string> sources;
  bool json = false;
};

int annotate(const AnnotateOptions& options) {
  catch_interrupts();
  const runner::RunInputs inputs = runner::load_inputs(options.request);
  const std::optional<runner::RunOutcome> outcome = run_watched(inputs);
  if (!outcome) {
    return kInterrupted;
  }
  std::vector<std::filesystem::path> folders(options.sources.begin(), options.sources.end());
  for (const auto& folder : runner::source_folders(inputs.firmware.firmware.units.path)) {
    folders.push_back(folder);
  }
  runner::SourceText sources(std::move(folders));
  std::optional<CoreId> core;
  if (!options.core.empty()) {
    core = options.core == "a" ? CoreId::a : CoreId::b;
  }
  const report::Annotation annotation =
      runner::annotate(inputs.firmware.firmware.units, *outcome, options.function, core, sources);
  fmt::print("{}", options.json ? report::to_json(annotation)
                                : report::to_text(annotation, style_for(options.colour)));
  return kFine;
}

}  // namespace

void add_annotate_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<AnnotateOptions>();
  CLI::App* command = app.add_subcommand(
      "annotate", "A function's source and code, with the cycles of each line and why");
  command->footer(kAnnotateExamples);
  command->add_option("function", options->function, "C name of the function")->required();
  command
      ->add_option("--core", options->core,
                   "Core to look at, a or b (default: the one that spent more in the function)")
      ->check(CLI::IsMember({"a", "b"}));
  command
      ->add_option("--source", options->sources,
                   "Folder where sources are looked for first; repeatable")
      ->check(CLI::ExistingDirectory)
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print JSON");
  add_colour_option(*command, options->colour);
  add_run_options(*command, options->request);
  command->callback([&action, options] { action = [options] { return annotate(*options); }; });
}

}  // namespace finback::cli
