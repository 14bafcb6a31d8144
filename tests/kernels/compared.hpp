// The calls of the kernels of benchmarks/compiler, each written by hand and in C, and what their
// results must be. The results come from plain C++ that knows nothing of either version; that of
// the Fourier transform, whose last bits depend on the order of roundings, from its definition in
// floating point, and both versions must give the same bits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kernel_call.hpp"

namespace finback::kernels {

struct Compared {
  std::string kernel;
  std::string size;
  std::function<void(KernelCall&)> arguments;
  std::function<void(KernelCall&)> check;  // fails the running test
};

// One call of each, in the order of the page.
[[nodiscard]] const std::vector<Compared>& compared();

// Other inputs than those that are timed: edges, odd sizes, other alignments.
[[nodiscard]] const std::vector<Compared>& other_inputs();

}  // namespace finback::kernels
