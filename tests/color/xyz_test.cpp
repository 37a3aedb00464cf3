#include "tristim/color/xyz.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

double unit() { return *rc::gen::inRange(1, 100001) / 1e5; }

RC_GTEST_PROP(XyzToXyy, ComesBack, ()) {
  const Xyz xyz{unit(), unit(), unit()};
  const Xyz back = xyy_to_xyz(xyz_to_xyy(xyz));
  // Three roundings each way.
  RC_ASSERT(std::fabs(back.x / xyz.x - 1) < 2e-15);
  RC_ASSERT(back.y == xyz.y);
  // Z = (1 - x - y) Y/y loses what x + y takes from 1.
  RC_ASSERT(std::fabs(back.z - xyz.z) < 1e-15 * (xyz.x + xyz.y + xyz.z));
}

TEST(XyzToXyy, BlackHasNoChromaticity) {
  const Xyy black = xyz_to_xyy({});
  EXPECT_TRUE(std::isnan(black.x));
  EXPECT_TRUE(std::isnan(black.y));
  EXPECT_EQ(black.luminance, 0);
  EXPECT_EQ(xyy_to_xyz(black), Xyz{});
}

TEST(XyyToXyz, HasNoFiniteValueAtYZero) {
  EXPECT_EQ(xyy_to_xyz({0.3, 0, 0}), Xyz{});
  EXPECT_FALSE(std::isfinite(xyy_to_xyz({0.3, 0, 0.5}).x));
}

TEST(WhiteXyz, HasTheWhitesChromaticityAndUnitLuminance) {
  for (const WhitePoint& white : kWhitePoints) {
    SCOPED_TRACE(white.name);
    const Xyy back = xyz_to_xyy(white_xyz(white.chromaticity));
    EXPECT_NEAR(back.x, white.chromaticity.x, 1e-15);
    EXPECT_NEAR(back.y, white.chromaticity.y, 1e-15);
    EXPECT_EQ(back.luminance, 1);
  }
  // The XYZ of D65 that the colour examples print.
  EXPECT_NEAR(white_xyz(kD65).x, 0.9504559270516717, 3e-16);
  EXPECT_NEAR(white_xyz(kD65).z, 1.0890577507598784, 3e-16);
}

TEST(XyzToXyy, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/xyy.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double in[] = {row.number("i0"), row.number("i1"), row.number("i2")};
    double out[3];
    if (row.text("op") == "XYZ_to_xyY") {
      const Xyy xyy = xyz_to_xyy({in[0], in[1], in[2]});
      out[0] = xyy.x, out[1] = xyy.y, out[2] = xyy.luminance;
    } else {
      const Xyz xyz = xyy_to_xyz({in[0], in[1], in[2]});
      out[0] = xyz.x, out[1] = xyz.y, out[2] = xyz.z;
    }
    for (int i = 0; i < 3; ++i) {  // the file's tolerance, 4e-16 of the largest term, which is 1
      EXPECT_NEAR(out[i], row.number("o" + std::to_string(i)), 4e-16);
    }
  }
}

}  // namespace
}  // namespace tristim
