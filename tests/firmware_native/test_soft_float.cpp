// Does the runtime's floating point equal the host's, bit for bit? On edge values against each
// other, and on random ones: any bits, near exponents, whole numbers. What is no number need only
// be none.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#define GUEST_ARITHMETIC(real, sf)                \
  real guest_add##sf##3(real a, real b);          \
  real guest_sub##sf##3(real a, real b);          \
  real guest_mul##sf##3(real a, real b);          \
  real guest_div##sf##3(real a, real b);          \
  int guest_eq##sf##2(real a, real b);            \
  int guest_ne##sf##2(real a, real b);            \
  int guest_lt##sf##2(real a, real b);            \
  int guest_le##sf##2(real a, real b);            \
  int guest_gt##sf##2(real a, real b);            \
  int guest_ge##sf##2(real a, real b);            \
  int guest_unord##sf##2(real a, real b);         \
  std::int32_t guest_fix##sf##si(real value);     \
  std::uint32_t guest_fixuns##sf##si(real value); \
  std::int64_t guest_fix##sf##di(real value);     \
  std::uint64_t guest_fixuns##sf##di(real value); \
  real guest_floatsi##sf(std::int32_t value);     \
  real guest_floatunsi##sf(std::uint32_t value);  \
  real guest_floatdi##sf(std::int64_t value);     \
  real guest_floatundi##sf(std::uint64_t value);

extern "C" {
GUEST_ARITHMETIC(float, sf)
GUEST_ARITHMETIC(double, df)
double guest_extendsfdf2(float value);
float guest_truncdfsf2(double value);
}

namespace finback {
namespace {

constexpr int kRandomPairs = 100'000;

/// The runtime's functions for one type, under one name each.
template <typename Real>
struct Guest;

#define GUEST_FUNCTIONS(real, bits, sf)                      \
  template <>                                                \
  struct Guest<real> {                                       \
    using Bits = bits;                                       \
    static constexpr auto add = guest_add##sf##3;            \
    static constexpr auto subtract = guest_sub##sf##3;       \
    static constexpr auto multiply = guest_mul##sf##3;       \
    static constexpr auto divide = guest_div##sf##3;         \
    static constexpr auto eq = guest_eq##sf##2;              \
    static constexpr auto ne = guest_ne##sf##2;              \
    static constexpr auto lt = guest_lt##sf##2;              \
    static constexpr auto le = guest_le##sf##2;              \
    static constexpr auto gt = guest_gt##sf##2;              \
    static constexpr auto ge = guest_ge##sf##2;              \
    static constexpr auto unordered = guest_unord##sf##2;    \
    static constexpr auto to_int32 = guest_fix##sf##si;      \
    static constexpr auto to_uint32 = guest_fixuns##sf##si;  \
    static constexpr auto to_int64 = guest_fix##sf##di;      \
    static constexpr auto to_uint64 = guest_fixuns##sf##di;  \
    static constexpr auto from_int32 = guest_floatsi##sf;    \
    static constexpr auto from_uint32 = guest_floatunsi##sf; \
    static constexpr auto from_int64 = guest_floatdi##sf;    \
    static constexpr auto from_uint64 = guest_floatundi##sf; \
  };

GUEST_FUNCTIONS(float, std::uint32_t, sf)
GUEST_FUNCTIONS(double, std::uint64_t, df)

template <typename To, typename From>
To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

template <typename Real>
class SoftFloat : public ::testing::Test {
 protected:
  using Bits = typename Guest<Real>::Bits;
  using Limits = std::numeric_limits<Real>;
  static constexpr int kFraction = Limits::digits - 1;

  static Bits bits(Real value) { return same_bits<Bits>(value); }

  static std::vector<Real> edges() {
    const Real one = 1;
    const Real half_up = one + Limits::epsilon();
    std::vector<Real> values = {0,
                                one,
                                half_up,
                                one - Limits::epsilon() / 2,
                                2,
                                3,
                                Real(0.5),
                                Real(1.5),
                                Real(0.1),
                                10,
                                Limits::min(),
                                Limits::denorm_min(),
                                3 * Limits::denorm_min(),
                                Limits::min() - Limits::denorm_min(),
                                Limits::min() + Limits::denorm_min(),
                                2 * Limits::min(),
                                Limits::max(),
                                Limits::max() / 2,
                                Limits::infinity(),
                                Limits::quiet_NaN(),
                                Limits::signaling_NaN()};
    for (const int power : {-1, 15, 23, 24, 25, 30, 31, 32, 33, 52, 53, 54, 62, 63, 64, 65}) {
      const Real whole = std::ldexp(one, power);
      values.insert(values.end(), {whole, whole * half_up, whole * (one - Limits::epsilon() / 2),
                                   whole - Real(0.5), whole + Real(0.5), whole + 1, whole - 1});
    }
    const std::size_t positive = values.size();
    for (std::size_t i = 0; i < positive; ++i) {
      values.push_back(-values[i]);
    }
    return values;
  }

