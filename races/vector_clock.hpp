// How far each actor had got when somebody last heard of it.
//
// Actors are numbered as memory::Initiator. An actor counts its own steps: one each time that it
// does something that another can hear of. What an actor did up to step n has happened before all
// that somebody does whose clock says at least n for it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <memory_model/memory_map.hpp>

namespace finback::races {

inline constexpr std::size_t kActorCount = memory::kInitiatorCount;

class VectorClock {
 public:
  [[nodiscard]] std::uint32_t operator[](std::size_t actor) const { return steps_[actor]; }
  void step(std::size_t actor) { ++steps_[actor]; }
  // What the other one has heard of, this one has now, too.
  void join(const VectorClock& other) {
    for (std::size_t actor = 0; actor < kActorCount; ++actor) {
      steps_[actor] = std::max(steps_[actor], other.steps_[actor]);
    }
  }

 private:
  std::array<std::uint32_t, kActorCount> steps_{};
};

}  // namespace finback::races
