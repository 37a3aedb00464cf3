#include "tristim/light/vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

TEST(ViewVector, ReachesFromOneEndOfTheNumbersToTheOther) {
  const Vector3d v = view_vector({1.5e308, 0, -1.5e308}, {-1.5e308, 0, 1.5e308});
  EXPECT_LT((v - Vector3d(-std::sqrt(0.5), 0, std::sqrt(0.5))).norm(), 3e-16);
}

TEST(Vector, NormalizeKeepsZeroAndMakesTheRestUnit) {
  EXPECT_EQ(normalize(Vector3d(0, 0, 0)), Vector3d(0, 0, 0));
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (double scale : {least, 1e-200, 1e-3, 1.0, 1e3, 1e200, largest}) {
    SCOPED_TRACE(scale);
    const Vector3d unit = normalize(Vector3d(scale, -scale, 0));
    EXPECT_NEAR(unit.x(), 0.70710678118654752, 2e-16);  // largest error measured: 1.2e-16
    EXPECT_NEAR(unit.y(), -0.70710678118654752, 2e-16);
    EXPECT_EQ(unit.z(), 0);
    EXPECT_EQ(length(Vector3d(0, scale, 0)), scale);
  }
  EXPECT_EQ(length(Vector3d(0, 0, 0)), 0);
  EXPECT_TRUE(std::isnan(length(Vector3d(0, std::nan(""), 0))));
}

TEST(Vector, ReflectionTurnsLightAboutTheNormal) {
  const Vector3d normal(0, 0, 1);
  EXPECT_EQ(reflect(Vector3d(0.6, 0, 0.8), normal), Vector3d(-0.6, 0, 0.8));
  EXPECT_EQ(reflect(normal, normal), normal);
  EXPECT_EQ(reflect(Vector3d(1, 0, 0), normal), Vector3d(-1, 0, 0));
}

TEST(Vector, HalfVectorOfOppositeDirectionsIsZero) {
  EXPECT_EQ(half_vector(Vector3d(0.6, 0, 0.8), Vector3d(-0.6, 0, -0.8)), Vector3d(0, 0, 0));
  EXPECT_EQ(half_vector(Vector3d(0.6, 0, 0.8), Vector3d(-0.6, 0, 0.8)), Vector3d(0, 0, 1));
}

TEST(Vector, PhongsReflectionIsTheGeometricOne) {
  const Vector3d lights[] = {{0, 0, 1}, {0, 0, -1}, {0.6, 0, 0.8}, {-0.48, 0.6, 0.64}, {1, 0, 0}};
  const Vector3d normals[] = {{0, 0, 1}, {0.6, 0, 0.8}, {-0.36, 0.48, 0.8}, {0, 0.6, -0.8}};
  for (const Vector3d& to_light : lights) {
    for (const Vector3d& normal : normals) {
      const Vector3d expected = reflect(to_light, normal);
      EXPECT_LT((reflect_by_turning(to_light, normal) - expected).norm(),
                2e-15);  // 1.3e-15 measured
      if (to_light == Vector3d(0, 0, 1)) {
        EXPECT_LT((reflect_z(normal) - expected).norm(), 3e-16);
      }
    }
  }
}

TEST(Vector, CosinesNearZeroKeepTheirDigits) {
  // Of these doubles, from mpmath with 40 digits.
  const Vector3d normal(0, 0.6, 0.8);
  const Vector3d to_light(0, -0.28, 0.96);
  const Vector3d to_eye(0, 0.8, -0.6);
  EXPECT_NEAR(r_dot_v(normal, to_light, to_eye), 0.8, 3e-16);
  const Vector3d nearly(0, 0.28000001, -0.96);
  // N.(L + V)/|L + V| with L + V = (0, 1e-8, 0)
  EXPECT_NEAR(n_dot_h(normal, to_light, nearly), 0.6, 2e-16);
  EXPECT_EQ(n_dot_h(normal, to_light, -to_light), 0);
}

TEST(Vector, AnglesHaveTheirNames) {
  const double half = 0.70710678118654752;
  const HighlightAngles angles =
      highlight_angles(Vector3d(0, 0, 1), Vector3d(half, 0, half), Vector3d(0, 0, 1));
  EXPECT_NEAR(angles.alpha_deg, 45, 1e-14);
  EXPECT_NEAR(angles.beta_deg, 22.5, 1e-14);
  EXPECT_NEAR(angles.rho_deg, 45, 1e-14);
  EXPECT_NEAR(angles.nu_deg, 22.5, 1e-14);
  EXPECT_EQ(angle_between_deg(Vector3d(5, 0, 0), Vector3d(0, -1e-200, 0)), 90);
  EXPECT_EQ(angle_between_deg(Vector3d(5, 0, 0), Vector3d(-3, 0, 0)), 180);
  EXPECT_EQ(angle_between_deg(Vector3d(5, 0, 0), Vector3d(0, 0, 0)), 0);
  EXPECT_EQ(view_vector(Vector3d(0, 0, 1), Vector3d(0, 3, 5)), Vector3d(0, 0.6, 0.8));
}

TEST(Vector, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared_dir() / "spec/shade-examples/vectors.csv")) {
    SCOPED_TRACE(row.text("id"));
    const auto vector = [&](const std::string& name) {
      return Vector3d(row.number(name + "x"), row.number(name + "y"), row.number(name + "z"));
    };
    const Vector3d to_light = vector("in_L");
    const Vector3d normal = vector("in_N");
    const Vector3d to_eye = vector("in_V");
    const Vector3d half = half_vector(to_light, to_eye);
    for (int i = 0; i < 3; ++i) {  // largest error measured: 2.3e-16
      EXPECT_NEAR(reflect(to_light, normal)[i], vector("out_R")[i], 1e-15);
      EXPECT_NEAR(reflect(to_eye, normal)[i], vector("out_M")[i], 1e-15);
      EXPECT_NEAR(half[i], vector("out_H")[i], 1e-15);
    }
    EXPECT_NEAR(dot(reflect(to_light, normal), to_eye), row.number("out_RdotV"), 1e-15);
    EXPECT_NEAR(dot(normal, half), row.number("out_NdotH"), 1e-15);
  }
}

}  // namespace
}  // namespace tristim