  Bits random_bits() { return static_cast<Bits>(generator_()); }

  /// Any bits; or, every second time, an exponent within some 64 of one's, where results round.
  Real random_value(bool near_one) {
    Bits value = random_bits();
    if (near_one) {
      const Bits sign_and_fraction = value & ~bits(Limits::infinity());
      const auto exponent = static_cast<Bits>(generator_() % 128 - 64);
      value = sign_and_fraction | (bits(1) + (exponent << kFraction));
    }
    if (generator_() % 4 == 0) {  // few bits set: ties
      value &= ~Bits{0} << (kFraction - static_cast<int>(generator_() % 12));
    }
    return same_bits<Real>(value);
  }

  template <typename Check>
  void on_pairs(Check check) {
    for (const Real a : edges()) {
      for (const Real b : edges()) {
        ASSERT_NO_FATAL_FAILURE(check(a, b));
      }
    }
    for (int i = 0; i < kRandomPairs; ++i) {
      const Real a = random_value(i % 2 == 0);
      const Real b = random_value(i % 2 == 0);
      ASSERT_NO_FATAL_FAILURE(check(a, b));
    }
  }

  template <typename Check>
  void on_values(Check check) {
    on_pairs([&](Real a, Real) { check(a); });
  }

  static void expect_same(Real got, Real wanted, Real a, Real b) {
    if (std::isnan(wanted)) {
      ASSERT_TRUE(std::isnan(got)) << std::hexfloat << a << " " << b;
      ASSERT_NE(bits(got) >> (kFraction - 1) & 1, 0U) << std::hexfloat << a << " " << b;
    } else {
      ASSERT_EQ(bits(got), bits(wanted)) << std::hexfloat << a << " " << b << ": " << got;
    }
  }

