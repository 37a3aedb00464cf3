#include "tristim/lut/lut.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/lut/luts.h"

namespace tristim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string complaint_of(const Lut& lut) {
  try {
    check(lut);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Lut, WithoutStepsIsTheIdentity) {
  EXPECT_EQ(evaluate(Lut{}, {-1, 0.5, 7}), (Rgb{-1, 0.5, 7}));
}

TEST(Lut, TakesItsStepsInOrder) {
  LutMatrix doubled{.matrix = 2 * Eigen::Matrix3d::Identity()};
  LutMatrix raised{.offset = {1, 1, 1}};
  EXPECT_EQ(evaluate(Lut{"", {doubled, raised}}, {1, 2, 3}), (Rgb{3, 5, 7}));
  EXPECT_EQ(evaluate(Lut{"", {raised, doubled}}, {1, 2, 3}), (Rgb{4, 6, 8}));
}

TEST(Lut1D, JoinsItsEntriesByStraightLines) {
  const Lut1D lut{{{0, -1, 0}, {1, 1, 2}}, 3, {0, 1, 5, 0.25F, 0, 6, 1, 0.5F, 8}};
  EXPECT_EQ(evaluate(lut, {0.25, 0, 1.5}), (Rgb{0.125, 0, 7}));
  EXPECT_EQ(evaluate(lut, {0.75, 0.5, 0.5}), (Rgb{0.625, 0.25, 5.5}));
}

TEST(Lut1D, HoldsItsEndsBeyondItsRange) {
  const Lut1D lut{{}, 2, {0.25F, 0.5F, 0.75F, 1, 2, 3}};
  EXPECT_EQ(evaluate(lut, {-9, -INFINITY, kNan}), (Rgb{0.25, 0.5, 0.75}));
  EXPECT_EQ(evaluate(lut, {9, INFINITY, 1}), (Rgb{1, 2, 3}));
}

TEST(LutPoints, JoinsItsPointsByStraightLines) {
  const LutCurve curve{{-1, 0, 4}, {0, 1, 2}};
  EXPECT_EQ(evaluate(curve, -0.5), 0.5);
  EXPECT_EQ(evaluate(curve, 1), 1.25);
  EXPECT_EQ(evaluate(curve, 4), 2);
  EXPECT_EQ(evaluate(curve, 5), 2);
  EXPECT_EQ(evaluate(curve, -INFINITY), 0);
  EXPECT_EQ(evaluate(curve, kNan), 0);
}

TEST(Lut3D, HasItsPointsWithEveryInterpolation) {
  const Lut3D cube = noise_cube(5, 1);
  for (const LutInterpolation& method : kLutInterpolations) {
    SCOPED_TRACE(method.name);
    for (int i = 0; i < 125; ++i) {
      const float* point = &cube.rgb[static_cast<std::size_t>(3 * i)];
      const Rgb in{i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0};
      EXPECT_EQ(evaluate(cube, in, method), (Rgb{point[0], point[1], point[2]}));
    }
  }
}

TEST(Lut3D, TakesTheTetrahedronOfTheColour) {
  Lut3D cube{{}, 2, std::vector<float>(24, 0)};
  cube.rgb[3 * 1] = 1;      // P100: red's own corner in the first channel
  cube.rgb[3 * 6 + 1] = 1;  // P011: that of green and blue in the second
  const Rgb red_first = tetrahedral(cube, {0.75, 0.5, 0.25});
  EXPECT_EQ(red_first, (Rgb{0.25, 0, 0}));
  const Rgb red_last = tetrahedral(cube, {0.25, 0.5, 0.75});
  EXPECT_EQ(red_last, (Rgb{0, 0.25, 0}));
  EXPECT_EQ(trilinear(cube, {0.75, 0.5, 0.25}), (Rgb{0.75 * 0.5 * 0.75, 0.25 * 0.5 * 0.25, 0}));
}

TEST(Lut3D, KeepsGreysOfItsDiagonalWithTetrahedra) {
  const Lut3D cube = noise_cube(3, 2);
  const float* low = &cube.rgb[0];
  const float* middle = &cube.rgb[std::size_t{3} * 13];
  const Rgb grey = tetrahedral(cube, {0.125, 0.125, 0.125});
  EXPECT_EQ(grey.r, 0.75 * low[0] + 0.25 * middle[0]);
  EXPECT_EQ(grey.g, 0.75 * low[1] + 0.25 * middle[1]);
}

RC_GTEST_PROP(Lut3D, ReproducesAffineMapsWithEveryInterpolation, ()) {
  const auto part = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
  LutMatrix map;
  for (int i = 0; i < 9; ++i) map.matrix(i / 3, i % 3) = part();
  const LutRange range{{-1, 0, 0.5}, {1, 3, 0.75}};
  const int size = *rc::gen::inRange(2, 9);
  const Lut3D cube = sampled(map, size, range);
  const Rgb in{part(), 1.5 + 1.5 * part(), 0.625 + 0.125 * part()};
  for (const LutInterpolation& method : kLutInterpolations) {
    const Rgb a = evaluate(cube, in, method);
    const Rgb b = evaluate(map, in);
    const double most = 1e-6;  // the table's floats of up to 5
    RC_ASSERT(std::abs(a.r - b.r) < most);
    RC_ASSERT(std::abs(a.g - b.g) < most);
    RC_ASSERT(std::abs(a.b - b.b) < most);
  }
}

TEST(InputRange, IsThatOfTheFirstStep) {
  const LutRange range{{-1, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(input_range(Lut{}), LutRange{});
  EXPECT_EQ(input_range({"", {LutMatrix{}, noise_cube(2, 1, range)}}), LutRange{});
  EXPECT_EQ(input_range({"", {noise_cube(2, 1, range)}}), range);
  const LutCurve curve{{-3, 1, 9}, {0, 1, 2}};
  EXPECT_EQ(input_range({"", {LutPoints{{curve, curve, curve}}}}),
            (LutRange{{-3, -3, -3}, {9, 9, 9}}));
}

TEST(CheckLut, SaysWhatIsWrong) {
  const std::vector<float> two(6, 0);
  EXPECT_EQ(complaint_of({"", {Lut1D{{}, 2, two}}}), "");
  EXPECT_EQ(complaint_of({"", {LutMatrix{}, Lut1D{{}, 1, {0, 0, 0}}}}),
            "lut: step 2: curves of size 1; expected 2 to 4194304");
  EXPECT_EQ(complaint_of({"", {Lut1D{{}, 3, two}}}), "lut: step 1: has 6 numbers; expected 9");
  EXPECT_EQ(complaint_of({"", {Lut1D{{}, 2, {0, 0, 0, 0, NAN, 0}}}}),
            "lut: step 1: entry 1 is nan; expected finite numbers");
  EXPECT_EQ(complaint_of({"", {Lut1D{{{0, 1, 0}, {1, 1, 1}}, 2, two}}}),
            "lut: step 1: range 1 to 1; expected low < high");
  EXPECT_EQ(complaint_of({"", {Lut1D{{{0, 0, kNan}, {1, 1, 1}}, 2, two}}}),
            "lut: step 1: range nan to 1; expected low < high");
  const LutCurve line{{0, 1}, {0, 1}};
  EXPECT_EQ(complaint_of({"", {LutPoints{{line, line, LutCurve{{0, 1, 1}, {0, 1, 2}}}}}}),
            "lut: step 1: point 1 follows 1; expected ascending points");
  EXPECT_EQ(complaint_of({"", {LutPoints{{line, line, LutCurve{{0, 1}, {0}}}}}}),
            "lut: step 1: has 1 numbers; expected 2");
  EXPECT_EQ(complaint_of({"", {LutMatrix{.offset = {0, INFINITY, 0}}}}),
            "lut: step 1: matrix with a number that is not finite");
}

TEST(CheckLut, RefusesSizesBeforeMemoryIsAskedFor) {
  for (const int size : {-1, 0, 1, 257, 1 << 20}) {
    EXPECT_THROW(cube_samples(size), std::invalid_argument) << size;
    EXPECT_NE(complaint_of({"", {Lut3D{{}, size, {}}}}), "") << size;
  }
  EXPECT_EQ(cube_samples(256), std::size_t{3} << 24);
  EXPECT_EQ(curve_samples(1 << 20), std::size_t{3} << 20);
  EXPECT_THROW(curve_samples((1 << 22) + 1), std::invalid_argument);
}

}  // namespace
}  // namespace tristim
