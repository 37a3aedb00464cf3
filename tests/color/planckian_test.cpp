#include "tristim/color/planckian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/core/fast_exp.h"
#include "lib/core/math.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/observer.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCodata = kRadiationConstants[1].c2;

struct Golden {
  double temperature_k, c2;
  Chromaticity xy;
};

// Summed at 1 nm from 360 to 830 in quadruple precision.
constexpr Golden kGolden[] = {
    {800, kCodata, {0.6813342745175867, 0.31793139694568917}},
    {16483.756, kCodata, {0.26099834560379487, 0.2637224589328267}},
    {3094.253, kCodata, {0.43037305354988264, 0.40171414751044304}},
};

// 1e-12 is the bound; 7e-16 the largest error measured from 5 to 1e9 K.
TEST(PlanckianChromaticity, IsTheExactSum) {
  for (const Golden& golden : kGolden) {
    SCOPED_TRACE(golden.temperature_k);
    const Chromaticity c = planckian_chromaticity(golden.temperature_k, golden.c2);
    EXPECT_NEAR(c.x, golden.xy.x, 2e-15);
    EXPECT_NEAR(c.y, golden.xy.y, 2e-15);
  }
}

TEST(PlanckianChromaticity, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/planckian.csv")) {
    if (row.text("kind") != "planck") continue;
    SCOPED_TRACE(row.text("id"));
    const RadiationConstant* named = find_by_name(kRadiationConstants, row.text("c2"));
    const double c2 = named != nullptr ? named->c2 : row.number("c2");
    const Chromaticity c = planckian_chromaticity(row.number("T"), c2);
    EXPECT_NEAR(c.x, row.number("x"), 1e-12);
    EXPECT_NEAR(c.y, row.number("y"), 1e-12);
    const double luminance = planckian_xyz(row.number("T"), c2).y;
    EXPECT_NEAR(luminance, row.number("L_cd_m2"), 1e-11 * row.number("L_cd_m2"));
  }
}

// At infinite temperature the power goes as lambda^-4, at low ones only the longest wave is left.
TEST(PlanckianChromaticity, HasItsLimits) {
  Xyz sum;
  for (int lambda = 360; lambda <= 830; ++lambda) {
    const Xyz bar = matching_functions(observers()[0], lambda);
    const double power = std::pow(560.0 / lambda, 4);
    sum = {sum.x + power * bar.x, sum.y + power * bar.y, sum.z + power * bar.z};
  }
  const Chromaticity hot = planckian_chromaticity(kInfinity);
  EXPECT_NEAR(hot.x, sum.x / (sum.x + sum.y + sum.z), 1e-14);
  EXPECT_NEAR(hot.y, sum.y / (sum.x + sum.y + sum.z), 1e-14);
  EXPECT_NEAR(planckian_chromaticity(1e300).x, hot.x, 1e-15);
  const Xyz red = matching_functions(observers()[0], 830);
  for (const double t : {5e-324, 1e-300, 1e-3}) {
    EXPECT_NEAR(planckian_chromaticity(t).x, red.x / (red.x + red.y), 1e-14) << t;
  }
  for (const double t : {0.0, -1.0, -kInfinity, std::nan("")}) {
    EXPECT_TRUE(std::isnan(planckian_chromaticity(t).x)) << t;
    EXPECT_TRUE(std::isnan(planckian_xyz(t).y)) << t;
    EXPECT_TRUE(std::isnan(planckian_radiance(560, t))) << t;
  }
}

// A radiator shows c2/T only.
TEST(PlanckianChromaticity, DependsOnTheRatio) {
  const Chromaticity a = planckian_chromaticity(2848, 1.4350e-2);
  const Chromaticity b = planckian_chromaticity(2848 * kC2 / 1.4350e-2);
  EXPECT_NEAR(a.x, b.x, 1e-15);
  EXPECT_NEAR(a.x, 0.44758, 1e-5);  // illuminant A
  EXPECT_NEAR(a.y, 0.40745, 2e-5);
}

TEST(PlanckianSpectrum, IsIlluminantA) {
  const Spectrum a = planckian_spectrum(2848, 1.4350e-2);
  EXPECT_EQ(spectrum_fault(a), "");
  EXPECT_EQ(value_at(a, 560), 100);
  EXPECT_NEAR(value_at(a, 380), 9.79510, 5e-6);  // ISO 11664-2
  EXPECT_NEAR(value_at(a, 780), 241.675, 5e-4);
}

TEST(PlanckianSpectrum, HasItsLimits) {
  const Spectrum hot = planckian_spectrum(kInfinity);
  EXPECT_NEAR(value_at(hot, 400), 100 * std::pow(1.4, 4), 1e-11);
  EXPECT_TRUE(std::isfinite(value_at(planckian_spectrum(20), 830)));
  EXPECT_TRUE(std::isnan(value_at(planckian_spectrum(19), 560)));
}

// Largest error of 2 million measured: 1.1 ulp.
TEST(FastExp, AgreesWithTheExactOne) {
  for (double x = -707.9; x < 709; x += 0.237) {
    const double exact = detail::exp(x);
    EXPECT_NEAR(detail::fast_exp(x), exact, 2 * (std::nextafter(exact, kInfinity) - exact)) << x;
  }
  EXPECT_EQ(detail::fast_exp(0), 1);
  EXPECT_EQ(detail::fast_exp(-kInfinity), 0);
  EXPECT_EQ(detail::fast_exp(-709), 0);
  EXPECT_EQ(detail::fast_exp(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(detail::fast_exp(std::nan(""))));
}

}  // namespace
}  // namespace tristim
