#include "tristim/device/dot_gain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tristim {
namespace {

const DotGain kGains[] = {NoGain{},
                          MurrayDaviesGain{0.14},
                          MurrayDaviesGain{0.25},
                          YuleNielsenGain{1.7, 0.02},
                          YuleNielsenGain{3, 0.3},
                          YuleNielsenGain{1, 0.1},
                          MeasuredGain{{0, 0.4, 0.5, 1}, {0, 0.58, 0.7, 1}}};

TEST(DotGain, EndsStayAndAreasRise) {
  for (const DotGain& gain : kGains) {
    SCOPED_TRACE(describe(gain));
    EXPECT_EQ(covered_area(gain, 0), 0);
    EXPECT_NEAR(covered_area(gain, 1), 1, 1e-15);
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
      const double covered = covered_area(gain, i / 100.0);
      EXPECT_GT(covered, last);
      EXPECT_GE(covered, i / 100.0 - 1e-15);
      last = covered;
    }
    EXPECT_EQ(covered_area(gain, -3), 0);
    EXPECT_EQ(covered_area(gain, 7), covered_area(gain, 1));
  }
}

TEST(DotGain, AskedAreaIsTheInverse) {
  for (const DotGain& gain : kGains) {
    SCOPED_TRACE(describe(gain));
    for (int i = 0; i <= 1000; ++i) {
      const double covered = i / 1000.0;
      EXPECT_NEAR(covered_area(gain, asked_area(gain, covered)), covered, 1e-12);
    }
  }
}

TEST(DotGain, HasTheFiguresOfItsFormulas) {
  EXPECT_NEAR(covered_area(MurrayDaviesGain{0.2}, 0.5), 0.7, 1e-15);  // [Murray36]
  // [Yule51], n = 2, Rs = .04: R = (.5 x .2 + .5)^2 = .36, covered (1 - .36)/.96
  EXPECT_NEAR(covered_area(YuleNielsenGain{2, 0.04}, 0.5), 0.64 / 0.96, 1e-15);
  EXPECT_NEAR(covered_area(YuleNielsenGain{1, 0.04}, 0.3), 0.3, 1e-15);  // n = 1 is no gain
  EXPECT_NEAR(covered_area(MeasuredGain{{0, 0.5, 1}, {0, 0.7, 1}}, 0.25), 0.35, 1e-15);
}

}  // namespace
}  // namespace tristim
