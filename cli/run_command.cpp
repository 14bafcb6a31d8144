#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include <cli/commands.hpp>
#include <cli/output_folder.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <cli/watched_run.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <report/json_writer.hpp>
#include <report/text_writer.hpp>
#include <runner/run_request.hpp>
#include <scenes/luma.hpp>

namespace finback::cli {

namespace {

// The disparities of the camera's firmware (stereo-system.md): maps are scaled to these, so that
// one grey means one distance in all of them; a map that goes beyond widens its own scale.
constexpr int kDisparityMin = 5;
constexpr int kDisparityMax = 35;

constexpr const char* kRunExamples =
    "Examples:\n"
    "  finback run --scene aloe --frames 4 --out out/aloe\n"
    "  finback run --left left.png --right right.jpg --out out/mine\n"
    "  finback run --scene synthetic --placement my_placement.toml --out out/placed\n"
    "Writes disparity_0000.png ... and result.json. More: docs/finback-run.md";

struct RunOptions {
  runner::RunRequest request;
  std::string out = "out";
  std::string trace_counters;
  bool check = false;
  std::size_t stale_lines = 0;
};

void write_published(const machine::PublishedMap& map, const std::filesystem::path& path) {
  scenes::ByteImage image(static_cast<int>(map.width), static_cast<int>(map.height));
  std::copy(map.bytes.begin(), map.bytes.end(), image.data());
  int smallest = kDisparityMin;
  int largest = kDisparityMax;
  for (const std::uint8_t disparity : map.bytes) {
    if (disparity != 0) {
      smallest = std::min<int>(smallest, disparity);
      largest = std::max<int>(largest, disparity);
    }
  }
  scenes::write_disparity_png(image, smallest, largest, path);
}

std::string map_name(std::size_t frame) { return fmt::format("disparity_{:04}.png", frame); }

// One counter a line, ordered by name: what differs shows in a diff.
std::string trace_text(const report::RunResult& result) {
  return nlohmann::json(runner::trace_counters(result)).dump(1) + "\n";
}

// Maps of an earlier run with more frames would pass for this one's.
void remove_maps_from(const std::filesystem::path& folder, std::size_t frame) {
  std::error_code error;
  while (std::filesystem::remove(folder / map_name(frame), error)) {
    ++frame;
  }
}

// Says what was found; true when that is nothing.
bool print_races(const std::vector<machine::RaceReport>& races, const report::RunResult& result) {
  for (const machine::RaceReport& race : races) {
    fmt::print("\nRace on {}: {} byte{}, first at {:.6f} s, nothing orders these two\n  {}\n  {}\n",
               race.object, race.bytes, race.bytes == 1 ? "" : "s", result.seconds(0, race.at),
               race.earlier, race.later);
  }
  fmt::print("{}\n", races.empty()
                         ? "No races."
                         : fmt::format("\n{} race{}; docs/races.md says how to mend them.",
                                       races.size(), races.size() == 1 ? "" : "s"));
  return races.empty();
}

int run(const RunOptions& options) {
  catch_interrupts();  // first: from here on a Ctrl-C ends in the destructors below
  const runner::RunInputs inputs = runner::load_inputs(options.request);
  OutputFolder folder(options.out);

  const std::optional<runner::RunOutcome> watched = run_watched(inputs, options.stale_lines);
  if (!watched) {
    return kInterrupted;
  }
  const runner::RunOutcome& outcome = *watched;

  for (const machine::PublishedMap& map : outcome.maps) {
    write_published(map, folder.staged(map_name(map.frame_number)));
  }
  write_file_whole(folder.staged("result.json"), report::to_json(outcome.result));
  if (!options.trace_counters.empty()) {
    write_file_whole(options.trace_counters, trace_text(outcome.result));
  }
  folder.commit();
  remove_maps_from(options.out, outcome.maps.size());
  fmt::print("{}", report::to_text(outcome.result));
  fmt::print("Written: {} maps and result.json in {}\n", outcome.maps.size(), options.out);
  const bool ordered = !options.request.check_races || print_races(outcome.races, outcome.result);
  const bool passed = std::all_of(outcome.result.targets.begin(), outcome.result.targets.end(),
                                  [](const report::Target& target) { return target.passed(); });
  return (options.check && !passed) || !ordered ? kBudgetBroken : kFine;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      app.add_subcommand("run", "Run a firmware on a stereo pair: maps, cycles, traffic, power");
  command->footer(kRunExamples);
  add_run_options(*command, options->request);
  command->add_option("--out", options->out, "Folder for what is written")->capture_default_str();
  command->add_flag("--check", options->check, "Exit with 3 when a target is missed");
  command->add_flag("--check-races", options->request.check_races,
                    "Also find accesses of cores and DMA that nothing orders; exit with 3 then");
  command
      ->add_option("--warn-stale", options->stale_lines,
                   "Say on stderr who saw old data because of a cache: at most N lines")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--trace-counters", options->trace_counters,
                      "Also write the golden trace's counters to this file");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace finback::cli
