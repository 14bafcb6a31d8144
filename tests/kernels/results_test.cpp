// The kernels compute what their headers say: a kernel that is fast and wrong proves nothing.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "published.hpp"

namespace finback::kernels {
namespace {

// The sum of products of fractions, as 40 bits of accumulator hold it.
std::int64_t product(std::int16_t one, std::int16_t other) {
  return std::min<std::int64_t>(2 * std::int64_t{one} * other, 0x7fffffff);
}

// Rounded at bit 16, halves to even, and saturated.
std::int16_t rounded(std::int64_t sum) {
  std::int64_t value = (sum + 0x8000) >> 16;
  if ((sum & 0xffff) == 0x8000) {
    value &= ~std::int64_t{1};
  }
  return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, -0x8000, 0x7fff));
}

std::int16_t scaled(std::int64_t value) { return static_cast<std::int16_t>(value); }

std::int16_t result_of(KernelCall call) {
  call.run();
  return static_cast<std::int16_t>(call.result());
}

Halves fir_by_definition(const Halves& input, const Halves& taps) {
  Halves output;
  for (std::size_t n = 0; n < input.size(); ++n) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < std::min(taps.size(), n + 1); ++k) {
      sum += product(taps[k], input[n - k]);
    }
    output.push_back(rounded(sum));
  }
  return output;
}

TEST(Kernels, FirFiltersRoundsAndSaturates) {
  for (const std::size_t taps : {2u, 4u, 8u, 20u}) {
    const Halves input = noise(64);
    const Halves coefficients = noise(taps);
    KernelCall call = fir(input, coefficients);
    call.run();
    EXPECT_EQ(call.halves(1), fir_by_definition(input, coefficients)) << taps << " taps";
  }
  KernelCall loud = fir(Halves(8, -32768), {-32768, -32768});
  loud.run();
  EXPECT_EQ(loud.halves(1), Halves(8, 32767));
}

