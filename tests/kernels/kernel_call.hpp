// One call of a kernel of benchmarks from a small program of its own, on one core.
//
// The caller is what a C compiler would write: arguments in R0, R1, R2 and on the stack, then CALL.
// Its cycles are those between two reads of CYCLES around this: argument set-up, call, kernel and
// return. Code and data lie in L1, each buffer in a sub-bank of its own. Does not model caches or a
// caller that has its arguments at hand.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <tests/core/core_harness.hpp>
#include <vector>

namespace finback::kernels {

using Halves = std::vector<std::int16_t>;
using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::int32_t>;

class KernelCall {
 public:
  // `kernel`: the function and its file in `folder`, without "_" and ".bir".
  explicit KernelCall(std::string kernel, std::string folder = FINBACK_KERNELS)
      : kernel_(std::move(kernel)), folder_(std::move(folder)) {}

  // Links the kernel with a unit of the runtime, written in BIR.
  KernelCall& with(const std::string& path);
  // The next argument, a number.
  KernelCall& number(std::int64_t value);
  // The next argument: the address of these values.
  KernelCall& buffer(const Halves& values);
  KernelCall& buffer(const Bytes& values);
  KernelCall& buffer(const Words& values);
  // The next argument: the address `bytes` into these values.
  KernelCall& inside(const Halves& values, std::size_t bytes);
  KernelCall& inside(const Bytes& values, std::size_t bytes);
  // The next argument: the address of `words`, each a number or "@N" or "@N + bytes", an
  // address in buffer N, which may be one of those that are no arguments.
  KernelCall& record(const std::vector<std::string>& words);
  // A buffer that is no argument.
  KernelCall& hidden_buffer(const Halves& values);
  KernelCall& hidden_buffer(const Bytes& values);
  // Lets all buffers begin in one sub-bank.
  KernelCall& crowded();

  // Adjusts the core, before run().
  [[nodiscard]] core::CoreParameters& parameters();

  // Runs the call; its cycles. Fails the running test when the kernel does not keep the registers
  // that a C function keeps.
  Cycles run();
  // After run().
  [[nodiscard]] std::uint32_t result();
  [[nodiscard]] Halves halves(std::size_t buffer);
  [[nodiscard]] Bytes bytes(std::size_t buffer);
  [[nodiscard]] Words words(std::size_t buffer);

 private:
  void argument(const std::string& value);
  void next_argument(std::size_t bytes);  // `bytes` into the buffer that follows
  [[nodiscard]] core::CoreHarness& harness();
  [[nodiscard]] std::string caller() const;

  std::string kernel_;
  std::string folder_;
  std::string linked_;  // the units' text
  std::vector<std::string> arguments_;
  std::vector<std::string> objects_;            // the lines of each, from its label on
  std::size_t alignment_ = 4096;                // a sub-bank each
  std::shared_ptr<core::CoreHarness> harness_;  // made when first wanted
};

}  // namespace finback::kernels
