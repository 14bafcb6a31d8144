#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <scenes/scene.hpp>

namespace finback::scenes {

namespace fs = std::filesystem;

namespace {

constexpr int kTruthWidth = kVgaWidth / 4;
constexpr int kTruthHeight = kVgaHeight / 4;

ByteImage load_sized(const fs::path& path, int width, int height) {
  ByteImage image = load_luma(path);
  if (image.width() != width || image.height() != height) {
    throw InputError(fmt::format("{}: the scene's image is {}x{}, expected {}x{}; reinstall it",
                                 path.string(), image.width(), image.height(), width, height));
  }
  return image;
}

// A scene kept as left.png, right.png (640x480) and truth.png (160x120, grey / truth_scale).
Scene load_stored(const std::string& name, const fs::path& folder, float truth_scale) {
  Scene scene;
  scene.name = name;
  scene.left = load_sized(folder / "left.png", kVgaWidth, kVgaHeight);
  scene.right = load_sized(folder / "right.png", kVgaWidth, kVgaHeight);
  const ByteImage grey = load_sized(folder / "truth.png", kTruthWidth, kTruthHeight);
  scene.truth = FloatImage(kTruthWidth, kTruthHeight);
  std::transform(grey.pixels().begin(), grey.pixels().end(), scene.truth.data(),
                 [truth_scale](std::uint8_t value) { return value / truth_scale; });
  return scene;
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = {"aloe", "synthetic"};
  return names;
}

Scene load_scene(const std::string& name, const fs::path& folder) {
  constexpr float kAloeTruthScale = 8.0F;
  if (name == "aloe") {
    return load_stored(name, folder / "aloe", kAloeTruthScale);
  }
  if (name == "synthetic") {
    return make_synthetic_scene();
  }
  throw InputError(fmt::format("scene '{}' is not known; known scenes: {}", name,
                               fmt::join(scene_names(), ", ")));
}

Scene load_scene_pair(const fs::path& left, const fs::path& right) {
  LumaPair pair = load_luma_vga_pair(left, right);
  return {fmt::format("{} + {}", left.filename().string(), right.filename().string()),
          std::move(pair.left), std::move(pair.right), FloatImage()};
}

}  // namespace finback::scenes
