// A point made ready: what it runs, whether it can be linked, and what its simulation is known by.
//
// Two points that come out as the same image on the same machine have the same key: they are one
// simulation, in this space and in every other. The key covers what a result depends on: Finback's
// version, the firmware, its image (code and data at their addresses), the machine's and the power
// model's values, the scene, the frames and the time limit. It does not see a change of the
// simulator itself under the same version.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <explorer/points.hpp>
#include <explorer/space.hpp>

namespace finback::explorer {

// What a simulation is known by: hashes (report::content_hash) of all that it depends on.
struct Identity {
  std::string key;  // over all the others
  std::string tool_version;
  std::string firmware;  // name
  std::string firmware_hash;
  std::string image_hash;
  std::string machine_hash;
  std::string power_hash;
  std::string scene;  // name
  std::string scene_hash;
  std::uint32_t frames = 0;
  Cycles cycle_limit = 0;
};

struct Candidate {
  Point point;
  std::string misfit;  // why it cannot be linked, one line; "": it can
  Identity identity;   // when it can
};

// All that a simulation of `point` wants.
[[nodiscard]] runner::RunInputs inputs_of(const Space& space, const Point& point);

// Links every point, each layout once. `cancelled` is asked now and then: true ends the work early,
// and the result is short.
[[nodiscard]] std::vector<Candidate> prepare(const Space& space, const std::vector<Point>& points,
                                             const std::function<bool()>& cancelled = {});

// `text` without the folders of the space and of its firmwares: messages are results, which may not
// depend on where the files lie.
[[nodiscard]] std::string without_folders(const Space& space, std::string text);

// The command that runs one point again: `finback run ...`.
[[nodiscard]] std::string run_command(const Space& space, const Point& point);

}  // namespace finback::explorer
