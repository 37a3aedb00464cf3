#include "tristim/color/hsv.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/hue.h"

namespace tristim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double cell(const ExampleRow& row, const char* column) {
  return row.text(column) == "undef" ? kNan : row.number(column);
}

void expect_output(const ExampleRow& row, double o0, double o1, double o2) {
  const double got[] = {o0, o1, o2};
  const char* const columns[] = {"o0", "o1", "o2"};
  for (int i = 0; i < 3; ++i) {
    const double expected = cell(row, columns[i]);
    EXPECT_EQ(std::isnan(got[i]), std::isnan(expected)) << columns[i];
    if (std::isnan(expected)) continue;
    EXPECT_NEAR(got[i], expected, expected > 2 ? 6e-14 : 4e-16) << columns[i];  // hues are above 2
  }
}

TEST(Hsv, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/hsv.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double i0 = cell(row, "i0");
    const double i1 = cell(row, "i1");
    const double i2 = cell(row, "i2");
    if (row.text("op") == "rgb_to_hsv") {
      const Hsv hsv = rgb_to_hsv({i0, i1, i2});
      expect_output(row, hsv.h, hsv.s, hsv.v);
    } else {
      const EncodedRgb rgb = hsv_to_rgb({i0, i1, i2});
      expect_output(row, rgb.r, rgb.g, rgb.b);
    }
  }
}

TEST(Hls, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/hls.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double i0 = cell(row, "i0");
    const double i1 = cell(row, "i1");
    const double i2 = cell(row, "i2");
    if (row.text("op") == "rgb_to_hls") {
      const Hls hls = rgb_to_hls({i0, i1, i2});
      expect_output(row, hls.h, hls.l, hls.s);
    } else {
      const EncodedRgb rgb = hls_to_rgb({i0, i1, i2});
      expect_output(row, rgb.r, rgb.g, rgb.b);
    }
  }
}

// The corners of the hexagon and points half way between, as [Smith78] and [Shoaff 2.2.7] define.
TEST(Hsv, HasTheCornersOfTheHexagon) {
  const EncodedRgb corners[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(rgb_to_hsv(corners[i]), (Hsv{60.0 * i, 1, 1}));
    EXPECT_EQ(rgb_to_hls(corners[i]), (Hls{60.0 * i, 0.5, 1}));
    EXPECT_EQ(hsv_to_rgb({60.0 * i - 720, 1, 1}), corners[i]);
    EXPECT_EQ(hls_to_rgb({60.0 * i + 360, 0.5, 1}), corners[i]);
  }
  EXPECT_EQ(rgb_to_hsv({1, 0, 0.5}), (Hsv{330, 1, 1}));
  EXPECT_EQ(rgb_to_hls({1, 0.75, 0.75}), (Hls{0, 0.875, 1}));
  EXPECT_EQ(rgb_to_hsl({1, 0.75, 0.75}), (Hsl{0, 1, 0.875}));
  EXPECT_EQ(hsl_to_rgb({0, 1, 0.875}), (EncodedRgb{1, 0.75, 0.75}));
}

TEST(Hsv, GreysHaveNoHueAndTakeAny) {
  for (const double v : {0.0, 0.3, 1.0, 2.0, -0.5}) {
    EXPECT_TRUE(same(rgb_to_hsv({v, v, v}), Hsv{kNan, 0, v}));
    EXPECT_TRUE(same(rgb_to_hls({v, v, v}), Hls{kNan, v, 0}));
    for (const double hue : {kNan, 0.0, 77.0}) {
      EXPECT_EQ(hsv_to_rgb({hue, 0, v}), (EncodedRgb{v, v, v}));
      EXPECT_EQ(hls_to_rgb({hue, v, 0}), (EncodedRgb{v, v, v}));
    }
  }
}

TEST(Hsv, HueIsNever360) {
  EXPECT_EQ(rgb_to_hsv({1, 0, 1e-20}).h, 0);
  EXPECT_EQ(rgb_to_hls({1, 0, 1e-20}).h, 0);
  EXPECT_LT(rgb_to_hsv({1, 0, 1e-15}).h, 360);
}

TEST(Hsv, NanMakesNan) {
  for (const EncodedRgb rgb : {EncodedRgb{kNan, 0.5, 0.5}, {0.5, kNan, 0.5}, {0.5, 0.5, kNan}}) {
    EXPECT_TRUE(std::isnan(rgb_to_hsv(rgb).v));
    EXPECT_TRUE(std::isnan(rgb_to_hls(rgb).l));
  }
  EXPECT_TRUE(std::isnan(hsv_to_rgb({kNan, 0.5, 0.5}).r));
  EXPECT_TRUE(std::isnan(hls_to_rgb({kNan, 0.5, 0.5}).r));
}

TEST(Hls, HasNoSaturationWhereItsDenominatorVanishes) {
  EXPECT_TRUE(std::isnan(rgb_to_hls({0.5, -0.5, 0}).s));
  EXPECT_TRUE(std::isnan(rgb_to_hls({1.5, 0.5, 1}).s));
  EXPECT_TRUE(std::isnan(rgb_to_hsv({0, -0.5, 0}).s));
}

RC_GTEST_PROP(Hsv, ComesBackInsideAndOutsideTheCube, ()) {
  const auto part = [] { return *rc::gen::inRange(-200, 1500) / 1000.0; };
  const EncodedRgb rgb{part(), part(), part()};
  // A saturation beside a denominator of 0 is huge, and multiplies the rounding of what it is made
  // of.
  const auto near = [&](EncodedRgb back, double saturation) {
    const double bound = 2e-15 * (1 + std::fabs(saturation));
    return std::fabs(back.r - rgb.r) < bound && std::fabs(back.g - rgb.g) < bound &&
           std::fabs(back.b - rgb.b) < bound;
  };
  const Hsv hsv = rgb_to_hsv(rgb);
  const Hls hls = rgb_to_hls(rgb);
  if (!std::isnan(hsv.s)) RC_ASSERT(near(hsv_to_rgb(hsv), hsv.s));
  if (!std::isnan(hls.s)) RC_ASSERT(near(hls_to_rgb(hls), hls.s));
}

TEST(Same, ComparesHuesModulo360) {
  EXPECT_TRUE(same(Hsv{-60, 1, 1}, Hsv{300, 1, 1}));
  EXPECT_TRUE(same(Hsl{660, 1, 0.5}, Hsl{300, 1, 0.5}));
  EXPECT_FALSE(same(Hsv{10, 1, 1}, Hsv{11, 1, 1}));
  EXPECT_TRUE(same(Hls{kNan, 0.5, 0}, Hls{20, 0.5, 0}));
  EXPECT_FALSE(same(Hls{kNan, 0.5, 0.5}, Hls{20, 0.5, 0.5}));
  EXPECT_FALSE(same(Hsv{0, 0, 1}, Hsv{0, 0, 0.5}));
}

TEST(WrapHue, StaysBelow360) {
  EXPECT_EQ(wrap_hue(-60), 300);
  EXPECT_EQ(wrap_hue(660), 300);
  EXPECT_EQ(wrap_hue(360), 0);
  EXPECT_FALSE(std::signbit(wrap_hue(-360)));
  EXPECT_EQ(wrap_hue(-1e-20), 0);
  EXPECT_TRUE(std::isnan(wrap_hue(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace tristim
