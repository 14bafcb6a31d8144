// Stereo pairs one after the other: what two cameras see over time.
//
// From a pair that does not change, a folder of pictures, a video (side by side or one for each
// camera), or the synthetic scene with things that move. Pairs are 640x480 luma; numbers count from
// 0, and behind the last pair comes the first again. A sequence reads a pair when it is asked for
// it and keeps that one only. Does not model: the time between pairs, which is the camera's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scenes/lens.hpp>
#include <scenes/luma.hpp>
#include <scenes/scene.hpp>

namespace finback::scenes {

class FrameSequence {
 public:
  FrameSequence() = default;
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;
  virtual ~FrameSequence() = default;

  // The pair of that number; valid until the next call. Throws InputError where a file is missing
  // or wrong.
  const LumaPair& pair(std::uint32_t number);
  // How many different pairs there are.
  [[nodiscard]] virtual std::uint32_t size() const = 0;
  // Disparities of pair `number`, as Scene::truth; empty where nothing is known.
  [[nodiscard]] virtual FloatImage truth(std::uint32_t /*number*/) const { return {}; }

 protected:
  // `number` is below size().
  virtual LumaPair load(std::uint32_t number) = 0;

 private:
  LumaPair pair_;
  std::uint32_t loaded_ = ~0U;
};

// A scene that stands still.
[[nodiscard]] std::unique_ptr<FrameSequence> still_sequence(Scene scene);

// left_*.EXT and right_*.EXT of a folder in the order of their names, a right one for each left
// one: left_0001.png and right_0001.png. Throws InputError: no folder, no pictures, one without its
// other.
[[nodiscard]] std::unique_ptr<FrameSequence> folder_sequence(const std::filesystem::path& folder);

// One video with the left view beside the right one, or two, left and right; each view as
// load_luma_vga makes it. Throws InputError: no video, and where videos cannot be read at all.
[[nodiscard]] std::unique_ptr<FrameSequence> video_sequence(
    const std::vector<std::filesystem::path>& paths);
// Whether Finback has the module that reads videos.
[[nodiscard]] bool reads_videos();

// The synthetic scene whose boxes move: box b by its own whole number of VGA pixels a frame, to and
// fro, so that truth stays exact. The same seed gives the same bytes on every host.
[[nodiscard]] std::unique_ptr<FrameSequence> moving_sequence(std::uint32_t seed = 1);

// Each pair as cameras with these lenses see it; truth is that of the scene without.
[[nodiscard]] std::unique_ptr<FrameSequence> sequence_through_lenses(
    std::unique_ptr<FrameSequence> sequence, const Lens& left, const Lens& right);

}  // namespace finback::scenes
