// Runs the shipped firmware on the simulated machine, for tests.
#pragma once

#include <string>
#include <utility>

#include <common/file.hpp>
#include <runner/run_firmware.hpp>
#include <scenes/scene.hpp>
#include <stereo_reference/method.hpp>
#include <stereo_reference/texture.hpp>

namespace finback {

[[nodiscard]] inline runner::RunInputs firmware_inputs(const std::string& firmware,
                                                       scenes::Scene scene,
                                                       std::uint32_t frames = 1) {
  runner::RunInputs inputs;
  inputs.firmware = runner::find_firmware(firmware, {});
  inputs.machine = std::make_unique<machine::MachineDescription>();
  inputs.scene = std::move(scene);
  inputs.frames = frames;
  return inputs;
}

[[nodiscard]] inline runner::RunInputs mesvs2_inputs(scenes::Scene scene,
                                                     std::uint32_t frames = 1) {
  return firmware_inputs("mesvs2", std::move(scene), frames);
}

// What MESVS-II (census, SHD) or MESVS-I (rank, SAD) must make of a rectified pair of 160x120.
[[nodiscard]] inline std::vector<std::uint8_t> reference_map_of(const scenes::ByteImage& left,
                                                                const scenes::ByteImage& right,
                                                                bool by_rank) {
  const stereo_reference::Method method =
      by_rank ? stereo_reference::Method::rank3 : stereo_reference::Method::census3;
  const scenes::ByteImage map =
      stereo_reference::check_left_right(stereo_reference::match(method, left, right, {}));
  return stereo_reference::post_process(map, left).pixels();
}

// What the firmware must compute for views of 640x480, which it samples and need not rectify.
[[nodiscard]] inline std::vector<std::uint8_t> reference_map(const scenes::ByteImage& left,
                                                             const scenes::ByteImage& right,
                                                             bool by_rank = false) {
  return reference_map_of(stereo_reference::subsample_by_4(left),
                          stereo_reference::subsample_by_4(right), by_rank);
}
[[nodiscard]] inline std::vector<std::uint8_t> reference_map(const scenes::Scene& scene,
                                                             bool by_rank = false) {
  return reference_map(scene.left, scene.right, by_rank);
}

}  // namespace finback
