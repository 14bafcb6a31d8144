// Figure 29: rank and census under real differences of light.
//
// Models: robustness.hpp's trial on pairs whose views were taken under different exposures or
// lights. The thesis has six scenes of 2005 under 3 exposures and 3 lights; of these pictures few
// are in the data: Aloe under four lights for the right view and two for the left, Art under two,
// and the six scenes under one. Does not model: the rest of the 54 pictures; names of exposures,
// which the data does not know.
#pragma once

#include <filesystem>

#include <stereo_reference/experiment.hpp>
#include <stereo_reference/figure26.hpp>

namespace finback::stereo_reference {

struct LightTrial {
  std::string name;         // "Aloe left_1, right_3"
  bool other_light = true;  // do the views differ in light?
  MethodErrors errors{};
};

// `folder` holds the years and `radiometric`. None when it was given up.
[[nodiscard]] std::vector<LightTrial> measure_figure29(const std::filesystem::path& folder,
                                                       const Parallel& how);

[[nodiscard]] Experiment figure29_experiment(const std::vector<LightTrial>& trials);

}  // namespace finback::stereo_reference