TEST(Kernels, FirKeepsItsLastSamplesForTheNextCall) {
  KernelCall call = fir({1, 2, 3, 4, 5, 6}, {16384, 0, 0, 0});
  call.run();
  Halves delay = call.halves(4);
  EXPECT_EQ(delay, (Halves{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(call.halves(2)[4], call.halves(2)[2]);  // full: where it goes on is the beginning
}

TEST(Kernels, FirOfNothingTouchesNothing) {
  KernelCall call("fir_fr16");
  call.buffer(Halves{7, 7}).buffer(Halves{1, 1}).number(0).record({"@3", "@4", "@4", "2"});
  call.hidden_buffer(Halves{5, 5}).hidden_buffer(Halves(4));
  call.run();
  EXPECT_EQ(call.halves(1), (Halves{1, 1}));
}

TEST(Kernels, MatrixProductIsRowsTimesColumns) {
  struct Shape {
    std::size_t rows;
    std::size_t inner;
    std::size_t columns;
  };
  for (const Shape& shape : {Shape{1, 1, 1}, Shape{3, 5, 2}, Shape{4, 1, 6}, Shape{8, 32, 16}}) {
    const Halves x = noise(shape.rows * shape.inner);
    const Halves y = noise(shape.inner * shape.columns);
    Halves expected;
    for (std::size_t row = 0; row < shape.rows; ++row) {
      for (std::size_t column = 0; column < shape.columns; ++column) {
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < shape.inner; ++k) {
          sum += product(x[row * shape.inner + k], y[k * shape.columns + column]);
        }
        expected.push_back(rounded(sum));
      }
    }
    KernelCall call = multiply(x, y, shape.rows, shape.inner, shape.columns);
    call.run();
    EXPECT_EQ(call.halves(2), expected) << shape.rows << " x " << shape.inner;
  }
}

TEST(Kernels, TransposeSwapsRowsAndColumns) {
  for (const auto& [rows, columns] :
       {std::pair<std::size_t, std::size_t>{1, 1}, {3, 5}, {20, 40}}) {
    const Halves a = noise(rows * columns);
    KernelCall call = transpose(a, rows, columns);
    call.run();
    Halves expected;
    for (std::size_t column = 0; column < columns; ++column) {
      for (std::size_t row = 0; row < rows; ++row) {
        expected.push_back(a[row * columns + column]);
      }
    }
    EXPECT_EQ(call.halves(1), expected) << rows << " x " << columns;
  }
}

TEST(Kernels, LargestIsFoundWhereverItStands) {
  for (std::size_t count = 1; count < 8; ++count) {
    for (std::size_t at = 0; at < count; ++at) {
      Halves x(count, -32768);
      x[at] = -5;
      EXPECT_EQ(result_of(over_vector("vecmax_fr16", x)), -5) << at << " of " << count;
    }
  }
  for (int count = 1; count < 8; ++count) {  // from an odd element on: pairs are out of step
    const Halves rising = {32767, 1, 2, 3, 4, 5, 6, 7, 32767, 32767};
    EXPECT_EQ(result_of(KernelCall("vecmax_fr16").inside(rising, 2).number(count)), count);
  }
  EXPECT_EQ(result_of(over_vector("vecmax_fr16", noise(24))), std::ranges::max(noise(24)));
}

TEST(Kernels, MeanIsTowardsZero) {
  for (const Halves& x : {noise(20), Halves(20, -32768), Halves(3, 32767), Halves{-1, -2},
                          Halves{1, 2}, Halves{-32768, 32767}, Halves{9}}) {
    const std::int64_t sum = std::accumulate(x.begin(), x.end(), std::int64_t{0});
    EXPECT_EQ(result_of(over_vector("mean_fr16", x)),
              scaled(sum / static_cast<std::int64_t>(x.size())));
  }
}

TEST(Kernels, VarianceIsThatOfTheFormula) {
  for (const Halves& x : {noise(255), noise(64), Halves(255, -32768), Halves(128, 32767),
                          Halves{5, -7, 300, 3000, -20000}, Halves{-32768, 32767}, Halves{9}}) {
    const auto n = static_cast<std::int64_t>(x.size());
    const std::int64_t sum = std::accumulate(x.begin(), x.end(), std::int64_t{0});
    const std::int64_t squares =
        std::inner_product(x.begin(), x.end(), x.begin(), std::int64_t{0}, std::plus<>(),
                           [](std::int64_t a, std::int64_t b) { return a * b; });
    const std::int64_t expected =
        n < 2 ? 0
              : std::min<std::int64_t>((n * squares - sum * sum) / (n * (n - 1)) / 32768, 32767);
    EXPECT_EQ(result_of(over_vector("var_fr16", x)), scaled(expected)) << n;
  }
}

TEST(Kernels, NothingHasTheLargestTheMeanAndTheVarianceZero) {
  for (const char* kernel : {"vecmax_fr16", "mean_fr16", "var_fr16"}) {
    EXPECT_EQ(result_of(KernelCall(kernel).buffer(Halves{7}).number(0)), 0) << kernel;
  }
}

TEST(Kernels, OnesAreCounted) {
  for (const std::uint32_t value : {0u, 1u, 0x80000000u, 0x12345678u, 0xffffffffu}) {
    EXPECT_EQ(result_of(KernelCall("countones").number(value)), std::popcount(value));
  }
}

TEST(Kernels, QuotientIsTowardsZero) {
  for (const auto& [numerator, denominator] : {std::pair{30000, -7},
                                               {-30000, 7},
                                               {7, 2},
                                               {-7, -2},
                                               {0, 5},
                                               {5, 32767},
                                               {-32768, 1},
                                               {-32768, 32767},
                                               {32767, 1}}) {
    EXPECT_EQ(result_of(KernelCall("div16").number(numerator).number(denominator)),
              scaled(numerator / denominator))
        << numerator << " / " << denominator;
  }
}

TEST(Kernels, RootIsRightToTwoUnits) {
  for (int x = 1; x <= 32767; x = x < 64 ? x + 1 : x + 511) {
    EXPECT_NEAR(result_of(KernelCall("sqrt_fr16").number(x)), std::sqrt(x * 32768.0), 2) << x;
  }
  EXPECT_EQ(result_of(KernelCall("sqrt_fr16").number(0)), 0);
  EXPECT_EQ(result_of(KernelCall("sqrt_fr16").number(-5)), 0);
}

TEST(Kernels, FloatsCompareAsTheHostComparesThem) {
  const std::array values = {0.0f,
                             -0.0f,
                             1.0f,
                             -1.0f,
                             1.5f,
                             -1.5f,
                             1e-40f,
                             -1e-40f,
                             std::numeric_limits<float>::infinity(),
                             -std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN(),
                             -std::numeric_limits<float>::quiet_NaN()};
  for (const float a : values) {
    for (const float b : values) {
      EXPECT_EQ(result_of(KernelCall("float_gt")
                              .number(std::bit_cast<std::uint32_t>(a))
                              .number(std::bit_cast<std::uint32_t>(b))),
                a > b ? 1 : 0)
          << a << " > " << b;
    }
  }
}

}  // namespace
}  // namespace finback::kernels
