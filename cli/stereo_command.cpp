// `finback stereo`: the stereo algorithms on the host, on pictures and on data sets.
#include <cstdio>
#include <fmt/format.h>

#include <cli/output_folder.hpp>
#include <cli/stereo_command.hpp>
#include <common/file.hpp>

namespace finback::cli {

void publish(const stereo_reference::Experiment& experiment, const std::string& name,
             const std::string& folder, const std::string& extension) {
  if (!folder.empty()) {
    OutputFolder output(folder);
    write_file_whole(output.staged(name + ".md"), experiment.page);
    for (const auto& table : experiment.tables) {
      write_file_whole(output.staged(table.name), table.text);
    }
    for (const auto& plot : experiment.plots) {
      draw_plot(plot.script, output.staged(plot.name + extension));
    }
    output.commit();
  }
  fmt::print("{}", experiment.page);
}

void add_stereo_command(CLI::App& app, Action& action) {
  CLI::App* stereo = app.add_subcommand(
      "stereo",
      "The camera's algorithms on this computer: on pictures, and the thesis's experiments");
  stereo->require_subcommand(1);
  stereo->footer("finback stereo COMMAND --help explains one. More: docs/finback-stereo.md");
  add_stereo_match(*stereo, action);
  add_stereo_check(*stereo, action);
  add_stereo_postprocess(*stereo, action);
  add_stereo_evaluate(*stereo, action);
  add_stereo_perturb(*stereo, action);
  add_stereo_calibrate(*stereo, action);
  add_stereo_rectify(*stereo, action);
  add_stereo_tables(*stereo, action);
  add_stereo_experiments(*stereo, action);
}

}  // namespace finback::cli
