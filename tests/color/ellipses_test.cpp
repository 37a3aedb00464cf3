#include "tristim/color/ellipses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tristim {
namespace {

TEST(MacAdamEllipses, AreTheTwentyFive) {
  ASSERT_EQ(macadam_ellipses().size(), 25U);
  EXPECT_EQ(macadam_ellipses().front().centre, (Chromaticity{0.16, 0.057}));
  for (const DiscriminationEllipse& e : macadam_ellipses()) {
    EXPECT_GT(e.semi_major_1e3, e.semi_minor_1e3);
  }
}

TEST(EllipseOutline, TurnsAndMagnifies) {
  const DiscriminationEllipse ellipse{{0.3, 0.4}, 2, 1, 90};
  const std::vector<Chromaticity> outline = ellipse_outline(ellipse, 10, 4);
  ASSERT_EQ(outline.size(), 4U);
  EXPECT_NEAR(outline[0].x, 0.3, 1e-15);  // the long axis points up
  EXPECT_NEAR(outline[0].y, 0.42, 1e-15);
  EXPECT_NEAR(outline[1].x, 0.29, 1e-15);
  EXPECT_NEAR(outline[1].y, 0.4, 1e-15);
}

}  // namespace
}  // namespace tristim
