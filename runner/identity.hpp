// Hashes of what a run is made from (report::content_hash), over the values in force, so that two
// files that mean the same have the same.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <isa_sim/machine/machine_description.hpp>
#include <peripheral_model/camera.hpp>
#include <power_model/power_parameters.hpp>
#include <scenes/scene.hpp>

namespace finback::runner {

// Parameters and regions.
[[nodiscard]] std::string machine_hash(const machine::MachineDescription& machine);
[[nodiscard]] std::string power_hash(const power::PowerParameters& parameters);
// The pixels of both views, and the truth where it is known.
[[nodiscard]] std::string scene_hash(const scenes::Scene& scene);
// The same, with the frames that the cameras do not send or begin late, where there are any.
[[nodiscard]] std::string view_hash(
    const scenes::Scene& scene,
    const std::array<std::vector<peripheral::FrameTrouble>, 2>& troubles);

}  // namespace finback::runner
