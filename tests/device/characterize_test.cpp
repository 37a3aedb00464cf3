#include "tristim/device/characterize.h"

#include <gtest/gtest.h>

#include "tests/error_text.h"

namespace tristim {
namespace {

Xyz column(const Eigen::Matrix3d& m, int c, double scale, Xyz black) {
  return {scale * m(0, c) + black.x, scale * m(1, c) + black.y, scale * m(2, c) + black.z};
}

// What a meter would read off sRGB primaries at 120 cd/m2 with a black of its own.
MeasuredPrimaries srgb_display(Xyz black) {
  const Eigen::Matrix3d m = xyz_from_rgb({});
  const Xyz white = white_xyz(kD65);
  return {column(m, 0, 120, black), column(m, 1, 120, black), column(m, 2, 120, black),
          Xyz{120 * white.x + black.x, 120 + black.y, 120 * white.z + black.z}, black};
}

TEST(PrimariesOf, AreThoseOfTheDisplayWithoutItsBlack) {
  const Primaries p = primaries_of(srgb_display({0.3, 0.2, 0.5}));
  EXPECT_NEAR(p.red.x, 0.64, 1e-14);
  EXPECT_NEAR(p.green.y, 0.60, 1e-14);
  EXPECT_NEAR(p.blue.x, 0.15, 1e-14);
  EXPECT_NEAR(p.white.x, kD65.x, 1e-14);
  EXPECT_NEAR(p.white.y, kD65.y, 1e-14);
}

TEST(PrimariesOf, SumUpToTheWhiteWhereNoneWasMeasured) {
  MeasuredPrimaries measured = srgb_display({});
  measured.white.reset();
  EXPECT_NEAR(primaries_of(measured).white.x, kD65.x, 1e-14);
  EXPECT_FALSE(additivity_of(measured));
}

TEST(AdditivityOf, IsTheSumBesideTheWhite) {
  MeasuredPrimaries measured = srgb_display({0.3, 0.2, 0.5});
  EXPECT_NEAR(additivity_of(measured)->excess[1], 0, 1e-14);
  EXPECT_NEAR(additivity_of(measured)->ciede2000, 0, 1e-10);
  measured.white->y *= 0.9;  // a supply that sags
  EXPECT_NEAR(additivity_of(measured)->excess[1], 1 / 0.9 - 1, 1e-14);
  EXPECT_GT(additivity_of(measured)->ciede2000, 2);
}

TEST(PrimariesOf, RefusesWhatGivesNoLight) {
  MeasuredPrimaries measured = srgb_display({});
  measured.green = {};
  EXPECT_EQ(error_text([&] { primaries_of(measured); }),
            "invalid: green: it gives no light above the black");
}

}  // namespace
}  // namespace tristim
