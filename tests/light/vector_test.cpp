#include "tristim/light/vector.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

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
