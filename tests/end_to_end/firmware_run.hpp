// Runs the shipped firmware on the simulated machine, for tests.
#pragma once

#include <functional>
#include <utility>

#include <common/file.hpp>
#include <runner/run_firmware.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/matching.hpp>
#include <stereo_reference/texture.hpp>

namespace finback {

[[nodiscard]] inline runner::RunInputs mesvs2_inputs(scenes::Scene scene,
                                                     std::uint32_t frames = 1) {
  runner::RunInputs inputs;
  inputs.firmware = runner::find_firmware("mesvs2", {});
  inputs.machine = std::make_unique<machine::MachineDescription>();
  inputs.scene = std::move(scene);
  inputs.frames = frames;
  return inputs;
}

// What the firmware must compute for `scene`.
[[nodiscard]] inline std::vector<std::uint8_t> reference_map(const scenes::Scene& scene) {
  const scenes::ByteImage left = stereo_reference::subsample_by_4(scene.left);
  const scenes::ByteImage map =
      stereo_reference::disparity_map(left, stereo_reference::subsample_by_4(scene.right), {});
  return stereo_reference::post_process(map, left).pixels();
}

}  // namespace finback
