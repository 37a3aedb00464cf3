#include "tristim/color/lab.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr double kEpsilon = 216.0 / 24389;  // [CIE15 note to 8.2.1]

Xyz white_of(const ExampleRow& row) {
  return {row.number("wX"), row.number("wY"), row.number("wZ")};
}
Xyz input_of(const ExampleRow& row) {
  return {row.number("i0"), row.number("i1"), row.number("i2")};
}
void expect_output(const ExampleRow& row, double o0, double o1, double o2, double tolerance) {
  EXPECT_NEAR(o0, row.number("o0"), tolerance);
  EXPECT_NEAR(o1, row.number("o1"), tolerance);
  EXPECT_NEAR(o2, row.number("o2"), tolerance);
}

// Tolerances are those of the files: 2e-13 for L*a*b* up to 500, 1e-15 max(1, |out|) back.
TEST(Lab, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/lab.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Xyz in = input_of(row);
    if (row.text("op") == "XYZ_to_Lab") {
      const Lab lab = xyz_to_lab(in, white_of(row));
      expect_output(row, lab.l, lab.a, lab.b, 2e-13);
    } else {
      const Xyz xyz = lab_to_xyz({in.x, in.y, in.z}, white_of(row));
      expect_output(row, xyz.x, xyz.y, xyz.z, 1.4e-15);
    }
  }
}

TEST(Luv, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/luv.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Xyz in = input_of(row);
    if (row.text("op") == "XYZ_to_Luv") {
      const Luv luv = xyz_to_luv(in, white_of(row));
      expect_output(row, luv.l, luv.u, luv.v, 2e-13);
    } else {
      const Xyz xyz = luv_to_xyz({in.x, in.y, in.z}, white_of(row));
      expect_output(row, xyz.x, xyz.y, xyz.z, 1e-15);
    }
  }
}

TEST(RgbToLab, AgreesWithTheNeutralAxisOfTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/neutral_axis.csv")) {
    SCOPED_TRACE(row.text("id"));
    const NamedPrimaries* set = find_by_name(primaries_list(), row.text("primaries"));
    if (set == nullptr) throw std::runtime_error("no such primaries");
    const double v = row.number("v");
    const Lab lab = rgb_to_lab({v, v, v}, xyz_from_rgb(set->primaries));
    EXPECT_NEAR(lab.l, row.number("L"), 1e-13);
    EXPECT_EQ(lab.a, 0);
    EXPECT_EQ(lab.b, 0);
    const Luv luv = rgb_to_luv({v, v, v}, xyz_from_rgb(set->primaries));
    EXPECT_NEAR(luv.l, row.number("L"), 1e-13);
    EXPECT_EQ(luv.u, 0);
    EXPECT_EQ(luv.v, 0);
  }
}

TEST(RgbToLab, GreysOfEverySetAreExactlyNeutral) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const Eigen::Matrix3d matrix = xyz_from_rgb(set.primaries);
    for (int code = -20; code <= 300; ++code) {
      const double grey = code / 255.0;
      const Lab lab = rgb_to_lab({grey, grey, grey}, matrix);
      ASSERT_EQ(lab.a, 0);
      ASSERT_EQ(lab.b, 0);
    }
    EXPECT_EQ(rgb_to_lab({1, 1, 1}, matrix).l, 100);
    EXPECT_EQ(rgb_to_lab({0, 0, 0}, matrix).l, 0);
  }
}

TEST(RgbToLab, IsTheWayThroughXyz) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const Eigen::Matrix3d matrix = xyz_from_rgb(set.primaries);
    for (const Rgb rgb :
         {Rgb{0.1, 0.5, 0.9}, Rgb{1, 0, 0}, Rgb{0.7, 0.7, 0.2}, Rgb{0, 1.5, -0.1}}) {
      const Eigen::Vector3d xyz = matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
      const Lab direct = rgb_to_lab(rgb, matrix);
      const Lab hub = xyz_to_lab({xyz.x(), xyz.y(), xyz.z()}, white_xyz(set.primaries.white));
      // 1e-15 of XYZ times 500 times the slope of the linear segment, 7.8: 4e-12.
      EXPECT_NEAR(direct.l, hub.l, 4e-12);
      EXPECT_NEAR(direct.a, hub.a, 8e-12);
      EXPECT_NEAR(direct.b, hub.b, 8e-12);
      const Xyz white = white_xyz(set.primaries.white);
      const Luv luv = rgb_to_luv(rgb, matrix);
      const Luv luv_hub = xyz_to_luv({xyz.x(), xyz.y(), xyz.z()}, white);
      EXPECT_NEAR(luv.u, luv_hub.u, 4e-12);
      EXPECT_NEAR(luv.v, luv_hub.v, 4e-12);
      const Eigen::Matrix3d inverse = rgb_from_xyz(set.primaries);
      for (const Rgb back : {lab_to_rgb(direct, white, inverse), luv_to_rgb(luv, white, inverse)}) {
        EXPECT_NEAR(back.r, rgb.r, 1e-13);
        EXPECT_NEAR(back.g, rgb.g, 1e-13);
        EXPECT_NEAR(back.b, rgb.b, 1e-13);
      }
    }
  }
}

