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

}  // namespace
}  // namespace tristim
