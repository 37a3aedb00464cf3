#include "tristim/light/opengl.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace tristim {
namespace {

using Eigen::Vector3d;

const Vector3d kUp(0, 0, 1);

TEST(GlLighting, AddsGlobalAmbientAndEveryLight) {
  const GlMaterial material{
      .ambient = {0.5, 0.5, 0.5}, .diffuse = {0.25, 0.5, 1}, .specular = {1, 0, 0}, .shininess = 4};
  const GlLightModel model{.ambient = {0.5, 0, 1}};
  const GlLight sun{.position = {0, 0, 2}, .ambient = {0, 0.5, 0}};
  EXPECT_EQ(gl_lighting(material, model, {}, kUp, kUp), (Rgb{0.25, 0, 0.5}));
  EXPECT_EQ(gl_lighting(material, model, std::array{sun}, Vector3d(3, 0, -9), kUp),
            (Rgb{0.25 + 0.25 + 1, 0.25 + 0.5, 0.5 + 1}));
}

TEST(GlLighting, DistanceAndConeScaleTheAmbientPartToo) {
  const GlMaterial material{.ambient = {1, 1, 1}, .diffuse = {1, 1, 1}};
  const GlLightModel dark{.ambient = {0, 0, 0}};
  GlLight lamp{.position = {0, 0, 4},  // divided by w: 2 above
               .w = 2,
               .ambient = {1, 0, 0},
               .spot_exponent = 1,
               .spot_cutoff_deg = 60,
               .quadratic = 1};
  EXPECT_EQ(gl_lighting(material, dark, std::array{lamp}, Vector3d(0, 0, 0), kUp),
            (Rgb{0.4, 0.2, 0.2}));
  lamp.spot_direction = {1, 0, 0};
  EXPECT_EQ(gl_lighting(material, dark, std::array{lamp}, Vector3d(0, 0, 0), kUp), (Rgb{}));
}

TEST(GlLighting, LocalViewerMovesTheHighlight) {
  const GlMaterial material{.ambient = {}, .diffuse = {}, .specular = {1, 1, 1}, .shininess = 1};
  const GlLight light{.position = {0, 0, 1}};
  const Vector3d position(-3, 0, -4);
  const GlLightModel far{.ambient = {}, .local_viewer = false};
  const GlLightModel near{.ambient = {}, .local_viewer = true};
  EXPECT_EQ(gl_lighting(material, far, std::array{light}, position, kUp).r, 1);
  // V = (.6, 0, .8): N.H = cos of half of the angle
  EXPECT_NEAR(gl_lighting(material, near, std::array{light}, position, kUp).r, std::sqrt(0.9),
              2e-16);
}

TEST(GlLighting, FiniteInputIsNeverNan) {
  const double large = std::numeric_limits<double>::max();
  const Vector3d vectors[] = {{0, 0, 0}, {0, 0, 1}, {1e-320, 0, 0}, {large, -large, 1}};
  for (const Vector3d& position : vectors) {
    for (const Vector3d& place : vectors) {
      for (double w : {0.0, 1e-320, 1.0, -large}) {
        for (double k : {0.0, 1.0, large}) {
          const GlLight light{.position = place,
                              .w = w,
                              .spot_direction = position,
                              .spot_exponent = k,
                              .spot_cutoff_deg = 45,
                              .constant = 0,
                              .quadratic = k};
          const GlMaterial material{.specular = {large, 1, 0}, .shininess = k};
          for (const Vector3d& normal : vectors) {
            const Rgb color =
                gl_lighting(material, {.local_viewer = true}, std::array{light}, position, normal);
            ASSERT_FALSE(std::isnan(color.r + color.g + color.b)) << k << ' ' << w;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace tristim
