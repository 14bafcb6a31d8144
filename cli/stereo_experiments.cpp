// `finback stereo experiment`: the thesis's experiments, measured again.
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <system_error>
#include <thread>

#include <cli/progress.hpp>
#include <cli/stereo_command.hpp>
#include <common/error.hpp>
#include <stereo_reference/readings.hpp>

namespace finback::cli {

namespace {

namespace fs = std::filesystem;
using namespace stereo_reference;

constexpr unsigned kMostJobs = 256;

struct Options {
  std::string data = "../shared/data";
  std::string out;
  std::string format = "svg";
  unsigned jobs = std::clamp(std::thread::hardware_concurrency(), 1U, kMostJobs);
  bool search = false;
};

fs::path middlebury_folder(const Options& options) {
  fs::path folder = fs::path(options.data) / "middlebury";
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format(
        "--data {}: there is no folder middlebury in it; name the folder that has the pictures "
        "as middlebury/2006/Aloe/view1.png",
        options.data));
  }
  return folder;
}

void check_output(const Options& options) {
  if (!options.out.empty()) {
    check_plot_path("--out", "plot." + options.format);
  }
}

// Work with a bar, until Ctrl-C.
Parallel watched(const Options& options, ProgressBar& bar, std::size_t pieces, const char* what) {
  return {options.jobs, [&bar, pieces, what](std::size_t done) {
            bar.show(done, [&] { return fmt::format("{}/{} {}", done, pieces, what); });
            return interrupted();
          }};
}

int give_up() {
  fmt::print(stderr, "finback: interrupted; nothing was written\n");
  return kInterrupted;
}

int table8(const Options& options) {
  catch_interrupts();
  check_output(options);
  const fs::path folder = middlebury_folder(options);
  const std::size_t scenes = middlebury_scenes(2006).size();
  ProgressBar bar(scenes);
  const std::vector<Reading> readings =
      options.search ? readings_to_try() : std::vector<Reading>{Reading()};
  const std::vector<Table8> tables =
      measure_table8(folder, readings, watched(options, bar, scenes, "scenes"));
  bar.wipe();
  if (tables.empty()) {
    return give_up();
  }
  publish(options.search ? readings_experiment(tables) : table8_experiment(tables.front()),
          options.search ? "readings" : "table8", options.out, "." + options.format);
  return kFine;
}

CLI::App* add(CLI::App& experiments, const char* name, const char* what, Options& options) {
  CLI::App* command = experiments.add_subcommand(name, what);
  command->add_option("--data", options.data, "The folder that has the folder middlebury")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--out", options.out, "Also write the page, CSV and plot into this folder")
      ->type_name("DIR");
  command->add_option("--format", options.format, "Of plots")
      ->check(CLI::IsMember({"svg", "png"}))
      ->capture_default_str();
  command->add_option("--jobs", options.jobs, "Threads")
      ->check(CLI::Range(1U, kMostJobs))
      ->capture_default_str();
  return command;
}

}  // namespace

void add_stereo_experiments(CLI::App& stereo, Action& action) {
  CLI::App* experiments =
      stereo.add_subcommand("experiment", "Measure the thesis's tables and figures again");
  experiments->require_subcommand(1);
  auto options = std::make_shared<Options>();
  CLI::App* command = add(*experiments, "table8",
                          "Table 8 and figure 34: bad pixels over the 21 scenes of 2006", *options);
  command->add_flag("--search", options->search,
                    "Try every reading of what the thesis leaves open, the nearest first");
  command->footer(
      "Example: finback stereo experiment table8 --data ../shared/data --out out/table8");
  command->callback([&action, options] { action = [options] { return table8(*options); }; });
}

}  // namespace finback::cli
