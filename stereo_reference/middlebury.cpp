#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/map_file.hpp>
#include <stereo_reference/middlebury.hpp>

namespace finback::stereo_reference {

namespace fs = std::filesystem;

namespace {

struct DataSet {
  int year;
  float scale;
  std::vector<const char*> names;
  const char* left;
  const char* right;
  const char* left_truth;
  const char* right_truth;
};

const std::vector<DataSet>& data_sets() {
  static const std::vector<DataSet> sets = {
      {2001,
       8,
       {"barn1", "barn2", "bull", "poster", "sawtooth", "tsukuba", "venus"},
       "im2.png",
       "im6.png",
       "disp2.png",
       "disp6.png"},
      {2003, 4, {"cones", "teddy"}, "im2.png", "im6.png", "disp2.png", "disp6.png"},
      {2005,
       3,
       {"Art", "Books", "Dolls", "Laundry", "Moebius", "Reindeer"},
       "view1.png",
       "view5.png",
       "disp1.png",
       "disp5.png"},
      {2006,
       3,
       {"Aloe",   "Baby1",    "Baby2",   "Baby3",      "Bowling1",   "Bowling2",   "Cloth1",
        "Cloth2", "Cloth3",   "Cloth4",  "Flowerpots", "Lampshade1", "Lampshade2", "Midd1",
        "Midd2",  "Monopoly", "Plastic", "Rocks1",     "Rocks2",     "Wood1",      "Wood2"},
       "view1.png",
       "view5.png",
       "disp1.png",
       "disp5.png"}};
  return sets;
}

const DataSet* set_of(int year) {
  const auto found = std::ranges::find(data_sets(), year, &DataSet::year);
  return found == data_sets().end() ? nullptr : &*found;
}

}  // namespace

std::string MiddleburyScene::path() const { return fmt::format("{}/{}", year, name); }

std::vector<MiddleburyScene> middlebury_scenes(int year) {
  std::vector<MiddleburyScene> scenes;
  if (const DataSet* set = set_of(year)) {
    for (const std::string name : set->names) {
      // Tsukuba's truth came with twice the scale, and of one view.
      const bool tsukuba = name == "tsukuba";
      scenes.push_back({year, name, tsukuba ? 2 * set->scale : set->scale, !tsukuba});
    }
  }
  return scenes;
}

std::optional<MiddleburyScene> find_middlebury_scene(const std::string& path) {
  for (const DataSet& set : data_sets()) {
    for (const MiddleburyScene& scene : middlebury_scenes(set.year)) {
      if (scene.path() == path) {
        return scene;
      }
    }
  }
  return std::nullopt;
}

int StereoSample::largest_disparity() const {
  const auto& truth = left_truth.pixels();
  return static_cast<int>(std::ceil(*std::max_element(truth.begin(), truth.end())));
}

StereoSample load_middlebury(const fs::path& folder, const MiddleburyScene& scene) {
  const DataSet* set = set_of(scene.year);
  if (set == nullptr) {
    throw InputError(fmt::format("Middlebury: there is no data set of {}", scene.year));
  }
  const fs::path where = folder / scene.path();
  StereoSample sample;
  sample.left = scenes::load_luma(where / set->left);
  const auto load = [&](const char* name) {
    scenes::ByteImage image = scenes::load_luma(where / name);
    if (image.width() != sample.left.width() || image.height() != sample.left.height()) {
      throw InputError(fmt::format("{}: {}x{} pixels, but {} has {}x{}", (where / name).string(),
                                   image.width(), image.height(), set->left, sample.left.width(),
                                   sample.left.height()));
    }
    return image;
  };
  sample.right = load(set->right);
  sample.left_truth = truth_of(load(set->left_truth), scene.scale);
  if (scene.right_truth) {
    sample.right_truth = truth_of(load(set->right_truth), scene.scale);
  }
  return sample;
}

}  // namespace finback::stereo_reference
