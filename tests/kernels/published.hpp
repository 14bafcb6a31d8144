// The cycle counts that have been published for functions of a DSP library, and the calls of our
// kernels that correspond to them. Source: hardware.md, section 6.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "kernel_call.hpp"

namespace finback::kernels {

struct Published {
  std::string kernel;
  std::string size;
  Cycles cycles;
  std::string source;  // "measured" or "formula", as docs/fidelity.md explains them
  bool reached;  // whether our kernel comes within the tolerance: docs/fidelity.md says why not
  std::function<KernelCall()> call;
};

[[nodiscard]] const std::vector<Published>& published();

// Of the kernels with several sizes: the published cycles are `fixed` and what `growing` says.
struct Terms {
  std::string kernel;
  int fixed;
  std::string growing;
};

[[nodiscard]] const std::vector<Terms>& published_terms();

// Simulated cycles less the published ones.
[[nodiscard]] std::int64_t difference(const Published& figure, KernelCall call);
[[nodiscard]] inline std::int64_t difference(const Published& figure) {
  return difference(figure, figure.call());
}

// Whether it is near enough: 2 % or 4 cycles, whichever is more.
[[nodiscard]] bool within(std::int64_t difference, const Published& figure);

// Calls of the kernels with buffers made for them.
[[nodiscard]] KernelCall fir(const Halves& input, const Halves& taps);
[[nodiscard]] KernelCall multiply(const Halves& x, const Halves& y, std::size_t rows,
                                  std::size_t inner, std::size_t columns);
[[nodiscard]] KernelCall transpose(const Halves& a, std::size_t rows, std::size_t columns);
[[nodiscard]] KernelCall over_vector(const std::string& kernel, const Halves& x);

// `count` halves of all sizes and both signs; deterministic.
[[nodiscard]] Halves noise(std::size_t count);

}  // namespace finback::kernels
