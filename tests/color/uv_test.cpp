#include "tristim/color/uv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

TEST(Xyy, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/xyy.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double i0 = row.number("i0");
    const double i1 = row.number("i1");
    const double i2 = row.number("i2");
    double out[3] = {};
    if (row.text("op") == "XYZ_to_xyY") {
      const Xyy xyy = xyz_to_xyy({i0, i1, i2});
      out[0] = xyy.x, out[1] = xyy.y, out[2] = xyy.luminance;
    } else {
      const Xyz xyz = xyy_to_xyz({i0, i1, i2});
      out[0] = xyz.x, out[1] = xyz.y, out[2] = xyz.z;
    }
    for (int i = 0; i < 3; ++i) {
      const double expected = row.number("o" + std::to_string(i));
      EXPECT_NEAR(out[i], expected, 4e-16 * std::fabs(expected));
    }
  }
}

// [CIE15]: illuminant C has u = .2009, v = .3073, v' = .4609 (four decimals).
TEST(Uv, HasTheChromaticityOfIlluminantC) {
  const Uv uv = xyz_to_uv(white_xyz({0.31006, 0.31616}));
  EXPECT_NEAR(uv.u, 0.2009, 5e-5);
  EXPECT_NEAR(uv.v, 0.3073, 5e-5);
  EXPECT_NEAR(xyz_to_uv_prime(white_xyz({0.31006, 0.31616})).v, 0.4609, 5e-5);
}

TEST(Uv, ComesBack) {
  for (const Xyz xyz : {Xyz{0.3, 0.5, 0.7}, Xyz{1, 0.01, 0}, Xyz{-0.2, 0.4, 2}}) {
    for (const Xyz back : {uv_to_xyz(xyz_to_uv(xyz)), uv_prime_to_xyz(xyz_to_uv_prime(xyz))}) {
      EXPECT_NEAR(back.x, xyz.x, 2e-15);
      EXPECT_EQ(back.y, xyz.y);
      EXPECT_NEAR(back.z, xyz.z, 2e-15);
    }
  }
}

TEST(Uv, BlackHasNoChromaticity) {
  EXPECT_TRUE(std::isnan(xyz_to_uv({}).u) && std::isnan(xyz_to_uv_prime({}).v));
  EXPECT_EQ(uv_to_xyz({std::nan(""), 0, 0}), Xyz{});
  EXPECT_EQ(uv_prime_to_xyz({0.2, 0, 0}), Xyz{});
  EXPECT_FALSE(std::isfinite(uv_to_xyz({0.2, 0, 0.5}).z));
  EXPECT_FALSE(std::isfinite(uv_prime_to_xyz({0.2, 0, 0.5}).z));
}

}  // namespace
}  // namespace tristim
