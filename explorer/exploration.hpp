// The exploration itself: simulates what is not known yet, several points at a time.
//
// Each thread has a machine of its own and shares nothing with the others but the list of what is
// left and the store. Which thread does what is left to chance; what comes out is not, since a
// simulation depends on its point alone. A fault of the simulated program is a result like others.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <explorer/candidate.hpp>
#include <explorer/store.hpp>

namespace finback::explorer {

// What is to be done. points = misfits + equal + known + to_simulate.
struct Plan {
  std::size_t points = 0;
  std::size_t misfits = 0;               // cannot be linked
  std::size_t equal = 0;                 // come out the same as an earlier point
  std::size_t known = 0;                 // are in the store
  std::vector<std::size_t> to_simulate;  // into the candidates
  // "64 points: 12 do not fit, 20 known, 32 to simulate"
  [[nodiscard]] std::string to_string() const;
};

[[nodiscard]] Plan plan_of(const std::vector<Candidate>& candidates,
                           const std::set<std::string>& known);

struct Observer {
  // Asked from the calling thread about ten times a second; true ends the exploration.
  std::function<bool(std::size_t done)> watch;
  // Told of each result, one at a time, when it is in the store. May throw: that ends it, too.
  std::function<void(const Candidate& candidate, const Result& result)> finished;
};

// Simulates the plan on `jobs` threads; each result is in the store before its thread begins the
// next. Returns how many were done: fewer than planned when `watch` ended it. Throws what the store
// or the observer throw, when all threads have stopped.
std::size_t simulate(const Space& space, const std::vector<Candidate>& candidates, const Plan& plan,
                     Store& store, unsigned jobs, const Observer& observer = {});

}  // namespace finback::explorer
