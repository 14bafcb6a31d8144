// Named scenes: rectified stereo pairs that need no camera, with ground truth at 160x120.
//
// `aloe` is a photograph (Middlebury 2006, see scenes/aloe/README.md), `synthetic` is generated:
// textured surfaces at exactly known integer disparities. Does not model: camera noise, lens
// distortion, differences of exposure between the views.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <scenes/image.hpp>

namespace finback::scenes {

struct Scene {
  std::string name;
  ByteImage left;    // 640x480 luma
  ByteImage right;   // 640x480 luma; left x is seen at x - 4 d, d the disparity at 160x120
  FloatImage truth;  // disparity of left pixel (4 i, 4 j) in pixels of 160x120, 0 unknown;
                     // 160x120, or empty when nothing is known
};

// The names that load_scene knows, in the order of the manual.
[[nodiscard]] const std::vector<std::string>& scene_names();

// The scene of that name; `folder` is the installed scenes' folder (share/finback/scenes).
// Throws InputError on an unknown name, listing the known ones, or when a file is missing or has a
// wrong size.
[[nodiscard]] Scene load_scene(const std::string& name, const std::filesystem::path& folder);

// Two pictures of any size as a scene without truth. Throws like load_luma_vga_pair.
[[nodiscard]] Scene load_scene_pair(const std::filesystem::path& left,
                                    const std::filesystem::path& right);

// Frontal textured surfaces between disparities 6 and 34: a floor of five steps rising towards the
// viewer, three boxes, one partly hidden by another, and a thin post. The same seed gives the
// same bytes on every host; different seeds give different textures on the same shapes. From one
// `frame` to the next the boxes and the post move to the side, each at its own speed.
[[nodiscard]] Scene make_synthetic_scene(std::uint32_t seed = 1, std::uint32_t frame = 0);

}  // namespace finback::scenes
