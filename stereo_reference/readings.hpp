// Which reading of the thesis gives its table 8? All combinations, the nearest first.
//
// Models: a full grid over what the thesis leaves open (readings_to_try), ranked by how far the
// twelve means lie from the thesis's on average. Does not model: a search for better stereo; T_L,
// the masks' windows and thresholds stay those that the thesis names.
#pragma once

#include <stereo_reference/experiment.hpp>
#include <stereo_reference/table8.hpp>

namespace finback::stereo_reference {

[[nodiscard]] std::vector<Reading> readings_to_try();

// Table 8 and figure 34 as a page, tables and a plot. `table` is of all scenes of 2006.
[[nodiscard]] Experiment table8_experiment(const Table8& table);

// The nearest readings, and what each single change of the chosen one does. `tables` has one table
// for each of readings_to_try().
[[nodiscard]] Experiment readings_experiment(const std::vector<Table8>& tables);

}  // namespace finback::stereo_reference
