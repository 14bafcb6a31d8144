// What the cameras see, and when they fail: from options to a sequence of pairs and troubles.
//
// Models nothing of its own: sequences and lenses are scenes/, times are peripheral_model/'s.
#pragma once

#include <runner/run_request.hpp>

namespace finback::runner {

// Sets the scene of `inputs`, and its sequence where more is asked for than a scene that stands
// still and is seen as it is. Throws InputError.
void load_scene(const RunRequest& request, RunInputs& inputs);

// Of both cameras, from --drop-frame and --late-frame. Throws InputError.
[[nodiscard]] std::array<std::vector<peripheral::FrameTrouble>, 2> camera_troubles(
    const RunRequest& request);

}  // namespace finback::runner
