#include "tristim/lut/compose.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "tests/lut/luts.h"
#include "tristim/lut/invert.h"

namespace tristim {
namespace {

// A rising curve of three channels over [0, 1], to [0, 1].
LutPoints rising_curves(int count) {
  LutPoints points;
  for (LutCurve& curve : points.curves) {
    for (int i = 0; i < count; ++i) {
      const float off =
          i == 0 || i == count - 1 ? 0 : static_cast<float>(*rc::gen::inRange(-300, 300)) / 1000;
      curve.in.push_back(static_cast<float>(i) / static_cast<float>(count - 1));
      curve.out.push_back((static_cast<float>(i) + off) / static_cast<float>(count - 1));
    }
  }
  return points;
}

double largest_difference(const Lut& a, const Lut& b) {
  double most = 0;
  for (int i = -5; i <= 105; ++i) {
    const double x = i / 100.0;
    const Rgb p = evaluate(a, {x, x, x});
    const Rgb q = evaluate(b, {x, x, x});
    most = std::max({most, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
  }
  return most;
}

RC_GTEST_PROP(ComposeLuts, MakesOneOfCurves, ()) {
  const LutPoints first = rising_curves(*rc::gen::inRange(2, 20));
  const LutPoints second = rising_curves(*rc::gen::inRange(2, 20));
  const Lut both = compose(std::array{Lut{"", {first}}, Lut{"", {second}}});
  RC_ASSERT(both.steps.size() == 1U);
  RC_ASSERT(largest_difference(both, {"", {first, second}}) < 5e-7);  // floats of points, 3 steep
}

RC_GTEST_PROP(ComposeLuts, WithTheInverseIsTheIdentity, ()) {
  const Lut lut{"", {rising_curves(*rc::gen::inRange(2, 40))}};
  const Lut both = compose(std::array{lut, invert(lut)});
  Lut1D identity{{}, 2, {0, 0, 0, 1, 1, 1}};
  RC_ASSERT(largest_difference(both, {"", {identity}}) < 5e-7);
}

TEST(ComposeLuts, TakesFallingCurvesAndPlateaus) {
  const LutCurve first{{0, 1, 2, 3}, {1, 0, 0, 2}};
  const LutCurve second{{0, 0.5F, 2}, {0, 1, 10}};
  const LutPoints a{{first, first, first}};
  const LutPoints b{{second, second, second}};
  const auto both = compose(a, b);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->curves[0], (LutCurve{{0, 0.5F, 1, 2, 2.25F, 3}, {4, 1, 0, 0, 1, 10}}));
}

TEST(ComposeLuts, MultipliesMatrices) {
  LutMatrix a;
  a.matrix << 1, 2, 0, 0, 1, 0, 0, 3, 1;
  a.offset = {1, 0, 2};
  LutMatrix b;
  b.matrix << 2, 0, 1, 0, 4, 0, 0, 0, 1;
  b.offset = {0, 5, 0};
  const Lut both = compose(std::array{Lut{"a", {a}}, Lut{"b", {b}}});
  EXPECT_EQ(both.title, "a, b");
  ASSERT_EQ(both.steps.size(), 1U);
  EXPECT_EQ(evaluate(both, {1, 2, 3}), evaluate(Lut{"", {a, b}}, {1, 2, 3}));
}

TEST(ComposeLuts, KeepsCubes) {
  const Lut cube{"", {noise_cube(3, 1)}};
  const Lut both = compose(std::array{cube, Lut{}, cube});
  ASSERT_EQ(both.steps.size(), 2U);
  EXPECT_EQ(evaluate(both, {0.2, 0.3, 0.4}), evaluate(cube, evaluate(cube, Rgb{0.2, 0.3, 0.4})));
}

}  // namespace
}  // namespace tristim
