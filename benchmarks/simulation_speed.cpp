// How fast the machine is simulated, on the firmware that it is for; and, in the same run, a fixed
// piece of work on the host, so that figures of two machines or two days can be compared by their
// ratio (benchmarks/README.md).
#include <benchmark/benchmark.h>

#include <common/file.hpp>
#include <runner/run_firmware.hpp>

namespace {

using namespace finback;

constexpr std::uint32_t kFrames = 2;

runner::RunInputs camera_inputs(const std::string& firmware, const std::string& scene) {
  runner::RunInputs inputs;
  inputs.firmware = runner::find_firmware(firmware, std::nullopt);
  inputs.machine = std::make_unique<machine::MachineDescription>();
  inputs.scene = scenes::load_scene(scene, share_folder() / "scenes");
  inputs.frames = kFrames;
  return inputs;
}

// A whole run, from linking to the gathered result; rates count both cores together.
void simulate(benchmark::State& state, const std::string& firmware, const std::string& scene) {
  const runner::RunInputs inputs = camera_inputs(firmware, scene);
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;
  for (auto _ : state) {
    const runner::RunOutcome outcome = runner::run_firmware(inputs);
    for (const report::Core& core : outcome.result.cores) {
      instructions += core.instructions;
      cycles += core.cycles;
    }
  }
  using benchmark::Counter;
  state.counters["instructions/s"] = Counter(static_cast<double>(instructions), Counter::kIsRate);
  state.counters["core_cycles/s"] = Counter(static_cast<double>(cycles), Counter::kIsRate);
  state.counters["frames/s"] =
      Counter(static_cast<double>(kFrames * state.iterations()), Counter::kIsRate);
}

// The yardstick: a chain of dependent multiplications over a megabyte, one a byte.
void host_yardstick(benchmark::State& state) {
  const std::string bytes(1U << 20U, 'x');
  for (auto _ : state) {
    benchmark::DoNotOptimize(report::content_hash(bytes));
  }
  state.counters["steps/s"] = benchmark::Counter(
      static_cast<double>(bytes.size()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

BENCHMARK(host_yardstick)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulate, mesvs2_synthetic, "mesvs2", "synthetic")
    ->Unit(benchmark::kMillisecond)
    ->MinTime(5);

}  // namespace
