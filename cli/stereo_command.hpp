// The subcommands of `finback stereo`, and what they share.
#pragma once

#include <filesystem>
#include <string>

#include <cli/commands.hpp>
#include <stereo_reference/experiment.hpp>

namespace finback::cli {

void add_stereo_match(CLI::App& stereo, Action& action);
void add_stereo_check(CLI::App& stereo, Action& action);
void add_stereo_postprocess(CLI::App& stereo, Action& action);
void add_stereo_evaluate(CLI::App& stereo, Action& action);
void add_stereo_perturb(CLI::App& stereo, Action& action);
void add_stereo_calibrate(CLI::App& stereo, Action& action);
void add_stereo_rectify(CLI::App& stereo, Action& action);
void add_stereo_tables(CLI::App& stereo, Action& action);
void add_stereo_experiments(CLI::App& stereo, Action& action);

// Writes an experiment into `folder`, all of its files or none: NAME.md, its tables, its plots with
// that extension (".svg"); "" as folder: nothing. Prints the page.
void publish(const stereo_reference::Experiment& experiment, const std::string& name,
             const std::string& folder, const std::string& extension);

}  // namespace finback::cli
