#include "lib/render/visibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

TEST(HiddenPart, RunsFromAllToNothing) {
  EXPECT_EQ(hidden_part(1, 3, 1.9), 1);
  EXPECT_EQ(hidden_part(1, 3, 4.1), 0);
  EXPECT_EQ(hidden_part(1, 3, 3), 0.5);   // its edge through the light's centre
  EXPECT_EQ(hidden_part(2, 1, 0), 0.25);  // a small blocker hides its share
  EXPECT_EQ(hidden_part(0, 1, 0.99), 1);  // a light without size: hard shadows
  EXPECT_EQ(hidden_part(0, 1, 1.01), 0);
  double last = 1;
  for (double apart = 0; apart < 5; apart += 0.01) {
    const double hidden = hidden_part(1, 3, apart);
    EXPECT_LE(hidden, last);
    last = hidden;
  }
}

TEST(HiddenPart, IsNearTheCircularSegment) {
  for (double x = -1; x <= 1; x += 0.01) {
    const double exact = 0.5 - (x * std::sqrt(1 - x * x) + std::asin(x)) / std::acos(-1.0);
    EXPECT_NEAR(hidden_part(1, 1e9, 1e9 + x), exact, 0.04);  // largest error: 0.0394
  }
}

SphereScene ball_over_ground() {
  SphereScene scene;
  scene.spheres = {{.centre = {0, 3, 0}, .radius = 1}};
  return scene;
}

TEST(VisiblePart, SphereHidesTheLightBehindIt) {
  const SphereScene scene = ball_over_ground();
  const Vector3d up(0, 1, 0);
  const SoftLight soft_sun{DirectionalLight{.to_light = up}, 0.1};
  EXPECT_EQ(visible_part(scene, soft_sun, up, Vector3d(0, 0, 0), nullptr), 0);
  EXPECT_EQ(visible_part(scene, soft_sun, up, Vector3d(0, 0, 0), &scene.spheres[0]), 1);
  EXPECT_NEAR(visible_part(scene, soft_sun, up, Vector3d(1, 0, 0), nullptr), 0.5, 1e-15);
  EXPECT_EQ(visible_part(scene, soft_sun, up, Vector3d(1.31, 0, 0), nullptr), 1);
  EXPECT_EQ(visible_part(scene, soft_sun, up, Vector3d(0, 5, 0), nullptr), 1);  // it is behind

  const SoftLight lamp_before{PointLight{.position = {0, 1.5, 0}}, 0.1};
  EXPECT_EQ(visible_part(scene, lamp_before, up, Vector3d(0, 0, 0), nullptr), 1);
}

TEST(UnblockedPart, IsTheFormFactorOfASphere) {
  const SphereScene scene = ball_over_ground();
  const Vector3d up(0, 1, 0);
  EXPECT_NEAR(unblocked_part(scene, Vector3d(0, 0, 0), up, nullptr), 1 - 1.0 / 9, 1e-15);
  EXPECT_EQ(unblocked_part(scene, Vector3d(0, 2, 0), up, nullptr), 0);  // it touches
  EXPECT_EQ(unblocked_part(scene, Vector3d(0, 0, 0), -up, nullptr), 1);
  EXPECT_EQ(unblocked_part(scene, Vector3d(0, 0, 0), up, &scene.spheres[0]), 1);
}

}  // namespace
}  // namespace tristim::detail
