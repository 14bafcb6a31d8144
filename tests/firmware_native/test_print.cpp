// Does the runtime's printf write what the host's does? Every flag, width and precision against
// each other, on edge values and random ones.
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <vector>

extern "C" {
#include "print/format.h"

/// The formatting's way out; on the target, print.c has it.
void put_character(struct output* output, char character) {
  ++output->written;
  if (output->at < output->end) {
    *output->at++ = character;
  }
}
}

namespace finback {
namespace {

std::string text_of(const char* format, ...) {
  std::vector<char> room(2000);
  output memory = {room.data(), room.data() + room.size(), 0};
  va_list values;
  va_start(values, format);
  va_list rest;
  va_copy(rest, values);
  put_formatted(&memory, format, &rest);
  va_end(rest);
  va_end(values);
  return {room.data(), memory.at};
}

template <typename... Values>
void expect_as_host(const std::string& format, Values... values) {
  std::vector<char> room(2000);
  const int length = std::snprintf(room.data(), room.size(), format.c_str(), values...);
  ASSERT_GE(length, 0) << format;
  ASSERT_EQ(text_of(format.c_str(), values...), std::string(room.data(), room.data() + length))
      << format;
}

/// All combinations of flags with some widths and precisions, before a conversion.
std::vector<std::string> all_prefixes(const std::string& flags) {
  std::vector<std::string> prefixes;
  for (unsigned chosen = 0; chosen < 1U << flags.size(); ++chosen) {
    std::string prefix = "%";
    for (std::size_t i = 0; i < flags.size(); ++i) {
      prefix += (chosen >> i & 1U) != 0 ? std::string(1, flags[i]) : "";
    }
    for (const char* width : {"", "1", "9", "25"}) {
      for (const char* precision : {"", ".", ".0", ".1", ".5", ".17"}) {
        prefixes.push_back(prefix + width + precision);
      }
    }
  }
  return prefixes;
}

TEST(Print, Integers) {
  const std::vector<long long> numbers = {0,
                                          1,
                                          -1,
                                          7,
                                          10,
                                          255,
                                          -128,
                                          32768,
                                          2147483647,
                                          -2147483648LL,
                                          4294967295LL,
                                          999999999999999999LL,
                                          std::numeric_limits<long long>::min(),
                                          std::numeric_limits<long long>::max()};
  for (const std::string& prefix : all_prefixes("-+ 0")) {
    for (const long long number : numbers) {
      for (const char* kind : {"d", "i", "hd", "hhd"}) {
        expect_as_host("[" + prefix + kind + "]", static_cast<int>(number));
      }
      expect_as_host("[" + prefix + "lld]", number);
      expect_as_host("[" + prefix + "ld]", static_cast<long>(number));
      expect_as_host("[" + prefix + "jd]", static_cast<std::intmax_t>(number));
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
  }
  for (const std::string& prefix : all_prefixes("-0#")) {
    for (const long long number : numbers) {
      for (const char* kind : {"x", "X", "o", "hx", "hho"}) {
        expect_as_host("[" + prefix + kind + "]", static_cast<unsigned>(number));
      }
      expect_as_host("[" + prefix + "llx]", static_cast<unsigned long long>(number));
      expect_as_host("[" + prefix + "llo]", static_cast<unsigned long long>(number));
      expect_as_host("[" + prefix + "zX]", static_cast<std::size_t>(number));
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
  }
  for (const std::string& prefix : all_prefixes("-0")) {
    expect_as_host("[" + prefix + "u]", 4294967295U);
    expect_as_host("[" + prefix + "llu]", 18446744073709551615ULL);
  }
}

TEST(Print, TextsAndTheRest) {
  for (const char* format : {"[%s]", "[%10s]", "[%-10s]", "[%.2s]", "[%10.0s]", "[%-7.3s]"}) {
    expect_as_host(format, "finback");
    expect_as_host(format, "");
  }
  expect_as_host("[%c%5c%-5c]", 'a', 'b', 'c');
  expect_as_host("%%[%5d%%]", 3);
  expect_as_host("[%*d|%-*d|%*d]", 6, 1, 6, 2, -6, 3);
  expect_as_host("[%.*f|%.*f|%*.*e]", 2, 3.14159, -1, 2.5, 12, 3, 1e10);
  expect_as_host("[%.*d]", -3, 0);
  int host = 0;
  int guest = 0;
  std::vector<char> room(40);
  std::snprintf(room.data(), room.size(), "four%n", &host);
  text_of("four%n", &guest);
  EXPECT_EQ(guest, host);
  EXPECT_EQ(text_of("[%s]", nullptr), "[(null)]");
  EXPECT_EQ(text_of("[%p]", reinterpret_cast<void*>(0x1234)), "[0x1234]");
}

TEST(Print, DoublesWithEveryFlag) {
  using Limits = std::numeric_limits<double>;
  const std::vector<double> numbers = {0.0,
                                       -0.0,
                                       1,
                                       -1,
                                       0.5,
                                       1.5,
                                       2.5,
                                       0.125,
                                       9.5,
                                       9.995,
                                       0.1,
                                       1e-5,
                                       1e-4,
                                       123456,
                                       1234567,
                                       1e15,
                                       1e22,
                                       123456789.125,
                                       Limits::max(),
                                       Limits::min(),
                                       Limits::denorm_min(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       Limits::quiet_NaN()};
  for (const std::string& prefix : all_prefixes("-+ 0#")) {
    for (const double number : numbers) {
      for (const char* kind : {"f", "e", "g", "G"}) {
        expect_as_host("[" + prefix + kind + "]", number);
      }
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
  }
  expect_as_host("[%F %E]", Limits::infinity(), Limits::quiet_NaN());
  EXPECT_EQ(text_of("%#.5g", 99999.95), "1.0000e+05");  // which not every C library gets right
  expect_as_host("%.1074f", Limits::denorm_min());
  expect_as_host("%.1100e", Limits::denorm_min());
  expect_as_host("%.400g", Limits::max());
}

TEST(Print, RandomDoubles) {
  std::mt19937_64 generator(11);
  for (int i = 0; i < 50'000; ++i) {
    std::uint64_t bits = generator();
    if (i % 2 == 0) {  // near one, with few bits: many ties
      bits = (bits >> 63 << 63) | (1023 + bits % 64 - 32) << 52 | (bits >> 20 & 0xFFFULL) << 40;
    }
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    const std::string precision = "%." + std::to_string(generator() % 24);
    expect_as_host(precision + "f", number);
    expect_as_host(precision + "e", number);
    expect_as_host(precision + "g", number);
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
}

}  // namespace
}  // namespace finback
