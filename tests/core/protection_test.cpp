// CPLBs: who may access what, and what the fault registers tell.
#include <gtest/gtest.h>

#include "core_harness.hpp"

namespace finback::core {
namespace {

constexpr Address kRegisters = Protection::kFirstRegister;
constexpr std::uint32_t kOn = 2, kValid = 1, kUserRead = 4, kUserWrite = 8, kSupervisorWrite = 0x10;
constexpr std::uint32_t kPage4K = 0x10000;

class Cplbs : public testing::Test {
 protected:
  Cplbs() {
    write(0x100, 0x1000);
    write(0x200, kValid | kUserRead | kSupervisorWrite | kPage4K);
    write(0x104, 0x1800);
    write(0x204, kValid | kUserRead | kUserWrite | kSupervisorWrite);
    write(0x004, kOn);
  }
  void write(Address offset, std::uint32_t value) {
    ASSERT_TRUE(protection_.write(kRegisters + offset, value));
  }
  std::uint32_t read(Address offset) {
    std::uint32_t value = 0;
    EXPECT_TRUE(protection_.read(kRegisters + offset, value));
    return value;
  }
  int check(Address address, bool is_write, bool supervisor, int bytes = 4) {
    return protection_.check_data(
        {.address = address, .bytes = bytes, .write = is_write, .supervisor = supervisor});
  }
  Protection protection_;
};

TEST_F(Cplbs, GrantWhatTheySay) {
  EXPECT_EQ(check(0x1000, true, true), 0);
  EXPECT_EQ(check(0x1000, false, false), 0);
  EXPECT_EQ(check(0x1000, true, false), kDataProtection);
  EXPECT_EQ(read(0x00C), 0x1000U);
  EXPECT_EQ(read(0x008), 1U << 16 | 1U);  // a write in user mode, CPLB 0
}

TEST_F(Cplbs, MissAndDoubleHit) {
  EXPECT_EQ(check(0x3000, false, true), kDataMiss);
  EXPECT_EQ(read(0x008), 1U << 19 | 1U << 17);
  EXPECT_EQ(check(0x1900, false, true), kDataMultipleHits);
  EXPECT_EQ(read(0x008), 1U << 17 | 3U);
  EXPECT_EQ(check(0x1C00, false, true), 0);  // behind the second's 1 KB
}

TEST_F(Cplbs, AlignmentAndWhatNeedsNone) {
  EXPECT_EQ(check(0x1001, false, true, 2), kMisalignedAccess);
  EXPECT_EQ(check(0xFF800000, true, false), 0);  // L1
  EXPECT_EQ(check(0xFFE02000, true, true), 0);   // registers
  EXPECT_EQ(check(0xFFE02000, true, false), kDataProtection);
}

TEST_F(Cplbs, FetchNeedsOneOfItsOwn) {
  EXPECT_EQ(protection_.check_fetch(0xFFA00000, false), 0);
  EXPECT_EQ(protection_.check_fetch(0x1000, true), kFetchMiss);
  write(0x1100, 0x1000);
  write(0x1200, kValid);
  EXPECT_EQ(protection_.check_fetch(0x1000, true), 0);
  EXPECT_EQ(protection_.check_fetch(0x1000, false), kFetchProtection);
  EXPECT_EQ(read(0x100C), 0x1000U);
}

TEST_F(Cplbs, RegistersThatAreNone) {
  EXPECT_FALSE(protection_.write(kRegisters + 0x010, 0));
  EXPECT_FALSE(protection_.write(kRegisters + 0x408, 0));
  std::uint32_t value = 0;
  EXPECT_FALSE(protection_.read(kRegisters + 0x140, value));
  EXPECT_EQ(read(0), 0xFF800000U);
}

// An access that went the short way before is checked too, and its packet can be repeated.
TEST(CplbsOnACore, StopTheNextAccess) {
  CoreHarness harness(
      program("P0.L = 0x200C; P0.H = 0xFFE0; R1.L = _refused; R1.H = _refused; [P0] = R1;"
              "P1.L = 0; P1.H = 0xFFE0; P2.L = 0x0100; P2.H = 0xFFE0; P3.L = _word; P3.H = _word;"
              "R2 = 1; R7 = 0; R4 = 0; P4 = 2; LSETUP (.Ltop, .Lend) LC0 = P4; .Ltop: [P3] = R2;"
              "R4 += 1; R1 = P3; [P2] = R1; R1 = 1; [P2 + 0x100] = R1; R1 = 2; [P1 + 4] = R1;"
              ".Lend: R2 += 1; R3 = [P3]; R1 = 0; [P1 + 4] = R1;") +
      ".text\n.type _refused, @function\n_refused: R7 += 1; R6 = SEQSTAT; R5 = [P1 + 12];"
      "R1 = 0x11 (X); [P2 + 0x100] = R1; RTX;\n.size _refused, .-_refused\n"
      ".data\n.align 4\n.type _word, @object\n_word: .byte4 0\n.size _word, 4\n");
  harness.run();
  EXPECT_EQ(harness.reg(isa::R7), 1U);
  EXPECT_EQ(harness.reg(isa::R6), static_cast<std::uint32_t>(kDataProtection));
  EXPECT_EQ(harness.reg(isa::R5), harness.reg(isa::P3));
  EXPECT_EQ(harness.reg(isa::R4), 2U);
  EXPECT_EQ(harness.reg(isa::R3), 2U);
}

}  // namespace
}  // namespace finback::core
