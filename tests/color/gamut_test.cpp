#include "tristim/color/gamut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const Primaries& named(std::string_view name) {
  const NamedPrimaries* set = find_by_name(primaries_list(), name);
  if (set == nullptr) throw std::runtime_error("no primaries " + std::string(name));
  return set->primaries;
}

TEST(Gamut, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/gamut_area.csv")) {
    SCOPED_TRACE(row.text("id"));
    const bool xy = row.text("plane") == "xy";
    const ChromaticityPlane& plane = xy ? kCie1931Plane : kCie1976Plane;
    const double value = row.text("kind") == "area"
                             ? gamut_area(named(row.text("a")), plane)
                             : gamut_coverage(named(row.text("a")), named(row.text("b")), plane);
    EXPECT_NEAR(value, row.number("value"), 1e-13);  // the file's tolerance
  }
}

// By hand from the published chromaticities.
TEST(GamutArea, IsThatOfTheTriangle) {
  EXPECT_NEAR(gamut_area(named("srgb"), kCie1931Plane), 0.11205, 1e-16);
  EXPECT_NEAR(gamut_area(named("bt2020"), kCie1931Plane), 0.2118665, 1e-16);
  EXPECT_NEAR(gamut_area(named("ntsc-1953"), kCie1931Plane), 0.1582, 1e-16);
}

TEST(GamutCoverage, IsAShareWithTheSameIntersectionBothWays) {
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    for (const NamedPrimaries& a : primaries_list()) {
      for (const NamedPrimaries& b : primaries_list()) {
        SCOPED_TRACE(testing::Message() << a.name << " " << b.name << " " << plane.name);
        const double ab = gamut_coverage(a.primaries, b.primaries, plane);
        const double ba = gamut_coverage(b.primaries, a.primaries, plane);
        EXPECT_GE(ab, 0);
        EXPECT_LE(ab, 1);
        // Areas are of order 1 in units in which their corners are rounded to 1e-16.
        EXPECT_NEAR(ab * gamut_area(b.primaries, plane), ba * gamut_area(a.primaries, plane),
                    1e-15);
      }
      EXPECT_EQ(gamut_coverage(a.primaries, a.primaries, plane), 1);
    }
  }
}

TEST(GamutCoverage, IsOneExactlyWhereAllIsCovered) {
  EXPECT_EQ(gamut_coverage(named("bt2020"), named("srgb"), kCie1931Plane), 1);
  EXPECT_EQ(gamut_coverage(named("adobe-rgb"), named("srgb"), kCie1976Plane), 1);
  // Both reds lie on x + y = 1: what rounding takes off a corner is not seen.
  EXPECT_NEAR(gamut_coverage(named("aces-ap0"), named("bt2020"), kCie1976Plane), 1, 1e-15);
  EXPECT_LT(gamut_coverage(named("srgb"), named("bt2020"), kCie1931Plane), 0.53);
}

TEST(GamutCoverage, HasNoneOfALine) {
  const Primaries line{{0.2, 0.3}, {0.3, 0.4}, {0.4, 0.5}, kD65};
  EXPECT_TRUE(
      std::isnan(gamut_coverage({}, {{0.2, 0.2}, {0.2, 0.2}, {0.2, 0.2}, kD65}, kCie1931Plane)));
  EXPECT_NEAR(gamut_coverage(line, {}, kCie1931Plane), 0, 1e-15);
}

TEST(GamutPosition, TellsHowFarOutside) {
  const Primaries srgb;
  const Xyz white = white_xyz(kD65);
  EXPECT_TRUE(gamut_position(white, srgb).inside());
  EXPECT_TRUE(gamut_position({}, srgb).inside());
  EXPECT_TRUE(gamut_position({}, srgb).chromaticity_inside());

  const GamutPosition bright = gamut_position({2 * white.x, 2, 2 * white.z}, srgb);
  EXPECT_FALSE(bright.inside());
  EXPECT_TRUE(bright.chromaticity_inside());
  EXPECT_NEAR(bright.above, 1, 1e-15);
  EXPECT_EQ(bright.below, 0);

  // Full green of BT.2020 is -.5876 1.1329 -.1006 in linear BT.709 [BT.2087 annex 2, inverse].
  const Eigen::Vector3d green = xyz_from_rgb(named("bt2020")).col(1);
  const GamutPosition position = gamut_position({green.x(), green.y(), green.z()}, srgb);
  EXPECT_NEAR(position.rgb.r, -0.5876, 5e-5);
  EXPECT_NEAR(position.below, 0.5876, 5e-5);
  EXPECT_NEAR(position.above, 0.1329, 5e-5);
  EXPECT_FALSE(position.chromaticity_inside());
  // From .0556 .5868 to the edge from green, .125 .5625, to blue, .1754 .1579.
  EXPECT_NEAR(position.distance, 0.0719, 2e-3);
}

TEST(GamutPosition, IsNowhereForNan) {
  const GamutPosition position = gamut_position({std::nan(""), 0.5, 0.5}, {});
  EXPECT_FALSE(position.inside());
  EXPECT_FALSE(position.chromaticity_inside());
}

}  // namespace
}  // namespace tristim
