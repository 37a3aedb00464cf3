#include "lib/core/math.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace tristim::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kRandomInputs = 100000;
constexpr bool kLongDoubleIsWider = std::numeric_limits<long double>::digits >= 64;

// Half an ulp, and 1/2048 that the long double function may be off itself.
constexpr double kCorrectlyRounded = 0.5005;

// Error of `value` in units of the last place that a double near `exact` has.
double ulps(double value, long double exact) {
  const int exponent = std::max(std::ilogb(exact), -1022);
  return static_cast<double>(std::fabs(value - exact) / std::ldexp(1.0L, exponent - 52));
}

template <typename Error>
double largest_error(unsigned seed, Error&& error_of) {
  std::mt19937_64 random(seed);
  double largest = 0;
  for (int i = 0; i < kRandomInputs; ++i) largest = std::max(largest, error_of(random));
  return largest;
}

// The same class and sign, and the same number but for the last bit.
void expect_like(double ours, double theirs) {
  if (std::isnan(theirs)) {
    EXPECT_TRUE(std::isnan(ours)) << ours;
  } else if (theirs == 0 || std::isinf(theirs)) {
    EXPECT_EQ(ours, theirs);
    EXPECT_EQ(std::signbit(ours), std::signbit(theirs));
  } else {
    EXPECT_LE(ulps(ours, theirs), 1) << ours << " for " << theirs;
  }
}

TEST(Pow, IsCorrectlyRounded) {
  if (!kLongDoubleIsWider) GTEST_SKIP() << "long double is no wider than double";
  const double wide = largest_error(1, [](auto& random) {
    const double x = std::exp2(std::uniform_real_distribution(-100.0, 100.0)(random));
    const double y = std::uniform_real_distribution(-9.0, 9.0)(random);
    return ulps(pow(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y)));
  });
  EXPECT_LE(wide, kCorrectlyRounded);
  const double curves = largest_error(2, [](auto& random) {
    const double x = std::uniform_real_distribution(0.0, 1.0)(random);
    const double y = std::uniform_real_distribution(0.3, 3.0)(random);
    return ulps(pow(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y)));
  });
  EXPECT_LE(curves, kCorrectlyRounded);
}

TEST(Exp, IsCorrectlyRounded) {
  if (!kLongDoubleIsWider) GTEST_SKIP() << "long double is no wider than double";
  const double largest = largest_error(3, [](auto& random) {
    const double x = std::uniform_real_distribution(-700.0, 700.0)(random);
    return ulps(exp(x), std::exp(static_cast<long double>(x)));
  });
  EXPECT_LE(largest, kCorrectlyRounded);
}

TEST(Log, IsCorrectlyRounded) {
  if (!kLongDoubleIsWider) GTEST_SKIP() << "long double is no wider than double";
  const double wide = largest_error(4, [](auto& random) {
    const double x = std::exp2(std::uniform_real_distribution(-1070.0, 1020.0)(random));
    return ulps(log(x), std::log(static_cast<long double>(x)));
  });
  EXPECT_LE(wide, kCorrectlyRounded);
  const double near_one = largest_error(5, [](auto& random) {
    const double x = 1 + std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                                    -std::uniform_int_distribution(1, 50)(random));
    return x == 1 ? 0 : ulps(log(x), std::log(static_cast<long double>(x)));
  });
  EXPECT_LE(near_one, kCorrectlyRounded);
}

TEST(Cbrt, IsCorrectlyRounded) {
  if (!kLongDoubleIsWider) GTEST_SKIP() << "long double is no wider than double";
  const double largest = largest_error(6, [](auto& random) {
    const double x = std::exp2(std::uniform_real_distribution(-1074.0, 1023.0)(random));
    return ulps(cbrt(x), std::cbrt(static_cast<long double>(x)));
  });
  EXPECT_LE(largest, kCorrectlyRounded);
}

