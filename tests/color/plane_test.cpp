#include "tristim/color/plane.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace tristim {
namespace {

const Polygon kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon kTurned{{0, 1}, {1, 1}, {1, 0}, {0, 0}};  // clockwise

TEST(ChromaticityPlane, GoesThereAndBack) {
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    SCOPED_TRACE(plane.name);
    for (double x = 0; x <= 0.75; x += 0.05) {
      for (double y = 0.01; y <= 0.85; y += 0.07) {
        const Chromaticity c = plane.chromaticity(plane.point({x, y}));
        EXPECT_NEAR(c.x, x, 1e-15);
        EXPECT_NEAR(c.y, y, 1e-15);
      }
    }
  }
}

// D65 at x .3127, y .3290: u' .6254 2 / 6.3226, v' 2.961 / 6.3226.
TEST(ChromaticityPlane, KnowsTheWhiteOfTelevision) {
  const PlanePoint p = kCie1976Plane.point(kD65);
  EXPECT_NEAR(p.x, 1.2508 / 6.3226, 1e-16);
  EXPECT_NEAR(p.y, 2.961 / 6.3226, 1e-16);
  EXPECT_EQ(kCie1931Plane.point(kD65), (PlanePoint{0.3127, 0.3290}));
}

TEST(PolygonArea, CountsEitherTurn) {
  EXPECT_EQ(polygon_area(kSquare), 1);
  EXPECT_EQ(polygon_area(kTurned), 1);
  EXPECT_EQ(polygon_area(Polygon{{0, 0}, {1, 1}}), 0);
  EXPECT_EQ(polygon_area(Polygon{}), 0);
  // Far from the origin the digits are kept.
  EXPECT_EQ(polygon_area(Polygon{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 1}}), 0.5);
}

TEST(ConvexContains, CountsEdgesAsInside) {
  for (const Polygon& square : {kSquare, kTurned}) {
    EXPECT_TRUE(convex_contains(square, {0.5, 0.5}));
    EXPECT_TRUE(convex_contains(square, {0, 0.5}));
    EXPECT_TRUE(convex_contains(square, {1, 1}));
    EXPECT_FALSE(convex_contains(square, {1.0000001, 0.5}));
    EXPECT_FALSE(convex_contains(square, {std::nan(""), 0.5}));
  }
  EXPECT_FALSE(convex_contains(Polygon{}, {0, 0}));
}

TEST(ConvexIntersection, CutsCorners) {
  const Polygon triangle{{0.5, 0.5}, {1.5, 0.5}, {0.5, 1.5}};
  EXPECT_EQ(polygon_area(convex_intersection(kSquare, triangle)), 0.25);
  EXPECT_EQ(polygon_area(convex_intersection(triangle, kTurned)), 0.25);
  EXPECT_TRUE(convex_intersection(kSquare, Polygon{{2, 2}, {3, 2}, {2, 3}}).empty());
  // An edge in common has no area.
  EXPECT_EQ(polygon_area(convex_intersection(kSquare, Polygon{{1, 0}, {2, 0}, {2, 1}, {1, 1}})), 0);
}

TEST(ConvexIntersection, LeavesWhatIsInsideAlone) {
  const Polygon triangle{{0.1, 0.1}, {1, 0.5}, {0.3, 0.7}};
  EXPECT_EQ(convex_intersection(triangle, kSquare), triangle);
  EXPECT_EQ(convex_intersection(triangle, triangle), triangle);
  EXPECT_EQ(convex_intersection(kTurned, kSquare), kTurned);
}

RC_GTEST_PROP(ConvexIntersection, IsSymmetricAndWithinBoth, ()) {
  const auto corner = [] {
    return PlanePoint{*rc::gen::inRange(0, 1000) / 1000.0, *rc::gen::inRange(0, 1000) / 1000.0};
  };
  const Polygon a{corner(), corner(), corner()};
  const Polygon b{corner(), corner(), corner()};
  const double area = polygon_area(convex_intersection(a, b));
  RC_ASSERT(std::fabs(area - polygon_area(convex_intersection(b, a))) < 1e-14);
  RC_ASSERT(area <= polygon_area(a) + 1e-15);
  RC_ASSERT(area <= polygon_area(b) + 1e-15);
}

TEST(ConvexHull, LeavesInnerAndStraightPointsOut) {
  const Polygon hull =
      convex_hull({{0, 0}, {0.5, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0, 0.3}, {1, 1}});
  EXPECT_EQ(hull, kSquare);
  EXPECT_EQ(convex_hull({}), Polygon{});
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}}), (Polygon{{1, 2}}));
}

RC_GTEST_PROP(ConvexHull, HoldsEveryPoint, (const std::vector<std::pair<int, int>>& numbers)) {
  std::vector<PlanePoint> points;
  for (const auto& [x, y] : numbers) points.push_back({x % 100 / 1.0, y % 100 / 1.0});
  const Polygon hull = convex_hull(points);
  if (hull.size() < 3) return;
  RC_ASSERT(std::all_of(points.begin(), points.end(),
                        [&](PlanePoint p) { return convex_contains(hull, p); }));
}

TEST(DistanceOutside, IsToTheNearestEdgeOrCorner) {
  EXPECT_EQ(distance_outside(kSquare, {0.5, 0.5}), 0);
  EXPECT_EQ(distance_outside(kSquare, {0.5, 1.25}), 0.25);
  EXPECT_EQ(distance_outside(kTurned, {-3, -4}), 5);
  EXPECT_TRUE(std::isnan(distance_outside(kSquare, {std::nan(""), 0})));
}

}  // namespace
}  // namespace tristim
