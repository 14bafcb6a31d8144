// The fast engine against the plain evaluator: equal registers, flags, memory and cycles on random
// programs.
#include <algorithm>
#include <cstdlib>
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

// 10,000 programs, a few long ones among them; FINBACK_RANDOM_PROGRAMS asks for more
// (CONTRIBUTING.md). Sanitizers look for slips of memory, which fewer show as well.
#ifdef __SANITIZE_ADDRESS__
constexpr long kPrograms = 1'000;
#else
constexpr long kPrograms = 10'000;
#endif
constexpr std::uint32_t kBatches = 100;
constexpr std::uint32_t kShort = 30;  // packets
constexpr std::uint32_t kLong = 400;

std::uint32_t programs_a_batch() {
  const char* wanted = std::getenv("FINBACK_RANDOM_PROGRAMS");
  const long programs = wanted == nullptr ? 0 : std::strtol(wanted, nullptr, 10);
  return static_cast<std::uint32_t>(std::max(programs, kPrograms)) / kBatches;
}

void compare_engines(const std::string& text, int store_buffer_stall) {
  CoreHarness engine(text);
  CoreHarness plain(text);
  engine.parameters().store_buffer_stall.set(store_buffer_stall);
  plain.parameters().store_buffer_stall.set(store_buffer_stall);
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
}

class Differential : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Differential, EngineEqualsEvaluator) {
  const std::uint32_t programs = programs_a_batch();
  for (std::uint32_t i = 0; i < programs; ++i) {
    const std::uint32_t seed = 1 + GetParam() * programs + i;
    const std::string text = random_program(seed, i == 0 ? kLong : kShort);
    ASSERT_NO_THROW(compare_engines(text, i % 4 == 1 ? 3 : 0)) << text;
    ASSERT_FALSE(HasFailure()) << "seed " << seed << "\n" << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Differential, testing::Range(0U, kBatches));

}  // namespace
}  // namespace finback::core
