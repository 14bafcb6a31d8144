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
#include <stereo_reference/figure26.hpp>
#include <stereo_reference/figure29.hpp>
#include <stereo_reference/figure8.hpp>
#include <stereo_reference/readings.hpp>

namespace finback::cli {

namespace {

namespace fs = std::filesystem;
using namespace stereo_reference;

struct ExperimentsOptions {
  std::string data = "../shared/data";
  std::string out;
  std::string format = "svg";
  unsigned jobs = std::clamp(std::thread::hardware_concurrency(), 1U, kMostJobs);
  bool search = false;
};

fs::path middlebury_folder(const ExperimentsOptions& options) {
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

void check_output(const ExperimentsOptions& options) {
  if (!options.out.empty()) {
    check_plot_path("--out", "plot." + options.format);
  }
}

// Work with a bar of a hundred parts, until Ctrl-C.
constexpr std::size_t kParts = 100;
Parallel watched(const ExperimentsOptions& options, ProgressBar& bar, const char* what) {
  return {options.jobs, [&bar, what](std::size_t done, std::size_t count) {
            bar.show(kParts * done / count,
                     [&] { return fmt::format("{}/{} {}", done, count, what); });
            return interrupted();
          }};
}

int give_up() {
  fmt::print(stderr, "finback: interrupted; nothing was written\n");
  return kInterrupted;
}

int table8(const ExperimentsOptions& options) {
  catch_interrupts();
  check_output(options);
  const fs::path folder = middlebury_folder(options);
  ProgressBar bar(kParts);
  const std::vector<Reading> readings =
      options.search ? readings_to_try() : std::vector<Reading>{Reading()};
  const std::vector<Table8> tables =
      measure_table8(folder, readings, watched(options, bar, "scenes"));
  bar.wipe();
  if (tables.empty()) {
    return give_up();
  }
  publish(options.search ? readings_experiment(tables) : table8_experiment(tables.front()),
          options.search ? "readings" : "table8", options.out, "." + options.format);
  return kFine;
}

int figure8(const ExperimentsOptions& options) {
  check_output(options);
  publish(figure8_experiment({}), "figure8", options.out, "." + options.format);
  return kFine;
}

int figure26(const ExperimentsOptions& options) {
  catch_interrupts();
  check_output(options);
  ProgressBar bar(kParts);
  const Figure26 figure = measure_figure26(middlebury_folder(options), figure26_changes(),
                                           watched(options, bar, "changed pairs"));
  bar.wipe();
  if (figure.scenes.empty()) {
    return give_up();
  }
  publish(figure26_experiment(figure), "figure26", options.out, "." + options.format);
  return kFine;
}

int figure29(const ExperimentsOptions& options) {
  catch_interrupts();
  check_output(options);
  ProgressBar bar(kParts);
  const std::vector<LightTrial> trials =
      measure_figure29(middlebury_folder(options), watched(options, bar, "pairs"));
  bar.wipe();
  if (trials.empty()) {
    return give_up();
  }
  publish(figure29_experiment(trials), "figure29", options.out, "." + options.format);
  return kFine;
}

// A subcommand with the options that write files; those of data sets follow.
CLI::App* add(CLI::App& experiments, Action& action, const char* name, const char* what,
              int (*run)(const ExperimentsOptions&),
              const std::shared_ptr<ExperimentsOptions>& options) {
  CLI::App* command = experiments.add_subcommand(name, what);
  command->add_option("--out", options->out, "Also write the page, CSV and plot into this folder")
      ->type_name("DIR");
  command->add_option("--format", options->format, "Of plots")
      ->check(CLI::IsMember({"svg", "png"}))
      ->capture_default_str();
  command->footer(fmt::format("Example: finback stereo experiment {0} --out out/{0}", name));
  command->callback([&action, run, options] { action = [run, options] { return run(*options); }; });
  return command;
}

CLI::App* add_data(CLI::App* command, ExperimentsOptions& options) {
  command->add_option("--data", options.data, "The folder that has the folder middlebury")
      ->type_name("DIR")
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
  auto options = std::make_shared<ExperimentsOptions>();
  add(*experiments, action, "figure8", "Range and its uncertainty by disparity", figure8, options);
  add_data(add(*experiments, action, "figure26",
               "Rank against census under computed changes of light and noise", figure26, options),
           *options);
  add_data(add(*experiments, action, "figure29", "Rank against census under real changes of light",
               figure29, options),
           *options);
  add_data(add(*experiments, action, "table8",
               "Table 8 and figure 34: bad pixels over the 21 scenes of 2006", table8, options),
           *options)
      ->add_flag("--search", options->search,
                 "Try every reading of what the thesis leaves open, the nearest first");
}

}  // namespace finback::cli
