#include "tristim/color/cct.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/color/planckian_locus.h"
#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Chromaticity from_uv(double u, double v) {
  const double d = 2 * u - 8 * v + 4;
  return {3 * u / d, 2 * v / d};
}

// .01 K and 1e-9 are the bounds of the file for |Duv| <= .02.
TEST(ColorTemperature, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/cct.csv")) {
    SCOPED_TRACE(row.text("id"));
    const ColorTemperature t = color_temperature(from_uv(row.number("u"), row.number("v")));
    EXPECT_NEAR(t.temperature_k, row.number("CCT"), 1e-5);
    EXPECT_NEAR(t.duv, row.number("Duv"), 1e-12);
  }
}

// Solved to 20 digits: white of digital cinema, and a place 1000 K wide of the locus.
TEST(ColorTemperature, IsTheTrueMinimum) {
  const ColorTemperature dci = color_temperature({0.314, 0.351});
  EXPECT_NEAR(dci.temperature_k, 6302.797255790941, 1e-6);
  EXPECT_NEAR(dci.duv, 0.013436653868721967, 1e-12);
  const ColorTemperature blue = color_temperature({0.2716148166713336, 0.2590102417961088});
  EXPECT_NEAR(blue.temperature_k, 14713.249993099902, 1e-5);
  EXPECT_NEAR(blue.duv, -0.01, 1e-12);
}

// Errors measured: 1.3e-6 K, 1.2e-13.
TEST(ColorTemperature, ComesBackFromEveryPlace) {
  for (double t = 1000; t <= 25000; t *= 1.0173) {
    for (const double duv : {-0.02, -0.003, 0.0, 0.01, 0.02}) {
      const ColorTemperature back = color_temperature(chromaticity_of({t, duv}));
      EXPECT_NEAR(back.temperature_k, t, 2e-5) << duv;
      EXPECT_NEAR(back.duv, duv, 1e-14) << t;
    }
  }
}

// On the locus itself, which is summed by other code than the table.
TEST(ColorTemperature, ReadsRadiators) {
  for (double t = 250; t < 1e6; t *= 1.37) {
    for (const RadiationConstant& constant : kRadiationConstants) {
      const Chromaticity c = planckian_chromaticity(t, constant.c2);
      const ColorTemperature back = color_temperature(c, constant.c2);
      EXPECT_NEAR(back.temperature_k, t, 1e-5 + 1e-7 * t) << constant.name;
      EXPECT_NEAR(back.duv, 0, 1e-12) << t;
    }
  }
}

// No place of a fine table of the locus is nearer than the answer.
TEST(ColorTemperature, IsTheGlobalMinimum) {
  const auto& locus = detail::PlanckianLocus::get();
  for (double u = 0.1; u < 0.6; u += 0.0137) {
    for (double v = 0.2; v < 0.45; v += 0.0111) {
      const ColorTemperature t = color_temperature(from_uv(u, v));
      double least = kInfinity;
      for (double mired = 0; mired <= detail::PlanckianLocus::kLastMired; mired += 5) {
        const detail::Uv p = locus.at(mired).point;
        least = std::fmin(least, std::hypot(p.u - u, p.v - v));
      }
      if (std::isnan(t.duv)) {
        EXPECT_GT(least, 0.1) << u << " " << v;
      } else {
        EXPECT_LE(std::fabs(t.duv), least + 1e-13) << u << " " << v;
      }
    }
  }
}

TEST(ColorTemperature, HasItsLimits) {
  const Chromaticity hot = planckian_chromaticity(kInfinity);
  EXPECT_EQ(color_temperature({hot.x - 0.01, hot.y - 0.02}).temperature_k, kInfinity);
  EXPECT_NEAR(chromaticity_of({kInfinity, 0}).x, hot.x, 1e-15);
  const auto none = [](Chromaticity c) {
    const ColorTemperature t = color_temperature(c);
    return std::isnan(t.temperature_k) && std::isnan(t.duv);
  };
  EXPECT_TRUE(none({0.15, 0.06}));  // the blue of sRGB
  EXPECT_TRUE(none({0.17, 0.80}));  // the green of BT.2020
  EXPECT_TRUE(none({0.74, 0.26}));  // beyond the coldest radiator
  EXPECT_TRUE(none({std::nan(""), 0.3}));
  EXPECT_TRUE(none({0.3, kInfinity}));
  EXPECT_TRUE(std::isnan(chromaticity_of({100, 0}).x));
  EXPECT_TRUE(std::isnan(chromaticity_of({-5000, 0}).x));
  EXPECT_TRUE(std::isnan(chromaticity_of({std::nan(""), 0}).x));
}

TEST(ColorTemperature, IsPositiveAboveTheLocus) {
  EXPECT_GT(color_temperature({0.3127, 0.3290}).duv, 0);  // D65 is on the green side
  EXPECT_LT(color_temperature({0.3127, 0.3100}).duv, 0);
}

}  // namespace
}  // namespace tristim
