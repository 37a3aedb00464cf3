#include "tristim/light/source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double factor(std::string_view kind, double d, double c1, double c2, double c3) {
  return find_by_name(kAttenuations, kind)->factor(d, c1, c2, c3);
}

TEST(Attenuation, FollowsEachFormula) {
  EXPECT_EQ(factor("none", 7, 1, 2, 3), 1);
  EXPECT_EQ(factor("inverse_square", 4, 1, 2, 3), 1.0 / 16);
  EXPECT_EQ(factor("linear", 4, 1, 2, 3), 1.0 / 9);
  EXPECT_EQ(factor("opengl", 4, 1, 2, 3), 1.0 / 57);
  EXPECT_EQ(factor("opengl", 0.125, 0.25, 0, 0), 4);
  EXPECT_EQ(factor("clamped_quadratic", 4, 1, 2, 3), 1.0 / 57);
  EXPECT_EQ(factor("clamped_quadratic", 0.125, 0.25, 0, 0), 1);
  EXPECT_NEAR(factor("beer_lambert", 4, 0.5, 2, 3), 0.13533528323661269, 1e-17);  // e^-2
}

TEST(Attenuation, DivisionByZeroIsInfiniteAndOneWhereClamped) {
  EXPECT_EQ(factor("inverse_square", 0, 0, 0, 0), kInfinity);
  EXPECT_EQ(factor("linear", 3, 0, 0, 0), kInfinity);
  EXPECT_EQ(factor("opengl", 3, 0, 0, 0), kInfinity);
  EXPECT_EQ(factor("clamped_quadratic", 3, 0, 0, 0), 1);
}

TEST(Attenuation, IsNeverNanForFiniteInput) {
  const double large = std::numeric_limits<double>::max();
  const double values[] = {0, 1, 1e-300, large, -1, -large};
  for (const AttenuationKind& kind : kAttenuations) {
    SCOPED_TRACE(kind.name);
    for (double d : {0.0, 1e-300, 1.0, large}) {
      for (double c1 : values) {
        for (double c2 : values) {
          for (double c3 : values) EXPECT_FALSE(std::isnan(kind.factor(d, c1, c2, c3)));
        }
      }
    }
  }
}

TEST(Attenuation, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared_dir() / "spec/shade-examples/attenuation.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double expected = row.number("out_f");
    EXPECT_NEAR(factor(row.text("in_kind"), row.number("in_d"), row.number("in_c1"),
                       row.number("in_c2"), row.number("in_c3")),
                expected, 1e-15 * expected);
  }
}

TEST(Incident, DirectionalLightIsTheSameEverywhere) {
  const DirectionalLight sun{.to_light = {0, 3, 4}, .intensity = {1, 2, 3}};
  for (const Vector3d& point : {Vector3d(0, 0, 0), Vector3d(1e6, -5, 2)}) {
    const Incident arriving = incident(sun, point);
    EXPECT_LT((arriving.to_light - Vector3d(0, 0.6, 0.8)).norm(), 2e-16);
    EXPECT_EQ(arriving.intensity, (Rgb{1, 2, 3}));
  }
}

TEST(Incident, DirectionsThatAreUnitStayAsTheyAre) {
  // Its square is 1 - 2.06e-16: made unit again, all three parts would move.
  const Vector3d unit(0.9375569964409753, 0.2448384850636399, 0.24706475802169464);
  EXPECT_EQ(incident(DirectionalLight{.to_light = unit}, {0, 0, 0}).to_light, unit);
}

TEST(Incident, PointLightFadesWithTheDistance) {
  const PointLight lamp{.position = {0, 0, 5},
                        .intensity = {100, 50, 0},
                        .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}};
  const Incident arriving = incident(lamp, Vector3d(0, 0, 3));
  EXPECT_EQ(arriving.to_light, Vector3d(0, 0, 1));
  EXPECT_EQ(arriving.intensity, (Rgb{25, 12.5, 0}));

  const Incident at_lamp = incident(lamp, lamp.position);
  EXPECT_EQ(at_lamp.to_light, Vector3d(0, 0, 0));
  EXPECT_EQ(at_lamp.intensity, (Rgb{kInfinity, kInfinity, 0}));
}