TEST(Pow, FollowsTheCStandardAtTheEdges) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  const double values[] = {0.0,  0.5,  1.0,       1.5,        2.0,    3.0,        4.0,
                           tiny, huge, kInfinity, 0x1p52 + 1, 0x1p53, 0x1p53 + 2, kNan};
  for (const double x : values) {
    for (const double y : values) {
      for (const double a : {x, -x}) {
        for (const double b : {y, -y}) {
          SCOPED_TRACE(testing::Message() << a << " ^ " << b);
          expect_like(pow(a, b), std::pow(a, b));
        }
      }
    }
  }
}

TEST(Pow, OverflowsAndUnderflowsWhereTheResultDoes) {
  EXPECT_EQ(pow(2, 1023), 0x1p1023);
  EXPECT_EQ(pow(2, 1024), kInfinity);
  EXPECT_EQ(pow(2, -1074), 0x1p-1074);
  EXPECT_EQ(pow(2, -1076), 0);
  EXPECT_EQ(pow(-2, 1025), -kInfinity);
}

TEST(Exp, FollowsTheCStandardAtTheEdges) {
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNan, 709.0, 710.0, -745.0, -746.0,
                         1e300, -1e300, 1e-300}) {
    SCOPED_TRACE(x);
    expect_like(exp(x), std::exp(x));
  }
}

TEST(Log, FollowsTheCStandardAtTheEdges) {
  for (const double x : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, kNan,
                         std::numeric_limits<double>::denorm_min()}) {
    SCOPED_TRACE(x);
    expect_like(log(x), std::log(x));
  }
}

TEST(Cbrt, FollowsTheCStandardAtTheEdges) {
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNan}) {
    SCOPED_TRACE(x);
    expect_like(cbrt(x), std::cbrt(x));
  }
  for (int n = 1; n <= 1000; ++n) EXPECT_EQ(cbrt(double(n) * n * n), n);
}

RC_GTEST_PROP(Cbrt, IsOdd, (std::uint64_t bits)) {
  const auto x = std::bit_cast<double>(bits);
  RC_PRE(!std::isnan(x));
  RC_ASSERT(cbrt(-x) == -cbrt(x));
}

TEST(Log2Precise, IsExactToFarBelowAnUlp) {
  EXPECT_EQ(log2_precise(8).hi, 3);
  EXPECT_NEAR(log2_precise(8).lo, 0, 0x1p-94);
  const DoubleDouble l = log2_precise(10);
  EXPECT_EQ(l.hi, 3.3219280948873623);
  // log2(10) less that double, from 50 digits: 3.32192809488736234787031942948939017586483139302458
  EXPECT_NEAR(l.lo, 1.6616175169735920e-16, 1e-28);
}

RC_GTEST_PROP(FirstFloat, FindsTheThresholdFromAnyGuess, ()) {
  const auto finite =
      rc::gen::suchThat(rc::gen::map(rc::gen::arbitrary<std::uint32_t>(),
                                     [](std::uint32_t bits) { return std::bit_cast<float>(bits); }),
                        [](float x) { return std::fabs(x) < 1e30F; });
  const float threshold = *finite;
  const float guess = *rc::gen::oneOf(finite, rc::gen::just(threshold));
  const auto reaches = [threshold](double x) { return x >= double{threshold}; };
  RC_ASSERT(first_float(guess, reaches) == threshold);
}

TEST(FirstFloat, IsInfiniteWhereNothingOrEverythingReaches) {
  EXPECT_EQ(first_float(0.5, [](double) { return false; }), std::numeric_limits<float>::infinity());
  EXPECT_EQ(first_float(0.5, [](double) { return true; }), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(first_float(kNan, [](double x) { return x >= 0.25; }), 0.25F);
  EXPECT_EQ(first_float(kInfinity, [](double x) { return x >= 0.25; }), 0.25F);
}

}  // namespace
}  // namespace tristim::detail
