// Each time of the memories by the scenario that shows it: with a parameter one unit up, the
// scenario takes exactly what is expected longer, and nothing else has changed.
#include <tests/memory_model/memory_fixture.hpp>

namespace finback::memory {
namespace {

struct Probe {
  const char* parameter;
  double value;         // instead of the default
  std::int64_t change;  // of what is measured
  Cycles (*measure)(MemorySystem&);
};

Cycles load(MemorySystem& memory, int core, Address address, Cycles now) {
  return memory.core_read(core, memory.find_span(core, address), address, 4, now);
}
Cycles stored_at(MemorySystem& memory, Address address, Cycles now) {
  memory.core_write(0, memory.find_span(0, address), address, 4, now);
  return memory.writes_drained_at(0);
}
Cycles dma(MemorySystem& memory, Address address) {
  const DmaRun run{.address = address, .stride = 4, .count = 4};
  return memory.dma_burst(Initiator::mdma1_0, Direction::read, {&run, 1}, 4, 1000, 1000);
}

// In SDRAM: a row that is open, and another one of the same bank.
constexpr Address kOtherRow = 0x4000;
Cycles open_row(MemorySystem& memory) { return load(memory, 0, kL3, 100); }

Cycles dma_of_l1(MemorySystem& memory) { return dma(memory, kL1A); }
Cycles dma_of_l2(MemorySystem& memory) { return dma(memory, kL2); }
Cycles store_to_l2(MemorySystem& memory) { return stored_at(memory, kL2, 1000); }
Cycles both_cores_in_l2(MemorySystem& memory) {
  load(memory, 0, kL2, 1000);
  return load(memory, 1, kL2 + 64, 1000);
}
Cycles core_beside_dma_in_l2(MemorySystem& memory) {
  dma(memory, kL2);
  return load(memory, 0, kL2, 1010);
}
Cycles load_of_open_row(MemorySystem& memory) {
  open_row(memory);
  return load(memory, 0, kL3, 1000);
}
Cycles load_of_other_row(MemorySystem& memory) {
  open_row(memory);
  return load(memory, 0, kOtherRow, 1000);
}
Cycles store_to_other_row(MemorySystem& memory) {
  open_row(memory);
  return stored_at(memory, kOtherRow, 1000);
}
Cycles store_to_open_row(MemorySystem& memory) {
  open_row(memory);
  return stored_at(memory, kL3, 1000);
}
Cycles both_cores_in_l3(MemorySystem& memory) {
  open_row(memory);
  load(memory, 0, kL3, 1000);
  return load(memory, 1, kL3, 1000);
}
Cycles refreshes(MemorySystem& memory) {
  load(memory, 0, kL3, 50'000);
  CounterRegistry registry;
  memory.register_counters(registry);
  return registry.snapshot().at("memory.sdram.refresh.events").value;
}
Cycles policy_of_l2(MemorySystem& memory) {
  return static_cast<Cycles>(memory.default_policy(Level::l2));
}

constexpr std::int64_t kOneSclk = kSclk;

TEST(MemoryParameters, EachShowsInItsScenario) {
  const Probe probes[] = {
      {"memory.l1.dma_overhead_sclk", 3, kOneSclk, dma_of_l1},
      {"memory.l1.dma_word_sclk", 2, 4 * kOneSclk, dma_of_l1},
      {"memory.l2.write_cycles", 4, 1, store_to_l2},
      {"memory.l2.contention_cycles", 3, 1, both_cores_in_l2},
      {"memory.l2.dma_collision_cycles", 3, 1, core_beside_dma_in_l2},
      {"memory.l2.dma_overhead_sclk", 3, kOneSclk, dma_of_l2},
      {"memory.l2.dma_word_sclk", 2, 4 * kOneSclk, dma_of_l2},
      {"memory.cache.l2_policy", 3, 3, policy_of_l2},
      {"memory.sdram.cl_sclk", 4, kOneSclk, load_of_open_row},
      {"memory.sdram.trp_sclk", 4, kOneSclk, load_of_other_row},
      {"memory.sdram.twr_sclk", 3, kOneSclk, store_to_other_row},
      {"memory.sdram.core_read_overhead_sclk", 6, kOneSclk, load_of_open_row},
      {"memory.sdram.core_read_hold_sclk", 5, kOneSclk, both_cores_in_l3},
      {"memory.sdram.write_sclk", 2, kOneSclk, store_to_open_row},
      {"memory.sdram.refresh_period_ns", 15'624, -5, refreshes},
  };
  const ClockParameters clock;
  for (const Probe& probe : probes) {
    MemoryParameters parameters;
    MemorySystem as_it_is(bf561_map(), parameters, clock, {});
    const Cycles before = probe.measure(as_it_is);
    const auto found = std::ranges::find_if(parameters.parameters(), [&](const auto* parameter) {
      return parameter->declaration().name == probe.parameter;
    });
    ASSERT_NE(found, parameters.parameters().end()) << probe.parameter;
    (*found)->set(probe.value);
    MemorySystem changed(bf561_map(), parameters, clock, {});
    EXPECT_EQ(static_cast<std::int64_t>(probe.measure(changed) - before), probe.change)
        << probe.parameter;
  }
}

}  // namespace
}  // namespace finback::memory
