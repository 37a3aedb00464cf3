#include "lib/core/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tristim::detail {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr long double kDegree = std::numbers::pi_v<long double> / 180;

// Distance of `value` from `expected` in units of the last place of the latter.
double ulps(double value, long double expected) {
  const double rounded = std::fabs(static_cast<double>(expected));
  const double ulp = std::nextafter(rounded, kInfinity) - rounded;
  return static_cast<double>(std::fabs(value - expected)) / ulp;
}

TEST(SineCosine, IsExactWhereTablesAre) {
  const double half_root = std::sqrt(0.5);
  EXPECT_EQ(sine_cosine_deg(30).sine, 0.5);
  EXPECT_EQ(sine_cosine_deg(60).cosine, 0.5);
  EXPECT_EQ(sine_cosine_deg(-210).sine, 0.5);
  EXPECT_EQ(sine_cosine_deg(765).sine, half_root);
  EXPECT_EQ(sine_cosine_deg(765).cosine, half_root);
  EXPECT_EQ(sine_cosine_deg(60).sine, std::sqrt(3.0) / 2);
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const SineCosine sc = sine_cosine_deg(90.0 * quarter);
    const double sines[] = {0, 1, 0, -1};
    EXPECT_EQ(sc.sine, sines[quarter & 3]);
    EXPECT_EQ(sc.cosine, sines[(quarter + 1) & 3]);
    EXPECT_FALSE(std::signbit(sc.sine) && sc.sine == 0);
  }
}

TEST(SineCosine, IsCorrectlyRounded) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-90, 90);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = angle(random);
    const SineCosine sc = sine_cosine_deg(degrees);
    // Next to their zeros the long double reference has no digits to spare.
    const long double radians = degrees * kDegree;
    const bool sine = std::fabs(sc.sine) > 0.1;
    const bool cosine = std::fabs(sc.cosine) > 0.1;
    EXPECT_LT(sine ? ulps(sc.sine, std::sin(radians)) : 0, 0.51) << degrees;
    EXPECT_LT(cosine ? ulps(sc.cosine, std::cos(radians)) : 0, 0.51) << degrees;
  }
}

TEST(SineCosine, RepeatsAfterWholeTurns) {
  for (double degrees = 0; degrees < 360; degrees += 0.375) {
    for (const double turns : {-360.0, 360.0, 3600.0}) {
      EXPECT_EQ(sine_cosine_deg(degrees + turns).sine, sine_cosine_deg(degrees).sine);
      EXPECT_EQ(sine_cosine_deg(degrees + turns).cosine, sine_cosine_deg(degrees).cosine);
    }
  }
}

TEST(SineCosine, HasNoValueForAnEndlessAngle) {
  for (const double odd : {kNan, kInfinity, -kInfinity}) {
    EXPECT_TRUE(std::isnan(sine_cosine_deg(odd).sine));
    EXPECT_TRUE(std::isnan(sine_cosine_deg(odd).cosine));
  }
}

TEST(Angle, IsExactWhereTablesAre) {
  EXPECT_EQ(angle_deg(0, 1), 0);
  EXPECT_EQ(angle_deg(1, 1), 45);
  EXPECT_EQ(angle_deg(3, 0), 90);
  EXPECT_EQ(angle_deg(1, -1), 135);
  EXPECT_EQ(angle_deg(0, -1), 180);
  EXPECT_EQ(angle_deg(-0.0, -1), 180);
  EXPECT_EQ(angle_deg(-1, -1), 225);
  EXPECT_EQ(angle_deg(-1e300, 1e-300), 270);
  EXPECT_EQ(angle_deg(-1, 1), 315);
  EXPECT_EQ(angle_deg(-1e-320, 1e-320), 315);
  for (const double x : {0.0, -0.0}) {
    for (const double y : {0.0, -0.0}) EXPECT_EQ(angle_deg(y, x), 0);
  }
}

TEST(Angle, IsCorrectlyRoundedAndBelow360) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> part;
  for (int i = 0; i < 20000; ++i) {
    const double x = part(random);
    const double y = part(random);
    long double expected = std::atan2(static_cast<long double>(y), x) / kDegree;
    if (expected < 0) expected += 360;
    EXPECT_LT(ulps(angle_deg(y, x), expected), 0.51) << y << " " << x;
  }
  EXPECT_EQ(angle_deg(-1e-20, 1), 0);
  EXPECT_EQ(angle_deg(-std::numeric_limits<double>::denorm_min(), 1), 0);
}

TEST(Angle, TakesOddVectors) {
  EXPECT_TRUE(std::isnan(angle_deg(kNan, 1)));
  EXPECT_TRUE(std::isnan(angle_deg(0, kNan)));
  EXPECT_EQ(angle_deg(kInfinity, kInfinity), 45);
  EXPECT_EQ(angle_deg(1, -kInfinity), 180);
  EXPECT_EQ(angle_deg(-kInfinity, 1), 270);
}

TEST(Hypotenuse, IsCorrectlyRoundedEverywhere) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> part;
  for (int i = 0; i < 20000; ++i) {
    const double x = part(random);
    const double y = part(random);
    EXPECT_LT(ulps(hypotenuse(x, y), std::hypot(static_cast<long double>(x), y)), 0.51);
  }
  EXPECT_EQ(hypotenuse(3e300, -4e300), 5e300);
  EXPECT_EQ(hypotenuse(0, -0.0), 0);
  EXPECT_EQ(hypotenuse(-kInfinity, kNan), kInfinity);
  EXPECT_TRUE(std::isnan(hypotenuse(1, kNan)));
}

}  // namespace
}  // namespace tristim::detail
