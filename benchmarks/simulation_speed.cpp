// How fast the machine is simulated, on loops of one kind each and on the firmware that it is for;
// and, in the same run, a fixed piece of work on the host, so that figures of two machines or two
// days can be compared by their ratio (benchmarks/README.md).
#include <algorithm>
#include <benchmark/benchmark.h>

#include <common/file.hpp>
#include <runner/program_request.hpp>
#include <runner/run_firmware.hpp>
#include <runner/run_program.hpp>

namespace {

using namespace finback;

constexpr std::uint32_t kFrames = 2;
constexpr double kCoreClock = 600e6;  // Hz; the real machine's

// What the cores did, as rates: instructions and cycles of both together, and how many times as
// fast as real cores at 600 MHz.
struct Work {
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;
  std::uint64_t longest = 0;  // of the cores' times

  void add(const report::RunResult& result) {
    std::uint64_t time = 0;
    for (const report::Core& core : result.cores) {
      instructions += core.instructions;
      cycles += core.cycles;
      time = std::max<std::uint64_t>(time, core.cycles);
    }
    longest += time;
  }
  void report_to(benchmark::State& state) const {
    using benchmark::Counter;
    state.counters["instructions/s"] = Counter(static_cast<double>(instructions), Counter::kIsRate);
    state.counters["core_cycles/s"] = Counter(static_cast<double>(cycles), Counter::kIsRate);
    state.counters["times_real_time"] =
        Counter(static_cast<double>(longest) / kCoreClock, Counter::kIsRate);
  }
};

// A program of benchmarks/loops on core A, code and data in its L1.
void loop(benchmark::State& state, const std::string& name) {
  runner::ProgramRequest request;
  request.core_a = {std::string(FINBACK_SOURCE_DIR) + "/benchmarks/loops/" + name + ".s"};
  request.environment = runner::Environment::chip;
  const runner::RunInputs inputs = runner::load_program(request);
  Work work;
  for (auto _ : state) {
    work.add(runner::run_program(inputs, {}).result);
  }
  work.report_to(state);
}

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
  Work work;
  for (auto _ : state) {
    work.add(runner::run_firmware(inputs).result);
  }
  work.report_to(state);
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(kFrames * state.iterations()),
                                                  benchmark::Counter::kIsRate);
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
BENCHMARK_CAPTURE(loop, registers, "registers")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(loop, hamming, "hamming")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(loop, branches, "branches")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulate, mesvs2_synthetic, "mesvs2", "synthetic")
    ->Unit(benchmark::kMillisecond)
    ->MinTime(5);

}  // namespace
