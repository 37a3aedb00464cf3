#include "tristim/color/oklab.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

TEST(Oklab, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/oklab.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double in[] = {row.number("i0"), row.number("i1"), row.number("i2")};
    double out[3];
    const bool forward = row.text("op") == "linear_srgb_to_oklab";
    if (forward) {
      const Oklab lab = linear_srgb_to_oklab({in[0], in[1], in[2]});
      out[0] = lab.l, out[1] = lab.a, out[2] = lab.b;
    } else {
      const Rgb rgb = oklab_to_linear_srgb({in[0], in[1], in[2]});
      out[0] = rgb.r, out[1] = rgb.g, out[2] = rgb.b;
    }
    for (int i = 0; i < 3; ++i) {  // the file's tolerances
      EXPECT_NEAR(out[i], row.number("o" + std::to_string(i)), forward ? 2e-15 : 1e-14);
    }
  }
}

TEST(Oklab, WhiteIsOneAndGreysAreNeutral) {
  for (int i = 0; i <= 1000; ++i) {
    const double grey = i / 1000.0;
    const Oklab lab = linear_srgb_to_oklab({grey, grey, grey});
    EXPECT_NEAR(lab.l, std::cbrt(grey), 1e-8);  // the published digits
    EXPECT_NEAR(lab.a, 0, 4e-8);                // the header's bound
    EXPECT_NEAR(lab.b, 0, 4e-8);
  }
}

RC_GTEST_PROP(Oklab, ComesBack, ()) {
  const auto part = [] { return *rc::gen::inRange(-500, 3000) / 1000.0; };
  const Rgb rgb{part(), part(), part()};
  const Rgb back = oklab_to_linear_srgb(linear_srgb_to_oklab(rgb));
  // Roundings of the largest term times the largest entry of the inverse, 4.
  RC_ASSERT(std::fabs(back.r - rgb.r) < 3e-14);
  RC_ASSERT(std::fabs(back.g - rgb.g) < 3e-14);
  RC_ASSERT(std::fabs(back.b - rgb.b) < 3e-14);
}

RC_GTEST_PROP(Oklab, IsOdd, ()) {
  const auto part = [] { return *rc::gen::inRange(-500, 3000) / 1000.0; };
  const Rgb rgb{part(), part(), part()};
  const Oklab lab = linear_srgb_to_oklab(rgb);
  RC_ASSERT(linear_srgb_to_oklab({-rgb.r, -rgb.g, -rgb.b}) == (Oklab{-lab.l, -lab.a, -lab.b}));
}

TEST(OklabWithToe, ShiftsTheCubeRootAndGoesStraightOnBelowBlack) {
  constexpr double kToe = 0.02;
  const auto lightness = [&](double grey) {
    return linear_srgb_to_oklab_with_toe({grey, grey, grey}, kToe).l;
  };
  EXPECT_EQ(lightness(0), 0);
  EXPECT_NEAR(lightness(0.5), std::cbrt(0.52) - std::cbrt(0.02), 1e-8);  // the published digits
  const double slope = 1 / (3 * std::cbrt(kToe * kToe));
  EXPECT_NEAR(lightness(-0.5), -0.5 * slope, 2e-8);  // the published digits
  // One tangent on both sides of black.
  EXPECT_NEAR(lightness(1e-7) / 1e-7, slope, slope * 1e-5);
  EXPECT_NEAR(lightness(-1e-7) / -1e-7, slope, slope * 1e-5);
  for (double grey = -1; grey < 2; grey += 0.01) EXPECT_LT(lightness(grey), lightness(grey + 0.01));
}

TEST(Oklab, NanStaysNan) {
  EXPECT_TRUE(std::isnan(linear_srgb_to_oklab({std::nan(""), 0, 0}).l));
  EXPECT_TRUE(std::isnan(oklab_to_linear_srgb({0.5, std::nan(""), 0}).r));
}

}  // namespace
}  // namespace tristim
