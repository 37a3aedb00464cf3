#include "tristim/light/area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979324;
const Vector3d kOrigin(0, 0, 0);
const Vector3d kUp(0, 0, 1);

// A square of side 2a at height h, shining down.
std::vector<Vector3d> square(double a, double h) {
  return {{-a, -a, h}, {-a, a, h}, {a, a, h}, {a, -a, h}};
}

// A square seen from below its centre: 4 atan-terms, 4/pi x/sqrt(1+x^2) atan(x/sqrt(1+x^2)), x =
// a/h.
double square_factor(double x) {
  const double s = x / std::sqrt(1 + x * x);
  return 4 / kPi * s * std::atan(s);
}

TEST(PolygonFormFactor, OfASquareOverhead) {
  for (double x : {1e-9, 1e-4, 0.1, 1.0, 5.0, 1e4}) {
    SCOPED_TRACE(x);
    const double factor = square_factor(x);
    EXPECT_NEAR(polygon_form_factor(square(x, 1), kOrigin, kUp), factor, 1e-15 * factor);
  }
  EXPECT_NEAR(polygon_irradiance(square(1, 1), kOrigin, kUp, 2), 2 * kPi * square_factor(1), 2e-15);
}

TEST(PolygonFormFactor, ShinesOnOneSideOnly) {
  std::vector<Vector3d> turned = square(1, 1);
  std::swap(turned[1], turned[3]);
  EXPECT_EQ(polygon_form_factor(turned, kOrigin, kUp), 0);
  EXPECT_EQ(polygon_form_factor(square(1, -1), kOrigin, kUp), 0);  // below the horizon
  EXPECT_EQ(polygon_form_factor(square(1, 0), kOrigin, kUp), 0);   // the point lies in it
  EXPECT_EQ(polygon_form_factor(std::vector<Vector3d>{kUp, {1, 0, 1}}, kOrigin, kUp), 0);
}

TEST(PolygonFormFactor, CutsOffWhatIsBelowTheHorizon) {
  // A wall from z = -3 to 2 lights the ground as the wall from 0 to 2.
  const std::vector<Vector3d> whole{{1, -1, -3}, {1, -1, 2}, {1, 1, 2}, {1, 1, -3}};
  const std::vector<Vector3d> upper{{1, -1, 0}, {1, -1, 2}, {1, 1, 2}, {1, 1, 0}};
  const double factor = polygon_form_factor(upper, kOrigin, kUp);
  EXPECT_GT(factor, 0.05);
  EXPECT_NEAR(polygon_form_factor(whole, kOrigin, kUp), factor, 1e-16);
}

TEST(PolygonFormFactor, IsTheSumOfItsParts) {
  const std::vector<Vector3d> left{{-1, -1, 1}, {-1, 1, 1}, {0, 1, 1}, {0, -1, 1}};
  const std::vector<Vector3d> right{{0, -1, 1}, {0, 1, 1}, {1, 1, 1}, {1, -1, 1}};
  const Vector3d tilted = Vector3d(0.6, 0, 0.8);
  EXPECT_NEAR(
      polygon_form_factor(left, kOrigin, tilted) + polygon_form_factor(right, kOrigin, tilted),
      polygon_form_factor(square(1, 1), kOrigin, tilted), 2e-16);
}

TEST(AreaReflection, OfARoomOfLightIsTheAlbedo) {
  const std::vector<Vector3d> sky = square(1e9, 1);
  const Material material{.kd = 0.5, .od = {1, 0.5, 0}};
  const Rgb out = area_reflection(material, {sky, {2, 4, 8}}, kOrigin, kUp);
  EXPECT_NEAR(out.r, 1, 1e-8);
  EXPECT_NEAR(out.g, 1, 1e-8);
  EXPECT_EQ(out.b, 0);
}

}  // namespace
}  // namespace tristim
