// Middlebury's stereo pairs with ground truth: which scenes there are, and how a folder holds them.
//
// Models: the data sets of 2001, 2003, 2005 and 2006 (Ahuja 2009, A.29 to A.31), two views and the
// truth of both, as `<year>/<scene>/` with im2, im6, disp2, disp6 (2001, 2003) or view1, view5,
// disp1, disp5 (2005, 2006). Grey 0 of a truth is "unknown". Does not model: other views, lights
// and exposures. Terms of use: the folder's README.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

struct MiddleburyScene {
  int year = 2006;
  std::string name;         // "Aloe"
  float scale = 3;          // grey values of the truth a pixel of disparity
  bool right_truth = true;  // is there a truth of the right view?

  // "2006/Aloe"
  [[nodiscard]] std::string path() const;
};

// Those of a year, in alphabetical order but for the year's own; none for a year without a set.
[[nodiscard]] std::vector<MiddleburyScene> middlebury_scenes(int year);
// The scene of that path, if there is one.
[[nodiscard]] std::optional<MiddleburyScene> find_middlebury_scene(const std::string& path);

struct StereoSample {
  scenes::ByteImage left;  // luma
  scenes::ByteImage right;
  scenes::FloatImage left_truth;   // pixels; 0: unknown
  scenes::FloatImage right_truth;  // empty where there is none

  // The least whole disparity that no pixel of the truth exceeds.
  [[nodiscard]] int largest_disparity() const;
};

// `folder` holds the years. Throws InputError naming the picture that is missing, cannot be read or
// has another size than the others.
[[nodiscard]] StereoSample load_middlebury(const std::filesystem::path& folder,
                                           const MiddleburyScene& scene);

}  // namespace finback::stereo_reference
