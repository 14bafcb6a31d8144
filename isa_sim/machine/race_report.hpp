// Races in the words of the program: which object, who, where in the source.
#pragma once

#include <functional>
#include <races/race_detector.hpp>
#include <string>
#include <vector>

#include <isa_sim/ir/image.hpp>

namespace finback::machine {

struct RaceReport {
  std::string object;   // "hand_over_left+16 of shared (0xfeb00010)", or "0x..." where none lies
  std::string earlier;  // "core_b reads in receive_pair (0xff600010, main_b.c:31)"
  std::string later;
  Cycles at = 0;  // when the later access came, the first time
  std::uint64_t bytes = 0;
};

// The memory through which the firmware says that its actors synchronise.
[[nodiscard]] std::vector<races::Range> flags_of(const ir::Image& image);

// `place_of`: a packet of a core, as messages tell it.
[[nodiscard]] RaceReport describe(
    const races::Race& race, const ir::Image& image,
    const std::function<std::string(int core, std::uint32_t packet)>& place_of);

}  // namespace finback::machine
