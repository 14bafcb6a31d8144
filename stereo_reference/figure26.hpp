// Figure 26: rank and census under changes of light that are made by computing.
//
// Models: Tsukuba, Venus, Teddy and Cones with the right picture's greys scaled, to the power of
// 1 / gamma, vignetted, or with Gaussian noise (Ahuja 2009, 4.1.1, A.23-A.26); the average of
// robustness.hpp's trial over the four. The thesis names neither the view that is changed nor
// all levels: the right one, and levels over the ranges that its listings allow. Does not model:
// the scale of A.24's listing, which multiplies by ten times the level.
#pragma once

#include <filesystem>
#include <functional>

#include <stereo_reference/experiment.hpp>
#include <stereo_reference/parallel.hpp>
#include <stereo_reference/robustness.hpp>

namespace finback::stereo_reference {

struct LightChange {
  std::string name;  // "scale"
  std::string axis;  // what a level is
  std::vector<double> levels;
  std::function<ByteImage(const ByteImage&, double level)> apply;
};
[[nodiscard]] std::vector<LightChange> figure26_changes();

using MethodErrors = std::array<TrialError, kCompared.size()>;

struct Figure26 {
  std::vector<LightChange> changes;
  std::vector<std::string> scenes;
  // By change, level, scene.
  std::vector<std::vector<std::vector<MethodErrors>>> errors;

  // Over the scenes.
  [[nodiscard]] MethodErrors average(std::size_t change, std::size_t level) const;
};

// `folder` holds the years. Without scenes when it was given up.
[[nodiscard]] Figure26 measure_figure26(const std::filesystem::path& folder,
                                        std::vector<LightChange> changes, const Parallel& how);
[[nodiscard]] Experiment figure26_experiment(const Figure26& figure);

}  // namespace finback::stereo_reference
