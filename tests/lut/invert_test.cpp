#include "tristim/lut/invert.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/lut/luts.h"

namespace tristim {
namespace {

// A curve of three equal channels.
Lut1D grey_curve(const std::vector<float>& values, LutRange range = {}) {
  Lut1D lut{range, static_cast<int>(values.size()), {}};
  for (const float v : values) lut.rgb.insert(lut.rgb.end(), 3, v);
  return lut;
}

std::string complaint_of(const Lut1D& curves) {
  try {
    (void)invert(curves);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(InvertCurves, ExchangesTheCoordinates) {
  const LutPoints inverted = invert(grey_curve({1, 2, 10}, {{0, 0, -4}, {2, 1, 4}}));
  EXPECT_EQ(inverted.curves[0], (LutCurve{{1, 2, 10}, {0, 1, 2}}));
  EXPECT_EQ(inverted.curves[2], (LutCurve{{1, 2, 10}, {-4, 0, 4}}));
  EXPECT_EQ(evaluate(inverted, {1.5, 6, -99}), (Rgb{0.5, 0.75, -4}));
}

TEST(InvertCurves, TakesFallingOnes) {
  EXPECT_EQ(invert(grey_curve({5, 3, 1})).curves[1], (LutCurve{{1, 3, 5}, {1, 0.5F, 0}}));
}

// A dead zone at the beginning, a level stretch inside and one at the end.
TEST(InvertCurves, SendsLevelStretchesToTheirFirstCode) {
  const LutPoints inverted = invert(grey_curve({0, 0, 0, 1, 1, 2, 2}, {{0, 0, 0}, {6, 6, 6}}));
  const LutCurve& curve = inverted.curves[0];
  EXPECT_EQ(evaluate(curve, 0), 0);
  EXPECT_NEAR(evaluate(curve, 1e-30), 2, 1e-6);
  EXPECT_EQ(evaluate(curve, 0.5), 2.5);
  EXPECT_EQ(evaluate(curve, 1), 3);
  EXPECT_EQ(evaluate(curve, std::nextafter(1.F, 2.F)), 4);
  EXPECT_EQ(evaluate(curve, 2), 5);
  EXPECT_EQ(evaluate(curve, 3), 5);
}

TEST(InvertCurves, RefusesWhatTurnsOrStaysLevel) {
  EXPECT_EQ(
      complaint_of(grey_curve({0, 1, 0.5F, 2})),
      "invert: the red curve rises from end to end, but turns at entry 2 from 1 to 0.5: it has "
      "no inverse");
  EXPECT_EQ(complaint_of(grey_curve({4, 1, 2, 0})),
            "invert: the red curve falls from end to end, but turns at entry 2 from 1 to 2: it has "
            "no inverse");
  EXPECT_EQ(complaint_of(grey_curve({1, 1, 1})),
            "invert: the red curve begins and ends at 1: it has no inverse");
}

RC_GTEST_PROP(InvertCurves, IsUndoneByTheCurves, (bool falling)) {
  const auto steps = *rc::gen::nonEmpty<std::vector<unsigned>>();
  std::vector<float> values = {0};
  for (const unsigned step : steps) {
    values.push_back(values.back() + static_cast<float>(step % 4096 + 1) / 4096);
  }
  const float top = values.back();
  if (falling) std::reverse(values.begin(), values.end());
  const Lut1D curves = grey_curve(values);
  const LutPoints inverted = invert(curves);
  for (int i = 0; i <= 50; ++i) {
    const double y = double{top} * i / 50;
    const Rgb x = evaluate(inverted, {y, y, y});
    // One rounding of an input to float, times the steepest slope.
    RC_ASSERT(std::abs(evaluate(curves, x).g - y) <= 6e-8 * static_cast<double>(values.size()));
  }
}

RC_GTEST_PROP(InvertCurves, TwiceGivesTheCurves, ()) {
  LutPoints points;
  for (LutCurve& curve : points.curves) {
    const int count = *rc::gen::inRange(2, 30);
    for (int i = 0; i < count; ++i) {
      const auto ahead = [&] { return static_cast<float>(*rc::gen::inRange(1, 1000)) / 1024; };
      curve.in.push_back(i == 0 ? -1.F : curve.in.back() + ahead());
      curve.out.push_back(i == 0 ? 3.F : curve.out.back() + ahead());
    }
  }
  RC_ASSERT(invert(invert(points)) == points);
}

TEST(InvertMatrix, IsItsInverse) {
  LutMatrix m;
  m.matrix << 2, 1, 0, 0, 4, 0, 1, 0, 1;
  m.offset = {1, 2, 3};
  const Rgb in{0.25, -7, 3};
  const Rgb back = evaluate(invert(m), evaluate(m, in));
  EXPECT_NEAR(back.r, in.r, 1e-15);
  EXPECT_NEAR(back.g, in.g, 1e-14);
  EXPECT_NEAR(back.b, in.b, 1e-14);
  EXPECT_THROW(invert(LutMatrix{.matrix = Eigen::Matrix3d::Ones()}), std::invalid_argument);
}

// A cube that bends but nowhere folds: what it makes of any colour leads back to it.
Lut3D bent_cube(int size, LutRange range = {}) {
  Lut3D cube{range, size, {}};
  for (int b = 0; b < size; ++b) {
    for (int g = 0; g < size; ++g) {
      for (int r = 0; r < size; ++r) {
        const double x = r / (size - 1.0);
        const double y = g / (size - 1.0);
        const double z = b / (size - 1.0);
        cube.rgb.push_back(static_cast<float>(0.7 * std::sqrt(x) + 0.2 * y + 0.1 * z));
        cube.rgb.push_back(static_cast<float>(0.1 * x + 0.8 * y * y + 0.1 * y));
        cube.rgb.push_back(static_cast<float>(0.2 * x * y + 0.8 * z));
      }
    }
  }
  return cube;
}

RC_GTEST_PROP(CubeInverse, LeadsBack, ()) {
  const int size = *rc::gen::inRange(2, 12);
  const LutRange range{{-1, 0, 0}, {1, 1, 4}};
  const Lut3D cube = bent_cube(size, range);
  const CubeInverse inverse(cube);
  const auto part = [] { return *rc::gen::inRange(0, 10001) / 10000.0; };
  const Rgb in{2 * part() - 1, part(), 4 * part()};
  const Rgb back = inverse(evaluate(cube, in));
  RC_ASSERT(std::abs(back.r - in.r) < 1e-12);
  RC_ASSERT(std::abs(back.g - in.g) < 1e-12);
  RC_ASSERT(std::abs(back.b - in.b) < 1e-12);
}

// Compared with all colours of a fine grid.
TEST(CubeInverse, FindsTheNearestOfColoursOutside) {
  const Lut3D cube = bent_cube(4);
  const CubeInverse inverse(cube);
  for (const Rgb target :
       {Rgb{1.5, 0.5, 0.5}, Rgb{-1, -1, -1}, Rgb{0.2, 1.2, 0.1}, Rgb{2, 2, -3}}) {
    const auto distance = [&](Rgb in) {
      const Rgb out = evaluate(cube, in);
      return std::hypot(out.r - target.r, out.g - target.g, out.b - target.b);
    };
    const Rgb found = inverse(target);
    double least = 99;
    for (int i = 0; i < 61 * 61 * 61; ++i) {
      least = std::min(least, distance({i % 61 / 60.0, i / 61 % 61 / 60.0, i / 3721 / 60.0}));
    }
    EXPECT_LE(distance(found), least + 1e-12);
    EXPECT_GE(std::min({found.r, found.g, found.b}), 0);
    EXPECT_LE(std::max({found.r, found.g, found.b}), 1);
  }
}

TEST(CubeInverse, TakesFlatCubesAndOddColours) {
  const CubeInverse flat(Lut3D{{}, 2, std::vector<float>(24, 0.5F)});
  EXPECT_EQ(flat({0.5, 0.5, 0.5}), (Rgb{0, 0, 0}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Rgb odd = flat({nan, 1, 1});
  EXPECT_EQ(odd, (Rgb{0, 0, 0}));
}

TEST(InvertLut, TurnsTheStepsRound) {
  LutMatrix half{.matrix = 0.5 * Eigen::Matrix3d::Identity()};
  const Lut lut{"t", {grey_curve({0, 4}), half}};
  EXPECT_TRUE(inverts_exactly(lut));
  const Lut inverted = invert(lut);
  ASSERT_EQ(inverted.steps.size(), 2U);
  EXPECT_EQ(evaluate(inverted, {1, 0.5, 2}), (Rgb{0.5, 0.25, 1}));
  EXPECT_EQ(LutInverse(lut)({1, 0.5, 2}), (Rgb{0.5, 0.25, 1}));
}

TEST(InvertLut, GoesThroughCubes) {
  const Lut lut{"", {grey_curve({0, 0.25F, 1}), bent_cube(9)}};
  EXPECT_FALSE(inverts_exactly(lut));
  EXPECT_THROW(invert(lut), std::invalid_argument);
  const LutInverse inverse(lut);
  for (const Rgb in : {Rgb{0.1, 0.5, 0.9}, Rgb{0.7, 0.2, 0.3}, Rgb{1, 1, 1}, Rgb{0, 0, 0}}) {
    const Rgb back = inverse(evaluate(lut, in));
    EXPECT_NEAR(back.r, in.r, 1e-7);
    EXPECT_NEAR(back.g, in.g, 1e-7);
    EXPECT_NEAR(back.b, in.b, 1e-7);
  }
}

}  // namespace
}  // namespace tristim
