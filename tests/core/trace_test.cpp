// A traced core does what one does that nobody looks at, in the same cycles, and what it tells is
// all of it.
#include <gtest/gtest.h>

#include "control_programs.hpp"
#include "core_harness.hpp"
#include "random_program.hpp"
#include "trace_tally.hpp"

namespace finback::core {
namespace {

void compare_traced(const std::string& text) {
  CoreHarness plain(text);
  CoreHarness traced(text);
  TraceTally tally;
  traced.trace(tally.sink());
  EXPECT_EQ(traced.run(), plain.run());
  EXPECT_EQ(traced.core().state().reg, plain.core().state().reg);
  EXPECT_EQ(traced.exit_status(), plain.exit_status());
  tally.check(traced.core().profile());
}

TEST(Trace, OfRandomProgramsIsTheRun) {
  constexpr std::uint32_t kPrograms = 100;
  constexpr std::uint32_t kFirst = 70'000;
  for (std::uint32_t seed = kFirst; seed < kFirst + kPrograms; ++seed) {
    const std::string text = random_program(seed, 60);
    ASSERT_NO_THROW(compare_traced(text)) << text;
    ASSERT_FALSE(HasFailure()) << "seed " << seed << "\n" << text;
  }
}

// With interrupts, exceptions that undo packets, single steps, the timer and user mode.
TEST(Trace, OfEventsAndModesIsTheRun) {
  for (const std::string& text : control_programs()) {
    ASSERT_NO_THROW(compare_traced(text)) << text;
    ASSERT_FALSE(HasFailure()) << text;
  }
}

std::vector<TraceRecord> records_of(const std::string& body) {
  CoreHarness harness(program(body));
  std::vector<TraceRecord> records;
  harness.trace([&records](const TraceRecord& record) { records.push_back(record); });
  harness.run();
  return records;
}

// Packet 3 waits, for `cause`.
TraceCost wait_of(const std::vector<TraceRecord>& records, Cause cause) {
  for (const TraceCost& cost : records[3].costs) {
    if (cost.cause == cause) {
      return cost;
    }
  }
  return {};
}

TEST(Trace, AnInterlockNamesItsRegister) {
  const TraceCost wait =
      wait_of(records_of("R1 = 4 (X); NOP; P1 = R1; P2 = P1 + P0;"), Cause::hazard_address);
  EXPECT_EQ(wait.cycles, 4U);
  EXPECT_EQ(wait.reg, isa::P1);
  const TraceCost early =
      wait_of(records_of("R1 = 4 (X); NOP; R2 = R1 + R1; R3.L = ONES R2;"), Cause::hazard_ex1);
  EXPECT_EQ(early.cycles, 1U);
  EXPECT_EQ(early.reg, isa::R2);
}

TEST(Trace, TheLastPacketOfABlockPaysForTheWayOut) {
  const std::vector<TraceRecord> records = records_of("NOP; NOP; NOP; JUMP.S .Lx; NOP; .Lx: NOP;");
  EXPECT_EQ(wait_of(records, Cause::branch_taken).cycles, 4U);
  ASSERT_EQ(records.size(), 6U);
  EXPECT_EQ(records[4].begin, 3U + 5);
  EXPECT_EQ(records[4].packet, 5U);
}

TEST(Trace, ShowsWhatLedToAFault) {
  CoreHarness harness(program("R0 = 1 (X); R1 = 2 (X); P0 = 2 (X); R2 = [P0]; NOP;"));
  std::vector<TraceRecord> records;
  harness.trace([&records](const TraceRecord& record) { records.push_back(record); });
  EXPECT_THROW(harness.run(), GuestFault);
  harness.core().end_trace();
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[2].kind, TraceRecord::Kind::packet);
  EXPECT_EQ(records[3].kind, TraceRecord::Kind::undone);
}

}  // namespace
}  // namespace finback::core
