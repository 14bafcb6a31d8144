// Does the runtime do what the C language asks of it? (How fast it is, the simulator says.)
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

extern "C" {
void* guest_memcpy(void* destination, const void* source, std::size_t bytes);
void* guest_memmove(void* destination, const void* source, std::size_t bytes);
void* guest_memset(void* destination, int value, std::size_t bytes);
std::uint32_t guest_udivsi3(std::uint32_t dividend, std::uint32_t divisor);
std::uint32_t guest_umodsi3(std::uint32_t dividend, std::uint32_t divisor);
std::int32_t guest_divsi3(std::int32_t dividend, std::int32_t divisor);
std::int32_t guest_modsi3(std::int32_t dividend, std::int32_t divisor);
std::uint64_t guest_udivdi3(std::uint64_t dividend, std::uint64_t divisor);
std::uint64_t guest_umoddi3(std::uint64_t dividend, std::uint64_t divisor);
std::int64_t guest_divdi3(std::int64_t dividend, std::int64_t divisor);
std::int64_t guest_moddi3(std::int64_t dividend, std::int64_t divisor);
}

namespace finback {
namespace {

constexpr std::size_t kBytes = 64;

std::vector<std::uint8_t> counted_bytes() {
  std::vector<std::uint8_t> bytes(kBytes);
  for (std::size_t i = 0; i < kBytes; ++i) {
    bytes[i] = static_cast<std::uint8_t>(i + 1);
  }
  return bytes;
}

TEST(Runtime, MemcpyAndMemmoveOfEveryAlignmentAndSize) {
  for (std::size_t to = 0; to < 8; ++to) {
    for (std::size_t from = 0; from < 8; ++from) {
      for (std::size_t size = 0; size <= 40; ++size) {
        const std::vector<std::uint8_t> source = counted_bytes();
        std::vector<std::uint8_t> expected(kBytes, 0xEE);
        std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), size,
                    expected.begin() + static_cast<std::ptrdiff_t>(to));
        std::vector<std::uint8_t> copy(kBytes, 0xEE);
        EXPECT_EQ(guest_memcpy(&copy[to], &source[from], size), &copy[to]);
        ASSERT_EQ(copy, expected) << to << " " << from << " " << size;

        // Both ways over itself.
        std::vector<std::uint8_t> moved = counted_bytes();
        std::vector<std::uint8_t> moved_expected = counted_bytes();
        std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), size,
                    moved_expected.begin() + static_cast<std::ptrdiff_t>(to));
        EXPECT_EQ(guest_memmove(&moved[to], &moved[from], size), &moved[to]);
        ASSERT_EQ(moved, moved_expected) << to << " " << from << " " << size;
      }
    }
  }
}

TEST(Runtime, MemsetOfEveryAlignmentAndSize) {
  for (std::size_t to = 0; to < 8; ++to) {
    for (std::size_t size = 0; size <= 40; ++size) {
      std::vector<std::uint8_t> expected = counted_bytes();
      std::fill_n(expected.begin() + static_cast<std::ptrdiff_t>(to), size, 0xA5);
      std::vector<std::uint8_t> bytes = counted_bytes();
      EXPECT_EQ(guest_memset(&bytes[to], 0x1A5, size), &bytes[to]);
      ASSERT_EQ(bytes, expected) << to << " " << size;
    }
  }
}

TEST(Runtime, DivisionEqualsTheHosts) {
  std::mt19937 generator(31);
  std::vector<std::uint32_t> numbers = {
      0, 1, 2, 3, 7, 10, 0x7FFFFFFF, 0x80000000, 0x80000001, 0xFFFFFFFE, 0xFFFFFFFF};
  for (int i = 0; i < 200; ++i) {
    numbers.push_back(static_cast<std::uint32_t>(generator() >> generator() % 32U));
  }
  for (const std::uint32_t dividend : numbers) {
    for (const std::uint32_t divisor : numbers) {
      if (divisor == 0) {
        continue;
      }
      ASSERT_EQ(guest_udivsi3(dividend, divisor), dividend / divisor);
      ASSERT_EQ(guest_umodsi3(dividend, divisor), dividend % divisor);
      const auto signed_dividend = static_cast<std::int32_t>(dividend);
      const auto signed_divisor = static_cast<std::int32_t>(divisor);
      if (signed_dividend == std::numeric_limits<std::int32_t>::min() && signed_divisor == -1) {
        continue;  // overflows: undefined in C
      }
      ASSERT_EQ(guest_divsi3(signed_dividend, signed_divisor), signed_dividend / signed_divisor);
      ASSERT_EQ(guest_modsi3(signed_dividend, signed_divisor), signed_dividend % signed_divisor);
    }
  }
}

TEST(Runtime, LongDivisionEqualsTheHosts) {
  std::mt19937_64 generator(32);
  std::vector<std::uint64_t> numbers = {0,
                                        1,
                                        2,
                                        3,
                                        10,
                                        0xFFFFFFFF,
                                        0x100000000,
                                        0x100000001,
                                        0x7FFFFFFFFFFFFFFF,
                                        0x8000000000000000,
                                        0x8000000000000001,
                                        0xFFFFFFFFFFFFFFFF};
  for (int i = 0; i < 300; ++i) {
    numbers.push_back(generator() >> generator() % 64U);
  }
  for (const std::uint64_t dividend : numbers) {
    for (const std::uint64_t divisor : numbers) {
      if (divisor == 0) {
        continue;
      }
      ASSERT_EQ(guest_udivdi3(dividend, divisor), dividend / divisor);
      ASSERT_EQ(guest_umoddi3(dividend, divisor), dividend % divisor);
      const auto signed_dividend = static_cast<std::int64_t>(dividend);
      const auto signed_divisor = static_cast<std::int64_t>(divisor);
      if (signed_dividend == std::numeric_limits<std::int64_t>::min() && signed_divisor == -1) {
        continue;  // overflows: undefined in C
      }
      ASSERT_EQ(guest_divdi3(signed_dividend, signed_divisor), signed_dividend / signed_divisor);
      ASSERT_EQ(guest_moddi3(signed_dividend, signed_divisor), signed_dividend % signed_divisor);
    }
  }
}

TEST(Runtime, DivisionByZeroGivesOnesAndTheDividend) {
  EXPECT_EQ(guest_udivdi3(77, 0), 0xFFFFFFFFFFFFFFFFU);
  EXPECT_EQ(guest_umoddi3(77, 0), 77U);
  EXPECT_EQ(guest_udivsi3(77, 0), 0xFFFFFFFFU);
  EXPECT_EQ(guest_umodsi3(77, 0), 77U);
}

}  // namespace
}  // namespace finback