TEST(SpotFactor, FollowsOpenGl) {
  const Vector3d axis(0, 0, -2);
  EXPECT_EQ(spot_factor(Vector3d(0, 0, -5), axis, 30, 8), 1);
  EXPECT_NEAR(spot_factor(Vector3d(0.6, 0, -0.8), axis, 40, 2), 0.64, 2e-16);
  EXPECT_EQ(spot_factor(Vector3d(0.6, 0, -0.8), axis, 36, 2), 0);  // 36.87 degrees off
  EXPECT_EQ(spot_factor(Vector3d(0.6, 0, -0.8), axis, 40, 0), 1);
  EXPECT_EQ(spot_factor(Vector3d(0, 0, 5), axis, 180, 8), 1);  // a point light
  EXPECT_EQ(spot_factor(Vector3d(0, 0, 5), axis, 179, 0), 0);  // the cosine is not above 0
  EXPECT_EQ(spot_factor(Vector3d(0, 0, 0), axis, 45, 1), 0);
  EXPECT_EQ(spot_factor(Vector3d(1, 0, -1), axis, 45, 0), 1);  // on the edge of the cone
  // cos 89.9999 keeps its digits: 1.745329251994e-6
  EXPECT_EQ(spot_factor(Vector3d(1, 0, -1.745329253e-6), axis, 89.9999, 0), 1);
  EXPECT_EQ(spot_factor(Vector3d(1, 0, -1.745329251e-6), axis, 89.9999, 0), 0);
}

TEST(Incident, SpotIsAPointLightInACone) {
  const SpotLight spot{.position = {0, 0, 5},
                       .direction = {0, 0, -3},
                       .cutoff_deg = 45,
                       .exponent = 2,
                       .intensity = {25, 50, 0},
                       .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}};
  const Incident arriving = incident(spot, Vector3d(3, 0, 1));
  EXPECT_LT((arriving.to_light - Vector3d(-0.6, 0, 0.8)).norm(), 2e-16);
  EXPECT_NEAR(arriving.intensity.r, 0.64, 2e-16);
  EXPECT_NEAR(arriving.intensity.g, 1.28, 4e-16);
  EXPECT_EQ(incident(spot, Vector3d(9, 0, 1)).intensity, (Rgb{}));
}

TEST(Incident, SpectralLightIsThatOfEachSample) {
  const PointLightOf<SpectralColor> lamp{
      .position = {0, 0, 5},
      .intensity = flat_spectrum(100),
      .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}};
  EXPECT_EQ(incident(lamp, Vector3d(0, 0, 3)).intensity, flat_spectrum(25));
}

TEST(PlacedWithCamera, TurnsAndMovesLights) {
  CameraPose camera{.eye = {1, 2, 3}};
  camera.world_from_camera << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // looks along -x
  const Light sun = placed_with_camera(DirectionalLight{.to_light = {0, 0, 1}}, camera);
  EXPECT_EQ(std::get<DirectionalLight>(sun).to_light, Vector3d(1, 0, 0));
  const Light lamp = placed_with_camera(PointLight{.position = {0, 1, 0}}, camera);
  EXPECT_EQ(std::get<PointLight>(lamp).position, Vector3d(1, 3, 3));
  const Light spot =
      placed_with_camera(SpotLight{.position = {0, 0, 0}, .direction = {0, 0, -1}}, camera);
  EXPECT_EQ(std::get<SpotLight>(spot).position, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<SpotLight>(spot).direction, Vector3d(-1, 0, 0));
}

}  // namespace
}  // namespace tristim
