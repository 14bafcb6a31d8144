// Table 8 and figure 34: how much the left-right check and the post-processing leave of the bad
// pixels, over the 21 scenes of 2006.
//
// Models: census 3x3, SHD, the check and equation 19 on whole pictures and the full range of
// disparities of each scene; bad pixels in all, non-occluded, texture-less and depth-discontinuous
// regions; mean, median and mode over the scenes (Ahuja 2009, 4.2). What the thesis leaves open is
// a Reading; readings.hpp tries them. Does not model: the firmware's 160x120 pixels and
// range 5..35.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <stereo_reference/middlebury.hpp>
#include <stereo_reference/parallel.hpp>

namespace finback::stereo_reference {

enum class TableRegion : std::uint8_t { all, non_occluded, texture_less, discontinuous };
enum class TableStage : std::uint8_t { matched, checked, post_processed };
enum class Statistic : std::uint8_t { mean, median, mode };
inline constexpr std::size_t kTableRegions = 4;
inline constexpr std::size_t kTableStages = 3;
inline constexpr std::size_t kStatistics = 3;

[[nodiscard]] const char* name_of(TableRegion region);
[[nodiscard]] const char* name_of(TableStage stage);
[[nodiscard]] const char* name_of(Statistic statistic);

// When a pixel is bad.
enum class BadRule : std::uint8_t {
  scaled,   // disparity times the truth's scale is more than 1 from the truth's grey (A.15's
            // listing)
  pixels,   // more than 1 pixel from the truth (equation 18)
  floored,  // more than 1 pixel from the truth rounded down (as A.20 reads it)
};

// One way to read what the thesis leaves open. The default is the one whose figures are nearest.
struct Reading {
  int window = 15;                   // of the matching; half of it is the border left out
  bool whole_range = false;          // only pixels whose whole range of candidates fits (A.19)
  int consistency = 1;               // the check's threshold, pixels, inclusive
  BadRule bad = BadRule::scaled;     //
  bool invalid_is_bad = false;       // else pixels without a disparity are left out
  bool hidden_counts = false;        // do the two hard regions have occluded pixels in them?
  bool gap_in_greys = false;         // discontinuity: 3 greys of the truth, else 3 pixels
  bool variance_is_texture = false;  // texture-less: variance <= T_L, else A.22
  double disparity_threshold = 135;  // T_H; 17 by the text, 135 is what the listing compares
  bool either = false;               // post-processing by the listing's "or"

  // Short words for what differs from the default; "as chosen" where nothing does.
  [[nodiscard]] std::string to_string() const;
  friend bool operator==(const Reading&, const Reading&) = default;
};

// Percent of bad pixels by region and stage; none where a region has no pixel to judge.
using SceneFigures = std::array<std::array<std::optional<double>, kTableStages>, kTableRegions>;

struct Table8 {
  Reading reading;
  std::vector<SceneFigures> scenes;  // in the order of middlebury_scenes(2006)

  // Over the scenes that have a figure. The mode is the most frequent value; where all differ, as
  // they do, the smallest, which is what MATLAB's mode() gives.
  [[nodiscard]] double value(Statistic statistic, TableRegion region, TableStage stage) const;
  // How far the twelve means lie from the thesis's: on average, and the farthest; points.
  [[nodiscard]] double average_distance() const;
  [[nodiscard]] double largest_distance() const;
};

// The thesis's figures.
[[nodiscard]] double thesis_table8(Statistic statistic, TableRegion region, TableStage stage);

// One table for each reading; none when it was given up. `folder` holds the years. Throws
// InputError naming the picture that is missing or wrong.
[[nodiscard]] std::vector<Table8> measure_table8(const std::filesystem::path& folder,
                                                 const std::vector<Reading>& readings,
                                                 const Parallel& how);

// All readings on one scene.
[[nodiscard]] std::vector<SceneFigures> measure_scene(const StereoSample& sample, float scale,
                                                      const std::vector<Reading>& readings);

}  // namespace finback::stereo_reference
