#include "tristim/device/monotone.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace tristim {
namespace {

using Numbers = std::vector<double>;

// [FritschButland84] by hand: chords 1 and 3 over widths 1 and 2. Inside w = 5 and 4, slope
// 9/(5/1 + 4/3) = 27/19; ends (4 - 3)/3 = 1/3 and (5 * 3 - 2)/3 = 13/3.
TEST(MonotoneValue, IsHermitesCubicWithTheWeightedHarmonicMean) {
  const Numbers x{0, 1, 3};
  const Numbers y{0, 1, 7};
  // t = 1/2: the mean of the ends, and an eighth of the width times the difference of the slopes.
  EXPECT_DOUBLE_EQ(monotone_value(x, y, 0.5), 0.5 + (1.0 / 3 - 27.0 / 19) / 8);
  EXPECT_DOUBLE_EQ(monotone_value(x, y, 2), 4 + 2 * (27.0 / 19 - 13.0 / 3) / 8);
}

TEST(MonotoneValue, OfTwoPointsIsALine) {
  const Numbers x{10, 20};
  const Numbers y{1, 3};
  EXPECT_DOUBLE_EQ(monotone_value(x, y, 15), 2);
  EXPECT_DOUBLE_EQ(monotone_inverse(x, y, 1.5), 12.5);
}

TEST(MonotoneValue, IsLevelWhereThePointsAre) {
  const Numbers x{0, 1, 2, 3};
  const Numbers y{0, 1, 1, 4};
  for (double at = 1; at <= 2; at += 0.125) EXPECT_EQ(monotone_value(x, y, at), 1);
  EXPECT_EQ(monotone_inverse(x, y, 1), 1);  // the lowest that reaches it
}

TEST(MonotoneValue, HoldsItsEnds) {
  const Numbers x{1, 2};
  const Numbers y{5, 6};
  EXPECT_EQ(monotone_value(x, y, 0), 5);
  EXPECT_EQ(monotone_value(x, y, 9), 6);
  EXPECT_EQ(monotone_inverse(x, y, 0), 1);
  EXPECT_EQ(monotone_inverse(x, y, 9), 2);
}

RC_GTEST_PROP(MonotoneValue, RisesAndComesBack, ()) {
  Numbers x{0};
  Numbers y{0};
  const auto steps = *rc::gen::container<std::vector<int>>(5, rc::gen::inRange(1, 1000));
  const auto rises = *rc::gen::container<std::vector<int>>(5, rc::gen::inRange(0, 1000));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    x.push_back(x.back() + steps[i]);
    y.push_back(y.back() + rises[i]);
  }
  double before = 0;
  for (int k = 0; k <= 200; ++k) {
    const double at = x.back() * k / 200;
    const double value = monotone_value(x, y, at);
    RC_ASSERT(value >= before - 1e-12 * y.back());
    const double inverse = monotone_inverse(x, y, value);
    RC_ASSERT(inverse <= at + 1e-9 * x.back());
    RC_ASSERT(monotone_value(x, y, inverse) >= value - 1e-12 * y.back());
    before = value;
  }
}

}  // namespace
}  // namespace tristim
