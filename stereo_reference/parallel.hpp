// Work on many pictures at a time, with results that do not depend on how many.
//
// Models: numbered pieces of work, each of which writes to its own place; threads take the next
// one. Does not model: an order among them. Of several failures the one with the smallest number is
// told.
#pragma once

#include <cstddef>
#include <functional>

namespace finback::stereo_reference {

// Looks on from the calling thread, about ten times a second; true: give up what was not begun.
using Watch = std::function<bool(std::size_t done, std::size_t count)>;

struct Parallel {
  unsigned jobs = 1;  // threads
  Watch watch;        // may be empty
};

// Runs work(0) to work(count - 1). False: given up. Throws what a piece of work has thrown.
bool run_all(std::size_t count, const Parallel& how, const std::function<void(std::size_t)>& work);

}  // namespace finback::stereo_reference