  std::mt19937_64 generator_{61};
};

using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SoftFloat, Types);

TYPED_TEST(SoftFloat, Sums) {
  this->on_pairs([&](TypeParam a, TypeParam b) {
    this->expect_same(Guest<TypeParam>::add(a, b), a + b, a, b);
    this->expect_same(Guest<TypeParam>::subtract(a, b), a - b, a, b);
  });
}

TYPED_TEST(SoftFloat, Products) {
  this->on_pairs([&](TypeParam a, TypeParam b) {
    this->expect_same(Guest<TypeParam>::multiply(a, b), a * b, a, b);
  });
}

TYPED_TEST(SoftFloat, Quotients) {
  this->on_pairs([&](TypeParam a, TypeParam b) {
    this->expect_same(Guest<TypeParam>::divide(a, b), a / b, a, b);
  });
}

/// Products and quotients at the lower end, where they are rounded as subnormal numbers.
TYPED_TEST(SoftFloat, SubnormalResults) {
  const auto tiny = std::numeric_limits<TypeParam>::min();
  for (int i = 0; i < kRandomPairs; ++i) {
    const TypeParam a = this->random_value(true);
    const TypeParam b = std::ldexp(this->random_value(true), -32) * tiny;
    this->expect_same(Guest<TypeParam>::multiply(a, b), a * b, a, b);
    this->expect_same(Guest<TypeParam>::divide(b, a), b / a, b, a);
    this->expect_same(Guest<TypeParam>::add(a * b, b), a * b + b, a * b, b);
    if (this->HasFatalFailure()) {
      return;
    }
  }
}

TYPED_TEST(SoftFloat, Comparisons) {
  using Functions = Guest<TypeParam>;
  this->on_pairs([&](TypeParam a, TypeParam b) {
    ASSERT_EQ(Functions::eq(a, b) == 0, a == b) << a << " " << b;
    ASSERT_EQ(Functions::ne(a, b) != 0, a != b) << a << " " << b;
    ASSERT_EQ(Functions::lt(a, b) < 0, a < b) << a << " " << b;
    ASSERT_EQ(Functions::le(a, b) <= 0, a <= b) << a << " " << b;
    ASSERT_EQ(Functions::gt(a, b) > 0, a > b) << a << " " << b;
    ASSERT_EQ(Functions::ge(a, b) >= 0, a >= b) << a << " " << b;
    ASSERT_EQ(Functions::unordered(a, b) != 0, std::isunordered(a, b)) << a << " " << b;
  });
}

/// What C says of a conversion, and where C says nothing, the nearest integer there is.
template <typename Integer, typename Real>
Integer clamped(Real value) {
  const Real limit = std::ldexp(Real(1), std::numeric_limits<Integer>::digits);
  if (std::isnan(value)) {
    return 0;
  }
  if (value >= limit) {
    return std::numeric_limits<Integer>::max();
  }
  if (std::is_signed_v<Integer> ? value <= -limit : value <= 0) {
    return std::numeric_limits<Integer>::min();
  }
  return static_cast<Integer>(value);
}

TYPED_TEST(SoftFloat, ToIntegers) {
  using Functions = Guest<TypeParam>;
  this->on_values([](TypeParam value) {
    ASSERT_EQ(Functions::to_int32(value), (clamped<std::int32_t>(value))) << value;
    ASSERT_EQ(Functions::to_uint32(value), (clamped<std::uint32_t>(value))) << value;
    ASSERT_EQ(Functions::to_int64(value), (clamped<std::int64_t>(value))) << value;
    ASSERT_EQ(Functions::to_uint64(value), (clamped<std::uint64_t>(value))) << value;
  });
}

TYPED_TEST(SoftFloat, FromIntegers) {
  using Functions = Guest<TypeParam>;
  std::mt19937_64 generator(7);
  std::vector<std::uint64_t> numbers = {0, 1, 2, 3};
  for (int power = 2; power < 64; ++power) {
    for (const int step : {-1, 0, 1}) {
      numbers.push_back((std::uint64_t{1} << power) + static_cast<std::uint64_t>(step));
      numbers.push_back(std::uint64_t{0} - numbers.back());
    }
  }
  for (int i = 0; i < kRandomPairs; ++i) {
    const std::uint64_t number = generator() >> generator() % 64;
    numbers.push_back(number & ~std::uint64_t{0} << generator() % 64);
    numbers.push_back(number);
  }
  for (const std::uint64_t number : numbers) {
    const auto low = static_cast<std::uint32_t>(number);
    const auto same = [&](TypeParam got, TypeParam wanted) {
      ASSERT_EQ(this->bits(got), this->bits(wanted)) << number;
    };
    same(Functions::from_uint32(low), static_cast<TypeParam>(low));
    same(Functions::from_int32(static_cast<std::int32_t>(low)),
         static_cast<TypeParam>(static_cast<std::int32_t>(low)));
    same(Functions::from_uint64(number), static_cast<TypeParam>(number));
    same(Functions::from_int64(static_cast<std::int64_t>(number)),
         static_cast<TypeParam>(static_cast<std::int64_t>(number)));
    if (this->HasFatalFailure()) {
      return;
    }
  }
}

class FloatAndDouble : public SoftFloat<float> {};

TEST_F(FloatAndDouble, EveryWay) {
  on_values([](float value) {
    const double wide = guest_extendsfdf2(value);
    if (std::isnan(value)) {
      ASSERT_TRUE(std::isnan(wide));
    } else {
      ASSERT_EQ(same_bits<std::uint64_t>(wide), same_bits<std::uint64_t>(double{value})) << value;
    }
  });
  std::vector<double> values;
  for (const float edge : edges()) {
    const double wide = edge;
    for (const double factor :
         {1.0, 1 + 0x1p-24, 1 - 0x1p-24, 1 + 0x1p-24 + 0x1p-52, 1 - 0x1p-30}) {
      values.push_back(wide * factor);
    }
  }
  for (int i = 0; i < kRandomPairs; ++i) {
    values.push_back(same_bits<double>(generator_()));
    values.push_back(std::ldexp(1 + static_cast<double>(generator_() >> 12) * 0x1p-52,
                                static_cast<int>(generator_() % 300) - 160));
  }
  for (const double value : values) {
    expect_same(guest_truncdfsf2(value), static_cast<float>(value), static_cast<float>(value), 0);
    if (HasFatalFailure()) {
      return;
    }
  }
}

/// Which of two results that are no numbers comes out is ours to say: the first operand's, made
/// quiet.
TEST(SoftFloatPayloads, AreCarried) {
  const auto signalling = same_bits<float>(0xFF812345U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_addsf3(signalling, 1)), 0xFFC12345U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_mulsf3(1, signalling)), 0xFFC12345U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_divsf3(signalling, 0)), 0xFFC12345U);
  EXPECT_EQ(same_bits<std::uint64_t>(guest_extendsfdf2(signalling)), 0xFFF82468A0000000U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_truncdfsf2(same_bits<double>(0x7FF02468A0000000U))),
            0x7FC12345U);
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(same_bits<std::uint32_t>(guest_subsf3(infinite, infinite)), 0x7FC00000U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_mulsf3(infinite, 0)), 0x7FC00000U);
  EXPECT_EQ(same_bits<std::uint32_t>(guest_divsf3(0, 0)), 0x7FC00000U);
}

}  // namespace
}  // namespace finback
