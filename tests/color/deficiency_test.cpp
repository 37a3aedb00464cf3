#include "tristim/color/deficiency.h"

#include <gtest/gtest.h>

namespace tristim {
namespace {

void expect_near(Rgb ours, Rgb wanted, double tolerance) {
  EXPECT_NEAR(ours.r, wanted.r, tolerance);
  EXPECT_NEAR(ours.g, wanted.g, tolerance);
  EXPECT_NEAR(ours.b, wanted.b, tolerance);
}

TEST(Deficiency, LeavesGreysAlone) {
  for (const ColorDeficiency& kind : kColorDeficiencies) {
    for (const double y : {0.0, 0.2, 1.0}) {
      expect_near(simulate_deficiency({y, y, y}, kind), {y, y, y}, 1e-14);
    }
  }
}

// Seen twice is seen once: a projection.
TEST(Deficiency, IsAProjection) {
  for (const ColorDeficiency& kind : kColorDeficiencies) {
    for (const Rgb c : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{0.3, 0.5, 0.1}}) {
      const Rgb once = simulate_deficiency(c, kind);
      expect_near(simulate_deficiency(once, kind), once, 1e-13);
    }
  }
}

// [Vienot99] prints .1124 and .2927 for the primaries of its own display; with those of sRGB it is
// .1089 and .2903. Red and green of protanopes and deuteranopes differ in lightness alone.
TEST(Deficiency, MixesRedAndGreenAsVienot) {
  expect_near(simulate_deficiency({1, 0, 0}, kColorDeficiencies[0]), {0.1089, 0.1089, 0.0045},
              1e-4);
  expect_near(simulate_deficiency({0, 1, 0}, kColorDeficiencies[0]), {0.8911, 0.8911, -0.0045},
              1e-4);
  expect_near(simulate_deficiency({1, 0, 0}, kColorDeficiencies[1]), {0.2903, 0.2903, -0.0220},
              1e-4);
  expect_near(simulate_deficiency({0, 0, 1}, kColorDeficiencies[0]), {0, 0, 1}, 1e-12);
}

TEST(Deficiency, TritanopesSeeBlueAndGreenAlike) {
  const Rgb blue = simulate_deficiency({0, 0, 1}, kColorDeficiencies[2]);
  EXPECT_LT(blue.b, 0.3);  // next to nothing of it is left
  const Rgb red = simulate_deficiency({1, 0, 0}, kColorDeficiencies[2]);
  EXPECT_GT(red.r, 0.9);
  EXPECT_LT(red.g, 0.1);
}

}  // namespace
}  // namespace tristim
