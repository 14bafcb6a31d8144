// The fast engine against the plain evaluator: equal registers, flags, memory and cycles on random
// programs.
#include <algorithm>
#include <gtest/gtest.h>

#include "core_harness.hpp"
#include "random_program.hpp"

namespace finback::core {
namespace {

// What the table says that the executed instructions moved, and what the memory counted.
Bytes profiled_l1_bytes(CoreHarness& harness) {
  Bytes bytes = 0;
  for (const FunctionProfile& function : harness.core().profile().functions) {
    bytes += function.bytes[static_cast<std::size_t>(memory::Level::l1)];
  }
  return bytes;
}
Bytes counted_l1_bytes(CoreHarness& harness) {
  Bytes bytes = 0;
  for (const memory::Direction direction : {memory::Direction::read, memory::Direction::write}) {
    bytes += harness.memory()
                 .level_traffic(memory::Level::l1, memory::Initiator::core_a, direction)
                 .bytes;
  }
  return bytes;
}

class Differential : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Differential, EngineEqualsEvaluator) {
  const std::string text = random_program(GetParam(), 400);
  CoreHarness engine(text);
  CoreHarness plain(text);
  const Cycles engine_cycles = engine.run();
  const Cycles plain_cycles = plain.evaluate();
  EXPECT_EQ(engine_cycles, plain_cycles);
  for (int reg = 0; reg < isa::kRegisterCount; ++reg) {
    EXPECT_EQ(engine.core().state().reg[static_cast<std::size_t>(reg)],
              plain.evaluator().state().reg[static_cast<std::size_t>(reg)])
        << isa::register_name(static_cast<isa::Register>(reg));
  }
  EXPECT_EQ(engine.core().state().astat(), plain.evaluator().state().astat());
  EXPECT_EQ(engine.core().state().accumulator, plain.evaluator().state().accumulator);
  EXPECT_EQ(engine.core().profile().packets, plain.evaluator().packets());
  EXPECT_EQ(profiled_l1_bytes(engine), counted_l1_bytes(engine));
  for (const ir::PlacedObject& object : engine.image().objects) {
    const auto left = engine.memory().view_bytes(object.address, object.size);
    const auto right = plain.memory().view_bytes(object.address, object.size);
    EXPECT_TRUE(std::ranges::equal(left, right)) << object.name;
  }
  if (HasFailure()) {
    std::puts(text.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Differential, testing::Range(1U, 201U));

}  // namespace
}  // namespace finback::core
