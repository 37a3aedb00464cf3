#include "tristim/color/lch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/oklab.h"

namespace tristim {
namespace {

TEST(Lch, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/lch.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double i0 = row.number("i0");
    const double i1 = row.number("i1");
    const double i2 = row.number("i2");
    double out[3] = {};
    if (row.text("op") == "rect_to_polar") {
      const Lch lch = lab_to_lch({i0, i1, i2});
      out[0] = lch.l, out[1] = lch.c, out[2] = lch.h;
    } else {
      const Lab lab = lch_to_lab({i0, i1, i2});
      out[0] = lab.l, out[1] = lab.a, out[2] = lab.b;
    }
    for (int i = 0; i < 3; ++i) {
      const double expected = row.number("o" + std::to_string(i));
      EXPECT_NEAR(out[i], expected, 2e-16 * std::fabs(expected));
    }
  }
}

TEST(Lch, GreysHaveNoHueWhateverTheSignsOfTheirZeros) {
  for (const double a : {0.0, -0.0}) {
    for (const double b : {0.0, -0.0}) {
      EXPECT_TRUE(std::isnan(lab_to_lch({50, a, b}).h));
      EXPECT_TRUE(std::isnan(luv_to_lch({50, a, b}).h));
    }
  }
  EXPECT_EQ(lch_to_lab({50, 0, std::nan("")}), (Lab{50, 0, 0}));
  EXPECT_EQ(lch_to_luv({50, 0, 30}), (Luv{50, 0, 0}));
  EXPECT_TRUE(std::isnan(lch_to_lab({50, 1e-9, std::nan("")}).a));
}

TEST(Lch, ReadsHuesModulo360) {
  EXPECT_EQ(lch_to_lab({50, 10, -60}), lch_to_lab({50, 10, 300}));
  EXPECT_EQ(lch_to_lab({50, 10, 90}), (Lab{50, 0, 10}));
  EXPECT_EQ(lab_to_lch({50, 3, 4}).c, 5);
  EXPECT_EQ(lab_to_lch({50, 1, -1e-20}).h, 0);
  EXPECT_TRUE(same(Lch{50, 10, -60}, Lch{50, 10, 660}));
  EXPECT_TRUE(same(LchUv{50, 0, std::nan("")}, LchUv{50, 0, 7}));
  EXPECT_FALSE(same(Lch{50, 10, 0}, Lch{50, 10, 1}));
}

TEST(Oklch, GreysHaveNoHue) {
  for (int code = 0; code <= 255; ++code) {
    const double v = code / 255.0;
    const Oklch grey = oklab_to_oklch(linear_srgb_to_oklab({v, v, v}));
    EXPECT_TRUE(std::isnan(grey.h));
    const Oklab back = oklch_to_oklab(grey);
    EXPECT_EQ(back.a, 0);
    EXPECT_EQ(back.b, 0);
  }
  EXPECT_EQ(oklab_to_oklch({0.5, 1.1e-6, 0}).h, 0);
  EXPECT_TRUE(std::isnan(oklch_to_oklab({0.5, 0.1, std::nan("")}).a));
  EXPECT_TRUE(same(Oklch{0.5, 0.1, 10}, Oklch{0.5, 0.1, 370}));
}

}  // namespace
}  // namespace tristim
