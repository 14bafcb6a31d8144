// The ladder for teaching: firmwares that compute the same map, each a small change from the one
// before (firmware/labs/, docs/finback-lab.md).
//
// Models nothing: finds the rungs that are installed, in their order, and what they are made of.
#pragma once

#include <string>
#include <vector>

#include <common/text_diff.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

struct Rung {
  std::string name;      // "modular"; of somebody's own firmware its path, as it was given
  std::string change;    // what it changes against the rung before, one line; "" where not known
  std::string firmware;  // as find_firmware takes it
};

// The installed rungs from the bottom to the top. Throws InputError: not installed, or what is
// wrong in ladder.toml.
[[nodiscard]] std::vector<Rung> load_ladder();

// A rung by its name, or, of a name with a slash, the firmware that lies there. Throws InputError:
// no such rung (the nearest, and all).
[[nodiscard]] Rung find_rung(const std::vector<Rung>& ladder, const std::string& name);

// What people wrote of a rung: manifest, placement, sources of its own (not those of the runtime
// and the drivers), by the names of files without folders. Throws InputError as load_firmware does.
[[nodiscard]] std::vector<NamedText> sources_of(const Rung& rung);

// How to get from one rung to another: unified diffs of what differs, in the order of the names.
[[nodiscard]] std::string rung_diff(const Rung& before, const Rung& after);

// Which maps of `runs` differ from those of the first: "" when all are equal, else one line that
// names the first that does and the number of its pixels that are others.
[[nodiscard]] std::string differing_maps(
    const std::vector<std::string>& names,
    const std::vector<std::vector<machine::PublishedMap>>& maps);

}  // namespace finback::runner
