#include "tristim/color/gamut_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/oklab.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const GamutSpace& srgb() {
  static const GamutSpace space = gamut_space(Primaries{});
  return space;
}

Rgb from_oklch(double l, double c, double h_deg) {
  const double h = h_deg * M_PI / 180;
  return oklab_to_linear_srgb({l, c * std::cos(h), c * std::sin(h)});
}

double chroma(Rgb rgb) {
  const Oklab c = linear_srgb_to_oklab(rgb);
  return std::hypot(c.a, c.b);
}

double distance(Rgb a, Rgb b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

// Beside pure blue, at 264.052 degrees, sRGB has a bay; without care neighbours part by .24.
TEST(GamutMapping, IsContinuousRoundTheHuesBesideBlue) {
  for (const GamutMethod& method : kGamutMethods) {
    for (const double l : {0.2, 0.33, 0.45, 0.6}) {
      Rgb before = method.map(from_oklch(l, 0.5, 262), srgb());
      for (double h = 262; h < 266; h += 5e-4) {
        const Rgb now = method.map(from_oklch(l, 0.5, h), srgb());
        ASSERT_LT(distance(now, before), 0.005) << method.name << " " << l << " " << h;
        before = now;
      }
    }
  }
}

TEST(GamutMapping, IsContinuousBeyondWhiteAndBelowBlack) {
  for (const GamutMethod& method : {kDesaturate, kCompress}) {
    for (double h = 0; h < 360; h += 15) {
      Rgb before{};
      for (double l = -0.1; l < 1.1; l += 1e-4) {
        const Rgb now = method.map(from_oklch(l, 0.1, h), srgb());
        ASSERT_TRUE(in_gamut(now));
        ASSERT_LT(distance(now, before), 0.01) << method.name << " " << l << " " << h;
        before = now;
      }
      EXPECT_EQ(before, (Rgb{1, 1, 1}));
    }
  }
}

TEST(GamutMapping, LeavesTheCoreAloneAndCompressesTheRestMonotonically) {
  for (double h = 0; h < 360; h += 10) {
    double before = 0;
    bool moved = false;
    for (double c = 0.002; c < 0.6; c += 0.002) {
      const Rgb in = from_oklch(0.6, c, h);
      const Rgb out = gamut_compress(in, srgb());
      const bool same = out == in;
      EXPECT_FALSE(same && moved) << c << " " << h;  // once beyond the knee, always
      moved = moved || !same;
      EXPECT_GT(chroma(out), before) << c << " " << h;
      before = chroma(out);
    }
    EXPECT_TRUE(moved);
  }
  for (const double y : {0.0, 1e-6, 0.5, 1.0}) {
    EXPECT_EQ(gamut_compress({y, y, y}, srgb()), (Rgb{y, y, y}));
  }
}

// Less chroma is lost than where another program stops, and hue and lightness stay.
TEST(GamutMapping, StaysNearTheYardstickOfCss) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/gamut_map_css.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Rgb in{row.number("r"), row.number("g"), row.number("b")};
    const Rgb out = gamut_desaturate(in, srgb());
    EXPECT_TRUE(in_gamut(out));
    if (row.number("L") < 0 || row.number("L") > 1) continue;
    EXPECT_NEAR(linear_srgb_to_oklab(out).l, row.number("L"), 0.003);
    EXPECT_NEAR(chroma(out), row.number("mC"), 0.03);
  }
}

TEST(GamutMapping, PassesNanOn) {
  for (const GamutMethod& method : kGamutMethods) {
    const Rgb out = method.map({std::nan(""), 0, 0}, srgb());
    EXPECT_FALSE(in_gamut(out)) << method.name;
  }
}

}  // namespace
}  // namespace tristim
