// The cycle counts that have been published for functions of a DSP library, and the calls of our
// kernels that correspond to them. Source: hardware.md, section 6.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kernel_call.hpp"

namespace finback::kernels {

struct Published {
  std::string kernel;
  std::string size;
  Cycles cycles;
  bool reached;  // whether our kernel comes within the tolerance: docs/fidelity.md says why not
  std::function<KernelCall()> call;
};

[[nodiscard]] const std::vector<Published>& published();

// How far a kernel may be away: 2 % or 4 cycles, whichever is more.
[[nodiscard]] Cycles tolerance(Cycles published);

// Calls of the kernels with buffers made for them, the first in sub-bank order of their arguments.
[[nodiscard]] KernelCall fir(const Halves& input, const Halves& taps);
[[nodiscard]] KernelCall multiply(const Halves& x, const Halves& y, int rows, int inner,
                                  int columns);
[[nodiscard]] KernelCall transpose(const Halves& a, int rows, int columns);
[[nodiscard]] KernelCall over_vector(const std::string& kernel, const Halves& x);

// `count` halves of all sizes and both signs; deterministic.
[[nodiscard]] Halves noise(std::size_t count);

}  // namespace finback::kernels