RC_GTEST_PROP(Lab, ComesBack, ()) {
  const auto part = [] { return *rc::gen::inRange(-200, 1500) / 1000.0; };
  const Xyz xyz{part(), part(), part()};
  const Xyz white = white_xyz(*rc::gen::element(kD50, kD65));
  const Xyz back = lab_to_xyz(xyz_to_lab(xyz, white), white);
  RC_ASSERT(std::fabs(back.x - xyz.x) < 2e-15);
  RC_ASSERT(std::fabs(back.y - xyz.y) < 2e-15);
  RC_ASSERT(std::fabs(back.z - xyz.z) < 2e-15);
}

RC_GTEST_PROP(Luv, ComesBack, ()) {
  const auto part = [] { return *rc::gen::inRange(1, 1500) / 1000.0; };
  const Xyz xyz{part(), part(), part()};
  const Xyz white = white_xyz(*rc::gen::element(kD50, kD65));
  const Xyz back = luv_to_xyz(xyz_to_luv(xyz, white), white);
  // A small Y makes u* and v* large for what they say.
  const double tolerance = 4e-16 * (1 + (xyz.x + 3 * xyz.z) / xyz.y);
  RC_ASSERT(std::fabs(back.x - xyz.x) < 4 * tolerance);
  RC_ASSERT(std::fabs(back.y - xyz.y) < 2e-15);
  RC_ASSERT(std::fabs(back.z - xyz.z) < 4 * tolerance);
}

// The references are computed in 50 digits from these doubles.
TEST(Lab, IsRoundedOnce) {
  const Xyz d50{0.9642956764295676, 1, 0.8251046025104602};
  const Lab lab = xyz_to_lab({0.238534954516542, 0.8974157081081162, 0.0995709735684162}, d50);
  EXPECT_EQ(lab.l, 95.88946868366686);
  EXPECT_EQ(lab.a, -168.41161440308835);
  EXPECT_EQ(lab.b, 94.07928564682702);
  const Luv luv = xyz_to_luv({0.238534954516542, 0.0974157081081162, 0.0995709735684162}, d50);
  EXPECT_EQ(luv.l, 37.3745614647318);
  EXPECT_EQ(luv.u, 130.33576370207743);
  EXPECT_EQ(luv.v, -23.99048498166896);
}

TEST(Lab, TakesNumbersWithoutEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Xyz white = white_xyz(kD65);
  EXPECT_EQ(xyz_to_lab({0.5, infinity, 0.5}, white).l, infinity);
  EXPECT_EQ(lstar_from_luminance(infinity), infinity);
  EXPECT_EQ(lstar_from_luminance(-infinity), -infinity);
  EXPECT_TRUE(std::isfinite(xyz_to_lab({1e300, 1e300, 1e300}, white).l));
}

TEST(Luv, BlackIsBlackAndNanIsNan) {
  const Xyz white = white_xyz(kD65);
  EXPECT_EQ(luv_to_xyz({0, 5, 5}, white), (Xyz{0, 0, 0}));
  EXPECT_TRUE(std::isnan(luv_to_xyz({0, std::nan(""), 0}, white).x));
  EXPECT_TRUE(std::isnan(luv_to_xyz({50, 0, std::nan("")}, white).x));
}

TEST(Lab, WhiteIsHundredAndNeutral) {
  for (const WhitePoint& white : kWhitePoints) {
    const Xyz xyz = white_xyz(white.chromaticity);
    EXPECT_EQ(xyz_to_lab(xyz, xyz), (Lab{100, 0, 0}));
    EXPECT_EQ(xyz_to_luv(xyz, xyz), (Luv{100, 0, 0}));
    EXPECT_EQ(xyz_to_luv({}, xyz), (Luv{0, 0, 0}));
  }
}

TEST(Lstar, IsContinuousAndStraightBelowEpsilon) {
  EXPECT_NEAR(lstar_from_luminance(kEpsilon), 8, 1e-14);
  EXPECT_NEAR(lstar_from_luminance(std::nextafter(kEpsilon, 1)), 8, 1e-14);
  // [CIE15]: kappa = 24389/27.
  EXPECT_NEAR(lstar_from_luminance(0.001), 24389.0 / 27 * 0.001, 1e-14);
  EXPECT_NEAR(lstar_from_luminance(-0.01), -24389.0 / 27 * 0.01, 1e-14);
  EXPECT_NEAR(lstar_from_luminance(0.18418651851244416), 50, 1e-14);  // (66/116)^3
  for (double l = -10; l <= 110; l += 0.25) {
    EXPECT_NEAR(lstar_from_luminance(luminance_from_lstar(l)), l, 3e-14);
  }
}

TEST(Lab, NanStaysNan) {
  const Lab lab = xyz_to_lab({std::nan(""), 0.5, 0.5}, white_xyz(kD65));
  EXPECT_TRUE(std::isnan(lab.a));
}

}  // namespace
}  // namespace tristim
